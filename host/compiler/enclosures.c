/* SPDX-License-Identifier: MIT */
/* The scene compiler: finds which primitives lie strictly within which. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/grow.h"
#include "compiler/compiler_internal.h"

static bool is_behind(const struct compiled_scene *scene, uint32_t inner, const double normal[3],
                      double offset) {
    return primitive_reach(scene, inner, normal) < offset - COMPILE_STRICTLY;
}

static bool is_within_box(const struct compiled_scene *scene, uint32_t inner, uint32_t outer) {
    const struct compiled_primitive *primitive = &scene->primitives[outer];
    const struct compiled_box *box = &scene->boxes[primitive->index];
    for (int i = 0; i < 3; i++) {
        double up[3], down[3];
        memcpy(up, compiled_axis(scene, primitive->frame, i), sizeof up);
        for (int j = 0; j < 3; j++) {
            down[j] = -up[j];
        }
        if (!is_behind(scene, inner, up, box->maximum[i]) ||
            !is_behind(scene, inner, down, -box->minimum[i])) {
            return false;
        }
    }
    return true;
}

/* Tells whether a ball, or a box by its corners, lies within a ball; false for other kinds. */
static bool is_within_ball(const struct compiled_scene *scene, uint32_t inner, uint32_t outer) {
    const struct compiled_ball *ball = &scene->balls[scene->primitives[outer].index];
    const struct compiled_primitive *primitive = &scene->primitives[inner];
    double square = 0;
    if (primitive->kind == PRIMITIVE_BALL) {
        const struct compiled_ball *small = &scene->balls[primitive->index];
        for (int i = 0; i < 3; i++) {
            square += pow(small->centre[i] - ball->centre[i], 2);
        }
        return sqrt(square) + small->radius < ball->radius - COMPILE_STRICTLY;
    }
    if (primitive->kind != PRIMITIVE_BOX) {
        return false;
    }
    const struct compiled_box *box = &scene->boxes[primitive->index];
    for (int i = 0; i < 3; i++) {
        const double *axis = compiled_axis(scene, primitive->frame, i);
        double middle = vector_dot(ball->centre, axis);
        square += pow(fmax(fabs(box->minimum[i] - middle), fabs(box->maximum[i] - middle)), 2);
    }
    return sqrt(square) < ball->radius - COMPILE_STRICTLY;
}

static bool is_within_polyhedron(const struct compiled_scene *scene, uint32_t inner,
                                 uint32_t outer) {
    const struct compiled_polyhedron *polyhedron =
        &scene->polyhedra[scene->primitives[outer].index];
    for (uint32_t i = 0; i < polyhedron->count; i++) {
        const struct compiled_plane *plane = &scene->planes[polyhedron->first + i];
        if (!is_behind(scene, inner, plane->normal, plane->offset)) {
            return false;
        }
    }
    return true;
}

/* Returns the most of a convex quadric's form over a box, which is given along its axes from its
 * centre. */
static double most_of_form(const struct compiled_quadric *quadric, const double low[3],
                           const double high[3]) {
    double most = quadric->constant;
    for (int i = 0; i < 3; i++) {
        double linear = i == 2 ? 2 * quadric->linear : 0;
        most += fmax((quadric->square[i] * low[i] + linear) * low[i],
                     (quadric->square[i] * high[i] + linear) * high[i]);
    }
    return most;
}

/* Finds a ball that a primitive lies within: the primitive itself, or a ball about its bounds in
 * its frame. */
static void surrounding_ball(const struct compiled_scene *scene, uint32_t index, double centre[3],
                             double *radius) {
    const struct compiled_primitive *primitive = &scene->primitives[index];
    double square = 0;
    if (primitive->kind == PRIMITIVE_BALL) {
        memcpy(centre, scene->balls[primitive->index].centre, 3 * sizeof *centre);
        *radius = scene->balls[primitive->index].radius;
        return;
    }
    centre[0] = centre[1] = centre[2] = 0;
    for (int i = 0; i < 3; i++) {
        const double *axis = compiled_axis(scene, primitive->frame, i);
        double down[3] = {-axis[0], -axis[1], -axis[2]};
        double high = primitive_reach(scene, index, axis);
        double low = -primitive_reach(scene, index, down);
        square += (high - low) * (high - low) / 4;
        for (int j = 0; j < 3; j++) {
            centre[j] += (low + high) / 2 * axis[j];
        }
    }
    *radius = sqrt(square);
}

