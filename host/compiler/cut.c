/* SPDX-License-Identifier: MIT */
/* A quadric that planes across its axes cut, while the scene compiler puts it together. */
#include "compiler/cut.h"

#include <math.h>
#include <string.h>

#include "base/grow.h"

static void start_ball(const struct compiled_ball *ball, struct cut_quadric *cut) {
    cut->is_ball = true;
    memcpy(cut->quadric.centre, ball->centre, sizeof ball->centre);
    for (int i = 0; i < 3; i++) {
        cut->quadric.square[i] = 1;
    }
    cut->quadric.constant = -ball->radius * ball->radius;
    cut->quadric.surface = ball->surface;
}

bool cut_start(const struct compiled_scene *scene, uint32_t index, struct cut_quadric *cut) {
    const struct compiled_primitive *primitive = &scene->primitives[index];
    memset(cut, 0, sizeof *cut);
    cut->frame = primitive->frame;
    cut->line = primitive->line;
    for (int i = 0; i < 3; i++) {
        cut->box.minimum[i] = -HUGE_VAL;
        cut->box.maximum[i] = HUGE_VAL;
    }
    if (primitive->kind == PRIMITIVE_BALL) {
        start_ball(&scene->balls[primitive->index], cut);
        return true;
    }
    if (primitive->kind != PRIMITIVE_QUADRIC) {
        return false;
    }
    cut->quadric = scene->quadrics[primitive->index];
    for (int i = 0; i < 3; i++) {
        if ((cut->quadric.cuts >> i & 1) != 0) {
            const struct compiled_box *box = &scene->boxes[cut->quadric.box];
            cut->box.minimum[i] = box->minimum[i];
            cut->box.maximum[i] = box->maximum[i];
        }
    }
    return true;
}

/* Finds or adds a frame that has a plane's normal for an axis; false with the failure recorded. */
static bool frame_across(struct compiler *compiler, const double normal[3], uint32_t *frame) {
    double axis[3][3], sign[3];
    int permutation[3], least = 0;
    for (int i = 1; i < 3; i++) {
        least = fabs(normal[i]) < fabs(normal[least]) ? i : least;
    }
    memcpy(axis[2], normal, sizeof axis[2]);
    vector_cross(normal, affine_identity.m[least], axis[0]);
    vector_normalise(axis[0]);
    vector_cross(axis[2], axis[0], axis[1]);
    return compile_frame(compiler, axis, false, permutation, sign, frame);
}

/* Returns the axis of a frame that a plane lies across, -1 if there is none. */
static int axis_across(const struct compiled_scene *scene, uint32_t frame, const double normal[3]) {
    int axis = 2;
    while (axis >= 0 && vector_parallel(normal, compiled_axis(scene, frame, axis)) == 0) {
        axis--;
    }
    return axis;
}

int cut_axis(struct compiler *compiler, struct cut_quadric *cut, const double normal[3]) {
    int axis = axis_across(compiler->scene, cut->frame, normal);
    if (axis >= 0) {
        return axis;
    }
    if (!cut->is_ball || cut->frame != COMPILED_FRAME_WORLD || cut->quadric.cuts != 0) {
        return -1;
    }
    if (!frame_across(compiler, normal, &cut->frame)) {
        return -1;
    }
    return axis_across(compiler->scene, cut->frame, normal);
}

void cut_across(struct cut_quadric *cut, int axis, double along, double offset) {
    double *low = &cut->box.minimum[axis], *high = &cut->box.maximum[axis];
    if (along > 0) {
        *high = fmin(*high, offset);
    } else {
        *low = fmax(*low, -offset);
    }
    cut->quadric.cuts = (uint8_t)(cut->quadric.cuts | 1 << axis);
}

/* Drops the cuts across axes along which the other faces end the solid already. */
static void drop_idle_axes(const struct compiled_scene *scene, struct cut_quadric *cut) {
    for (int i = 0; i < 3; i++) {
        struct compiled_quadric without = cut->quadric;
        double low[3], high[3];
        double centre = vector_dot(without.centre, compiled_axis(scene, cut->frame, i));
        without.cuts = (uint8_t)(without.cuts & ~(1u << i));
        quadric_extent(scene, &without, &cut->box, cut->frame, low, high);
        if (centre + low[i] > cut->box.minimum[i] + COMPILE_STRICTLY &&
            centre + high[i] < cut->box.maximum[i] - COMPILE_STRICTLY) {
            cut->quadric.cuts = without.cuts;
        }
    }
}

