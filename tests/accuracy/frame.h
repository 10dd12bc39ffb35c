/* SPDX-License-Identifier: MIT */
/* Pictures in levels, neither rounded nor clamped, and the converged ones they are held against. */
#ifndef SUPERFRAME_FRAME_H
#define SUPERFRAME_FRAME_H

#include <stdbool.h>

#include "render/arithmetic.h"
#include "scene/load.h"

/* The depth level of all pictures here: what --error takes by itself. */
enum { FRAME_DEPTH = SCENE_ERROR_DEPTH };

/* What is rendered. */
struct frame_settings {
    const char *scene, *arithmetic;
    int width, height;
    double threshold; /* without an error asked for */
    double error;     /* levels; 0: none is asked for */
    bool estimates;   /* pruned branches count as their estimated radiance, not as black */
    bool shown;       /* levels rounded and clamped, as the screen has them, will do */
};

/* One pixel: its levels, and what the weights in it that were cut by the threshold and by the depth
 * level were; the latter in converged pictures alone. */
struct frame_pixel {
    double level[3];
    double cut[3], ended[3];
    double uncertainty; /* the estimated error in levels, where an error was asked for */
};

struct frame {
    int width, height;
    struct frame_pixel *pixels;
    double rays; /* a pixel, the pre-pass counted */
    double learning_rays;
    unsigned long exhausted_pixels;
    struct estimate estimate;
};

/* Renders, with two threads. False with the reason printed. frame->pixels is to be freed. */
bool frame_render(const struct frame_settings *settings, struct frame *frame);

/* The picture to which thresholds converge, in f64: down to a weight of 2^-20, what is left worth
 * the mean. What the depth level ends is black, or worth the mean too: the file in the folder holds
 * both. Rendered if it is not in the folder. */
bool frame_converged(const char *folder, const char *scene, int width, int height,
                     struct frame *frame);

/* How a frame differs from a converged one, as a screen clamps both. */
struct frame_errors {
    double share;  /* per cent of the pixels within `most`, black beyond the depth level */
    double open;   /* the same, the mean beyond the depth level */
    double square; /* the root of the mean square, black beyond the depth level */
    double worst;  /* levels */
    int worst_x, worst_y;
    double doubted; /* per cent of the pixels within their own estimated error and 0.01 level */
};

void frame_compare(const struct frame *frame, const struct frame *converged, double most,
                   struct frame_errors *errors);

/* Per cent of the pixels whose channels, rounded to levels, are within 1; of the better of both
 * kinds of converged picture. */
double frame_share_of_levels(const struct frame *frame, const struct frame *converged);

#endif
