/* SPDX-License-Identifier: MIT */
/* The report of `superframe measure`: what to choose on which machine, in words and tables. */
#include <inttypes.h>
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "command.h"
#include "measure.h"

/* The same report twice: as Markdown and as HTML. */
struct report {
    const struct measure *measure;
    const struct measure_settings *settings;
    FILE *file;
    bool is_html;
};

enum { TEXT_SIZE = 1024 };

static void paragraph(const struct report *report, const char *format, ...)
#if defined(__GNUC__)
    __attribute__((format(printf, 2, 3)))
#endif
    ;

static void heading(const struct report *report, int level, const char *text) {
    if (report->is_html) {
        (void)fprintf(report->file, "<h%d>%s</h%d>\n", level, text, level);
    } else {
        (void)fprintf(report->file, "%.*s %s\n\n", level, "###", text);
    }
}

static void paragraph(const struct report *report, const char *format, ...) {
    char text[TEXT_SIZE];
    va_list arguments;
    va_start(arguments, format);
    (void)vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    if (report->is_html) {
        (void)fprintf(report->file, "<p>%s</p>\n", text);
    } else {
        (void)fprintf(report->file, "%s\n\n", text);
    }
}

/* Cells are parted by '|'. */
static void row(const struct report *report, bool is_head, const char *cells) {
    const char *tag = is_head ? "th" : "td";
    if (!report->is_html) {
        (void)fprintf(report->file, "| %s |\n", cells);
        for (const char *c = cells; is_head && *c != '\0'; c++) {
            (void)fputs(c == cells ? "|---|" : *c == '|' ? "---|" : "", report->file);
        }
        (void)fputs(is_head ? "\n" : "", report->file);
        return;
    }
    (void)fprintf(report->file, "%s<tr><%s>", is_head ? "<table>\n" : "", tag);
    for (; *cells != '\0'; cells++) {
        if (*cells == '|') {
            (void)fprintf(report->file, "</%s><%s>", tag, tag);
        } else {
            (void)fputc(*cells, report->file);
        }
    }
    (void)fprintf(report->file, "</%s></tr>\n", tag);
}

static void end_table(const struct report *report) {
    (void)fputs(report->is_html ? "</table>\n" : "\n", report->file);
}

static void picture(const struct report *report, const char *file, const char *caption) {
    char path[TEXT_SIZE];
    (void)snprintf(path, sizeof path, "%s/%s", report->measure->folder, file);
    if (access(path, R_OK) != 0) {
        return;
    }
    if (report->is_html) {
        (void)fprintf(report->file,
                      "<figure><img src=\"%s\" alt=\"%s\"><figcaption>%s</figcaption></figure>\n",
                      file, caption, caption);
    } else {
        (void)fprintf(report->file, "![%s](%s)\n\n%s\n\n", caption, file, caption);
    }
}

/* "1/4096", or "none". */
static const char *threshold_text(double threshold, char text[32]) {
    if (!(threshold > 0)) {
        return "none";
    }
    double inverse = 1 / threshold;
    (void)snprintf(text, 32, "1/%.*f", fabs(inverse - round(inverse)) < 1e-6 ? 0 : 3, inverse);
    return text;
}

static const char *seconds_text(double seconds, char text[32]) {
    if (isnan(seconds)) {
        return "–";
    }
    if (seconds < 120) {
        (void)snprintf(text, 32, "%.3g s", seconds);
    } else if (seconds < 7200) {
        (void)snprintf(text, 32, "%.0f min", seconds / 60);
    } else {
        (void)snprintf(text, 32, "%.1f h", seconds / 3600);
    }
    return text;
}

/* ---- Chapters ------------------------------------------------------------------------------- */

static void write_method(const struct report *report) {
    const struct measure *measure = report->measure;
    char names[TEXT_SIZE] = "";
    double oracle = 100;
    for (size_t i = 0; i < measure->scene_count; i++) {
        size_t used = strlen(names);
        (void)snprintf(names + used, sizeof names - used, "%s%s", i > 0 ? ", " : "",
                       measure->scenes[i].name);
        oracle = fmin(oracle, measure->scenes[i].oracle);
    }
    const struct measure_point *first = &measure->points.points[0];
    heading(report, 1, "Speed against accuracy");
    paragraph(report,
              "Scenes: %s; %u x %u pixels. Every picture is held against the one that double "
              "makes with depth level %d and a threshold of 1/262144, where four times less "
              "changes no pixel by more than 1 LSB. A pixel is wrong if a channel is more than 1 "
              "LSB (of 255) off.",
              names, first->width, first->height, MEASURE_CONVERGED_DEPTH);
    paragraph(report,
              "That double is exact enough was checked against 113-bit numbers (f128), 48 x 30 "
              "pixels of each scene at N = 10: %.2f %% of the pixels or more are the same to the "
              "last bit. f128 itself is too slow for the converged pictures.",
              oracle);
    paragraph(report,
              "Seconds are predicted from counted rays, boundaries, tests and port writes, by the "
              "operations that each takes and the instructions that each operation takes on the "
              "machine: %zu points, in table.csv.",
              measure->points.count);
}

