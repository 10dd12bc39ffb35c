/* SPDX-License-Identifier: MIT */
/* The next crossing of each lane's ray in a scene of many primitives. */
#ifndef SUPERFRAME_SEARCH_H
#define SUPERFRAME_SEARCH_H

#include "set_memory.h"
#include "stream/interval.h"

/* Rays as the world sees them. */
struct world_lanes {
    struct point_lanes origin;
    struct direction_lanes direction;
    real_slope slope[3][LANES];
    uint32_t level[LANES], falling[LANES]; /* as in struct local_ray */
};

/* What a search goes by, and what the search has found. */
struct search_lanes {
    struct world_lanes world;
    uint32_t surface[LANES]; /* that the ray starts on, or SURFACE_NONE */
    uint32_t inside[LANES];  /* the set of the primitives that the ray is inside of */
    real_length from[LANES];
    uint32_t active[LANES]; /* 0: an idle lane, which finds nothing */

    /* The nearest crossing. */
    real_length t[LANES];
    uint32_t place[LANES];   /* its surface and face (interval.h), or PLACE_NONE */
    uint32_t crossed[LANES]; /* the primitive, and whether it is left: crossed_of() */
    uint32_t behind[LANES];  /* the set behind the crossing */

    const struct scene *scene;
    struct set_memory *memory;
    bool shadows; /* only what can keep light off is looked at */
};

/* Returns the set behind a lane's crossing. */
static inline uint32_t search_behind(const struct search_lanes *search, int lane) {
    return search->behind[lane];
}

/* Fills in what follows from the world's origins and directions. */
void search_begin(struct search_lanes *search, struct set_memory *memory);

/* Finds each active lane's nearest crossing at or after `from`. Adds the number of tests to
 * *solid_tests. */
void search_next(struct search_lanes *search, uint64_t *solid_tests);

#endif
