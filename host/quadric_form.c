/* SPDX-License-Identifier: MIT */
/* Quadratic forms of space: how placements change them, and their own axes. */
#include "quadric_form.h"

#include <math.h>
#include <string.h>

#include "affine.h"

/* What is this much smaller than the largest coefficient is rounding, not shape. */
#define NEGLIGIBLE 1e-13

/* (x y z 1) m (x y z 1)^T <= 0; m is symmetric. */
struct quadric_form {
    double m[4][4];
};

double leaf_axes(const struct solid_node *leaf, double u[3], double v[3], double w[3]) {
    for (int i = 0; i < 3; i++) {
        w[i] = leaf->b[i] - leaf->a[i];
    }
    double length = vector_length(w);
    vector_normalise(w);
    int least = 0;
    for (int i = 1; i < 3; i++) {
        least = fabs(w[i]) < fabs(w[least]) ? i : least;
    }
    vector_cross(w, affine_identity.m[least], u);
    vector_normalise(u);
    vector_cross(w, u, v);
    return length;
}

/* The inverse of a placement's linear part, by cofactors. */
static struct affine linear_inverse(const struct affine *placement) {
    struct affine inverse;
    double column[3][3], cofactor[3];
    for (int i = 0; i < 3; i++) {
        affine_axis(placement, i, column[i]);
    }
    vector_cross(column[1], column[2], cofactor);
    double determinant = vector_dot(cofactor, column[0]);
    for (int i = 0; i < 3; i++) {
        vector_cross(column[(i + 1) % 3], column[(i + 2) % 3], cofactor);
        for (int j = 0; j < 3; j++) {
            inverse.m[i][j] = cofactor[j] / determinant;
        }
        inverse.m[i][3] = 0;
    }
    return inverse;
}

/* The form after the linear part of a placement. */
static struct quadric_form form_placed(const struct quadric_form *form,
                                       const struct affine *placement) {
    struct affine inverse = linear_inverse(placement);
    double map[4][4] = {{0}}, half[4][4];
    struct quadric_form placed;
    memcpy(map, inverse.m, sizeof inverse.m);
    map[3][3] = 1;
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 4; j++) {
            half[i][j] = 0;
            for (int k = 0; k < 4; k++) {
                half[i][j] += form->m[i][k] * map[k][j];
            }
        }
    }
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 4; j++) {
            placed.m[i][j] = 0;
            for (int k = 0; k < 4; k++) {
                placed.m[i][j] += map[k][i] * half[k][j];
            }
        }
    }
    return placed;
}

/* A form around the axis of a leaf: x^2 + y^2 + square z^2 + 2 linear z + constant, z from `from`.
 */
static struct quadric_form around_axis(const struct solid_node *leaf, double square, double linear,
                                       double constant) {
    struct quadric_form local = {
        {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, square, linear}, {0, 0, linear, constant}}};
    struct affine placement;
    double axis[3][3];
    leaf_axes(leaf, axis[0], axis[1], axis[2]);
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            placement.m[i][j] = axis[j][i];
        }
        placement.m[i][3] = 0;
    }
    return form_placed(&local, &placement);
}

static struct quadric_form ellipsoid(const double radii[3]) {
    struct quadric_form local = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, -1}}};
    struct affine placement = affine_identity;
    for (int i = 0; i < 3; i++) {
        placement.m[i][i] = radii[i];
    }
    return form_placed(&local, &placement);
}

static struct quadric_form hyperboloid(const struct solid_node *leaf) {
    double u[3], v[3], w[3];
    double half = leaf_axes(leaf, u, v, w) / 2;
    double end = leaf->radius_b * leaf->radius_b;
    if (leaf->sheets == 1) {
        /* x^2 + y^2 = waist^2 + k (z - half)^2 */
        double waist = leaf->radius * leaf->radius;
        double k = (end - waist) / (half * half);
        return around_axis(leaf, -k, k * half, -waist - k * half * half);
    }
    /* x^2 + y^2 = k ((z - half)^2 - (gap / 2)^2) */
    double gap = leaf->radius / 2;
    double k = end / ((half - gap) * (half + gap));
    return around_axis(leaf, -k, k * half, -k * (half - gap) * (half + gap));
}

/* Around leaf->a, which a general quadric has at the origin. */
static struct quadric_form form_of_leaf(const struct solid_node *leaf) {
    double u[3], v[3], w[3];
    const double *f = leaf->form;
    switch (leaf->kind) {
    case SOLID_BALL:
        return ellipsoid((double[3]){leaf->radius, leaf->radius, leaf->radius});
    case SOLID_ELLIPSOID:
        return ellipsoid(leaf->b);
    case SOLID_CYLINDER:
        return around_axis(leaf, 0, 0, -leaf->radius * leaf->radius);
    case SOLID_CONE: {
        double k = (leaf->radius_b - leaf->radius) / leaf_axes(leaf, u, v, w);
        return around_axis(leaf, -k * k, -k * leaf->radius, -leaf->radius * leaf->radius);
    }
    case SOLID_PARABOLOID: {
        double k = leaf->radius_b * leaf->radius_b / leaf_axes(leaf, u, v, w);
        return around_axis(leaf, 0, -k / 2, 0);
    }
    case SOLID_HYPERBOLOID:
        return hyperboloid(leaf);
    default: {
        const struct quadric_form general = {{{f[0], f[3] / 2, f[5] / 2, f[6] / 2},
                                              {f[3] / 2, f[1], f[4] / 2, f[7] / 2},
                                              {f[5] / 2, f[4] / 2, f[2], f[8] / 2},
                                              {f[6] / 2, f[7] / 2, f[8] / 2, f[9]}}};
        return general;
    }
    }
}

