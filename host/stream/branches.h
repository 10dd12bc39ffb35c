/* SPDX-License-Identifier: MIT */
/* What grows from the lanes' boundaries: firmware/growth.c for many rays at once. */
#ifndef SUPERFRAME_CHILDREN_H
#define SUPERFRAME_CHILDREN_H

#include "image.h"
#include "stream/boundaries.h"
#include "stream/queue.h"
#include "stream/watch.h"

/* What is not followed, by lane: its weight, 0 where all is followed, and an enum estimate_way. */
struct cut_lanes {
    struct energy_lanes weight;
    uint32_t way[LANES];
};

/* Puts the mirrored and the refracted rays that depth and threshold let through into the queue. The
 * tails of `watched` get the other rays, where an accuracy is asked for; else `watched` is NULL.
 * Then `cut` gets the others, where the scene has an estimate of the radiance of those rays. */
void children_grow(const struct scene *scene, const struct ray_lanes *rays,
                   const struct hit_lanes *hit, const struct boundary_lanes *boundary,
                   struct watched_pixels *watched, struct queue *queue, struct cut_lanes cut[2]);

#endif
