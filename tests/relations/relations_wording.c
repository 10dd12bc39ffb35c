/* SPDX-License-Identifier: MIT */
/* Relations: leaves and placements in other words. */
#include <math.h>
#include <string.h>

#include "chance.h"
#include "relation.h"

static void swap_three(double a[3], double b[3]) {
    for (int i = 0; i < 3; i++) {
        double kept = a[i];
        a[i] = b[i];
        b[i] = kept;
    }
}

/* Swaps `from` and `to` of what has an axis and looks the same from both ends, or has both radii.
 */
static bool swap_ends(struct syntax_solid *solid) {
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

bool rewrite_ends(struct syntax *scene, uint64_t *random) {
    int list[SYNTAX_SOLIDS_MOST], count = syntax_list(scene, list);
    bool has_changed = false;
    for (int i = 0; i < count; i++) {
        if (chance_is(random, 70)) {
            has_changed = swap_ends(&scene->solids[list[i]]) || has_changed;
        }
    }
    return has_changed;
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

static bool reword_leaf(struct syntax_solid *solid, uint64_t *random) {
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

bool rewrite_leaves(struct syntax *scene, uint64_t *random) {
    int list[SYNTAX_SOLIDS_MOST], count = syntax_list(scene, list);
    bool has_changed = false;
    for (int i = 0; i < count; i++) {
        if (chance_is(random, 60)) {
            has_changed = reword_leaf(&scene->solids[list[i]], random) || has_changed;
        }
    }
    return has_changed && !syntax_has_endless(scene);
}

/* Says a placement by one wrapper for each of its steps, or mirrors twice what is turned half. */
static void reword_placement(struct syntax *scene, int solid, uint64_t *random) {
    int below = syntax_push_down(scene, solid, SYNTAX_UNION);
    struct syntax_solid *inner = &scene->solids[below], *outer = &scene->solids[solid];
    memcpy(outer->translate, inner->translate, sizeof outer->translate);
    memset(inner->translate, 0, sizeof inner->translate);
    outer->rotate[2] = inner->rotate[2];
    inner->rotate[2] = 0;
    if (chance_is(random, 40)) { /* a half turn about z and its mirrors */
        outer->rotate[2] += outer->rotate[2] > 0 ? -180 : 180;
        outer->scale[0] = outer->scale[1] = -1;
    }
    syntax_adopt(scene, solid, below);
}

bool rewrite_placements(struct syntax *scene, uint64_t *random) {
    int list[SYNTAX_SOLIDS_MOST], count = syntax_list(scene, list);
    bool has_changed = false;
    for (int i = 0; i < count && !scene->is_full; i++) {
        const struct syntax_solid *solid = &scene->solids[list[i]];
        bool is_placed = fabs(solid->translate[0]) + fabs(solid->translate[2]) > 0;
        if (is_placed && chance_is(random, 60) && solid->kind != SYNTAX_HALF_SPACE) {
            reword_placement(scene, list[i], random);
            has_changed = true;
        }
    }
    return has_changed;
}
