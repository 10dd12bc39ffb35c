/* SPDX-License-Identifier: MIT */
/* The reach of primitives, in scaled units. */
#ifndef SUPERFRAME_EXTENTS_H
#define SUPERFRAME_EXTENTS_H

#include "compiler/bounds.h"
#include "compiler/tables.h"

/* Returns how far a primitive reaches along a direction of length 1. The result is infinite where
 * the primitive has no end, or none that is known. */
double primitive_reach(const struct compiled_scene *scene, uint32_t primitive,
                       const double direction[3]);

/* Returns bounds of a primitive along the world's axes. */
struct bounds primitive_bounds(const struct compiled_scene *scene, uint32_t primitive);

/* Finds bounds of a quadric that a box cuts, along its frame's axes and from its centre. The bounds
 * are infinite where the quadric has no end. */
void quadric_extent(const struct compiled_scene *scene, const struct compiled_quadric *quadric,
                    const struct compiled_box *box, uint32_t frame, double low[3], double high[3]);

/* Returns how far from its centre a quadric with that extent reaches; perhaps infinite. */
double quadric_ball(const struct compiled_quadric *quadric, const double low[3],
                    const double high[3]);

#endif
