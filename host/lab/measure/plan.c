/* SPDX-License-Identifier: MIT */
/* Which points `superframe measure` measures. */
#include <stdlib.h>
#include <string.h>

#include "base/complain.h"
#include "board_ports.h"
#include "lab/measure/measure.h"
#include "scene/load.h"

enum { BASE_WIDTH = 160, BASE_HEIGHT = 100, BASE_DEPTH = 10, TAIL_DEPTH = 64 };

static const double base_threshold = 1.0 / 4096;

static const char *const model_words[] = {"simple", "fresnel", "wavelength"};

static void colour_text(enum scene_colour colour, int bits, char text[16]) {
    if (colour == COLOUR_BITS) {
        (void)snprintf(text, 16, "bits:%d", bits);
    } else {
        (void)snprintf(text, 16, "%s", colour == COLOUR_DITHER ? "dither" : "full");
    }
}

static int add(struct measure *measure, const struct measure_point *point) {
    if (measure_list_find(&measure->points, point) == NULL &&
        !measure_list_add(&measure->points, point)) {
        return failure("out of memory");
    }
    return STATUS_DONE;
}

/* Tells whether the board shows a point: a dithered pixel has 2 x 2 dots. */
static bool can_be_shown(const struct measure_point *point) {
    return strcmp(point->colour, "dither") != 0 ||
           board_dots_a_pixel(point->width, point->height) == 2;
}

/* Adds a point beside the grid, where the board shows it. */
static int vary(struct measure *measure, const struct measure_point *point) {
    return can_be_shown(point) ? add(measure, point) : STATUS_DONE;
}

/* Gives a point the arithmetic that was asked for, or one of those that are varied. */
static void take_arithmetic(struct measure_point *point, const struct options *options,
                            const char *varied) {
    (void)snprintf(point->arithmetic, sizeof point->arithmetic, "%s",
                   options->arithmetic != NULL ? options->arithmetic : varied);
}

/* Adds the grid: arithmetic by depth by threshold. Without a threshold a tree doubles with each
 * level, so that depths end where the paper ends. The finest threshold says nothing new where the
 * depth ends the tree. */
static int plan_grid(struct measure *measure, struct measure_point point) {
    static const char *const arithmetics[] = {"fx", "f32", "f64", "q16", "q16_epsilon"};
    static const unsigned depths[] = {1, 2, 4, 7, 10, 16, 32, 64};
    static const double thresholds[] = {0,          1.0 / 256,   1.0 / 1024,
                                        1.0 / 4096, 1.0 / 16384, 1.0 / 65536};
    const struct options *options = measure->options;
    const struct scene_overrides *overrides = &options->overrides;
    unsigned many_a = options->arithmetic != NULL ? 1 : 5, many_d = overrides->has_depth ? 1 : 8;
    unsigned many_t = overrides->has_threshold ? 1 : 6;
    for (unsigned i = 0; i < many_a * many_d * many_t; i++) {
        unsigned a = i / (many_d * many_t), d = i / many_t % many_d, t = i % many_t;
        take_arithmetic(&point, options, arithmetics[a]);
        point.depth = overrides->has_depth ? (unsigned)overrides->depth : depths[d];
        point.threshold = overrides->has_threshold ? overrides->threshold : thresholds[t];
        bool is_endless = point.depth > BASE_DEPTH && !(point.threshold > 0);
        bool is_idle = point.depth < 64 && point.threshold > 0 && point.threshold < 1e-4 / 2;
        if ((is_endless || is_idle) && !overrides->has_depth && !overrides->has_threshold) {
            continue;
        }
        if (add(measure, &point) != STATUS_DONE) {
            return STATUS_FAILED;
        }
    }
    return STATUS_DONE;
}

/* Adds points with an estimated tail, at a depth with room for one. Arithmetics and the values of a
 * member are varied. */
static int plan_estimates(struct measure *measure, struct measure_point *point, double *member,
                          const double *values, unsigned count) {
    static const char *const arithmetics[] = {"fx", "f32", "f64"};
    const struct options *options = measure->options;
    const struct scene_overrides *overrides = &options->overrides;
    strcpy(point->tail, "estimate");
    point->depth = overrides->has_depth ? (unsigned)overrides->depth : TAIL_DEPTH;
    for (unsigned i = 0; i < (options->arithmetic != NULL ? 1 : 3) * count; i++) {
        take_arithmetic(point, options, arithmetics[i / count]);
        *member = values[i % count];
        if (add(measure, point) != STATUS_DONE) {
            return STATUS_FAILED;
        }
    }
    return STATUS_DONE;
}

/* Adds points that show what an estimated tail gains. */
static int plan_tails(struct measure *measure, struct measure_point point) {
    static const double thresholds[] = {1.0 / 256,  1.0 / 1024,  1.0 / 2048,
                                        1.0 / 4096, 1.0 / 16384, 1.0 / 65536};
    const struct scene_overrides *overrides = &measure->options->overrides;
    if (overrides->has_estimates) {
        return STATUS_DONE;
    }
    return overrides->has_threshold
               ? plan_estimates(measure, &point, &point.threshold, &overrides->threshold, 1)
               : plan_estimates(measure, &point, &point.threshold, thresholds, 6);
}