/* Places the sides that nothing cuts COMPILE_MARGIN off the solid, or at COMPILE_FAR if that is
 * nearer. */
static void close_sides(const struct compiled_scene *scene, struct cut_quadric *cut) {
    double low[3], high[3];
    quadric_extent(scene, &cut->quadric, &cut->box, cut->frame, low, high);
    for (int i = 0; i < 3; i++) {
        double centre = vector_dot(cut->quadric.centre, compiled_axis(scene, cut->frame, i));
        if (!isfinite(cut->box.minimum[i])) {
            cut->box.minimum[i] = fmax(centre + low[i] - COMPILE_MARGIN, -COMPILE_FAR);
        }
        if (!isfinite(cut->box.maximum[i])) {
            cut->box.maximum[i] = fmin(centre + high[i] + COMPILE_MARGIN, COMPILE_FAR);
        }
    }
}

/* Finds or adds the surfaces of the faces that cut. A face takes over its surface's place, so that
 * coincident faces agree to the last bit. */
static bool find_surfaces(struct compiler *compiler, struct cut_quadric *cut) {
    for (int face = 0; face < 6; face++) {
        const double *axis = compiled_axis(compiler->scene, cut->frame, face % 3);
        double *place = face < 3 ? &cut->box.minimum[face] : &cut->box.maximum[face - 3];
        if ((cut->quadric.cuts >> face % 3 & 1) == 0) {
            continue;
        }
        uint32_t surface = compile_plane_surface(compiler, axis, *place);
        if (surface == COMPILED_NONE) {
            return false;
        }
        *place = compile_place_of_plane(compiler, surface, axis);
        cut->box.surface[face] = surface;
    }
    return true;
}

static bool is_same(const struct compiled_scene *scene, const struct compiled_primitive *other,
                    const struct cut_quadric *cut) {
    const struct compiled_quadric *quadric = &scene->quadrics[other->index];
    if (other->kind != PRIMITIVE_QUADRIC || other->frame != cut->frame ||
        quadric->surface != cut->quadric.surface || quadric->cuts != cut->quadric.cuts) {
        return false;
    }
    const struct compiled_box *box = &scene->boxes[quadric->box];
    for (int i = 0; i < 3; i++) {
        if ((quadric->cuts >> i & 1) != 0 && (box->surface[i] != cut->box.surface[i] ||
                                              box->surface[i + 3] != cut->box.surface[i + 3])) {
            return false;
        }
    }
    return true;
}

/* Adds the box to the table of boxes. The quadric's own one, if it had one, has been copied by
 * then. */
static bool keep_box(struct compiler *compiler, struct cut_quadric *cut) {
    struct compiled_scene *scene = compiler->scene;
    if (!GROW(scene->boxes, scene->box_count)) {
        return compile_fail_memory(compiler);
    }
    cut->quadric.box = scene->box_count;
    scene->boxes[scene->box_count++] = cut->box;
    return true;
}

uint32_t cut_finish(struct compiler *compiler, struct cut_quadric *cut) {
    struct compiled_scene *scene = compiler->scene;
    compiler->line = cut->line;
    drop_idle_axes(scene, cut);
    close_sides(scene, cut);
    if (!find_surfaces(compiler, cut)) {
        return COMPILED_NONE;
    }
    const uint64_t key = compile_quadric_key(&cut->quadric, cut->frame, &cut->box);
    uint32_t slot = buckets_first(&compiler->known, key), twin = COMPILED_NONE;
    for (; slot != COMPILED_NONE; slot = buckets_next(&compiler->known, slot)) {
        const uint32_t known = compiler->known.slots[slot].entry;
        if (known < twin && is_same(scene, &scene->primitives[known], cut)) {
            twin = known;
        }
    }
    if (twin != COMPILED_NONE) {
        return twin;
    }
    return keep_box(compiler, cut) ? compile_new_quadric(compiler, &cut->quadric, cut->frame, false)
                                   : COMPILED_NONE;
}

bool cut_replace(struct compiler *compiler, struct cut_quadric *cut, uint32_t index) {
    struct compiled_scene *scene = compiler->scene;
    struct compiled_primitive *primitive = &scene->primitives[index];
    compiler->line = cut->line;
    drop_idle_axes(scene, cut);
    close_sides(scene, cut);
    if (!find_surfaces(compiler, cut) || !keep_box(compiler, cut)) {
        return false;
    }
    primitive->left_for_good = false;
    scene->quadrics[primitive->index] = cut->quadric;
    return true;
}
