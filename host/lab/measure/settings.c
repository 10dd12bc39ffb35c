/* SPDX-License-Identifier: MIT */
/* The points of the grid gathered by setting, and which settings are on the Pareto front. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/complain.h"
#include "lab/measure/measure.h"

/* Tells whether a point has the size, colours and model of its scene's first point, as all of the
 * grid have. */
bool measure_is_of_grid(const struct measure *measure, const struct measure_point *point) {
    for (size_t i = 0; i < measure->points.count; i++) {
        const struct measure_point *first = &measure->points.points[i];
        if (strcmp(first->scene, point->scene) == 0) {
            return first->width == point->width && first->height == point->height &&
                   strcmp(first->colour, point->colour) == 0 &&
                   strcmp(first->model, point->model) == 0;
        }
    }
    return false;
}

static bool is_setting_of(const struct measure_setting *setting,
                          const struct measure_point *point) {
    return strcmp(setting->arithmetic, point->arithmetic) == 0 &&
           strcmp(setting->tail, point->tail) == 0 && setting->depth == point->depth &&
           !(setting->threshold < point->threshold) && !(setting->threshold > point->threshold) &&
           !(setting->error < point->error) && !(setting->error > point->error);
}

static bool is_gathered(const struct measure_settings *settings,
                        const struct measure_point *point) {
    for (size_t i = 0; i < settings->count; i++) {
        if (is_setting_of(&settings->settings[i], point)) {
            return true;
        }
    }
    return false;
}

/* Fills in a setting's means over the scenes, and the error of its worst scene. */
static void gather(const struct measure *measure, struct measure_setting *setting) {
    double scenes = 0;
    for (size_t i = 0; i < measure->points.count; i++) {
        const struct measure_point *point = &measure->points.points[i];
        if (!is_setting_of(setting, point) || !measure_is_of_grid(measure, point)) {
            continue;
        }
        double pixels = (double)point->width * point->height;
        scenes++;
        setting->wrong += point->wrong;
        setting->apart += point->apart;
        setting->worst = fmax(setting->worst, point->wrong);
        setting->rays += (double)(point->events.rays + point->events.shadow_rays) / pixels;
        for (size_t j = 0; cost_targets[j].name != NULL; j++) {
            setting->seconds[j] += measure_predict(measure, point, &cost_targets[j]);
        }
    }
    setting->wrong /= scenes;
    setting->apart /= scenes;
    setting->rays /= scenes;
    for (size_t j = 0; cost_targets[j].name != NULL; j++) {
        setting->seconds[j] /= scenes;
    }
}

int measure_gather(struct measure *measure) {
    struct measure_settings *settings = &measure->settings;
    free(settings->settings);
    settings->count = 0;
    settings->settings = calloc(measure->points.count + 1, sizeof *settings->settings);
    if (settings->settings == NULL) {
        return failure("out of memory");
    }
    for (size_t i = 0; i < measure->points.count; i++) {
        const struct measure_point *point = &measure->points.points[i];
        if (measure_is_of_grid(measure, point) && !is_gathered(settings, point)) {
            struct measure_setting *setting = &settings->settings[settings->count++];
            memcpy(setting->arithmetic, point->arithmetic, sizeof setting->arithmetic);
            memcpy(setting->tail, point->tail, sizeof setting->tail);
            setting->depth = point->depth;
            setting->threshold = point->threshold;
            setting->error = point->error;
            gather(measure, setting);
        }
    }
    return STATUS_DONE;
}

const struct measure_setting *measure_cheapest(const struct measure_settings *settings,
                                               size_t target, double wrong_most) {
    const struct measure_setting *best = NULL;
    for (size_t i = 0; i < settings->count; i++) {
        const struct measure_setting *setting = &settings->settings[i];
        if (!isnan(setting->seconds[target]) && setting->wrong <= wrong_most &&
            (best == NULL || setting->seconds[target] < best->seconds[target])) {
            best = setting;
        }
    }
    return best;
}

bool measure_is_on_front(const struct measure_settings *settings, size_t i, size_t target) {
    const struct measure_setting *one = &settings->settings[i];
    if (isnan(one->seconds[target])) {
        return false;
    }
    for (size_t j = 0; j < settings->count; j++) {
        const struct measure_setting *other = &settings->settings[j];
        bool is_better =
            other->wrong < one->wrong ||
            (other->wrong <= one->wrong && other->seconds[target] < one->seconds[target]);
        if (!isnan(other->seconds[target]) && other->seconds[target] <= one->seconds[target] &&
            is_better) {
            return false;
        }
    }
    return true;
}
