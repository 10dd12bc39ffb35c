/* SPDX-License-Identifier: MIT */
/* The paper's claims about what its pictures cost. */
#include <string.h>

#include "base/complain.h"
#include "lab/paper/claims.h"
#include "lab/paper/curves.h"
#include "lab/paper/measure.h"

/* How many times as much b takes as a. */
struct ratios {
    double rays, tests, seconds;
};

static struct ratios ratios_of(const struct render_totals *a, const struct render_totals *b) {
    const struct ratios ratios = {
        (double)(b->rays + b->shadow_rays) / (double)(a->rays + a->shadow_rays),
        (double)b->solid_tests / (double)a->solid_tests, b->seconds / a->seconds};
    return ratios;
}

/* ---- 2 -------------------------------------------------------------------------------------- */

int paper_claim_nested(struct paper *paper, struct paper_claim *claim) {
    static const char *const objects[3] = {"ball", "intermediate cube", "inner cube"};
    const struct paper_photo *a = paper_photo_of(paper, "fig4a"),
                             *b = paper_photo_of(paper, "fig4b");
    int status = STATUS_DONE;
    for (int i = 0; i < 3 && status == STATUS_DONE; i++) {
        const struct paper_shot outline = {
            .scene = "fig4b", .change = PAPER_OUTLINE, .object = objects[i], .is_large = true};
        status = paper_shoot(paper, &outline, paper->scratch[i]);
    }
    if (status != STATUS_DONE) {
        return status;
    }
    const struct paper_photo *ball = paper->scratch[0];
    const struct ratios ratios = ratios_of(&b->totals, &a->totals);
    const struct paper_mean cube = paper_mean(paper->scratch[1], paper->scratch[2], b);
    const struct paper_mean ball_a = paper_mean(ball, NULL, a), ball_b = paper_mean(ball, NULL, b);
    const struct paper_contrast mirrored = paper_contrast(ball, a, b);
    paper_say(claim->measured,
              "(a) over (b): %.2f in rays, %.2f in solid tests, %.2f in seconds. Mean colour in "
              "(b) inside the outline of the (64, 32, 0) cube and outside that of the inner one: "
              "(%.0f, %.0f, %.0f). ",
              ratios.rays, ratios.tests, ratios.seconds, cube.rgb[0], cube.rgb[1], cube.rgb[2]);
    paper_say(claim->measured,
              "Mean colour inside the ball's outline: (%.0f, %.0f, %.0f) in (a), chroma %.2f; "
              "(%.0f, %.0f, %.0f) in (b), chroma %.2f; %.1f %% of its pixels differ between the "
              "two by %d levels or more.",
              ball_a.rgb[0], ball_a.rgb[1], ball_a.rgb[2], paper_chroma(&ball_a), ball_b.rgb[0],
              ball_b.rgb[1], ball_b.rgb[2], paper_chroma(&ball_b), 100 * mirrored.share,
              PAPER_SEEN);
    const bool parts[] = {ratios.rays > 2 && ratios.tests > 2,
                          cube.rgb[0] > 1.1 * cube.rgb[1] && cube.rgb[0] > 1.1 * cube.rgb[2],
                          paper_chroma(&ball_a) >= 0.1 && paper_chroma(&ball_b) >= 0.1,
                          mirrored.share >= 0.5};
    paper_say(
        claim->why,
        "Asked for: more than 2 in both counts (%s); red 10 %% above green and blue (%s; what the "
        "paper calls red is an orange, (64, 32, 0), to begin with); a chroma of 0.1 or more of "
        "the ball in both, whose own colour is grey (%s); half of its pixels differ (%s).",
        paper_yes(parts[0]), paper_yes(parts[1]), paper_yes(parts[2]), paper_yes(parts[3]));
    return paper_judge(claim, parts, sizeof parts / sizeof parts[0]);
}

/* ---- 3 -------------------------------------------------------------------------------------- */

int paper_claim_cover(struct paper *paper, struct paper_claim *claim) {
    const struct ratios ratios =
        ratios_of(&paper_photo_of(paper, "fig6a")->totals, &paper_photo_of(paper, "fig6b")->totals);
    paper_say(claim->measured, "(b) over (a): %.2f in rays, %.2f in solid tests, %.2f in seconds.",
              ratios.rays, ratios.tests, ratios.seconds);
    const bool parts[] = {ratios.rays >= 2.5 && ratios.rays <= 3.5,
                          ratios.tests >= 2.5 && ratios.tests <= 3.5};
    paper_say(claim->why,
              "Asked for: 2.5 to 3.5, in rays (%s) and in solid tests (%s). The paper does not say "
              "how much of the picture its cover fills, on which the ratio depends.",
              paper_yes(parts[0]), paper_yes(parts[1]));
    return paper_judge(claim, parts, sizeof parts / sizeof parts[0]);
}

