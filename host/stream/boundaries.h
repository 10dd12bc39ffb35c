/* SPDX-License-Identifier: MIT */
/* What the two objects on both sides of each lane's boundary make of that boundary. */
#ifndef SUPERFRAME_BOUNDARIES_H
#define SUPERFRAME_BOUNDARIES_H

#include "stream/hits.h"

/* All of it is 0 in the lanes without a boundary. */
struct boundary_lanes {
    struct colour_lanes colour;  /* Ic there */
    struct colour_lanes ambient; /* the ambient term of Eq. (1) */
    real_energy diffuse[LANES];
    real_energy specular[LANES]; /* of highlights, and the mirror coefficient of what is opaque */
    uint32_t gloss[LANES];
    real_index eta[LANES]; /* n1 / n2, seen from the arriving ray */
    real_index n[LANES];   /* n2 / n1 */
    uint32_t bends[LANES]; /* 1: the indices differ */
    uint32_t clear[LANES]; /* 1: the surface is transparent */
    uint32_t gloss_most;
};

void boundaries_find(const struct scene *scene, const struct hit_lanes *hit,
                     struct boundary_lanes *boundary);

#endif
