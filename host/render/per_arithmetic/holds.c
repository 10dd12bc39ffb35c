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

/* Returns a number as this arithmetic has it: the same for all that it can't tell apart. */
static double kept_length(double length) {
    return LENGTH_VALUE(REAL_LENGTH(length)) + 0.0; /* not -0 */
}

static double kept_unit(double number) {
    return UNIT_VALUE(REAL_UNIT(number)) + 0.0;
}

static bool fail_memory(const struct compiled_scene *scene, struct scene_error *error) {
    snprintf(error->text, sizeof error->text, "%.200s: out of memory", scene->path);
    return false;
}

/* ---- What is one to this arithmetic --------------------------------------------------------- */

enum { SHAPE_NUMBERS = 8 };

/* A face or a curve, by all the numbers that tell one from another. Shapes of one kind and with the
 * same numbers look alike: two surfaces of one shape are one. */
struct shape {
    double number[SHAPE_NUMBERS];
    uint32_t kind, surface;
    unsigned line;
    size_t place; /* in the order in which they are told */
};

struct shapes {
    struct shape *entries; /* grows as base/grow.h says */
    size_t count;
};

/* Adds a shape; false if memory is out. */
static bool add_shape(struct shapes *shapes, struct shape shape) {
    if (!GROW(shapes->entries, shapes->count)) {
        return false;
    }
    shape.place = shapes->count;
    shapes->entries[shapes->count++] = shape;
    return true;
}

/* Orders shapes by what they are. */
static int compare_kinds(const struct shape *a, const struct shape *b) {
    int order = (a->kind > b->kind) - (a->kind < b->kind);
    for (int i = 0; i < SHAPE_NUMBERS && order == 0; i++) {
        order = (a->number[i] > b->number[i]) - (a->number[i] < b->number[i]);
    }
    return order;
}

/* Orders shapes that are alike by their places. */
static int compare_shapes(const void *a, const void *b) {
    const struct shape *one = a, *other = b;
    const int order = compare_kinds(one, other);
    return order != 0 ? order : (one->place > other->place) - (one->place < other->place);
}

/* Returns the first shape, by its place, that looks like an earlier one of another surface; NULL:
 * there is none. Leaves the shapes in another order. */
static const struct shape *find_alike(struct shapes *shapes) {
    const struct shape *found = NULL;
    if (shapes->count > 1) {
        qsort(shapes->entries, shapes->count, sizeof *shapes->entries, compare_shapes);
    }
    for (size_t i = 1; i < shapes->count; i++) {
        const struct shape *shape = &shapes->entries[i];
        if (compare_kinds(shape, shape - 1) == 0 && shape->surface != shape[-1].surface &&
            (found == NULL || shape->place < found->place)) {
            found = shape;
        }
    }
    return found;
}

/* ---- Faces ---------------------------------------------------------------------------------- */

/* Returns the shape of a plane face, in scaled world coordinates. The normal's first component that
 * is not 0 in this arithmetic is positive: both sides of a wall look alike. */
static struct shape face_shape(const struct compiled_face *face, unsigned line) {
    struct shape shape = {.surface = face->surface, .line = line};
    int first = 0;
    while (first < 2 && kept_unit(face->normal[first]) == 0) {
        first++;
    }
    double sign = face->normal[first] < 0 ? -1 : 1;
    for (int i = 0; i < 3; i++) {
        shape.number[i] = kept_unit(sign * face->normal[i]);
    }
    shape.number[3] = kept_length(sign * face->offset);
    return shape;
}

/* Lists the faces of all primitives; false if memory is out. */
static bool list_faces(const struct compiled_scene *scene, struct shapes *shapes) {
    for (uint32_t i = 0; i < scene->primitive_count; i++) {
        struct compiled_face faces[COMPILED_FACES_MOST];
        int count = compiled_faces(scene, i, faces);
        for (int j = 0; j < count; j++) {
            if (!add_shape(shapes, face_shape(&faces[j], scene->primitives[i].line))) {
                return false;
            }
        }
    }
    return true;
}