static void write_advice(const struct report *report) {
    heading(report, 2, "What to choose");
    row(report, true,
        "machine|at most 10 % wrong|takes|at most 1 % wrong|takes|at most 0.1 % wrong|takes");
    for (size_t i = 0; cost_targets[i].name != NULL; i++) {
        static const double most[] = {10, 1, 0.1};
        char cells[TEXT_SIZE], threshold[32], seconds[32];
        size_t used = (size_t)snprintf(cells, sizeof cells, "%s", cost_targets[i].label);
        for (int j = 0; j < 3; j++) {
            const struct measure_setting *best = measure_cheapest(report->settings, i, most[j]);
            if (best == NULL) {
                used += (size_t)snprintf(cells + used, sizeof cells - used, "|none of these|–");
            } else {
                used += (size_t)snprintf(cells + used, sizeof cells - used,
                                         "|%s, N = %u, threshold %s, tail %s|%s", best->arithmetic,
                                         best->depth, threshold_text(best->threshold, threshold),
                                         best->tail, seconds_text(best->seconds[i], seconds));
            }
        }
        row(report, false, cells);
    }
    end_table(report);
    paragraph(report, "Shares are the mean over the scenes. How each machine's figure is made, and "
                      "what of it is assumed, stands at the end.");
    for (size_t i = 0; cost_targets[i].name != NULL; i++) {
        char file[64], caption[128];
        (void)snprintf(file, sizeof file, "pareto-%s.png", cost_targets[i].name);
        (void)snprintf(caption, sizeof caption, "%s: cost against share wrong",
                       cost_targets[i].label);
        picture(report, file, caption);
    }
}

static const struct measure_setting *find_setting(const struct report *report,
                                                  const char *arithmetic, unsigned depth,
                                                  double threshold) {
    for (size_t i = 0; i < report->settings->count; i++) {
        const struct measure_setting *setting = &report->settings->settings[i];
        if (strcmp(setting->arithmetic, arithmetic) == 0 && strcmp(setting->tail, "black") == 0 &&
            setting->depth == depth && fabs(setting->threshold - threshold) < 1e-9) {
            return setting;
        }
    }
    return NULL;
}

static void write_paper(const struct report *report) {
    const struct measure_setting *paper = find_setting(report, "fx", 10, 0);
    if (paper == NULL) {
        return;
    }
    heading(report, 2, "What the paper's N = 10 costs and loses");
    paragraph(report,
              "Depth level 10 and no threshold, as in the paper, takes %.0f rays a pixel and gets "
              "%.2f %% of the pixels wrong (%.2f %% on the worst scene): the light beyond the "
              "tenth boundary is missing.",
              paper->rays, paper->wrong, paper->worst);
    const struct measure_setting *better = NULL;
    for (size_t i = 0; i < report->settings->count; i++) {
        const struct measure_setting *setting = &report->settings->settings[i];
        if (strcmp(setting->arithmetic, "fx") == 0 && setting->wrong <= paper->wrong &&
            setting != paper && (better == NULL || setting->rays < better->rays)) {
            better = setting;
        }
    }
    if (better != NULL) {
        char threshold[32];
        paragraph(
            report,
            "N = %u with a threshold of %s, tail %s, is no worse: %.2f %% wrong with %.0f rays a "
            "pixel, %.1f times fewer.",
            better->depth, threshold_text(better->threshold, threshold), better->tail,
            better->wrong, better->rays, paper->rays / better->rays);
    }
    picture(report, "difference-paper.png",
            "The paper's setting against the converged picture, first scene. Black: equal; blue: 1 "
            "LSB; green: 2; yellow: 4; red: 9; white: 33 and more.");
    picture(report, "difference-fx.png", "fx with N = 64 and a threshold of 1/65536, first scene.");
    picture(report, "error-depth.png", "Share wrong against depth level.");
    picture(report, "error-threshold.png", "Share wrong against threshold, N = 64.");
}

