/* SPDX-License-Identifier: MIT */
/* Axis-aligned bounds of solids, for scaling and for what can meet or hide what. */
#ifndef SUPERFRAME_BOUNDS_H
#define SUPERFRAME_BOUNDS_H

#include <stdbool.h>

#include "scene/description.h"

/* low > high on an axis: empty. Infinite ends: unbounded. */
struct bounds {
    double low[3], high[3];
};

extern const struct bounds bounds_nothing;
extern const struct bounds bounds_everything;

void bounds_include(struct bounds *bounds, const double point[3]);
struct bounds bounds_union(const struct bounds *a, const struct bounds *b);
struct bounds bounds_intersection(const struct bounds *a, const struct bounds *b);
bool bounds_are_finite(const struct bounds *bounds);
bool bounds_are_empty(const struct bounds *bounds);
bool bounds_overlap(const struct bounds *a, const struct bounds *b);

/* Returns true if bounds are farther apart than a gap, along some axis. */
bool bounds_are_apart(const struct bounds *a, const struct bounds *b, double gap);

/* Returns the bounds of a polyhedron's corners; everything if it is unbounded, nothing if it is
 * empty. */
struct bounds polyhedron_bounds(const struct affine *map, const struct solid_node *node);

bool polyhedron_is_bounded(const struct solid_node *node);

/* Returns bounds of a CSG tree by the rules of its operations. They may be larger than the solid's,
 * never smaller. `outer` is the placement of the node's parent. */
struct bounds solid_bounds(const struct scene_description *description, int node,
                           const struct affine *outer);

#endif
