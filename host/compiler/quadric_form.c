/* SPDX-License-Identifier: MIT */
/* Quadratic forms of space: how placements change them, and their own axes. */
#include "compiler/quadric_form.h"

#include <math.h>
#include <string.h>

#include "compiler/affine.h"

/* What is this much smaller than the largest coefficient is rounding, not shape. */
#define NEGLIGIBLE 1e-13

/* Forms are worked out in long double, which has some digits more on most hosts. Where a cone is
 * narrow, or a placement stretches it, double loses the digits that say where its tip is. */
typedef long double wide;

/* (x y z 1) m (x y z 1)^T <= 0; m is symmetric. */
struct quadric_form {
    wide m[4][4];
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

static wide wide_dot(const wide a[3], const wide b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void wide_cross(const wide a[3], const wide b[3], wide product[3]) {
    product[0] = a[1] * b[2] - a[2] * b[1];
    product[1] = a[2] * b[0] - a[0] * b[2];
    product[2] = a[0] * b[1] - a[1] * b[0];
}

/* Inverts a placement's linear part, by cofactors. */
static void invert_linear(const struct affine *placement, wide inverse[4][4]) {
    wide column[3][3], cofactor[3];
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            column[i][j] = placement->m[j][i];
        }
    }
    wide_cross(column[1], column[2], cofactor);
    wide determinant = wide_dot(cofactor, column[0]);
    for (int i = 0; i < 3; i++) {
        wide_cross(column[(i + 1) % 3], column[(i + 2) % 3], cofactor);
        for (int j = 0; j < 3; j++) {
            inverse[i][j] = cofactor[j] / determinant;
        }
        inverse[i][3] = inverse[3][i] = 0;
    }
    inverse[3][3] = 1;
}

/* Returns the form after the linear part of a placement. */
static struct quadric_form form_placed(const struct quadric_form *form,
                                       const struct affine *placement) {
    wide map[4][4], half[4][4];
    struct quadric_form placed;
    invert_linear(placement, map);
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

/* Finds the vector from one end of a leaf's axis to the other; returns its length. */
static wide leaf_way(const struct solid_node *leaf, wide way[3]) {
    for (int i = 0; i < 3; i++) {
        way[i] = (wide)leaf->b[i] - leaf->a[i];
    }
    return sqrtl(wide_dot(way, way));
}

/* Returns a form around the axis of a leaf, |p|^2 + (square - 1) z^2 + 2 linear z + constant. z is
 * counted along the axis from `from`. */
static struct quadric_form around_axis(const struct solid_node *leaf, wide square, wide linear,
                                       wide constant) {
    struct quadric_form form;
    wide way[3], length = leaf_way(leaf, way);
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            form.m[i][j] = (square - 1) * way[i] * way[j] / (length * length) + (i == j ? 1 : 0);
        }
        form.m[i][3] = form.m[3][i] = linear * way[i] / length;
    }
    form.m[3][3] = constant;
    return form;
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
    wide way[3], half = leaf_way(leaf, way) / 2;
    wide end = (wide)leaf->radius_b * leaf->radius_b;
    if (leaf->sheets == 1) {
        /* x^2 + y^2 = waist^2 + k (z - half)^2 */
        wide waist = (wide)leaf->radius * leaf->radius;
        wide k = (end - waist) / (half * half);
        return around_axis(leaf, -k, k * half, -waist - k * half * half);
    }
    /* x^2 + y^2 = k ((z - half)^2 - (gap / 2)^2) */
    wide gap = (wide)leaf->radius / 2;
    wide k = end / ((half - gap) * (half + gap));
    return around_axis(leaf, -k, k * half, -k * (half - gap) * (half + gap));
}

/* Returns the form of a leaf around leaf->a, which a general quadric has at the origin. */
static struct quadric_form form_of_leaf(const struct solid_node *leaf) {
    wide way[3], radius = leaf->radius, radius_b = leaf->radius_b;
    const double *f = leaf->form;
    switch (leaf->kind) {
    case SOLID_BALL:
        return ellipsoid((double[3]){leaf->radius, leaf->radius, leaf->radius});
    case SOLID_ELLIPSOID:
        return ellipsoid(leaf->b);
    case SOLID_CYLINDER:
        return around_axis(leaf, 0, 0, -radius * radius);
    case SOLID_CONE: {
        wide k = (radius_b - radius) / leaf_way(leaf, way);
        return around_axis(leaf, -k * k, -k * radius, -radius * radius);
    }
    case SOLID_PARABOLOID: {
        wide k = radius_b * radius_b / leaf_way(leaf, way);
        return around_axis(leaf, 0, -k / 2, 0);
    }
    case SOLID_HYPERBOLOID:
        return hyperboloid(leaf);
    case SOLID_QUADRIC:
    case SOLID_BOX:
    case SOLID_HALF_SPACE:
    case SOLID_POLYHEDRON:
    case SOLID_UNION:
    case SOLID_INTERSECTION:
    case SOLID_DIFFERENCE:
    case SOLID_PART:
        break;
    }
    const struct quadric_form general = {{{f[0], f[3] / 2, f[5] / 2, f[6] / 2},
                                          {f[3] / 2, f[1], f[4] / 2, f[7] / 2},
                                          {f[5] / 2, f[4] / 2, f[2], f[8] / 2},
                                          {f[6] / 2, f[7] / 2, f[8] / 2, f[9]}}};
    return general;
}

