/* SPDX-License-Identifier: MIT */
/* Quadratic forms of space: how placements change them, and their own axes. */
#ifndef SUPERFRAME_QUADRIC_FORM_H
#define SUPERFRAME_QUADRIC_FORM_H

#include <stdbool.h>

#include "scene/description.h"

/* A form in its own axes: sum of square[i] x_i^2, plus 2 linear x_2, plus constant, where
 * x = axis . (p - origin). The largest |square| is 1, and linear is 0 unless square[2] is 0. */
struct quadric_axes {
    double origin[3];
    double axis[3][3];
    double square[3];
    double linear, constant;
};

/* Finds the form of a leaf in its own axes, after a placement whose linear part has an inverse. The
 * leaf is a quadric, or a quadric cut by a slab. Returns false if the form has no quadratic part.
 * The form is worked out around the leaf's own place: its centre, or the end of its axis. Then the
 * form is moved as a whole, so that what is small and far away keeps its digits. */
bool quadric_axes_of_leaf(const struct solid_node *leaf, const struct affine *placement,
                          struct quadric_axes *axes);

/* Finds three unit vectors at right angles for a leaf that has an axis. w points from `from` to
 * `to`; u and v are at right angles to w. Returns the distance from `from` to `to`. */
double leaf_axes(const struct solid_node *leaf, double u[3], double v[3], double w[3]);

#endif
