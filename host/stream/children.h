/* SPDX-License-Identifier: MIT */
/* What grows from the lanes' boundaries: firmware/growth.c for many rays at once. */
#ifndef SUPERFRAME_CHILDREN_H
#define SUPERFRAME_CHILDREN_H

#include "borders.h"
#include "queue.h"

/* Puts the mirrored and the refracted rays that depth and threshold let through into the queue.
 * cut gets, by lane, the weights of those that they do not, where the scene has an estimate of what
 * they are worth. */
void children_grow(const struct scene *scene, const struct ray_lanes *rays,
                   const struct hit_lanes *hit, const struct border_lanes *border,
                   struct queue *queue, struct energy_lanes cut[2]);

#endif
