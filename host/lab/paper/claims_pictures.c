/* SPDX-License-Identifier: MIT */
/* The paper's claims about what is to be seen in Fig. 3, in Fig. A and by multiple exposure. */
#include <string.h>

#include "base/complain.h"
#include "lab/paper/claims.h"
#include "lab/paper/measure.h"

/* Measures how much of the mask in scratch[0] shows the board. Compares `shown`, the shot's photo,
 * with another whose board has its two colours swapped. shown may be NULL: the shot is rendered for
 * it. Uses scratch[1] and, if shown is NULL, scratch[2]. */
static int board_contrast(struct paper *paper, const struct paper_shot *shot,
                          const struct paper_photo *shown, struct paper_contrast *contrast) {
    struct paper_shot other = *shot;
    int status = STATUS_DONE;
    if (shown == NULL) {
        status = paper_shoot(paper, shot, paper->scratch[2]);
        shown = paper->scratch[2];
    }
    other.change = shot->change == PAPER_BARE ? PAPER_BARE_SWAPPED : PAPER_SWAPPED;
    if (status == STATUS_DONE) {
        status = paper_shoot(paper, &other, paper->scratch[1]);
    }
    if (status == STATUS_DONE) {
        *contrast = paper_contrast(paper->scratch[0], shown, paper->scratch[1]);
    }
    return status;
}

/* ---- 1 -------------------------------------------------------------------------------------- */

static double mean_level(const struct paper_mean *mean) {
    return (mean->rgb[0] + mean->rgb[1] + mean->rgb[2]) / 3;
}

/* What is seen at N = 5 and 10, the figure's two pictures, and at N = 24. */
enum { DEPTH_FINAL = 24, VIEWS = 3 };

static int measure_views(struct paper *paper, struct paper_contrast seen[VIEWS],
                         struct paper_mean mean[VIEWS]) {
    static const int depths[VIEWS] = {5, 10, DEPTH_FINAL};
    static const char *const files[VIEWS] = {"fig3a", "fig3b", NULL};
    int status = STATUS_DONE;
    for (int i = 0; i < VIEWS && status == STATUS_DONE; i++) {
        const struct paper_shot shot = {.scene = "fig3",
                                        .overrides = {.has_depth = true, .depth = depths[i]}};
        const struct paper_photo *photo = files[i] != NULL ? paper_photo_of(paper, files[i]) : NULL;
        status = board_contrast(paper, &shot, photo, &seen[i]);
        mean[i] = paper_mean(paper->scratch[0], NULL, photo != NULL ? photo : paper->scratch[2]);
    }
    return status;
}

int paper_claim_depth(struct paper *paper, struct paper_claim *claim) {
    const struct paper_shot outline = {
        .scene = "fig3", .change = PAPER_OUTLINE, .object = "inner cube"};
    const struct paper_shot bare = {.scene = "fig3", .change = PAPER_BARE};
    struct paper_contrast without, seen[VIEWS];
    struct paper_mean mean[VIEWS];
    int status = paper_shoot(paper, &outline, paper->scratch[0]);
    if (status == STATUS_DONE) {
        status = board_contrast(paper, &bare, NULL, &without);
    }
    if (status == STATUS_DONE) {
        status = measure_views(paper, seen, mean);
    }
    if (status != STATUS_DONE) {
        return status;
    }
    paper_say(claim->measured,
              "The board's two colours are swapped, and the change is measured on the %lu pixels "
              "inside the inner cube's outline. Without any glass it is %.1f levels in the mean. ",
              seen[0].pixels, without.mean);
    for (int i = 0; i < VIEWS; i++) {
        paper_say(claim->measured,
                  "N = %d: %.2f levels, and %.1f %% of the pixels change by %d levels or more; "
                  "mean colour (%.0f, %.0f, %.0f). ",
                  i < 2 ? 5 + 5 * i : DEPTH_FINAL, seen[i].mean, 100 * seen[i].share, PAPER_SEEN,
                  mean[i].rgb[0], mean[i].rgb[1], mean[i].rgb[2]);
    }
    const bool parts[] = {seen[0].share <= 0.05, seen[1].share >= 0.95,
                          mean_level(&mean[0]) < mean_level(&mean[1]) / 2};
    paper_say(claim->why,
              "Asked for: at most 5 %% of the pixels change at N = 5 (%s), at least 95 %% at N = "
              "10 (%s), and the middle at N = 5 is less than half as bright (%s). A line of sight "
              "through all three cubes crosses ten boundaries before it comes to the board; one "
              "that enters the inner cube's side is reflected in it as well, and needs more.",
              paper_yes(parts[0]), paper_yes(parts[1]), paper_yes(parts[2]));
    return paper_judge(claim, parts, sizeof parts / sizeof parts[0]);
}

/* ---- 6 -------------------------------------------------------------------------------------- */

enum { SHARES = 13 };

/* The share of the glass's pixels that show the board, at N = 0..12 and at N = 24. */
struct visibility {
    double share[SHARES], final;
};

static int measure_visibility(struct paper *paper, const char *scene,
                              struct visibility *visibility) {
    const struct paper_shot outline = {.scene = scene, .change = PAPER_GLASS_OUTLINE};
    int status = paper_shoot(paper, &outline, paper->scratch[0]);
    for (int i = 0; i <= SHARES && status == STATUS_DONE; i++) {
        const struct paper_shot shot = {
            .scene = scene,
            .overrides = {.has_depth = true, .depth = i < SHARES ? i : DEPTH_FINAL}};
        struct paper_contrast contrast = {0, 0, 0};
        status = board_contrast(paper, &shot, NULL, &contrast);
        *(i < SHARES ? &visibility->share[i] : &visibility->final) = contrast.share;
    }
    return status;
}

