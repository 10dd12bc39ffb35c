/* SPDX-License-Identifier: MIT */
/* Puts what the command line says in the place of what the scene file says. */
#include "scene/overrides.h"

void scene_override(struct scene_description *description,
                    const struct scene_overrides *overrides) {
    if (overrides->has_depth) {
        description->depth = overrides->depth;
    }
    if (overrides->has_threshold) {
        description->threshold = overrides->threshold;
    }
    if (overrides->has_size) {
        description->width = overrides->width;
        description->height = overrides->height;
    }
    if (overrides->has_model) {
        description->model = overrides->model;
    }
    if (overrides->has_highlight) {
        description->highlight = overrides->highlight;
    }
    if (overrides->has_colour) {
        description->colour = overrides->colour;
        description->colour_bits = overrides->colour_bits;
    }
    if (overrides->has_seed) {
        description->seed = overrides->seed;
    }
    if (overrides->has_estimates) {
        description->estimates = overrides->estimates;
    }
    if (overrides->has_error) {
        description->error = overrides->error;
        if (!overrides->has_depth) {
            description->depth = SCENE_ERROR_DEPTH;
        }
    }
}
