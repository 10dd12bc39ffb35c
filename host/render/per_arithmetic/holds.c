/* SPDX-License-Identifier: MIT */
/* Checks that an arithmetic can hold a scene: what differs still differs, and keeps its shape. */
#include "render/per_arithmetic/holds.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "base/grow.h"
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

/* A plane face in scaled world coordinates. The normal's first component that is not 0 in this
 * arithmetic is positive: both sides of a wall look alike. */
struct face {
    double normal[3], offset;
    uint32_t surface;
    unsigned line;
};

static void set_face(struct face *face, const struct compiled_face *from, unsigned line) {
    int first = 0;
    while (first < 2 && same_unit(from->normal[first], 0)) {
        first++;
    }
    double sign = from->normal[first] < 0 ? -1 : 1;
    for (int i = 0; i < 3; i++) {
        face->normal[i] = sign * from->normal[i];
    }
    face->offset = sign * from->offset;
    face->surface = from->surface;
    face->line = line;
}

static bool same_faces(const struct face *a, const struct face *b) {
    return same_length(a->offset, b->offset) && same_unit(a->normal[0], b->normal[0]) &&
           same_unit(a->normal[1], b->normal[1]) && same_unit(a->normal[2], b->normal[2]);
}

static bool fail_memory(const struct compiled_scene *scene, struct scene_error *error) {
    snprintf(error->text, sizeof error->text, "%.200s: out of memory", scene->path);
    return false;
}

/* All plane faces of a scene. */
struct faces {
    struct face *entries;
    size_t count;
};

/* Lists the faces of all primitives; false if memory is out. */
static bool list_faces(const struct compiled_scene *scene, struct faces *faces) {
    for (uint32_t i = 0; i < scene->primitive_count; i++) {
        struct compiled_face own[COMPILED_FACES_MOST];
        int more = compiled_faces(scene, i, own);
        for (int j = 0; j < more; j++) {
            if (!GROW(faces->entries, faces->count)) {
                return false;
            }
            set_face(&faces->entries[faces->count++], &own[j], scene->primitives[i].line);
        }
    }
    return true;
}

static bool faces_are_distinct(const struct compiled_scene *scene, struct scene_error *error) {
    struct faces faces = {NULL, 0};
    bool is_good = list_faces(scene, &faces) || fail_memory(scene, error);
    for (size_t i = 0; i < faces.count && is_good; i++) {
        for (size_t j = 0; j < i && is_good; j++) {
            if (faces.entries[i].surface != faces.entries[j].surface &&
                same_faces(&faces.entries[i], &faces.entries[j])) {
                is_good = fail(scene, faces.entries[i].line, "a wall thinner", "thicker", error);
            }
        }
    }
    free(faces.entries);
    return is_good;
}

static bool same_balls(const struct compiled_ball *a, const struct compiled_ball *b) {
    return same_length(a->radius, b->radius) && same_length(a->centre[0], b->centre[0]) &&
           same_length(a->centre[1], b->centre[1]) && same_length(a->centre[2], b->centre[2]);
}

/* Returns how far a quadric reaches along an axis of its own, as a length with the sign of the
 * square. Quadrics without a constant term are told apart by their squares alone. */
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

static bool same_curves(const struct compiled_scene *scene, const struct compiled_primitive *a,
                        const struct compiled_primitive *b) {
    if (a->kind != b->kind) {
        return false;
    }
    if (a->kind == PRIMITIVE_BALL) {
        return same_balls(&scene->balls[a->index], &scene->balls[b->index]);
    }
    return a->kind == PRIMITIVE_QUADRIC && a->frame == b->frame &&
           same_quadrics(&scene->quadrics[a->index], &scene->quadrics[b->index]);
}

static bool curves_are_distinct(const struct compiled_scene *scene, struct scene_error *error) {
    for (uint32_t i = 0; i < scene->primitive_count; i++) {
        for (uint32_t j = 0; j < i; j++) {
            if (same_curves(scene, &scene->primitives[i], &scene->primitives[j])) {
                return fail(scene, scene->primitives[i].line, "a shell thinner", "thicker", error);
            }
        }
    }
    return true;
}

/* Tells whether a radius is less than a few times the noise. Distances along a ray are uncertain by
 * that noise: what is so small has no shape. */