/* Tells whether an ellipsoid holds a ball. Coordinates in which the ellipsoid is a ball are used,
 * with the ball's centre and the most that its radius becomes there. */
static bool holds_ball(const struct compiled_scene *scene, uint32_t outer, const double centre[3],
                       double radius) {
    const struct compiled_primitive *primitive = &scene->primitives[outer];
    const struct compiled_quadric *quadric = &scene->quadrics[primitive->index];
    double square = 0, steepest = 0;
    for (int i = 0; i < 3; i++) {
        const double *axis = compiled_axis(scene, primitive->frame, i);
        double x = vector_dot(centre, axis) - vector_dot(quadric->centre, axis);
        square += quadric->square[i] * x * x;
        steepest = fmax(steepest, quadric->square[i]);
    }
    return quadric->linear == 0 &&
           sqrt(square) + radius * sqrt(steepest) < sqrt(-quadric->constant) - COMPILE_STRICTLY;
}

/* Tells whether a primitive lies within a quadric's form, and behind the planes that cut the
 * quadric. */
static bool is_within_quadric(const struct compiled_scene *scene, uint32_t inner, uint32_t outer) {
    const struct compiled_primitive *primitive = &scene->primitives[outer];
    const struct compiled_quadric *quadric = &scene->quadrics[primitive->index];
    const struct compiled_box *box = compiled_box_of(scene, quadric);
    double low[3], high[3], centre[3], radius;
    for (int i = 0; i < 3; i++) {
        const double *axis = compiled_axis(scene, primitive->frame, i);
        const double down[3] = {-axis[0], -axis[1], -axis[2]};
        double middle = vector_dot(quadric->centre, axis);
        bool cut = (quadric->cuts >> i & 1) != 0;
        if (quadric->square[i] < 0 || (cut && (!is_behind(scene, inner, axis, box->maximum[i]) ||
                                               !is_behind(scene, inner, down, -box->minimum[i])))) {
            return false;
        }
        high[i] = primitive_reach(scene, inner, axis) - middle;
        low[i] = -primitive_reach(scene, inner, down) - middle;
        if (!isfinite(low[i]) || !isfinite(high[i])) {
            return false;
        }
    }
    surrounding_ball(scene, inner, centre, &radius);
    return most_of_form(quadric, low, high) < -COMPILE_STRICTLY * COMPILE_EXTENT ||
           holds_ball(scene, outer, centre, radius);
}

/* Tells whether one primitive lies within another. Only convex primitives enclose: from a point
 * within, a ray leaves them once. */
bool primitive_is_within(const struct compiled_scene *scene, uint32_t inner, uint32_t outer) {
    switch (scene->primitives[outer].kind) {
    case PRIMITIVE_BOX:
        return is_within_box(scene, inner, outer);
    case PRIMITIVE_BALL:
        return is_within_ball(scene, inner, outer);
    case PRIMITIVE_POLYHEDRON:
        return is_within_polyhedron(scene, inner, outer);
    case PRIMITIVE_QUADRIC:
        break;
    }
    return is_within_quadric(scene, inner, outer);
}

/* Tells whether all of one primitive lies before another one along a direction of any length; false
 * for a null direction. */
static bool lies_beyond(const struct compiled_scene *scene, uint32_t one, uint32_t other,
                        const double direction[3]) {
    double there[3] = {direction[0], direction[1], direction[2]}, back[3];
    if (!vector_normalise(there)) {
        return false;
    }
    for (int i = 0; i < 3; i++) {
        back[i] = -there[i];
    }
    return primitive_reach(scene, one, there) + primitive_reach(scene, other, back) < -COMPILE_GAP;
}

/* Tells whether a plane between two primitives was found, so that they have no point in common.
 * Planes across the axes of either and of the world are tried, then across the line from one to the
 * other. */