/* ---- 4 -------------------------------------------------------------------------------------- */

static const char *const reading_names[PAPER_READINGS] = {"(i)", "(ii)"};

/* Counts at how many of N = 1..16 the curves lie in the paper's order. */
static int ordered_depths(const struct paper *paper, enum paper_cost cost) {
    int ordered = 0;
    for (int depth = 1; depth < PAPER_DEPTHS; depth++) {
        double relative[PAPER_CURVES];
        for (int i = 0; i < PAPER_CURVES; i++) {
            const double *costs = paper_costs(&paper->curves[i], cost);
            relative[i] = costs[depth] / costs[0];
        }
        ordered +=
            relative[0] < relative[1] && relative[1] < relative[2] && relative[1] < relative[3];
    }
    return ordered;
}

/* Writes down one reading's fits of one cost; returns the least R^2 of all curves. */
static double say_fits(const struct paper *paper, struct paper_claim *claim, enum paper_cost cost,
                       enum paper_reading reading) {
    double least = 1;
    paper_say(claim->measured, "%s, reading %s:", paper_cost_name(cost), reading_names[reading]);
    for (int i = 0; i < PAPER_CURVES; i++) {
        const struct paper_fit fit = paper_fit_curve(&paper->curves[i], cost, reading);
        paper_say(claim->measured, "%s %s C1 = %d, C2 = %d, R^2 = %.3f", i > 0 ? ";" : "",
                  paper->curves[i].scene, fit.c1, fit.c2, fit.r_squared);
        least = fit.r_squared < least ? fit.r_squared : least;
    }
    paper_say(claim->measured, ". ");
    return least;
}

int paper_claim_formula(struct paper *paper, struct paper_claim *claim) {
    double best[PAPER_READINGS] = {0, 0};
    paper_say(claim->measured, "T(N)/T(0) for N = 0..16 at 320 x 200. ");
    for (int cost = 0; cost < PAPER_COSTS; cost++) {
        for (int reading = 0; reading < PAPER_READINGS; reading++) {
            double least =
                say_fits(paper, claim, (enum paper_cost)cost, (enum paper_reading)reading);
            best[reading] = least > best[reading] ? least : best[reading];
        }
    }
    const double *costs = paper->curves[2].rays;
    const double growth = (costs[16] - costs[0]) / (costs[8] - costs[0]);
    const int ordered[] = {ordered_depths(paper, PAPER_RAYS), ordered_depths(paper, PAPER_TESTS)};
    paper_say(claim->measured,
              "The order of the curves is the paper's at %d of the 16 depth levels above 0 in "
              "rays, at %d in solid tests. From N = 8 to 16 fig4a's rays above those of N = 0 grow "
              "%.2f times.",
              ordered[0], ordered[1], growth);
    const bool parts[] = {best[0] >= 0.95, best[1] >= 0.95,
                          ordered[0] == PAPER_DEPTHS - 1 && ordered[1] == PAPER_DEPTHS - 1,
                          growth < 1.8 || growth > 2.2};
    paper_say(claim->why,
              "Reading (i): T(N)/T(0) is the formula; (ii): log10(T(N)/T(0)) + 1 is, so T(N)/T(0) "
              "= C1 N^C2 + 1. Asked for: R^2 of 0.95 or more for all four curves, in rays or in "
              "solid tests, by (i) (%s), by (ii) (%s); the order at every N (%s); a growth from N "
              "= 8 to 16 that is not 2 (%s). With the largest C1 and C2 "
              "reading (i) comes to 13.8 at N = 16; reading (ii) never falls below N + 1 and has "
              "no power between N and N^2.",
              paper_yes(parts[0]), paper_yes(parts[1]), paper_yes(parts[2]), paper_yes(parts[3]));
    return paper_judge(claim, parts, sizeof parts / sizeof parts[0]);
}

/* ---- 5 -------------------------------------------------------------------------------------- */

enum { SIZE_DEPTHS = 4 };

