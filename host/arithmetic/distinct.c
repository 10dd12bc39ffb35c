/* SPDX-License-Identifier: MIT */
/* Whether surfaces and cells that differ in the file still differ in an arithmetic. */
#include "distinct.h"

#include <math.h>
#include <stdio.h>

#include "scene.h"

/* Compiled once for each arithmetic; the include path says which. */

static bool fail(const struct compiled_scene *scene, unsigned line, const char *what,
                 const char *remedy, struct scene_error *error) {
    snprintf(error->text, sizeof error->text,
             "%.200s:%u: %s than this arithmetic resolves: make it %s, the scene smaller, or "
             "choose another --arith",
             scene->path, line, what, remedy);
    return false;
}

static bool same_length(double a, double b) {
    real_length left = REAL_LENGTH(a), right = REAL_LENGTH(b);
    return !length_less(left, right) && !length_less(right, left);
}

static bool same_unit(double a, double b) {
    real_unit left = REAL_UNIT(a), right = REAL_UNIT(b);
    return !unit_less(left, right) && !unit_less(right, left);
}

/* A plane face in scaled world coordinates; the first component of its normal that is not 0 in this
 * arithmetic is positive, so that both sides of a wall look alike. */
struct face {
    double normal[3], offset;
    uint16_t surface;
    unsigned line;
};

enum { FACES_MOST = 6 * COMPILED_PRIMITIVES_MOST + COMPILED_PLANES_MOST };

static void add_face(struct face *face, const double normal[3], double offset, uint16_t surface,
                     unsigned line) {
    int first = 0;
    while (first < 2 && same_unit(normal[first], 0)) {
        first++;
    }
    double sign = normal[first] < 0 ? -1 : 1;
    for (int i = 0; i < 3; i++) {
        face->normal[i] = sign * normal[i];
    }
    face->offset = sign * offset;
    face->surface = surface;
    face->line = line;
}

/* The faces of one primitive, at `faces`: their number. */
static int primitive_faces(const struct compiled_scene *scene,
                           const struct compiled_primitive *primitive, struct face *faces) {
    static const double world[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    int count = 0;
    if (primitive->kind == PRIMITIVE_BOX || primitive->kind == PRIMITIVE_QUADRIC) {
        /* The frames of boxes have their origin where the scene has its own. */
        bool is_box = primitive->kind == PRIMITIVE_BOX;
        const struct compiled_quadric *quadric = &scene->quadrics[primitive->index];
        const struct compiled_box *box = &scene->boxes[is_box ? primitive->index : quadric->box];
        for (int i = 0; i < 6; i++) {
            if (!is_box && (quadric->cuts >> i % 3 & 1) == 0) {
                continue;
            }
            const double *normal = primitive->frame == FRAME_WORLD
                                       ? world[i % 3]
                                       : scene->frames[primitive->frame].axis[i % 3];
            add_face(&faces[count++], normal, i < 3 ? box->minimum[i] : box->maximum[i - 3],
                     box->surface[i], primitive->line);
        }
    } else if (primitive->kind == PRIMITIVE_POLYHEDRON) {
        const struct compiled_polyhedron *polyhedron = &scene->polyhedra[primitive->index];
        for (int i = 0; i < polyhedron->count; i++) {
            const struct compiled_plane *plane = &scene->planes[polyhedron->first + i];
            add_face(&faces[count++], plane->normal, plane->offset, plane->surface,
                     primitive->line);
        }
    }
    return count;
}

static bool same_faces(const struct face *a, const struct face *b) {
    return same_length(a->offset, b->offset) && same_unit(a->normal[0], b->normal[0]) &&
           same_unit(a->normal[1], b->normal[1]) && same_unit(a->normal[2], b->normal[2]);
}

static bool faces_are_distinct(const struct compiled_scene *scene, struct scene_error *error) {
    struct face faces[FACES_MOST];
    int count = 0;
    for (int i = 0; i < scene->primitive_count; i++) {
        count += primitive_faces(scene, &scene->primitives[i], &faces[count]);
    }
    for (int i = 0; i < count; i++) {
        for (int j = 0; j < i; j++) {
            if (faces[i].surface != faces[j].surface && same_faces(&faces[i], &faces[j])) {
                return fail(scene, faces[i].line, "a wall thinner", "thicker", error);
            }
        }
    }
    return true;
}

static bool same_balls(const struct compiled_ball *a, const struct compiled_ball *b) {
    return same_length(a->radius, b->radius) && same_length(a->centre[0], b->centre[0]) &&
           same_length(a->centre[1], b->centre[1]) && same_length(a->centre[2], b->centre[2]);
}

/* How far a quadric reaches along an axis of its own, as a signed length; what has no constant term
 * is told by its square alone. */
static double reach(const struct compiled_quadric *quadric, int axis) {
    double square = quadric->square[axis];
    if (same_unit(square, 0)) {
        return 0;
    }
    double length = sqrt(fabs(quadric->constant / square));
    return square < 0 ? -length : length;
}

static bool same_quadrics(const struct compiled_quadric *a, const struct compiled_quadric *b) {
    bool same = a->surface != b->surface && same_length(a->centre[0], b->centre[0]) &&
                same_length(a->centre[1], b->centre[1]) &&
                same_length(a->centre[2], b->centre[2]) && same_length(a->linear, b->linear) &&
                same_length(sqrt(fabs(a->constant)), sqrt(fabs(b->constant)));
    for (int i = 0; i < 3; i++) {
        bool pointed = same_length(sqrt(fabs(a->constant)), 0);
        same = same && (pointed ? same_unit(a->square[i], b->square[i])
                                : same_length(reach(a, i), reach(b, i)));
    }
    return same;
}

static bool curves_are_distinct(const struct compiled_scene *scene, struct scene_error *error) {
    for (int i = 0; i < scene->primitive_count; i++) {
        const struct compiled_primitive *primitive = &scene->primitives[i];
        const struct compiled_ball *ball = &scene->balls[primitive->index];
        const struct compiled_quadric *quadric = &scene->quadrics[primitive->index];
        if (primitive->kind == PRIMITIVE_BALL && same_length(ball->radius, 0)) {
            return fail(scene, primitive->line, "a ball smaller", "larger", error);
        }
        for (int j = 0; j < i; j++) {
            const struct compiled_primitive *other = &scene->primitives[j];
            bool same =
                other->kind == primitive->kind &&
                ((primitive->kind == PRIMITIVE_BALL &&
                  same_balls(ball, &scene->balls[other->index])) ||
                 (primitive->kind == PRIMITIVE_QUADRIC && primitive->frame == other->frame &&
                  same_quadrics(quadric, &scene->quadrics[other->index])));
            if (same) {
                return fail(scene, primitive->line, "a shell thinner", "thicker", error);
            }
        }
    }
    return true;
}

/* Cells of no size have no number. */
static bool cells_are_distinct(const struct compiled_scene *scene, struct scene_error *error) {
    for (int i = 0; i < scene->pattern_count; i++) {
        const struct compiled_pattern *pattern = &scene->patterns[i];
        for (int axis = 0; axis < 3; axis++) {
            if ((pattern->axes >> axis & 1) != 0 && same_length(pattern->size[axis], 0)) {
                return fail(scene, pattern->line, "a pattern's cell smaller", "larger", error);
            }
        }
    }
    return true;
}

bool surfaces_are_distinct(const struct compiled_scene *scene, struct scene_error *error) {
    return faces_are_distinct(scene, error) && curves_are_distinct(scene, error) &&
           cells_are_distinct(scene, error);
}
