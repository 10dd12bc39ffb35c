/* SPDX-License-Identifier: MIT */
/* The scene compiler: which primitives lie strictly within which. */
#include <math.h>
#include <string.h>

#include "compile_internal.h"

bool compiled_set_has(const struct compiled_set *set, int primitive) {
    return (set->word[primitive / 32] >> primitive % 32 & 1) != 0;
}

void compiled_set_include(struct compiled_set *set, int primitive) {
    set->word[primitive / 32] |= (uint32_t)1 << primitive % 32;
}

static bool is_behind(const struct compiled_scene *scene, int inner, const double normal[3],
                      double offset) {
    return primitive_reach(scene, inner, normal) < offset - COMPILE_STRICTLY;
}

static bool is_within_box(const struct compiled_scene *scene, int inner, int outer) {
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

/* A ball within a ball, or a box's corners within one. */
static bool is_within_ball(const struct compiled_scene *scene, int inner, int outer) {
    const struct compiled_ball *ball = &scene->balls[scene->primitives[outer].index];
    const struct compiled_primitive *primitive = &scene->primitives[inner];
    double square = 0;
    if (primitive->kind == KIND_BALL) {
        const struct compiled_ball *small = &scene->balls[primitive->index];
        for (int i = 0; i < 3; i++) {
            square += pow(small->centre[i] - ball->centre[i], 2);
        }
        return sqrt(square) + small->radius < ball->radius - COMPILE_STRICTLY;
    }
    if (primitive->kind != KIND_BOX) {
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

static bool is_within_polyhedron(const struct compiled_scene *scene, int inner, int outer) {
    const struct compiled_polyhedron *polyhedron =
        &scene->polyhedra[scene->primitives[outer].index];
    for (int i = 0; i < polyhedron->count; i++) {
        const struct compiled_plane *plane = &scene->planes[polyhedron->first + i];
        if (!is_behind(scene, inner, plane->normal, plane->offset)) {
            return false;
        }
    }
    return true;
}

/* Only convex primitives enclose: from a point within, a ray leaves them once. */
static bool is_within(const struct compiled_scene *scene, int inner, int outer) {
    switch (scene->primitives[outer].kind) {
    case KIND_BOX:
        return is_within_box(scene, inner, outer);
    case KIND_BALL:
        return is_within_ball(scene, inner, outer);
    case KIND_POLYHEDRON:
        return is_within_polyhedron(scene, inner, outer);
    default:
        return false;
    }
}

/* The enclosure of a primitive is the innermost of all that it lies within: that which lies within
 * the most others itself. */
void compile_enclosures(struct compiler *compiler) {
    struct compiled_scene *scene = compiler->scene;
    int depth[COMPILED_PRIMITIVES_MOST] = {0};
    for (int i = 0; i < scene->primitive_count; i++) {
        for (int j = 0; j < scene->primitive_count; j++) {
            depth[i] += i != j && is_within(scene, i, j);
        }
    }
    for (int i = 0; i < scene->primitive_count; i++) {
        struct compiled_primitive *primitive = &scene->primitives[i];
        primitive->enclosure = NO_ENCLOSURE;
        for (int j = 0; j < scene->primitive_count; j++) {
            if (i != j && is_within(scene, i, j) &&
                (primitive->enclosure == NO_ENCLOSURE || depth[j] > depth[primitive->enclosure])) {
                primitive->enclosure = (uint8_t)j;
            }
        }
        if (primitive->enclosure != NO_ENCLOSURE) {
            compiled_set_include(&scene->enclosed[primitive->enclosure], i);
        }
    }
}
