/* SPDX-License-Identifier: MIT */
/* The scene compiler: balls and quadrics, in their own axes. */
#include <math.h>
#include <string.h>

#include "base/grow.h"
#include "compiler/compiler_internal.h"

static uint32_t compile_ball(struct compiler *compiler, const double centre[3], double radius) {
    struct compiled_scene *scene = compiler->scene;
    uint32_t surface = compile_new_surface(compiler);
    if (surface == COMPILED_NONE) {
        return COMPILED_NONE;
    }
    if (!GROW(scene->balls, scene->ball_count)) {
        return compile_fail_room(compiler);
    }
    struct compiled_ball *ball = &scene->balls[scene->ball_count++];
    memcpy(ball->centre, centre, sizeof ball->centre);
    ball->radius = radius;
    ball->surface = surface;
    return compile_note_curve(compiler,
                              compile_new_primitive(compiler, PRIMITIVE_BALL, scene->ball_count - 1,
                                                    COMPILED_FRAME_WORLD, true));
}

static uint32_t add_quadric(struct compiler *compiler, const struct compiled_quadric *quadric,
                            uint32_t frame) {
    const double *square = quadric->square;
    bool convex = square[0] >= 0 && square[1] >= 0 && square[2] >= 0;
    return compile_note_curve(compiler, compile_new_quadric(compiler, quadric, frame, convex));
}

/* Makes a quadric of a ball, so that the other side of the ball's surface rounds as this side
 * does. */
static bool make_quadric(struct compiler *compiler, uint32_t index) {
    struct compiled_scene *scene = compiler->scene;
    struct compiled_primitive *primitive = &scene->primitives[index];
    if (!GROW(scene->quadrics, scene->quadric_count)) {
        return compile_fail_memory(compiler);
    }
    const struct compiled_ball *ball = &scene->balls[primitive->index];
    struct compiled_quadric quadric = {.square = {1, 1, 1}, .surface = ball->surface};
    memcpy(quadric.centre, ball->centre, sizeof quadric.centre);
    quadric.constant = -ball->radius * ball->radius;
    primitive->kind = PRIMITIVE_QUADRIC;
    primitive->index = scene->quadric_count;
    scene->quadrics[scene->quadric_count++] = quadric;
    const uint64_t key = compile_quadric_key(&quadric, primitive->frame, NULL);
    return compile_note(compiler, key, index) != COMPILED_NONE;
}

/* Adds the other side of a surface that exists already, by the same numbers. */
static uint32_t add_opposite(struct compiler *compiler, uint32_t twin) {
    struct compiled_primitive *primitive = &compiler->scene->primitives[twin];
    if (primitive->kind == PRIMITIVE_BALL && !make_quadric(compiler, twin)) {
        return COMPILED_NONE;
    }
    struct compiled_quadric quadric = compiler->scene->quadrics[primitive->index];
    for (int i = 0; i < 3; i++) {
        quadric.square[i] = -quadric.square[i];
    }
    quadric.linear = -quadric.linear;
    quadric.constant = -quadric.constant;
    return add_quadric(compiler, &quadric, primitive->frame);
}

/* Tells whether a form is a ball's: the radius is the same along all axes. */
static bool is_round(const struct compiler *compiler, const struct quadric_axes *axes) {
    double radius = sqrt(fabs(axes->constant));
    for (int i = 0; i < 3; i++) {
        if (axes->square[i] <= 0 || !compile_same(compiler, axes->square[i] * radius, radius)) {
            return false;
        }
    }
    return true;
}

/* Adds a quadric with a surface that no primitive has. A linear part stays on the third axis. */
static uint32_t add_curve(struct compiler *compiler, struct quadric_axes *axes) {
    struct compiled_quadric quadric;
    double sign[3];
    int permutation[3];
    uint32_t frame;
    if (!compile_frame(compiler, axes->axis, axes->linear > 0, permutation, sign, &frame)) {
        return COMPILED_NONE;
    }
    uint32_t surface = compile_new_surface(compiler);
    if (surface == COMPILED_NONE) {
        return COMPILED_NONE;
    }
    memset(&quadric, 0, sizeof quadric);
    memcpy(quadric.centre, axes->origin, sizeof quadric.centre);
    for (int i = 0; i < 3; i++) {
        quadric.square[i] = axes->square[permutation[i]];
    }
    quadric.linear = axes->linear * sign[2];
    quadric.constant = axes->constant;
    quadric.surface = surface;
    return add_quadric(compiler, &quadric, frame);
}

static bool holds_no_point(const struct quadric_axes *axes) {
    return axes->square[0] > 0 && axes->square[1] > 0 && axes->square[2] > 0 && axes->constant >= 0;
}

/* Returns why a form cannot be a primitive of the firmware, or NULL if the form can. */
static const char *fault_of(const struct quadric_axes *axes) {
    if (holds_no_point(axes)) {
        return "a quadric that holds no point: its form has to be negative somewhere";
    }
    if (fabs(axes->linear) >= 2 * COMPILE_WORLD ||
        fabs(axes->constant) >= 4 * COMPILE_WORLD * COMPILE_WORLD) {
        return "a quadric that is nearly flat over the whole scene: use a half_space, or make it "
               "smaller";
    }
    for (int i = 0; i < 3; i++) {
        if (fabs(axes->origin[i]) >= COMPILE_WORLD) {
            return "a quadric whose centre or apex lies outside of the scene, at more than twice "
                   "its size: use a half_space, or move it";
        }
    }
    return NULL;
}