static bool is_too_small(double radius) {
    return radius < 4 * LENGTH_VALUE(LENGTH_NOISE);
}

/* Finds the least radius of an ellipsoid or a cylinder; infinite for other forms. */
static double least_radius(const struct compiled_quadric *quadric) {
    double least = HUGE_VAL;
    for (int i = 0; i < 3; i++) {
        if (quadric->square[i] < 0 || quadric->linear != 0) {
            return HUGE_VAL;
        }
        if (quadric->square[i] > 0) {
            least = fmin(least, sqrt(fmax(0, -quadric->constant) / quadric->square[i]));
        }
    }
    return least;
}

/* Moves a quadric's squares, centre and linear term to numbers that this arithmetic has. */
static struct compiled_quadric rounded(const struct compiled_quadric *quadric) {
    struct compiled_quadric moved = *quadric;
    for (int i = 0; i < 3; i++) {
        moved.square[i] = UNIT_VALUE(REAL_UNIT(quadric->square[i]));
        moved.centre[i] = LENGTH_VALUE(REAL_LENGTH(quadric->centre[i]));
    }
    moved.linear = LENGTH_VALUE(REAL_LENGTH(quadric->linear));
    return moved;
}

/* A quadric may move by STRAY_MOST scaled units, of the 1,024 of a scene: less than half a pixel. A
 * square may change by SQUARE_STRAY_MOST of itself: a cone that is nearly flat opens wider without
 * moving far. */
#define STRAY_MOST        0.5
#define SQUARE_STRAY_MOST (1.0 / 64)

static bool keeps_shape(const struct compiled_scene *scene, uint32_t frame,
                        const struct compiled_quadric *quadric) {
    struct compiled_quadric moved = rounded(quadric);
    for (int i = 0; i < 3; i++) {
        if (fabs(moved.square[i] - quadric->square[i]) >
            SQUARE_STRAY_MOST * fabs(quadric->square[i])) {
            return false;
        }
    }
    return compiled_quadric_strays(scene, frame, quadric, &moved) <= STRAY_MOST;
}

static bool curves_keep_shape(const struct compiled_scene *scene, struct scene_error *error) {
    for (uint32_t i = 0; i < scene->primitive_count; i++) {
        const struct compiled_primitive *primitive = &scene->primitives[i];
        if (primitive->kind == PRIMITIVE_BALL &&
            is_too_small(scene->balls[primitive->index].radius)) {
            return fail(scene, primitive->line, "a ball smaller", "larger", error);
        }
        if (primitive->kind != PRIMITIVE_QUADRIC) {
            continue;
        }
        const struct compiled_quadric *quadric = &scene->quadrics[primitive->index];
        if (is_too_small(least_radius(quadric))) {
            return fail(scene, primitive->line, "a solid narrower", "wider", error);
        }
        if (!keeps_shape(scene, primitive->frame, quadric)) {
            return fail(scene, primitive->line, "a solid longer for its width", "shorter", error);
        }
    }
    return true;
}

/* The boundaries of cells may stray by this share of a cell at the end of what is bounded. */
#define CELL_STRAY_MOST (1.0 / 64)

/* Checks that cells keep size and place. Cells of no size have no number; rounded sizes add up to
 * boundaries elsewhere. */
static bool cells_keep_place(const struct compiled_scene *scene, struct scene_error *error) {
    for (uint32_t i = 0; i < scene->pattern_count; i++) {
        const struct compiled_pattern *pattern = &scene->patterns[i];
        for (int axis = 0; axis < 3; axis++) {
            if ((pattern->axes >> axis & 1) == 0) {
                continue;
            }
            double size = pattern->size[axis], origin = pattern->origin[axis];
            double cells = 512 / size;
            double stray = cells * fabs(LENGTH_VALUE(REAL_LENGTH(size)) - size) +
                           fabs(LENGTH_VALUE(REAL_LENGTH(origin)) - origin);
            if (same_length(size, 0) || stray > CELL_STRAY_MOST * size) {
                return fail(scene, pattern->line, "a pattern's cell smaller", "larger", error);
            }
        }
    }
    return true;
}

bool arithmetic_holds(const struct compiled_scene *scene, struct scene_error *error) {
    return faces_are_distinct(scene, error) && curves_are_distinct(scene, error) &&
           curves_keep_shape(scene, error) && cells_keep_place(scene, error);
}