/* The two ways to count what a branch would have brought that is cut, side by side. */
static void write_tails(const struct report *report) {
    bool has_any = false;
    for (size_t i = 0; i < report->settings->count; i++) {
        const struct measure_setting *one = &report->settings->settings[i];
        const struct measure_setting *black =
            find_setting(report, one->arithmetic, one->depth, one->threshold);
        char cells[TEXT_SIZE], threshold[32];
        if (strcmp(one->tail, "estimate") != 0) {
            continue;
        }
        if (!has_any) {
            heading(report, 2, "What a cut branch counts as");
            row(report, true,
                "arithmetic|N|threshold|black: per cent wrong|rays a pixel|estimate: per cent "
                "wrong|rays a pixel");
        }
        has_any = true;
        size_t used = (size_t)snprintf(cells, sizeof cells, "%s|%u|%s|", one->arithmetic,
                                       one->depth, threshold_text(one->threshold, threshold));
        if (black != NULL) {
            used += (size_t)snprintf(cells + used, sizeof cells - used, "%.3f|%.1f", black->wrong,
                                     black->rays);
        } else {
            used += (size_t)snprintf(cells + used, sizeof cells - used, "–|–");
        }
        (void)snprintf(cells + used, sizeof cells - used, "|%.3f|%.1f", one->wrong, one->rays);
        row(report, false, cells);
    }
    if (has_any) {
        end_table(report);
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
    heading(report, 2, "Arithmetics");
    row(report, true,
        "arithmetic|what it is|per cent off double|per cent wrong|worst scene|"
        "rays a pixel");
    for (size_t i = 0; i < sizeof kinds / sizeof kinds[0]; i++) {
        const struct measure_setting *setting =
            find_setting(report, kinds[i].name, 64, 1.0 / 65536);
        char cells[TEXT_SIZE];
        if (setting != NULL) {
            (void)snprintf(cells, sizeof cells, "%s|%s|%.3f|%.3f|%.3f|%.1f", kinds[i].name,
                           kinds[i].words, setting->apart, setting->wrong, setting->worst,
                           setting->rays);
            row(report, false, cells);
        }
    }
    end_table(report);
    paragraph(
        report,
        "All at N = 64 and a threshold of 1/65536. The first share is of pixels more than 1 "
        "LSB off what double makes with the same settings: that is the arithmetic's own "
        "doing. The second is held against the converged picture and has the light in it that "
        "the threshold cuts off; an arithmetic that rounds weights up cuts less, and takes "
        "more rays for it.");
    picture(report, "difference-q16-epsilon.png",
            "Q16.16 with an absolute epsilon, N = 64, threshold 1/65536, first scene.");
}

/* What was varied one at a time. */
static void write_others(const struct report *report) {
    const struct measure *measure = report->measure;
    bool has_any = false;
    for (size_t i = 0; i < measure->points.count; i++) {
        const struct measure_point *point = &measure->points.points[i];
        char cells[TEXT_SIZE], threshold[32];
        if (measure_is_of_grid(measure, point)) {
            continue;
        }
        if (!has_any) {
            heading(report, 2, "Size, colours and model");
            row(report, true,
                "scene|setting|size|colours|model|per cent wrong|largest error|CIEDE2000, "
                "mean|rays|port writes");
            has_any = true;
        }
        (void)snprintf(cells, sizeof cells,
                       "%s|%s, N = %u, %s|%ux%u|%s|%s|%.3f|%u|%.3f|%" PRIu64 "|%" PRIu64,
                       point->scene, point->arithmetic, point->depth,
                       threshold_text(point->threshold, threshold), point->width, point->height,
                       point->colour, point->model, point->wrong, point->largest,
                       point->colour_mean, point->events.rays, point->port_writes);
        row(report, false, cells);
    }
    if (has_any) {
        end_table(report);
        paragraph(report, "Each is held against the converged picture of its own size and model in "
                          "full colour.");
    }
}

static void write_machines(const struct report *report) {
    heading(report, 2, "The machines");
    row(report, true, "machine|clocks an instruction, and a port write");
    for (size_t i = 0; cost_targets[i].name != NULL; i++) {
        char cells[TEXT_SIZE];
        (void)snprintf(cells, sizeof cells, "%s|%s", cost_targets[i].label, cost_targets[i].source);
        row(report, false, cells);
    }
    end_table(report);
    paragraph(report, "Where a machine has no floating-point unit and no entry for float, none was "
                      "measured.");
}

/* ---- Files ---------------------------------------------------------------------------------- */

static int write_report(const struct measure *measure, const struct measure_settings *settings,
                        bool is_html) {
    const char *name = is_html ? "report.html" : "report.md";
    struct report report = {measure, settings, measure_create(measure, name), is_html};
    if (report.file == NULL) {
        return STATUS_FAILED;
    }
    if (is_html) {
        (void)fputs("<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
                    "<title>Speed against accuracy</title>\n<style>body{font-family:sans-serif;"
                    "max-width:60em;margin:2em auto}td,th{border:1px solid #999;padding:.2em "
                    ".5em;text-align:left}table{border-collapse:collapse}img{max-width:100%}"
                    "</style></head><body>\n",
                    report.file);
    }
    write_method(&report);
    write_advice(&report);
    write_paper(&report);
    write_tails(&report);
    write_arithmetics(&report);
    write_others(&report);
    write_machines(&report);
    if (is_html) {
        (void)fputs("</body></html>\n", report.file);
    }
    return measure_close(measure, report.file, name);
}

static int write_table(const struct measure *measure) {
    FILE *file = measure_create(measure, "table.csv");
    if (file == NULL) {
        return STATUS_FAILED;
    }
    (void)fputs("scene,arithmetic,depth,threshold,width,height,colour,model,tail,percent_wrong",
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
    return measure_close(measure, file, "table.csv");
}

int measure_report(struct measure *measure) {
    struct measure_settings settings;
    if (!measure_settings(measure, &settings)) {
        complain("out of memory");
        return STATUS_FAILED;
    }
    int status = write_table(measure);
    if (status == STATUS_DONE) {
        status = write_report(measure, &settings, false);
    }
    if (status == STATUS_DONE) {
        status = write_report(measure, &settings, true);
    }
    free(settings.settings);
    return status;
}
