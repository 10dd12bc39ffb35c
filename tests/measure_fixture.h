/* SPDX-License-Identifier: MIT */
/* What `superframe measure` would write of a plan whose results are drawn by a seed, in a folder of
 * its own, and the means that its pages must give. */
#ifndef SUPERFRAME_TESTS_MEASURE_FIXTURE_H
#define SUPERFRAME_TESTS_MEASURE_FIXTURE_H

#include <math.h>
#include <sys/stat.h>

#include "base/complain.h"
#include "command_fixture.h"
#include "lab/measure/measure.h"
#include "options_fixture.h"
#include "page_reader.h"
#include "scene/load.h"
#include "splitmix64.h"

/* Plans the points of a command line whose -o is "m"; the caller frees them by discard_measure().
 */
static inline struct measure *plan_measure(const char *line) {
    static struct options options;
    struct options_error error;
    struct measure *measure = calloc(1, sizeof *measure);
    assert_non_null(measure);
    if (!parse(COMMAND_MEASURE, line, &options, &error)) {
        fail_msg("%s: %s", line, error.text);
    }
    measure->options = &options;
    measure->folder = options.output;
    measure->points_path = strdup("m/points.csv");
    for (int i = 0; i < options.operand_count; i++) {
        struct measure_scene *scene = &measure->scenes[measure->scene_count++];
        scene->operand = options.operands[i];
        scene_short_name(scene->operand, scene->name, sizeof scene->name);
    }
    (void)mkdir("m", 0777);
    assert_int_equal(measure_plan(measure), STATUS_DONE);
    assert_true(measure->points.count > 0);
    return measure;
}

static inline void discard_measure(struct measure *measure) {
    free(measure->points.points);
    free(measure->points_path);
    free(measure);
}

/* Draws a number of 0..1. */
static inline double draw_share(uint64_t *random) {
    return (double)(splitmix64(random) >> 11) / 9007199254740992.0;
}

/* Draws the results of all points: shares of 0.01 to 100 per cent, one in eight of them 0. */
static inline void draw_results(struct measure *measure, uint64_t seed) {
    uint64_t random = seed;
    for (size_t i = 0; i < measure->points.count; i++) {
        struct measure_point *point = &measure->points.points[i];
        double rays = pow(10, 3 + 4 * draw_share(&random));
        const struct cost_events events = {(uint64_t)rays, (uint64_t)(rays / 3),
                                           (uint64_t)(rays * draw_share(&random)),
                                           (uint64_t)(rays * 9 * draw_share(&random))};
        bool is_right = splitmix64(&random) % 8 == 0;
        point->is_done = true;
        point->events = events;
        point->leaked_rays = splitmix64(&random) % 5;
        point->port_writes = splitmix64(&random) % 1000000;
        point->seconds = draw_share(&random);
        point->wrong = is_right ? 0 : pow(10, 4 * draw_share(&random) - 2);
        point->apart = pow(10, 4 * draw_share(&random) - 2);
        point->largest = is_right ? 0 : (unsigned)(splitmix64(&random) % 256);
        point->rmse = is_right ? 0 : 9 * draw_share(&random);
        point->psnr = is_right ? (double)INFINITY : 40 * draw_share(&random);
        point->colour_mean = 3 * draw_share(&random);
        point->colour_high = 30 * draw_share(&random);
    }
    for (size_t i = 0; i < measure->scene_count; i++) {
        measure->scenes[i].oracle = i == 0 ? 100 : 99 + draw_share(&random);
    }
}

/* What is told of a setting: the means over the scenes. */
struct mean {
    double wrong, worst, apart, rays, seconds[MEASURE_TARGETS_MOST];
};

static inline bool is_same_but_scene(const struct measure_point *a, const struct measure_point *b) {
    return strcmp(a->arithmetic, b->arithmetic) == 0 && a->depth == b->depth &&
           a->threshold - b->threshold == 0 && a->width == b->width && a->height == b->height &&
           strcmp(a->colour, b->colour) == 0 && strcmp(a->model, b->model) == 0 &&
           strcmp(a->tail, b->tail) == 0 && a->error - b->error == 0;
}

/* Finds the kinds of primitives that a scene has, as the program's cost model counts them. */
static inline struct cost_mix mix_of(const struct measure *measure, const char *scene) {
    for (size_t i = 0; i < measure->scene_count; i++) {
        if (strcmp(measure->scenes[i].name, scene) == 0) {
            return measure->scenes[i].mix;
        }
    }
    fail_msg("no scene %s", scene);
    return measure->scenes[0].mix;
}

/* Predicts the seconds of a point from what was drawn for it. */
static inline double predict(const struct measure *measure, const struct measure_point *point,
                             const struct cost_target *target) {
    const struct cost_work work = {point->events, mix_of(measure, point->scene),
                                   point->port_writes};
    return cost_seconds(target, point->arithmetic, &work);
}

