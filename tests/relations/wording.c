/* SPDX-License-Identifier: MIT */
/* One solid in other words. */
#include "wording.h"

#include <math.h>
#include <string.h>

#include "chance.h"

static void swap_three(double a[3], double b[3]) {
    for (int i = 0; i < 3; i++) {
        double kept = a[i];
        a[i] = b[i];
        b[i] = kept;
    }
}

bool wording_ends(struct syntax_solid *solid) {
    switch (solid->kind) {
    case SYNTAX_CONE: {
        double radius = solid->radius;
        solid->radius = solid->radius_b;
        solid->radius_b = radius;
        break;
    }
    case SYNTAX_CYLINDER:
    case SYNTAX_ONE_SHEET:
    case SYNTAX_TWO_SHEETS:
        break;
    default: /* what has no two ends */
        return false;
    }
    swap_three(solid->a, solid->b);
    return true;
}

/* Writes a box as a polyhedron, its planes in either order and their normals of any length. */
static void box_as_polyhedron(struct syntax_solid *solid, uint64_t *random) {
    double length = chance_is(random, 50) ? 1 : 3;
    bool is_backward = chance_is(random, 50);
    solid->kind = SYNTAX_POLYHEDRON;
    solid->plane_count = 6;
    for (int i = 0; i < 6; i++) {
        struct syntax_plane *plane = &solid->planes[is_backward ? 5 - i : i];
        memset(plane, 0, sizeof *plane);
        plane->normal[i % 3] = i < 3 ? -length : length;
        plane->offset = length * (i < 3 ? -solid->a[i] : solid->b[i - 3]);
    }
}

/* Writes a ball or an ellipsoid by its coefficients. */
static void ellipsoid_as_quadric(struct syntax_solid *solid) {
    double radii[3];
    for (int i = 0; i < 3; i++) {
        radii[i] = solid->kind == SYNTAX_BALL ? solid->radius : solid->b[i];
    }
    memset(solid->form, 0, sizeof solid->form);
    solid->form[9] = -radii[0] * radii[0];
    for (int i = 0; i < 3; i++) {
        double square = radii[0] * radii[0] / (radii[i] * radii[i]);
        solid->form[i] = square;
        solid->form[6 + i] = -2 * square * solid->a[i];
        solid->form[9] += square * solid->a[i] * solid->a[i];
    }
    solid->kind = SYNTAX_QUADRIC;
}

static void ball_as_ellipsoid(struct syntax_solid *solid) {
    solid->kind = SYNTAX_ELLIPSOID;
    solid->b[0] = solid->b[1] = solid->b[2] = solid->radius;
}

/* Writes a leaf twice as large, or half, and scales it back. */
static void carry(struct syntax_solid *solid, uint64_t *random) {
    double factor = chance_is(random, 50) ? 2 : 0.5;
    for (int i = 0; i < 3; i++) {
        solid->a[i] *= factor;
        solid->b[i] *= factor;
        solid->scale[i] /= factor;
    }
    solid->radius *= factor;
    solid->radius_b *= factor;
}

bool wording_leaf(struct syntax_solid *solid, uint64_t *random) {
    bool is_bare = solid->scale[0] > 0 && fabs(solid->rotate[0]) + fabs(solid->rotate[1]) <= 0;
    int choice = chance_pick(random, 3);
    switch (solid->kind) {
    case SYNTAX_BOX:
        if (choice == 0) {
            carry(solid, random);
        } else {
            box_as_polyhedron(solid, random);
        }
        return true;
    case SYNTAX_BALL:
    case SYNTAX_ELLIPSOID:
        if (choice == 0 && is_bare) {
            ellipsoid_as_quadric(solid);
        } else if (choice == 1 && solid->kind == SYNTAX_BALL) {
            ball_as_ellipsoid(solid);
        } else {
            carry(solid, random);
        }
        return true;
    case SYNTAX_HALF_SPACE:
        for (int i = 0; i < 3; i++) {
            solid->planes[0].normal[i] *= 2.5;
        }
        solid->planes[0].offset *= 2.5;
        return true;
    case SYNTAX_QUADRIC:
        for (int i = 0; i < 10; i++) {
            solid->form[i] *= 3;
        }
        return true;
    case SYNTAX_POLYHEDRON: {
        struct syntax_plane first = solid->planes[0];
        memmove(solid->planes, solid->planes + 1, (size_t)(solid->plane_count - 1) * sizeof first);
        solid->planes[solid->plane_count - 1] = first;
        return true;
    }
    case SYNTAX_CYLINDER:
    case SYNTAX_CONE:
    case SYNTAX_PARABOLOID:
    case SYNTAX_ONE_SHEET:
    case SYNTAX_TWO_SHEETS:
        carry(solid, random);
        return true;
    default: /* operations */
        return false;
    }
}
