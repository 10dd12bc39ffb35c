/* SPDX-License-Identifier: MIT */
/* The report of `superframe measure`: what to choose on which machine, in words and tables. */
#include <inttypes.h>
#include <math.h>
#include <string.h>

#include "base/complain.h"
#include "lab/measure/page.h"
#include "render/arithmetic.h"

/* ---- Chapters ------------------------------------------------------------------------------- */

static const struct measure_setting *find_setting(const struct report *report,
                                                  const char *arithmetic, unsigned depth,
                                                  double threshold) {
    for (size_t i = 0; i < report->settings->count; i++) {
        const struct measure_setting *setting = &report->settings->settings[i];
        if (strcmp(setting->arithmetic, arithmetic) == 0 && strcmp(setting->tail, "black") == 0 &&
            setting->depth == depth && !(setting->error > 0) &&
            fabs(setting->threshold - threshold) < 1e-9) {
            return setting;
        }
    }
    return NULL;
}

/* Says how far double and f128 agree, where f128 is there. */
static void write_oracle(const struct report *report) {
    const struct measure *measure = report->measure;
    double oracle = 100;
    if (arithmetic_find("f128") == NULL) {
        page_paragraph(report, "Double was not checked against 113-bit numbers: this build has no "
                               "f128.");
        return;
    }
    for (size_t i = 0; i < measure->scene_count; i++) {
        oracle = fmin(oracle, measure->scenes[i].oracle);
    }
    page_paragraph(report,
                   "That double is exact enough was checked against 113-bit numbers (f128), 48 x "
                   "30 pixels of each scene at N = 10: %s%.2f %% of the pixels are the same to the "
                   "last bit. f128 itself is too slow for the converged pictures.",
                   oracle < 100 ? "at least " : "", floor(100 * oracle) / 100);
}

static void write_method(const struct report *report) {
    const struct measure *measure = report->measure;
    char names[PAGE_TEXT_SIZE] = "";
    for (size_t i = 0; i < measure->scene_count; i++) {
        size_t used = strlen(names);
        (void)snprintf(names + used, sizeof names - used, "%s%s", i > 0 ? ", " : "",
                       measure->scenes[i].name);
    }
    const struct measure_point *first = &measure->points.points[0];
    page_heading(report, 2, "How it was measured");
    page_paragraph(
        report,
        "Scenes: %s; %u x %u pixels. Every picture is held against the one that double "
        "makes with depth level %d, a threshold of 1/262144 and the estimated tail, where "
        "four times less changes no pixel by more than 1 LSB. Shares are the mean over the "
        "scenes.",
        names, first->width, first->height, MEASURE_CONVERGED_DEPTH);
    write_oracle(report);
    page_paragraph(report,
                   "Seconds are predicted from counted rays, boundaries, tests and port writes, by "
                   "the operations that each takes and the instructions that each operation takes "
                   "on the machine: %zu points, in table.csv.",
                   measure->points.count);
}

static size_t count_of_machines(void) {
    size_t count = 0;
    while (cost_targets[count].name != NULL) {
        count++;
    }
    return count;
}

static void write_words(const struct report *report) {
    static const char *const words[] = {
        ("arithmetic|the numbers that the renderer computes with. fx: integers, fixed point with a "
         "format for each role. f32: float. f64: double. q16, q16_epsilon: plain 16.16 fixed "
         "point, for comparison only"),
        "N, depth level|how many reflections and refractions a path of light may have",
        "threshold|a branch of the path ends where less than this share of the light is left",
        "tail|what a branch that was ended counts as: black, or an estimate of the mean",
        "--error E|an accuracy asked for instead of a threshold, in LSB",
        "LSB|one of the 255 steps of a colour from dark to bright",
        "wrong|a pixel of which a colour is more than 1 LSB off"};
    page_paragraph(report,
                   "A ray tracer may be quick or exact. This page says, for each of %zu "
                   "machines, which numbers to compute with, which setting to take, how "
                   "long a picture takes then, and how much of it is wrong.",
                   count_of_machines());
    page_row(report, true, "word|meaning");
    for (size_t i = 0; i < sizeof words / sizeof words[0]; i++) {
        page_row(report, false, words[i]);
    }
    page_end_table(report);
}

/* Compares the times of the same work in each arithmetic: that of the plan with N = 64 and a
 * threshold of 1/4096. */