static inline struct mean mean_of(const struct measure *measure, const struct measure_point *like) {
    struct mean mean;
    double scenes = (double)measure->scene_count;
    size_t count = 0;
    memset(&mean, 0, sizeof mean);
    for (size_t i = 0; i < measure->points.count; i++) {
        const struct measure_point *point = &measure->points.points[i];
        if (is_same_but_scene(point, like)) {
            double rays = (double)(point->events.rays + point->events.shadow_rays);
            count++;
            mean.wrong += point->wrong / scenes;
            mean.worst = point->wrong > mean.worst ? point->wrong : mean.worst;
            mean.apart += point->apart / scenes;
            mean.rays += rays / point->width / point->height / scenes;
            for (size_t j = 0; cost_targets[j].name != NULL; j++) {
                mean.seconds[j] += predict(measure, point, &cost_targets[j]) / scenes;
            }
        }
    }
    assert_int_equal(count, measure->scene_count);
    return mean;
}

/* Tells the points of the grid from those where size, colours or model were varied. */
static inline bool is_of_first_kind(const struct measure *measure,
                                    const struct measure_point *point) {
    const struct measure_point *first = &measure->points.points[0];
    return point->width == first->width && point->height == first->height &&
           strcmp(point->colour, first->colour) == 0 && strcmp(point->model, first->model) == 0;
}

enum { SETTINGS_MOST = 256 };

/* A setting of the grid, as its point of the first scene, and its means. */
struct setting_told {
    const struct measure_point *point;
    struct mean mean;
};

static inline size_t settings_of(const struct measure *measure,
                                 struct setting_told settings[SETTINGS_MOST]) {
    size_t count = 0;
    for (size_t i = 0; i < measure->points.count; i++) {
        const struct measure_point *point = &measure->points.points[i];
        if (strcmp(point->scene, measure->scenes[0].name) == 0 &&
            is_of_first_kind(measure, point)) {
            assert_true(count < SETTINGS_MOST);
            settings[count].point = point;
            settings[count++].mean = mean_of(measure, point);
        }
    }
    return count;
}

/* Compares numbers of which one was printed. */
static inline bool is_near(double printed, double exact, double tolerance) {
    return fabs(printed - exact) <= tolerance + 1e-9 * fabs(exact);
}

/* Reads "1/N" and "none". */
static inline double threshold_of(const char *text) {
    return strcmp(text, "none") == 0 ? 0 : strncmp(text, "1/", 2) == 0 ? 1 / number(text + 2) : NAN;
}

/* Tells whether the words for a setting are those of a point. */
static inline bool names_setting(const char *text, const struct measure_point *point) {
    char arithmetic[16], threshold[32], tail[16];
    unsigned depth;
    double error;
    if (sscanf(text, "%15[^,], --error %lf, N up to %u", arithmetic, &error, &depth) == 3) {
        return strcmp(arithmetic, point->arithmetic) == 0 && is_near(error, point->error, 1e-6) &&
               depth == point->depth;
    }
    assert_int_equal(sscanf(text, "%15[^,], N = %u, threshold %31[^,], tail %15s", arithmetic,
                            &depth, threshold, tail),
                     4);
    return strcmp(arithmetic, point->arithmetic) == 0 && depth == point->depth &&
           is_near(threshold_of(threshold), point->threshold, 1e-9) && !(point->error > 0) &&
           strcmp(tail, point->tail) == 0;
}

/* ---- Reports -------------------------------------------------------------------------------- */

/* What was made of a plan. */
struct report_made {
    struct measure *measure;
    char folder[8];
    size_t count;
    struct setting_told settings[SETTINGS_MOST];
    struct page page, html;
};

/* Plans of every shape: whole, of one arithmetic, of one depth, without tails, of accuracies alone,
 * of an arithmetic that no machine has an entry for. */
static const char *const plans[] = {
    "measure fig3 figA -o m",
    "measure figA fig3 fig4a -o m --arith f64",
    "measure fig3 -o m --arith fx --depth 3",
    "measure figA fig3 -o m --arith fx --tail black --size 40x25",
    "measure fig3 -o m --arith f32 --error 2",
    "measure fig3 figA -o m --arith f128 --threshold 0.001 --colour bits:4",
};

enum { PLANS = sizeof plans / sizeof plans[0] };

static struct report_made reports[PLANS];

/* Makes the files of all plans, without gnuplot: each plan has a folder of its own. */
static inline int make_reports(void **state) {
    if (enter(state) != 0) {
        return -1;
    }
    for (unsigned i = 0; i < PLANS; i++) {
        struct report_made *made = &reports[i];
        made->measure = plan_measure(plans[i]);
        draw_results(made->measure, i + 1);
        made->count = settings_of(made->measure, made->settings);
        assert_int_equal(measure_report(made->measure), STATUS_DONE);
        read_markdown(text_of("m/report.md"), &made->page);
        read_html(text_of("m/report.html"), &made->html);
        (void)snprintf(made->folder, sizeof made->folder, "m%u", i);
        made->measure->folder = made->folder;
        assert_int_equal(rename("m", made->folder), 0);
    }
    return 0;
}

/* Runs a check on what was made of each plan. */
static inline void check_reports(void (*check)(const struct report_made *made)) {
    for (unsigned i = 0; i < PLANS; i++) {
        check(&reports[i]);
    }
}

static inline int discard_reports(void **state) {
    for (unsigned i = 0; i < PLANS; i++) {
        discard_measure(reports[i].measure);
    }
    return leave(state);
}

#endif