/* ---- Curves --------------------------------------------------------------------------------- */

/* Returns how far a quadric reaches along an axis of its own, as a length with the sign of the
 * square. Quadrics without a constant term are told apart by their squares alone. */
static double reach(const struct compiled_quadric *quadric, int axis) {
    double square = quadric->square[axis];
    if (kept_unit(square) == 0) {
        return 0;
    }
    double length = sqrt(fabs(quadric->constant / square));
    return square < 0 ? -length : length;
}

/* Returns the shape of a quadric of a frame: frames are kinds. */
static struct shape quadric_shape(const struct compiled_quadric *quadric, uint32_t frame) {
    const double constant = sqrt(fabs(quadric->constant));
    const bool pointed = kept_length(constant) == 0;
    struct shape shape = {.kind = frame, .surface = quadric->surface};
    for (int i = 0; i < 3; i++) {
        shape.number[i] = kept_length(quadric->centre[i]);
        shape.number[3 + i] =
            pointed ? kept_unit(quadric->square[i]) : kept_length(reach(quadric, i));
    }
    shape.number[6] = kept_length(quadric->linear);
    shape.number[7] = kept_length(constant);
    return shape;
}

static struct shape ball_shape(const struct compiled_ball *ball) {
    struct shape shape = {.surface = ball->surface};
    for (int i = 0; i < 3; i++) {
        shape.number[i] = kept_length(ball->centre[i]);
    }
    shape.number[3] = kept_length(ball->radius);
    return shape;
}

/* Lists the curves of one kind of primitives; false if memory is out. */
static bool list_curves(const struct compiled_scene *scene, enum primitive_kind kind,
                        struct shapes *shapes) {
    for (uint32_t i = 0; i < scene->primitive_count; i++) {
        const struct compiled_primitive *primitive = &scene->primitives[i];
        if (primitive->kind != kind) {
            continue;
        }
        struct shape shape =
            kind == PRIMITIVE_BALL
                ? ball_shape(&scene->balls[primitive->index])
                : quadric_shape(&scene->quadrics[primitive->index], primitive->frame);
        shape.line = primitive->line;
        if (!add_shape(shapes, shape)) {
            return false;
        }
        shapes->entries[shapes->count - 1].place = i; /* balls and quadrics are told in one order */
    }
    return true;
}

/* ---- Refusals ------------------------------------------------------------------------------- */

static bool faces_are_distinct(const struct compiled_scene *scene, struct scene_error *error) {
    struct shapes faces = {NULL, 0};
    bool is_good = list_faces(scene, &faces) || fail_memory(scene, error);
    const struct shape *alike = is_good ? find_alike(&faces) : NULL;
    if (alike != NULL) {
        is_good = fail(scene, alike->line, "a wall thinner", "thicker", error);
    }
    free(faces.entries);
    return is_good;
}

static bool curves_are_distinct(const struct compiled_scene *scene, struct scene_error *error) {
    struct shapes balls = {NULL, 0}, quadrics = {NULL, 0};
    bool is_good = (list_curves(scene, PRIMITIVE_BALL, &balls) &&
                    list_curves(scene, PRIMITIVE_QUADRIC, &quadrics)) ||
                   fail_memory(scene, error);
    if (is_good) {
        const struct shape *ball = find_alike(&balls), *quadric = find_alike(&quadrics);
        const bool is_ball = ball != NULL && (quadric == NULL || ball->place < quadric->place);
        const struct shape *first = is_ball ? ball : quadric;
        is_good = first == NULL || fail(scene, first->line, "a shell thinner", "thicker", error);
    }
    free(balls.entries);
    free(quadrics.entries);
    return is_good;
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
            if (kept_length(size) == 0 || stray > CELL_STRAY_MOST * size) {
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