/* Adds points with an accuracy asked for instead of a threshold. */
static int plan_errors(struct measure *measure, struct measure_point point) {
    static const double errors[] = {4, 2, 1, 0.5};
    const struct scene_overrides *overrides = &measure->options->overrides;
    if (overrides->has_threshold || (overrides->has_estimates && !overrides->estimates)) {
        return STATUS_DONE;
    }
    point.threshold = 0;
    return overrides->has_error
               ? plan_estimates(measure, &point, &point.error, &overrides->error, 1)
               : plan_estimates(measure, &point, &point.error, errors, 4);
}

/* Adds points with one setting varied, the others as in the middle of the grid. */
static int plan_star(struct measure *measure, struct measure_point point) {
    static const unsigned sizes[][2] = {{80, 50}, {320, 200}, {640, 400}};
    static const char *const colours[] = {"bits:6", "bits:4", "bits:2", "bits:1", "dither"};
    const struct options *options = measure->options;
    const struct scene_overrides *overrides = &options->overrides;
    take_arithmetic(&point, options, "fx");
    point.depth = overrides->has_depth ? (unsigned)overrides->depth : BASE_DEPTH;
    point.threshold = overrides->has_threshold ? overrides->threshold : base_threshold;
    int status = STATUS_DONE;
    for (int i = 0; i < 3 && !overrides->has_size && status == STATUS_DONE; i++) {
        struct measure_point other = point;
        other.width = sizes[i][0];
        other.height = sizes[i][1];
        status = vary(measure, &other);
    }
    for (int i = 0; i < 5 && !overrides->has_colour && status == STATUS_DONE; i++) {
        struct measure_point other = point;
        (void)snprintf(other.colour, sizeof other.colour, "%s", colours[i]);
        status = vary(measure, &other);
    }
    for (int i = 0; i < 3 && !overrides->has_model && status == STATUS_DONE; i++) {
        struct measure_point other = point;
        (void)snprintf(other.model, sizeof other.model, "%s", model_words[i]);
        status = vary(measure, &other);
    }
    return status;
}

/* Loads a scene with the options that no column of points.csv tells: highlight and seed. Points
 * with another value of such an option count as points of another scene. NULL with *error filled on
 * failure. */
static struct scene_description *load_as_measured(const struct measure_scene *scene,
                                                  const struct scene_overrides *options,
                                                  struct scene_error *error) {
    struct scene_overrides untold;
    memset(&untold, 0, sizeof untold);
    untold.has_highlight = options->has_highlight;
    untold.highlight = options->highlight;
    untold.has_seed = options->has_seed;
    untold.seed = options->seed;
    untold.set_count = options->set_count;
    memcpy(untold.sets, options->sets, sizeof untold.sets);
    return load_scene_with(scene->operand, &untold, error);
}

/* Fills in what is known of a scene before rendering, and the point at which its settings begin.
 * Returns an exit status. */
static int look_at_scene(struct measure_scene *scene, const struct scene_overrides *overrides,
                         struct measure_point *point) {
    struct scene_error error;
    struct scene_description *description = load_as_measured(scene, overrides, &error);
    struct compiled_scene *compiled = NULL;
    memset(point, 0, sizeof *point);
    if (description != NULL) {
        compiled = scene_compile(description, &error);
    }
    if (compiled == NULL) {
        scene_description_free(description);
        return bad_input("%s", error.text);
    }
    (void)snprintf(point->scene, sizeof point->scene, "%s", scene->name);
    point->width = overrides->has_size ? (unsigned)overrides->width : BASE_WIDTH;
    point->height = overrides->has_size ? (unsigned)overrides->height : BASE_HEIGHT;
    colour_text(overrides->has_colour ? overrides->colour : COLOUR_FULL, overrides->colour_bits,
                point->colour);
    enum scene_model model = overrides->has_model ? overrides->model : description->model;
    (void)snprintf(point->model, sizeof point->model, "%s", model_words[model]);
    bool estimates = overrides->has_estimates && overrides->estimates;
    strcpy(point->tail, estimates ? "estimate" : "black");
    scene->mix = cost_mix_of(compiled);
    bool has_digest = scene_digest(compiled, scene->digest);
    scene_description_free(description);
    compiled_scene_free(compiled);
    if (!has_digest) {
        complain("out of memory");
    }
    return has_digest ? STATUS_DONE : STATUS_FAILED;
}

int measure_plan(struct measure *measure) {
    for (size_t i = 0; i < measure->scene_count; i++) {
        struct measure_point point;
        int status = look_at_scene(&measure->scenes[i], &measure->options->overrides, &point);
        if (status != STATUS_DONE) {
            return status;
        }
        if (!can_be_shown(&point)) {
            return bad_input("measure: --colour dither with %u x %u pixels; allowed is: up to "
                             "%d x %d, or another colour",
                             point.width, point.height, BOARD_WIDTH / 2, BOARD_HEIGHT / 2);
        }
        if (plan_grid(measure, point) != STATUS_DONE || plan_tails(measure, point) != STATUS_DONE ||
            plan_errors(measure, point) != STATUS_DONE ||
            plan_star(measure, point) != STATUS_DONE) {
            return STATUS_FAILED;
        }
    }
    return STATUS_DONE;
}
