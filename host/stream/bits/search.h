/* SPDX-License-Identifier: MIT */
/* The next crossing of each lane's ray: firmware/ray.c for many rays at once. */
#ifndef SUPERFRAME_SEARCH_H
#define SUPERFRAME_SEARCH_H

#include "set_memory.h"
#include "stream/interval.h"
#include "stream/lanes.h"

/* The axes whose slopes are there, and those on which some lane's component is zero: bits 0, 1,
 * 2. */
struct sloping {
    uint8_t known, level;
};

/* Rays in the coordinates of a frame; see struct local_ray. */
struct local_lanes {
    struct point_lanes origin;
    struct direction_lanes direction;
    real_slope slope[3][LANES];
    uint32_t level[3][LANES], falling[3][LANES]; /* 1: the component is zero, is negative */
};

enum { SEARCH_VIEWS = 2 };

/* What a search goes by, and what the search has found. */
struct search_lanes {
    struct local_lanes world;
    struct local_lanes views[SEARCH_VIEWS]; /* in the frames that were asked for last */
    uint32_t surface[LANES];                /* that the ray starts on, or SURFACE_NONE */
    uint32_t touch[LANES];                  /* the primitives that this surface bounds */
    uint32_t inside[LANES];                 /* the primitives that the ray is inside of */
    real_length from[LANES];
    uint32_t active[LANES]; /* 0: an idle lane, which finds nothing */

    /* The nearest crossing. */
    real_length t[LANES];
    uint32_t place[LANES];   /* its surface and face (interval.h), or PLACE_NONE */
    uint32_t crossed[LANES]; /* the primitive, and whether it is left: crossed_of() */
    uint32_t toggled[LANES]; /* all primitives that are crossed there */

    /* After the arrays, so that the arrays begin where vectors like to. */
    const struct scene *scene;
    bool shadows;                         /* only what can keep light off is looked at */
    uint8_t frames[SEARCH_VIEWS];         /* of the views; FRAME_WORLD: none yet */
    struct sloping sloping[SEARCH_VIEWS]; /* of the views */
    struct sloping world_sloping;
};

/* Returns the set behind a lane's crossing. */
static inline uint32_t search_behind(const struct search_lanes *search, int lane) {
    return search->inside[lane] ^ search->toggled[lane];
}

/* Fills in what follows from the world's origins and directions and from `surface`. */
void search_begin(struct search_lanes *search, struct set_memory *memory);

/* Finds each active lane's nearest crossing at or after `from`. Adds the number of tests to
 * *solid_tests. */
void search_next(struct search_lanes *search, uint64_t *solid_tests);

#endif
