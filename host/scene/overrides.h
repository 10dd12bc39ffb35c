/* SPDX-License-Identifier: MIT */
/* What the command line may put in the place of what a scene file says. */
#ifndef SUPERFRAME_OVERRIDES_H
#define SUPERFRAME_OVERRIDES_H

#include <stdbool.h>
#include <stdint.h>

#include "scene/description.h"

enum { SCENE_SETS_MOST = 64 };

/* All zero: the scene as it is. */
struct scene_overrides {
    bool has_depth, has_threshold, has_size, has_model, has_highlight, has_colour, has_seed;
    bool has_estimates, has_error;
    bool estimates;    /* a pruned branch counts as its estimated radiance */
    double error;      /* SCENE_ERROR_LEAST..255 levels */
    int depth;         /* 0..255 */
    double threshold;  /* 0..1 */
    int width, height; /* 1..640, 1..400 pixels */
    enum scene_model model;
    enum scene_highlight highlight;
    enum scene_colour colour;
    int colour_bits; /* 1..8 with COLOUR_BITS */
    uint32_t seed;
    const char *sets[SCENE_SETS_MOST]; /* "PATH=VALUE", for any value of the file */
    unsigned set_count;
};

/* Puts the overrides into the description; `sets` have been put in where the file was read. */
void scene_override(struct scene_description *description, const struct scene_overrides *overrides);

#endif