static void write_choice_of_arithmetic(const struct report *report) {
    static const char *const names[] = {"fx", "f32", "f64"};
    static const double threshold = 1.0 / 4096;
    if (find_setting(report, "fx", 64, threshold) == NULL ||
        find_setting(report, "f32", 64, threshold) == NULL) {
        return;
    }
    page_heading(report, 2, "Which arithmetic for which machine");
    page_row(report, true, "machine|take|fx|f32|f64");
    for (size_t i = 0; cost_targets[i].name != NULL; i++) {
        char cells[PAGE_TEXT_SIZE], text[3][32];
        const char *best = "fx", *times[3];
        double least = INFINITY;
        for (int j = 0; j < 3; j++) {
            const struct measure_setting *setting = find_setting(report, names[j], 64, threshold);
            double seconds = setting != NULL ? setting->seconds[i] : (double)NAN;
            best = seconds < least ? names[j] : best;
            least = fmin(least, seconds);
            times[j] = page_seconds(seconds, text[j]);
        }
        (void)snprintf(cells, sizeof cells, "%s|%s|%s|%s|%s", cost_targets[i].label, best, times[0],
                       times[1], times[2]);
        page_row(report, false, cells);
    }
    page_end_table(report);
    page_paragraph(report, "Time of one picture at N = 64 and a threshold of 1/4096. A dash: that "
                           "machine would compute it in software, and it was not measured. All "
                           "three are as exact as the settings let them be (see Arithmetics): the "
                           "machine decides, not the picture.");
}

static void write_advice(const struct report *report) {
    page_heading(report, 2, "Which setting");
    page_row(report, true,
             "machine|at most 10 % wrong|takes|at most 1 % wrong|takes|at most 0.1 % wrong|takes");
    for (size_t i = 0; cost_targets[i].name != NULL; i++) {
        static const double most[] = {10, 1, 0.1};
        char cells[PAGE_TEXT_SIZE], setting[96], seconds[32];
        size_t used = (size_t)snprintf(cells, sizeof cells, "%s", cost_targets[i].label);
        for (int j = 0; j < 3; j++) {
            const struct measure_setting *best = measure_cheapest(report->settings, i, most[j]);
            if (best == NULL) {
                used += (size_t)snprintf(cells + used, sizeof cells - used, "|none of these|–");
            } else {
                used += (size_t)snprintf(cells + used, sizeof cells - used, "|%s|%s",
                                         page_setting(best, setting),
                                         page_seconds(best->seconds[i], seconds));
            }
        }
        page_row(report, false, cells);
    }
    page_end_table(report);
    page_paragraph(report, "The quickest setting of all measured whose share of wrong pixels is as "
                           "small. How each machine's time is made, and what of it is assumed, "
                           "stands at the end.");
}

static void write_fronts(const struct report *report) {
    page_heading(report, 2, "Time against error, machine by machine");
    page_paragraph(report, "Each mark is a setting: to the left is quick, down is right. The line "
                           "joins those that are worth their time: what is above it is slower than "
                           "one of them and no more right. Both scales are logarithmic; nothing "
                           "wrong at all is drawn at the foot, at 0.001 %%.");
    for (size_t i = 0; cost_targets[i].name != NULL; i++) {
        char file[64], caption[128];
        (void)snprintf(file, sizeof file, "pareto-%s.png", cost_targets[i].name);
        (void)snprintf(caption, sizeof caption, "%s: time against error", cost_targets[i].label);
        page_picture(report, file, caption);
    }
}

static void write_paper(const struct report *report) {
    const struct measure_setting *paper = find_setting(report, "fx", 10, 0);
    if (paper == NULL) {
        return;
    }
    page_heading(report, 2, "What the paper's N = 10 costs and loses");
    page_paragraph(
        report,
        "Depth level 10 and no threshold, as in the paper, takes %.0f rays a pixel and gets "
        "%.2f %% of the pixels wrong (%.2f %% on the worst scene): the light beyond the "
        "tenth boundary is missing.",
        paper->rays, paper->wrong, paper->worst);
    const struct measure_setting *better = NULL;
    for (size_t i = 0; i < report->settings->count; i++) {
        const struct measure_setting *setting = &report->settings->settings[i];
        if (strcmp(setting->arithmetic, "fx") == 0 && setting->wrong <= paper->wrong &&
            setting->rays < (better != NULL ? better : paper)->rays) {
            better = setting;
        }
    }
    if (better != NULL) {
        char text[96];
        page_paragraph(
            report, "%s is no worse: %.2f %% wrong with %.0f rays a pixel, %.1f times fewer.",
            page_setting(better, text), better->wrong, better->rays, paper->rays / better->rays);
    }
    page_picture(report, "difference-paper.png",
                 "Left: the first scene at the paper's setting. Right: where it is off. Black: not "
                 "at all; blue: 1 LSB; green: 2; yellow: 4; red: 9; white: 33 and more.");
    page_picture(report, "difference-fx.png",
                 "The same with N = 64 and a threshold of 1/65536, arithmetic fx.");
    page_picture(report, "difference-error.png", "The same with --error 1, arithmetic fx.");
    page_picture(report, "error-depth.png",
                 "Pixels wrong against depth level: with a threshold, more depth soon stops "
                 "helping.");
    page_picture(report, "error-threshold.png",
                 "Pixels wrong against threshold at N = 64, for each arithmetic and tail. fx, f32 "
                 "and f64 lie on each other.");
}