/* Finds a lower and an upper bound of a form's values within the world's box. */
static void form_range(const struct quadric_axes *axes, double *least, double *most) {
    *least = *most = axes->constant;
    for (int i = 0; i < 3; i++) {
        double reach = 0, square = axes->square[i], linear = i == 2 ? axes->linear : 0;
        for (int j = 0; j < 3; j++) {
            reach += COMPILE_WORLD * fabs(axes->axis[i][j]);
        }
        double middle = -vector_dot(axes->axis[i], axes->origin);
        double low = middle - reach, high = middle + reach;
        double at_low = (square * low + 2 * linear) * low;
        double at_high = (square * high + 2 * linear) * high;
        double bottom = fmin(at_low, at_high), top = fmax(at_low, at_high);
        double turn = square == 0 ? low : -linear / square; /* where the form's slope is 0 */
        if (turn > low && turn < high) {
            bottom = fmin(bottom, -linear * turn);
            top = fmax(top, -linear * turn);
        }
        *least += bottom;
        *most += top;
    }
}

/* Finds the half-space that stands for a form whose surface stays outside of the world. The plane
 * holds all of the world, or nothing. Returns false where the surface may come near. */
static bool stays_beyond(const struct quadric_axes *axes, struct scene_plane *plane) {
    const struct scene_plane up = {{0, 0, 1}, COMPILE_WORLD};
    double least, most;
    form_range(axes, &least, &most);
    *plane = up;
    plane->offset *= most < 0 ? 1 : -2;
    return least > 0 || most < 0;
}

/* Moves a centre that lies out of the scene to the scene's middle, along the axes that leave the
 * centre free. */
static void centre_form(struct quadric_axes *axes) {
    for (int i = 0; i < 3; i++) {
        double along = vector_dot(axes->origin, axes->axis[i]);
        bool is_free = axes->square[i] == 0 && (i != 2 || axes->linear == 0);
        for (int j = 0; j < 3 && is_free && fabs(along) >= COMPILE_EXTENT; j++) {
            axes->origin[j] -= along * axes->axis[i][j];
        }
    }
}

/* Appends the half-spaces of a form that is two parallel planes: what is between them, or what is
 * not. As planes, the faces coincide with those of other solids. */
static bool append_planes(struct compiler *compiler, const struct quadric_axes *axes) {
    double half = sqrt(fabs(axes->constant)), between = axes->square[0];
    double middle = vector_dot(axes->axis[0], axes->origin);
    for (int side = -1; side <= 1; side += 2) {
        struct scene_plane plane;
        for (int i = 0; i < 3; i++) {
            plane.normal[i] = side * between * axes->axis[0][i];
        }
        plane.offset = side * between * middle + between * half;
        uint32_t primitive = compile_half_space(compiler, &plane, &affine_identity);
        if (primitive == COMPILED_NONE || !compile_append(compiler, primitive)) {
            return false;
        }
    }
    return compile_append(compiler, between > 0 ? COMPILED_INTERSECTION : COMPILED_UNION);
}

bool compile_general_quadric(struct compiler *compiler, const struct solid_node *leaf,
                             const struct affine *placement) {
    struct quadric_axes axes;
    if (quadric_axes_of_leaf(leaf, placement, &axes) && axes.square[1] == 0 && axes.linear == 0 &&
        axes.square[0] * axes.constant < 0) {
        unsigned lost_line = compiler->lost_line;
        bool is_done = append_planes(compiler, &axes);
        compiler->lost_line = lost_line; /* one of the two may be out of the scene */
        return is_done;
    }
    uint32_t primitive = compile_quadric(compiler, leaf, placement);
    return primitive != COMPILED_NONE && compile_append(compiler, primitive);
}

uint32_t compile_quadric(struct compiler *compiler, const struct solid_node *leaf,
                         const struct affine *placement) {
    struct quadric_axes axes;
    bool opposite;
    if (!quadric_axes_of_leaf(leaf, placement, &axes)) {
        compile_fail(compiler, compiler->line,
                     "a quadric without a quadratic term: use a half_space");
        return COMPILED_NONE;
    }
    centre_form(&axes);
    const char *fault = fault_of(&axes);
    struct scene_plane plane;
    if (fault && !holds_no_point(&axes) && stays_beyond(&axes, &plane)) {
        return compile_placed_half_space(compiler, &plane);
    }
    if (fault) {
        compile_fail(compiler, compiler->line, "%s", fault);
        return COMPILED_NONE;
    }
    uint32_t twin;
    if (!compile_same_curve(compiler, &axes, &twin, &opposite)) {
        return COMPILED_NONE;
    }
    if (twin != COMPILED_NONE) {
        return opposite ? add_opposite(compiler, twin) : twin;
    }
    return is_round(compiler, &axes)
               ? compile_ball(compiler, axes.origin, sqrt(fabs(axes.constant)))
               : add_curve(compiler, &axes);
}
