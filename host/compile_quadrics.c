/* SPDX-License-Identifier: MIT */
/* The scene compiler: balls and quadrics, in their own axes. */
#include <math.h>
#include <string.h>

#include "compile_internal.h"

static int compile_ball(struct compiler *compiler, const double centre[3], double radius) {
    struct compiled_scene *scene = compiler->scene;
    for (int i = 0; i < scene->primitive_count; i++) {
        const struct compiled_ball *other = &scene->balls[scene->primitives[i].index];
        if (scene->primitives[i].kind == KIND_BALL && compile_same_point(centre, other->centre) &&
            compile_same(radius, other->radius)) {
            return i;
        }
    }
    int primitive =
        compile_new_primitive(compiler, KIND_BALL, scene->ball_count, WORLD_FRAME, true);
    int surface = primitive < 0 ? -1 : compile_new_surface(compiler);
    if (surface < 0) {
        return -1;
    }
    struct compiled_ball *ball = &scene->balls[scene->ball_count++];
    memcpy(ball->centre, centre, sizeof ball->centre);
    ball->radius = radius;
    ball->surface = (uint16_t)surface;
    return primitive;
}

static bool same_quadric(const struct compiled_quadric *a, const struct compiled_quadric *b) {
    return compile_same_point(a->centre, b->centre) && compile_same_point(a->square, b->square) &&
           compile_same(a->linear, b->linear) &&
           fabs(a->constant - b->constant) <= COMPILE_SAME * COMPILE_EXTENT;
}

static int add_quadric(struct compiler *compiler, const struct compiled_quadric *quadric,
                       int frame) {
    struct compiled_scene *scene = compiler->scene;
    for (int i = 0; i < scene->primitive_count; i++) {
        const struct compiled_primitive *other = &scene->primitives[i];
        if (other->kind == KIND_QUADRIC && other->frame == frame &&
            same_quadric(quadric, &scene->quadrics[other->index])) {
            return i;
        }
    }
    const double *square = quadric->square;
    bool convex = square[0] >= 0 && square[1] >= 0 && square[2] >= 0;
    int primitive =
        compile_new_primitive(compiler, KIND_QUADRIC, scene->quadric_count, (uint8_t)frame, convex);
    int surface = primitive < 0 ? -1 : compile_new_surface(compiler);
    if (surface < 0) {
        return -1;
    }
    scene->quadrics[scene->quadric_count] = *quadric;
    scene->quadrics[scene->quadric_count++].surface = (uint16_t)surface;
    return primitive;
}

/* Axes that are the world's need no frame. The third one takes the linear part with it. */
static int quadric_frame(struct compiler *compiler, double axis[3][3],
                         struct compiled_quadric *quadric) {
    int permutation[3];
    double sign[3], square[3];
    bool upright = quadric->linear <= 0 || compile_same(fabs(axis[2][2]), 1);
    if (!upright || !compile_straighten(axis, permutation, sign)) {
        return compile_frame(compiler, axis);
    }
    for (int i = 0; i < 3; i++) {
        square[i] = quadric->square[permutation[i]];
    }
    memcpy(quadric->square, square, sizeof square);
    quadric->linear *= sign[2];
    return WORLD_FRAME;
}

int compile_quadric(struct compiler *compiler, const struct solid_node *leaf,
                    const struct affine *placement) {
    struct quadric_axes axes;
    struct compiled_quadric quadric;
    if (!quadric_axes_of_leaf(leaf, placement, &axes)) {
        compile_fail(compiler, compiler->line,
                     "a quadric without a quadratic term: use a half_space");
        return -1;
    }
    bool definite = axes.square[0] > 0 && axes.square[1] > 0 && axes.square[2] > 0;
    if (definite && axes.constant >= 0) {
        compile_fail(compiler, compiler->line,
                     "a quadric that holds no point: its form has to be negative somewhere");
        return -1;
    }
    if (definite && compile_same(axes.square[0], 1) && compile_same(axes.square[1], 1) &&
        compile_same(axes.square[2], 1)) {
        return compile_ball(compiler, axes.origin, sqrt(-axes.constant));
    }
    memset(&quadric, 0, sizeof quadric);
    memcpy(quadric.centre, axes.origin, sizeof quadric.centre);
    memcpy(quadric.square, axes.square, sizeof quadric.square);
    quadric.linear = axes.linear;
    quadric.constant = axes.constant;
    if (fabs(quadric.linear) >= 2 * COMPILE_WORLD ||
        fabs(quadric.constant) >= 4 * COMPILE_WORLD * COMPILE_WORLD) {
        compile_fail(compiler, compiler->line,
                     "a quadric that is nearly flat over the whole scene: use a half_space, or "
                     "make it smaller");
        return -1;
    }
    for (int i = 0; i < 3; i++) {
        if (fabs(axes.origin[i]) >= COMPILE_WORLD) {
            compile_fail(compiler, compiler->line,
                         "a quadric whose centre or apex lies outside of the scene, at more than "
                         "twice its size: use a half_space, or move it");
            return -1;
        }
    }
    int frame = quadric_frame(compiler, axes.axis, &quadric);
    return frame < 0 ? -1 : add_quadric(compiler, &quadric, frame);
}