int paper_claim_visibility(struct paper *paper, struct paper_claim *claim) {
    static const char *const scenes[] = {"fig7-isolated", "fig7-frustum", "fig3"};
    struct visibility seen[3];
    int status = STATUS_DONE;
    memset(seen, 0, sizeof seen);
    paper_say(claim->measured,
              "Of the pixels of the glass, those that change by %d levels or more when the board's "
              "two colours are swapped, in per cent of those that do at N = %d: ",
              PAPER_SEEN, DEPTH_FINAL);
    for (int i = 0; i < 3 && status == STATUS_DONE; i++) {
        status = measure_visibility(paper, scenes[i], &seen[i]);
        paper_say(claim->measured, "%s%s", i > 0 ? "; " : "", scenes[i]);
        for (int depth = 0; depth < SHARES; depth++) {
            seen[i].share[depth] /= seen[i].final;
            paper_say(claim->measured, "%s %.1f", depth == 0 ? " N = 0, 1, ... 12:" : ",",
                      100 * seen[i].share[depth]);
        }
    }
    paper_say(claim->measured, ".");
    const bool parts[] = {seen[0].share[3] >= 0.9, seen[1].share[3] >= 0.9,
                          seen[0].share[5] >= 0.95, seen[1].share[5] >= 0.95,
                          seen[2].share[10] >= 0.95};
    paper_say(claim->why,
              "Asked for: 90 %% at N = 3 for the two simple models, the objects apart (%s) and the "
              "frustum (%s); 95 %% at N = 5 for the same (%s, %s); 95 %% at N = 10 for the nested "
              "cubes (%s). A line of sight straight on crosses 2 boundaries of a solid object, 4 "
              "of the frustum with its cavity and 10 of the nested cubes; total reflection adds "
              "to that.",
              paper_yes(parts[0]), paper_yes(parts[1]), paper_yes(parts[2]), paper_yes(parts[3]),
              paper_yes(parts[4]));
    return status == STATUS_DONE ? paper_judge(claim, parts, sizeof parts / sizeof parts[0])
                                 : status;
}

/* ---- 7 -------------------------------------------------------------------------------------- */

int paper_claim_bands(struct paper *paper, struct paper_claim *claim) {
    static const char *const files[3] = {"figA-4bits", "figA-5bits", "figA-8bits"};
    static const int bits[3] = {4, 5, 8};
    bool parts[3];
    const struct paper_shot outline = {
        .scene = "figA", .change = PAPER_OUTLINE, .object = "white ball"};
    int status = paper_shoot(paper, &outline, paper->scratch[0]);
    paper_say(claim->measured, "Red, along the row on which the white ball is widest. ");
    for (int i = 0; i < 3 && status == STATUS_DONE; i++) {
        const struct paper_profile profile =
            paper_profile(paper->scratch[0], paper_photo_of(paper, files[i]));
        parts[i] = (profile.cliff >= PAPER_SEEN) == (bits[i] < 8);
        paper_say(claim->measured,
                  "%d bits: %u levels on %u pixels, the largest step between neighbours %u; %u "
                  "terraces of %d pixels or more, the largest step from one to the next %u. ",
                  bits[i], profile.levels, profile.length, profile.largest, profile.terraces,
                  PAPER_TERRACE, profile.cliff);
    }
    if (status != STATUS_DONE) {
        return status;
    }
    paper_say(claim->why,
              "A band is a step of %d levels or more (2 %% of the range) between two terraces. "
              "There is one at 4 bits (%s) and at 5 bits (%s), and none at 8 bits (%s). Whether "
              "an eye adds light and dark edges to it (Mach) was not measured.",
              PAPER_SEEN, paper_yes(parts[0]), paper_yes(parts[1]), paper_yes(parts[2]));
    return paper_judge(claim, parts, sizeof parts / sizeof parts[0]);
}

/* ---- 9 -------------------------------------------------------------------------------------- */

int paper_claim_exposures(struct paper *paper, struct paper_claim *claim) {
    const struct paper_shot shot = {
        .scene = "fig3",
        .overrides = {
            .has_depth = true, .depth = 10, .has_colour = true, .colour = COLOUR_EXPOSURES}};
    int status = paper_shoot(paper, &shot, paper->scratch[0]);
    if (status != STATUS_DONE) {
        return status;
    }
    const struct paper_photo *full = paper_photo_of(paper, "fig3b"), *sum = paper->scratch[0];
    unsigned long differing = 0;
    for (size_t i = 0; i < PICTURE_BYTES; i++) {
        differing += full->rgb[i] != sum->rgb[i];
    }
    paper_say(claim->measured,
              "Fig. 3 (b) drawn eight times in 8 colours and photographed by an emulated camera: "
              "%lu of %d levels differ from the full-colour picture.",
              differing, PICTURE_BYTES);
    const bool part = differing == 0;
    paper_say(claim->why, part ? "The sum of 2^k times bit k is the level itself."
                               : "The sum is not the full-colour picture.");
    return paper_judge(claim, &part, 1);
}