/* One Jacobi rotation that makes a[p][q] zero; the rows of axis turn with it. */
static void rotate(double a[3][3], double axis[3][3], int p, int q) {
    if (a[p][q] == 0) {
        return;
    }
    double theta = (a[q][q] - a[p][p]) / (2 * a[p][q]);
    double t = (theta < 0 ? -1 : 1) / (fabs(theta) + sqrt(theta * theta + 1));
    double c = 1 / sqrt(t * t + 1), s = t * c;
    for (int k = 0; k < 3; k++) {
        double kp = a[k][p], kq = a[k][q];
        a[k][p] = c * kp - s * kq;
        a[k][q] = s * kp + c * kq;
    }
    for (int k = 0; k < 3; k++) {
        double pk = a[p][k], qk = a[q][k];
        a[p][k] = c * pk - s * qk;
        a[q][k] = s * pk + c * qk;
        double pa = axis[p][k], qa = axis[q][k];
        axis[p][k] = c * pa - s * qa;
        axis[q][k] = s * pa + c * qa;
    }
    a[p][q] = a[q][p] = 0;
}

/* Eigenvalues and axes of the quadratic part; a few sweeps reach the last bit. */
static void diagonalise(const struct quadric_form *form, double value[3], double axis[3][3]) {
    double a[3][3];
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            a[i][j] = form->m[i][j];
            axis[i][j] = i == j;
        }
    }
    for (int sweep = 0; sweep < 30; sweep++) {
        rotate(a, axis, 0, 1);
        rotate(a, axis, 1, 2);
        rotate(a, axis, 0, 2);
    }
    for (int i = 0; i < 3; i++) {
        value[i] = a[i][i];
    }
}

static void swap_axes(struct quadric_axes *axes, int i, int j) {
    double square = axes->square[i];
    axes->square[i] = axes->square[j];
    axes->square[j] = square;
    for (int k = 0; k < 3; k++) {
        double x = axes->axis[i][k];
        axes->axis[i][k] = axes->axis[j][k];
        axes->axis[j][k] = x;
    }
}

/* Turns the axes without a square so that the last one takes all of the linear part. */
static void gather_linear(struct quadric_axes *axes, double linear[3]) {
    double along[3] = {0, 0, 0};
    for (int i = 0; i < 3; i++) {
        for (int k = 0; axes->square[i] == 0 && k < 3; k++) {
            along[k] += linear[i] * axes->axis[i][k];
        }
    }
    axes->linear = vector_length(along);
    if (axes->linear <= 0) {
        return;
    }
    vector_normalise(along);
    memcpy(axes->axis[2], along, sizeof along);
    if (axes->square[1] == 0) {
        vector_cross(axes->axis[2], axes->axis[0], axes->axis[1]);
    }
}

/* The form in its own axes; false if it has no quadratic part. */
static bool form_axes(const struct quadric_form *form, struct quadric_axes *axes) {
    double linear[3], largest = 0;
    diagonalise(form, axes->square, axes->axis);
    for (int i = 0; i < 3; i++) {
        largest = fmax(largest, fabs(axes->square[i]));
    }
    if (!(largest > 0)) {
        return false;
    }
    for (int i = 0; i < 3; i++) {
        axes->square[i] = fabs(axes->square[i]) < NEGLIGIBLE * largest ? 0 : axes->square[i];
    }
    for (int i = 0; i < 2; i++) {
        for (int j = 0; j < 2; j++) {
            if (axes->square[j] == 0) {
                swap_axes(axes, j, j + 1);
            }
        }
    }
    const double part[3] = {form->m[0][3], form->m[1][3], form->m[2][3]};
    axes->constant = form->m[3][3];
    for (int i = 0; i < 3; i++) {
        axes->origin[i] = 0;
        linear[i] = vector_dot(part, axes->axis[i]);
    }
    for (int i = 0; i < 3; i++) {
        if (axes->square[i] != 0) {
            double shift = -linear[i] / axes->square[i];
            axes->constant += linear[i] * shift;
            for (int k = 0; k < 3; k++) {
                axes->origin[k] += shift * axes->axis[i][k];
            }
        }
    }
    gather_linear(axes, linear);
    if (axes->linear > NEGLIGIBLE * largest) {
        double shift = -axes->constant / (2 * axes->linear);
        for (int k = 0; k < 3; k++) {
            axes->origin[k] += shift * axes->axis[2][k];
        }
        axes->constant = 0;
    } else {
        axes->linear = 0;
    }
    for (int i = 0; i < 3; i++) {
        axes->square[i] /= largest;
    }
    axes->linear /= largest;
    axes->constant /= largest;
    return true;
}

bool quadric_axes_of_leaf(const struct solid_node *leaf, const struct affine *placement,
                          struct quadric_axes *axes) {
    double place[3];
    struct quadric_form form = form_of_leaf(leaf);
    form = form_placed(&form, placement);
    if (!form_axes(&form, axes)) {
        return false;
    }
    affine_point(placement, leaf->a, place);
    for (int i = 0; i < 3; i++) {
        axes->origin[i] += place[i];
    }
    return true;
}
