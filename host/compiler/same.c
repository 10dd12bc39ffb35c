/* SPDX-License-Identifier: MIT */
/* The scene compiler: which directions, planes and frames count as one, however the file writes
 * each. */
#include <math.h>
#include <string.h>

#include "base/grow.h"
#include "compiler/compiler_internal.h"

/* Tells whether two directions count as one, the second times the sign. A direction may be off by
 * so much that nothing within the scene moves by more than compiler->same. */
static bool same_direction(const struct compiler *compiler, const double a[3], const double b[3],
                           double sign) {
    for (int i = 0; i < 3; i++) {
        if (fabs(a[i] - sign * b[i]) * COMPILE_EXTENT > compiler->same) {
            return false;
        }
    }
    return true;
}

bool compile_same(const struct compiler *compiler, double a, double b) {
    return fabs(a - b) <= compiler->same;
}

bool compile_direction(struct compiler *compiler, double direction[3]) {
    for (uint32_t i = 0; i < compiler->direction_count; i++) {
        const double *known = compiler->directions[i];
        double sign = vector_dot(direction, known) < 0 ? -1 : 1;
        if (same_direction(compiler, direction, known, sign)) {
            for (int j = 0; j < 3; j++) {
                direction[j] = sign * known[j];
            }
            return true;
        }
    }
    if (!GROW(compiler->directions, compiler->direction_count)) {
        return compile_fail_memory(compiler);
    }
    memcpy(compiler->directions[compiler->direction_count++], direction,
           sizeof compiler->directions[0]);
    return true;
}

uint32_t compile_new_surface(struct compiler *compiler) {
    struct compiled_scene *scene = compiler->scene;
    if (!GROW(compiler->planes, scene->surface_count)) {
        (void)compile_fail_memory(compiler);
        return COMPILED_NONE;
    }
    return scene->surface_count++;
}

uint32_t compile_fail_thin(struct compiler *compiler) {
    compile_fail(compiler, compiler->line,
                 "a solid thinner than %g units: its faces are one; make it thicker, or 'weld' "
                 "smaller",
                 ldexp(compiler->same, -compiler->scene->exponent));
    return COMPILED_NONE;
}

uint32_t compile_plane_surface(struct compiler *compiler, const double normal[3], double offset) {
    for (uint32_t i = 0; i < compiler->scene->surface_count; i++) {
        const struct compile_plane *plane = &compiler->planes[i];
        double sign = vector_parallel(normal, plane->normal);
        if (sign != 0 && compile_same(compiler, sign * offset, plane->offset)) {
            return i;
        }
    }
    uint32_t surface = compile_new_surface(compiler);
    if (surface != COMPILED_NONE) {
        memcpy(compiler->planes[surface].normal, normal, 3 * sizeof *normal);
        compiler->planes[surface].offset = offset;
    }
    return surface;
}

double compile_place_of_plane(const struct compiler *compiler, uint32_t surface,
                              const double axis[3]) {
    const struct compile_plane *plane = &compiler->planes[surface];
    return vector_parallel(axis, plane->normal) < 0 ? -plane->offset : plane->offset;
}

/* Sorts axes into those of a frame, up to their order and signs. Returns false if they do not
 * match, or the third axis would have to stay and does not. */
static bool sort_axes(const struct compiled_scene *scene, uint32_t frame, double axis[3][3],
                      bool third_stays, int permutation[3], double sign[3]) {
    for (int i = 0; i < 3; i++) {
        int j = 0;
        while (j < 3 && vector_parallel(axis[j], compiled_axis(scene, frame, i)) == 0) {
            j++;
        }
        if (j == 3) {
            return false;
        }
        permutation[i] = j;
        sign[i] = vector_parallel(axis[j], compiled_axis(scene, frame, i));
    }
    return !third_stays || permutation[2] == 2;
}

bool compile_frame(struct compiler *compiler, double axis[3][3], bool third_stays,
                   int permutation[3], double sign[3], uint32_t *frame) {
    struct compiled_scene *scene = compiler->scene;
    for (int i = 0; i < 3; i++) {
        if (!compile_direction(compiler, axis[i])) {
            return false;
        }
    }
    if (sort_axes(scene, COMPILED_FRAME_WORLD, axis, third_stays, permutation, sign)) {
        *frame = COMPILED_FRAME_WORLD;
        return true;
    }
    for (uint32_t i = 0; i < scene->frame_count; i++) {
        if (sort_axes(scene, i, axis, third_stays, permutation, sign)) {
            *frame = i;
            return true;
        }
    }
    if (!GROW(scene->frames, scene->frame_count)) {
        return compile_fail_memory(compiler);
    }
    memcpy(scene->frames[scene->frame_count].axis, axis, sizeof scene->frames[0].axis);
    for (int i = 0; i < 3; i++) {
        permutation[i] = i;
        sign[i] = 1;
    }
    *frame = scene->frame_count++;
    return true;
}
