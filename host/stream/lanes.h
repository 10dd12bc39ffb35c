/* SPDX-License-Identifier: MIT */
/* Rays side by side: one array a quantity, one lane a ray, so that a compiler's vectors fit. */
#ifndef SUPERFRAME_LANES_H
#define SUPERFRAME_LANES_H

#include "render/engine.h"
#include "scene.h"

/* All loops over lanes run from 0 to LANES, a constant that vectors of any width divide. LANES is
 * small enough for what a step works on to stay in the nearest cache. A word of 64 bits has a bit
 * for each lane. */
enum { LANES = 64 };

/* The room for a quantity of rays. The queue puts whole vectors behind the rays that wait in a
 * block. Such a vector may reach beyond the last lane; what counts does not. */
enum { LANES_ROOM = LANES + 16 };

struct point_lanes {
    real_length x[LANES_ROOM], y[LANES_ROOM], z[LANES_ROOM];
};

struct direction_lanes {
    real_unit x[LANES_ROOM], y[LANES_ROOM], z[LANES_ROOM];
};

/* Where all of a scene's weights are grey, red stands for all three; green and blue hold
 * nothing. */
struct energy_lanes {
    real_energy red[LANES_ROOM], green[LANES_ROOM], blue[LANES_ROOM];
};

struct colour_lanes {
    real_colour red[LANES], green[LANES], blue[LANES];
};

static inline struct point point_in(const struct point_lanes *lanes, int i) {
    const struct point point = {lanes->x[i], lanes->y[i], lanes->z[i]};
    return point;
}

static inline struct direction direction_in(const struct direction_lanes *lanes, int i) {
    const struct direction direction = {lanes->x[i], lanes->y[i], lanes->z[i]};
    return direction;
}

/* Rays that are to be followed; struct branch and struct ray say what each member means. */
struct ray_lanes {
    struct point_lanes origin;
    struct direction_lanes direction;
    struct energy_lanes weight;
    real_length from[LANES_ROOM]; /* where the search for the next crossing begins */
    uint32_t inside[LANES_ROOM];  /* a set of primitives, as set_memory.h has it */
    uint32_t path[LANES_ROOM];    /* the surface it starts on, and more: path_of() */
    uint32_t target[LANES_ROOM];  /* where its parts are summed | TARGET_CONTINUED */
};

/* Rays as in struct ray_lanes whose quantities lie apart: for each quantity, where its lanes
 * are. */
struct ray_columns {
    const struct point_lanes *origin;
    const struct direction_lanes *direction;
    const struct energy_lanes *weight;
    const real_length *from;
    const uint32_t *inside, *path, *target;
};

/* Set for a ray behind a crossing where the material did not change: the ray has been counted. */
#define TARGET_CONTINUED UINT32_C(0x80000000)

/* The most pixels of a band. A ray's parts are summed at its pixel's number in the band. Where an
 * accuracy is asked for, they are summed at that number + its enum tail_place * TARGET_PIXELS. */
enum { TARGET_PIXELS = STREAM_ROWS_MOST * FEATURE_WIDTH };

static inline struct ray_columns columns_of(const struct ray_lanes *rays) {
    const struct ray_columns columns = {&rays->origin, &rays->direction, &rays->weight, rays->from,
                                        rays->inside,  rays->path,       rays->target};
    return columns;
}

/* Copies the lanes alone: an assignment would copy all of their room. */
static inline void copy_points(struct point_lanes *restrict to,
                               const struct point_lanes *restrict from) {
    for (int i = 0; i < LANES; i++) {
        to->x[i] = from->x[i];
        to->y[i] = from->y[i];
        to->z[i] = from->z[i];
    }
}

static inline void copy_directions(struct direction_lanes *restrict to,
                                   const struct direction_lanes *restrict from) {
    for (int i = 0; i < LANES; i++) {
        to->x[i] = from->x[i];
        to->y[i] = from->y[i];
        to->z[i] = from->z[i];
    }
}

/* Returns the set of the lanes that are 1, a bit for each lane; each is 0 or 1. */
static inline uint64_t lanes_set(const uint32_t lanes[restrict LANES]) {
    uint32_t low = 0, high = 0;
    for (int i = 0; i < LANES / 2; i++) {
        low |= lanes[i] << i;
        high |= lanes[i + LANES / 2] << i;
    }
    return (uint64_t)high << 32 | low;
}

/* Tells whether any lane is not 0. */
static inline bool lanes_any(const uint32_t lanes[restrict LANES]) {
    uint32_t any = 0;
    for (int i = 0; i < LANES; i++) {
        any |= lanes[i];
    }
    return any != 0;
}

/* Returns the number of the first lane in a set that is not empty. */
static inline uint32_t lanes_first(uint64_t set) {
    return (uint32_t)__builtin_ctzll(set);
}

#endif
