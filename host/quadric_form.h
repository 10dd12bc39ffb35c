/* SPDX-License-Identifier: MIT */
/* Quadratic forms of space: how placements change them, and their own axes. */
#ifndef SUPERFRAME_QUADRIC_FORM_H
#define SUPERFRAME_QUADRIC_FORM_H

#include <stdbool.h>

#include "scene_description.h"

/* (x y z 1) m (x y z 1)^T <= 0; m is symmetric. */
struct quadric_form {
    double m[4][4];
};

/* A form in its own axes: sum of square[i] x_i^2, plus 2 linear x_2, plus constant, where x = axis
 * . (p - origin); the largest |square| is 1, and linear is 0 unless square[2] is. */
struct quadric_axes {
    double origin[3];
    double axis[3][3];
    double square[3];
    double linear, constant;
};

/* The form of a leaf that is a quadric, or a quadric cut by a slab, in its own coordinates. */
struct quadric_form quadric_form_of_leaf(const struct solid_node *leaf);

/* The form of the solid after the placement, whose linear part has an inverse. */
struct quadric_form quadric_form_placed(const struct quadric_form *form,
                                        const struct affine *placement);

/* The form in its own axes; false if it has no quadratic part. */
bool quadric_form_axes(const struct quadric_form *form, struct quadric_axes *axes);

/* The unit vector from `from` to `to` of a leaf that has an axis, and two at right angles to it: w,
 * u, v. Returns the distance. */
double leaf_axes(const struct solid_node *leaf, double u[3], double v[3], double w[3]);

#endif
