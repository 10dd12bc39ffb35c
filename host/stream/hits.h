/* SPDX-License-Identifier: MIT */
/* Where the lanes' rays have come to a boundary between two materials. */
#ifndef SUPERFRAME_HITS_H
#define SUPERFRAME_HITS_H

#include "search.h"

/* See struct hit. `is` is 1 in the lanes that have a hit, else 0; the other lanes hold nothing of
 * use. */
struct hit_lanes {
    uint32_t is[LANES];
    real_length t[LANES];
    struct point_lanes where;
    struct direction_lanes normal;        /* turned towards the arriving ray */
    uint32_t before[LANES], after[LANES]; /* objects on the near and the far side */
    uint32_t inside_before[LANES], inside_after[LANES];
    uint32_t surface[LANES];
    uint32_t material_before[LANES], material_after[LANES];
    real_unit cosine[LANES]; /* of the angle of incidence */
    struct direction_lanes mirrored;
};

/* Describes the boundaries that `search` has found, in the lanes that hit->is selects. The caller
 * has set is, inside_after, the objects and their materials. */
void hits_describe(const struct search_lanes *search, struct hit_lanes *hit);

#endif