/* Writes the heading and the head of a table whose first row comes next; nothing before others. */
static void begin_table(const struct report *report, bool *has_begun, const char *heading,
                        const char *head) {
    if (!*has_begun) {
        page_heading(report, 2, heading);
        page_row(report, true, head);
    }
    *has_begun = true;
}

/* Writes side by side the two ways to count the light of a pruned branch. */
static void write_tails(const struct report *report) {
    bool has_any = false;
    for (size_t i = 0; i < report->settings->count; i++) {
        const struct measure_setting *one = &report->settings->settings[i];
        const struct measure_setting *black =
            find_setting(report, one->arithmetic, one->depth, one->threshold);
        char cells[PAGE_TEXT_SIZE], threshold[32];
        if (strcmp(one->tail, "estimate") != 0 || one->error > 0) {
            continue;
        }
        begin_table(report, &has_any, "What a cut branch counts as",
                    "arithmetic|N|threshold|black: per cent wrong|rays a pixel|estimate: per cent "
                    "wrong|rays a pixel");
        size_t used = (size_t)snprintf(cells, sizeof cells, "%s|%u|%s|", one->arithmetic,
                                       one->depth, page_threshold(one->threshold, threshold));
        if (black != NULL) {
            used += (size_t)snprintf(cells + used, sizeof cells - used, "%.3f|%.1f", black->wrong,
                                     black->rays);
        } else {
            used += (size_t)snprintf(cells + used, sizeof cells - used, "–|–");
        }
        (void)snprintf(cells + used, sizeof cells - used, "|%.3f|%.1f", one->wrong, one->rays);
        page_row(report, false, cells);
    }
    if (has_any) {
        page_end_table(report);
    }
}

/* Writes the accuracies that were asked for, and the errors that came. */
static void write_errors(const struct report *report) {
    bool has_any = false;
    for (size_t i = 0; i < report->settings->count; i++) {
        const struct measure_setting *one = &report->settings->settings[i];
        char cells[PAGE_TEXT_SIZE];
        if (!(one->error > 0)) {
            continue;
        }
        begin_table(report, &has_any, "An accuracy asked for",
                    "arithmetic|--error|per cent wrong|worst scene|rays a pixel");
        (void)snprintf(cells, sizeof cells, "%s|%g|%.3f|%.3f|%.1f", one->arithmetic, one->error,
                       one->wrong, one->worst, one->rays);
        page_row(report, false, cells);
    }
    if (has_any) {
        page_end_table(report);
        page_paragraph(report, "The share is of pixels more than 1 LSB off, whatever was asked "
                               "for: with --error 4 a pixel may be 4 off and be as it should.");
    }
}

static void write_arithmetics(const struct report *report) {
    static const struct {
        const char *name, *words;
    } kinds[] = {{"fx", "fixed point, a format for each role"},
                 {"f32", "float"},
                 {"f64", "double"},
                 {"q16", "Q16.16 everywhere, rays snap to surfaces"},
                 {"q16_epsilon", "Q16.16 everywhere, absolute epsilon of 2^-10"}};
    page_heading(report, 2, "Arithmetics");
    page_row(report, true,
             "arithmetic|what it is|per cent off double|per cent wrong|worst scene|"
             "rays a pixel");
    for (size_t i = 0; i < sizeof kinds / sizeof kinds[0]; i++) {
        const struct measure_setting *setting =
            find_setting(report, kinds[i].name, 64, 1.0 / 65536);
        char cells[PAGE_TEXT_SIZE];
        if (setting != NULL) {
            (void)snprintf(cells, sizeof cells, "%s|%s|%.3f|%.3f|%.3f|%.1f", kinds[i].name,
                           kinds[i].words, setting->apart, setting->wrong, setting->worst,
                           setting->rays);
            page_row(report, false, cells);
        }
    }
    page_end_table(report);
    page_paragraph(
        report,
        "All at N = 64 and a threshold of 1/65536. The first share is of pixels more than 1 "
        "LSB off what double makes with the same settings: that is the arithmetic's own "
        "doing. The second is held against the converged picture and has the light in it that "
        "the threshold cuts off; an arithmetic that rounds weights up cuts less, and takes "
        "more rays for it.");
    page_picture(report, "difference-q16-epsilon.png",
                 "Q16.16 with an absolute epsilon, N = 64, threshold 1/65536, first scene.");
}