bool primitives_are_apart(const struct compiled_scene *scene, uint32_t one, uint32_t other) {
    const uint32_t frames[3] = {COMPILED_FRAME_WORLD, scene->primitives[one].frame,
                                scene->primitives[other].frame};
    double from[3], to[3], radius;
    for (int i = 0; i < 9; i++) {
        const double *axis = compiled_axis(scene, frames[i / 3], i % 3);
        if (lies_beyond(scene, one, other, axis) || lies_beyond(scene, other, one, axis)) {
            return true;
        }
    }
    surrounding_ball(scene, one, from, &radius);
    surrounding_ball(scene, other, to, &radius);
    for (int i = 0; i < 3; i++) {
        to[i] -= from[i];
    }
    return isfinite(vector_length(to)) && lies_beyond(scene, one, other, to);
}

bool compile_solids(struct compiler *compiler) {
    for (uint32_t i = 0; i < compiler->scene->primitive_count; i++) {
        const struct bounds bounds = primitive_bounds(compiler->scene, i);
        if (!neighbours_add(&compiler->solids, &bounds, i)) {
            return compile_fail_memory(compiler);
        }
    }
    return true;
}

/* The primitives that each primitive lies within: those of primitive i stand from first[i] on, up
 * to first[i + 1]. */
struct holders {
    size_t *first;
    uint32_t *holder;
    size_t count;
};

/* Finds what each primitive lies within, among what it may meet; false if memory is out. */
static bool find_holders(struct compiler *compiler, struct holders *holders) {
    const struct compiled_scene *scene = compiler->scene;
    struct compiled_set found = {NULL, 0};
    bool is_found = true;
    for (uint32_t i = 0; i < scene->primitive_count && is_found; i++) {
        const struct bounds *bounds = &compiler->solids.entries[i].bounds;
        holders->first[i] = holders->count;
        is_found = neighbours_find(&compiler->solids, bounds, 0, &found);
        for (uint32_t k = 0; k < found.count && is_found; k++) {
            const uint32_t j = found.members[k];
            if (i != j && primitive_is_within(scene, i, j)) {
                is_found = GROW(holders->holder, holders->count);
                if (is_found) {
                    holders->holder[holders->count++] = j;
                }
            }
        }
    }
    holders->first[scene->primitive_count] = holders->count;
    compiled_set_clear(&found);
    return is_found;
}

/* Returns the innermost of the primitives that a primitive lies within: that which itself lies
 * within the most others. */
static uint32_t innermost(const struct holders *holders, uint32_t primitive) {
    uint32_t enclosure = COMPILED_ENCLOSURE_NONE;
    size_t deepest = 0;
    for (size_t k = holders->first[primitive]; k < holders->first[primitive + 1]; k++) {
        const uint32_t j = holders->holder[k];
        const size_t depth = holders->first[j + 1] - holders->first[j];
        if (enclosure == COMPILED_ENCLOSURE_NONE || depth > deepest) {
            enclosure = j;
            deepest = depth;
        }
    }
    return enclosure;
}

static bool find_enclosures(struct compiler *compiler) {
    struct compiled_scene *scene = compiler->scene;
    struct holders holders = {malloc(((size_t)scene->primitive_count + 1) * sizeof(size_t)), NULL,
                              0};
    const bool is_found = holders.first != NULL && find_holders(compiler, &holders);
    for (uint32_t i = 0; i < scene->primitive_count && is_found; i++) {
        scene->primitives[i].enclosure = innermost(&holders, i);
    }
    free(holders.first);
    free(holders.holder);
    return is_found || compile_fail_memory(compiler);
}

/* Sets for each of few primitives what hides it. */
static bool find_hiders(struct compiler *compiler) {
    struct compiled_scene *scene = compiler->scene;
    scene->hidden_by = calloc((size_t)scene->primitive_count + 1, sizeof *scene->hidden_by);
    if (scene->hidden_by == NULL) {
        return compile_fail_memory(compiler);
    }
    for (uint32_t i = 0; i < scene->primitive_count; i++) {
        for (uint32_t j = 0; j < scene->primitive_count; j++) {
            if (i == j ||
                (!primitive_is_within(scene, i, j) && !primitives_are_apart(scene, i, j))) {
                continue;
            }
            if (!compiled_set_include(&scene->hidden_by[j], i)) {
                return compile_fail_memory(compiler);
            }
            scene->report.hidden++;
        }
    }
    return true;
}

bool compile_enclosures(struct compiler *compiler) {
    return find_enclosures(compiler) &&
           (compiler->scene->primitive_count > COMPILED_BITS_MOST || find_hiders(compiler));
}
