/* SPDX-License-Identifier: MIT */
/* Vectors and affine maps in doubles, for the scene compiler. */
#include "compiler/affine.h"

#include <math.h>

const struct affine affine_identity = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}}};

double vector_dot(const double a[3], const double b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

double vector_length(const double a[3]) {
    return sqrt(vector_dot(a, a));
}

void vector_cross(const double a[3], const double b[3], double product[3]) {
    product[0] = a[1] * b[2] - a[2] * b[1];
    product[1] = a[2] * b[0] - a[0] * b[2];
    product[2] = a[0] * b[1] - a[1] * b[0];
}

bool vector_normalise(double a[3]) {
    double length = vector_length(a);
    if (!(length > 0)) {
        return false;
    }
    for (int i = 0; i < 3; i++) {
        a[i] /= length;
    }
    return true;
}

struct affine affine_compose(const struct affine *outer, const struct affine *inner) {
    struct affine both;
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 4; j++) {
            both.m[i][j] = outer->m[i][0] * inner->m[0][j] + outer->m[i][1] * inner->m[1][j] +
                           outer->m[i][2] * inner->m[2][j];
        }
        both.m[i][3] += outer->m[i][3];
    }
    return both;
}

void affine_point(const struct affine *map, const double point[3], double image[3]) {
    for (int i = 0; i < 3; i++) {
        image[i] = map->m[i][0] * point[0] + map->m[i][1] * point[1] + map->m[i][2] * point[2] +
                   map->m[i][3];
    }
}

void affine_axis(const struct affine *map, int axis, double image[3]) {
    for (int i = 0; i < 3; i++) {
        image[i] = map->m[i][axis];
    }
}

double vector_parallel(const double a[3], const double b[3]) {
    bool same = a[0] == b[0] && a[1] == b[1] && a[2] == b[2];
    bool opposite = a[0] == -b[0] && a[1] == -b[1] && a[2] == -b[2];
    return same ? 1 : opposite ? -1 : 0;
}