/* Turns the form by the Jacobi rotation that makes a[p][q] zero; the rows of axis turn with it. */
static void rotate(wide a[3][3], wide axis[3][3], int p, int q) {
    if (a[p][q] == 0) {
        return;
    }
    wide theta = (a[q][q] - a[p][p]) / (2 * a[p][q]);
    wide t = (theta < 0 ? -1 : 1) / (fabsl(theta) + sqrtl(theta * theta + 1));
    wide c = 1 / sqrtl(t * t + 1), s = t * c;
    for (int k = 0; k < 3; k++) {
        wide kp = a[k][p], kq = a[k][q];
        a[k][p] = c * kp - s * kq;
        a[k][q] = s * kp + c * kq;
    }
    for (int k = 0; k < 3; k++) {
        wide pk = a[p][k], qk = a[q][k];
        a[p][k] = c * pk - s * qk;
        a[q][k] = s * pk + c * qk;
        wide pa = axis[p][k], qa = axis[q][k];
        axis[p][k] = c * pa - s * qa;
        axis[q][k] = s * pa + c * qa;
    }
    a[p][q] = a[q][p] = 0;
}

/* A form in its own axes, before it is rounded to double. */
struct wide_axes {
    wide origin[3], axis[3][3], square[3];
    wide linear, constant;
};

/* Finds eigenvalues and axes of the quadratic part; a few sweeps reach the last bit. */
static void diagonalise(const struct quadric_form *form, struct wide_axes *axes) {
    wide a[3][3];
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            a[i][j] = form->m[i][j];
            axes->axis[i][j] = i == j;
        }
    }
    for (int sweep = 0; sweep < 30; sweep++) {
        rotate(a, axes->axis, 0, 1);
        rotate(a, axes->axis, 1, 2);
        rotate(a, axes->axis, 0, 2);
    }
    for (int i = 0; i < 3; i++) {
        axes->square[i] = a[i][i];
    }
}

static void swap_axes(struct wide_axes *axes, int i, int j) {
    wide square = axes->square[i];
    axes->square[i] = axes->square[j];
    axes->square[j] = square;
    for (int k = 0; k < 3; k++) {
        wide x = axes->axis[i][k];
        axes->axis[i][k] = axes->axis[j][k];
        axes->axis[j][k] = x;
    }
}

/* Turns the axes without a square so that the last one takes all of the linear part. */
static void gather_linear(struct wide_axes *axes, wide linear[3]) {
    wide along[3] = {0, 0, 0};
    for (int i = 0; i < 3; i++) {
        for (int k = 0; axes->square[i] == 0 && k < 3; k++) {
            along[k] += linear[i] * axes->axis[i][k];
        }
    }
    axes->linear = sqrtl(wide_dot(along, along));
    if (axes->linear <= 0) {
        return;
    }
    for (int k = 0; k < 3; k++) {
        axes->axis[2][k] = along[k] / axes->linear;
    }
    if (axes->square[1] == 0) {
        wide_cross(axes->axis[2], axes->axis[0], axes->axis[1]);
    }
}

/* Finds the form in its own axes; returns false if the form has no quadratic part. */
static bool form_axes(const struct quadric_form *form, struct wide_axes *axes) {
    wide linear[3], largest = 0;
    diagonalise(form, axes);
    for (int i = 0; i < 3; i++) {
        largest = fmaxl(largest, fabsl(axes->square[i]));
    }
    if (!(largest > 0)) {
        return false;
    }
    for (int i = 0; i < 3; i++) {
        axes->square[i] = fabsl(axes->square[i]) < NEGLIGIBLE * largest ? 0 : axes->square[i];
    }
    for (int i = 0; i < 2; i++) {
        for (int j = 0; j < 2; j++) {
            if (axes->square[j] == 0) {
                swap_axes(axes, j, j + 1);
            }
        }
    }
    const wide part[3] = {form->m[0][3], form->m[1][3], form->m[2][3]};
    axes->constant = form->m[3][3];
    for (int i = 0; i < 3; i++) {
        axes->origin[i] = 0;
        linear[i] = wide_dot(part, axes->axis[i]);
    }
    for (int i = 0; i < 3; i++) {
        if (axes->square[i] != 0) {
            wide shift = -linear[i] / axes->square[i];
            axes->constant += linear[i] * shift;
            for (int k = 0; k < 3; k++) {
                axes->origin[k] += shift * axes->axis[i][k];
            }
        }
    }
    gather_linear(axes, linear);
    if (axes->linear > NEGLIGIBLE * largest) {
        wide shift = -axes->constant / (2 * axes->linear);
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
    struct wide_axes exact;
    struct quadric_form form = form_of_leaf(leaf);
    form = form_placed(&form, placement);
    if (!form_axes(&form, &exact)) {
        return false;
    }
    affine_point(placement, leaf->a, place);
    for (int i = 0; i < 3; i++) {
        axes->origin[i] = (double)(exact.origin[i] + place[i]);
        axes->square[i] = (double)exact.square[i];
        for (int j = 0; j < 3; j++) {
            axes->axis[i][j] = (double)exact.axis[i][j];
        }
    }
    axes->linear = (double)exact.linear;
    axes->constant = (double)exact.constant;
    return true;
}