/* Writes the points beside the grid, in which one setting at a time was varied. */
static void write_others(const struct report *report) {
    const struct measure *measure = report->measure;
    bool has_any = false;
    for (size_t i = 0; i < measure->points.count; i++) {
        const struct measure_point *point = &measure->points.points[i];
        char cells[PAGE_TEXT_SIZE], threshold[32];
        if (measure_is_of_grid(measure, point)) {
            continue;
        }
        begin_table(report, &has_any, "Size, colours and model",
                    "scene|setting|size|colours|model|per cent wrong|largest error|CIEDE2000, "
                    "mean|rays|port writes");
        (void)snprintf(cells, sizeof cells,
                       "%s|%s, N = %u, %s|%ux%u|%s|%s|%.3f|%u|%.3f|%" PRIu64 "|%" PRIu64,
                       point->scene, point->arithmetic, point->depth,
                       page_threshold(point->threshold, threshold), point->width, point->height,
                       point->colour, point->model, point->wrong, point->largest,
                       point->colour_mean, point->events.rays, point->port_writes);
        page_row(report, false, cells);
    }
    if (has_any) {
        page_end_table(report);
        page_paragraph(report,
                       "Each is held against the converged picture of its own size and model in "
                       "full colour.");
    }
}

static void write_machines(const struct report *report) {
    page_heading(report, 2, "The machines");
    page_row(report, true, "machine|clocks an instruction, and a port write");
    for (size_t i = 0; cost_targets[i].name != NULL; i++) {
        char cells[PAGE_TEXT_SIZE];
        (void)snprintf(cells, sizeof cells, "%s|%s", cost_targets[i].label, cost_targets[i].source);
        page_row(report, false, cells);
    }
    page_end_table(report);
    page_paragraph(report,
                   "Where a machine has no floating-point unit and no entry for float, none was "
                   "measured.");
    page_paragraph(report,
                   "Instructions that were predicted lay less than a fifth from those that were "
                   "counted of real images (docs/measure.md of the source has the table; "
                   "make cost-check makes it): times of machines and arithmetics that are a "
                   "factor apart can be told from each other, not those that are near.");
}

/* ---- Files ---------------------------------------------------------------------------------- */

static int write_report(const struct measure *measure, bool is_html) {
    const char *name = is_html ? "report.html" : "report.md";
    struct measure_file file;
    if (!measure_create(&file, measure, name)) {
        return STATUS_FAILED;
    }
    const struct report report = {measure, &measure->settings, file.output.file, is_html};
    page_begin(&report, "Speed against accuracy");
    write_words(&report);
    write_choice_of_arithmetic(&report);
    write_advice(&report);
    write_paper(&report);
    write_fronts(&report);
    write_tails(&report);
    write_errors(&report);
    write_arithmetics(&report);
    write_others(&report);
    write_method(&report);
    write_machines(&report);
    page_end(&report);
    return measure_close(&file);
}

static int write_table(const struct measure *measure) {
    struct measure_file table;
    if (!measure_create(&table, measure, "table.csv")) {
        return STATUS_FAILED;
    }
    FILE *file = table.output.file;
    (void)fputs(
        "scene,arithmetic,depth,threshold,width,height,colour,model,tail,error,percent_wrong",
        file);
    for (size_t j = 0; cost_targets[j].name != NULL; j++) {
        (void)fprintf(file, ",seconds_%s", cost_targets[j].name);
    }
    (void)fputs("\n", file);
    for (size_t i = 0; i < measure->points.count; i++) {
        const struct measure_point *point = &measure->points.points[i];
        char key[MEASURE_KEY_SIZE];
        measure_key(point, key);
        (void)fprintf(file, "%s,%.6f", key, point->wrong);
        for (size_t j = 0; cost_targets[j].name != NULL; j++) {
            double seconds = measure_predict(measure, point, &cost_targets[j]);
            if (isnan(seconds)) {
                (void)fputs(",", file);
            } else {
                (void)fprintf(file, ",%.6g", seconds);
            }
        }
        (void)fputs("\n", file);
    }
    return measure_close(&table);
}

int measure_report(struct measure *measure) {
    int status = write_table(measure);
    if (status == STATUS_DONE) {
        status = write_report(measure, false);
    }
    return status == STATUS_DONE ? write_report(measure, true) : status;
}