int paper_claim_size(struct paper *paper, struct paper_claim *claim) {
    static const int depths[SIZE_DEPTHS] = {0, 2, 5, 10};
    struct render_totals totals[2][SIZE_DEPTHS];
    int status = STATUS_DONE;
    for (int i = 0; i < 2 * SIZE_DEPTHS && status == STATUS_DONE; i++) {
        const struct paper_shot shot = {
            .scene = "fig7-frustum",
            .is_large = i >= SIZE_DEPTHS,
            .overrides = {.has_depth = true, .depth = depths[i % SIZE_DEPTHS]}};
        status = paper_shoot(paper, &shot, paper->scratch[0]);
        totals[i / SIZE_DEPTHS][i % SIZE_DEPTHS] = paper->scratch[0]->totals;
    }
    if (status != STATUS_DONE) {
        return status;
    }
    const struct ratios ratios = ratios_of(&totals[0][3], &totals[1][3]);
    double worst = 0;
    paper_say(claim->measured,
              "fig7-frustum at N = 10, 640 x 400 over 320 x 200: %.3f in rays, %.3f in solid "
              "tests, %.2f in "
              "seconds. Relative solid tests, T(N)/T(0), at the two sizes:",
              ratios.rays, ratios.tests, ratios.seconds);
    for (int i = 1; i < SIZE_DEPTHS; i++) {
        const double small = ratios_of(&totals[0][0], &totals[0][i]).tests;
        const double large = ratios_of(&totals[1][0], &totals[1][i]).tests;
        const double off = large > small ? large / small - 1 : 1 - large / small;
        worst = off > worst ? off : worst;
        paper_say(claim->measured, " N = %d: %.3f and %.3f%s", depths[i], small, large,
                  i + 1 < SIZE_DEPTHS ? ";" : ".");
    }
    const bool parts[] = {ratios.rays >= 3.8 && ratios.rays <= 4.2 && ratios.tests >= 3.8 &&
                              ratios.tests <= 4.2,
                          worst <= 0.02};
    paper_say(claim->why,
              "Asked for: 3.8 to 4.2 in both counts (%s); relative costs that differ by no more "
              "than 2 %% (%s; the largest difference is %.2f %%). Seconds are processor time of "
              "one run each, the drawing of the whole screen included.",
              paper_yes(parts[0]), paper_yes(parts[1]), 100 * worst);
    return paper_judge(claim, parts, sizeof parts / sizeof parts[0]);
}

/* ---- 8 -------------------------------------------------------------------------------------- */

enum { THRESHOLDS = 2, LONG_DEPTHS = 5 };

int paper_claim_threshold(struct paper *paper, struct paper_claim *claim) {
    static const int depths[LONG_DEPTHS] = {10, 16, 32, 64, 255}, open_depths[2] = {10, 12};
    static const int inverse[THRESHOLDS] = {4096, 256};
    double rays[THRESHOLDS + 1][LONG_DEPTHS];
    int status = STATUS_DONE;
    paper_say(claim->measured, "Rays a pixel of fig3");
    for (int i = 0; i <= THRESHOLDS; i++) {
        const int count = i < THRESHOLDS ? LONG_DEPTHS : 2;
        if (i < THRESHOLDS) {
            paper_say(claim->measured, "; threshold 1/%d:", inverse[i]);
        } else {
            paper_say(claim->measured, "; without one:");
        }
        for (int j = 0; j < count && status == STATUS_DONE; j++) {
            const int depth = i < THRESHOLDS ? depths[j] : open_depths[j];
            const struct paper_shot shot = {
                .scene = "fig3",
                .overrides = {.has_depth = true,
                              .depth = depth,
                              .has_threshold = true,
                              .threshold = i < THRESHOLDS ? 1.0 / inverse[i] : 0}};
            status = paper_shoot(paper, &shot, paper->scratch[0]);
            const struct paper_photo *photo = paper->scratch[0];
            rays[i][j] = (double)photo->totals.rays / (photo->width * photo->height);
            paper_say(claim->measured, "%s N = %d: %.3f", j > 0 ? "," : "", depth, rays[i][j]);
        }
    }
    if (status != STATUS_DONE) {
        return status;
    }
    paper_say(claim->measured, ".");
    const bool parts[] = {rays[0][4] <= 1.001 * rays[0][3], rays[1][4] <= 1.001 * rays[1][3],
                          rays[2][1] >= 1.1 * rays[2][0]};
    paper_say(claim->why,
              "Asked for: from N = 64 to 255 the rays grow by no more than 0.1 %% with either "
              "threshold (%s, %s), and without one they grow from N = 10 to 12 by 10 %% or more "
              "(%s). Light that is caught by total reflection loses nothing and goes on to N.",
              paper_yes(parts[0]), paper_yes(parts[1]), paper_yes(parts[2]));
    return paper_judge(claim, parts, sizeof parts / sizeof parts[0]);
}
