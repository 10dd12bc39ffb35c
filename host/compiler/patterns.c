/* SPDX-License-Identifier: MIT */
/* The scene compiler: patterns, and the faces in which their cells end. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/grow.h"
#include "compiler/compiler_internal.h"

/* Nearer to the end of a cell than this, an arithmetic may round a face's points to either side. */
#define BORDER_NEAR 0x1p-6

/* Places the cells of a pattern along an axis, from a corner of an even cell near the middle of the
 * scene. The pattern stays the same, and far origins lose no digits. Cells that are larger than the
 * world end in the world once at most. Returns false if the corner lies outside of the world. */
static bool place_cells(const struct scene_pattern *pattern, int axis, double scale, double origin,
                        struct compiled_pattern *compiled) {
    double size = pattern->size[axis] * scale;
    compiled->origin[axis] = remainder(origin, 2 * size);
    compiled->size[axis] = fmin(size, COMPILE_FAR);
    compiled->axes = (uint8_t)(compiled->axes | 1 << axis);
    return fabs(compiled->origin[axis]) < COMPILE_WORLD;
}

bool compile_pattern(struct compiler *compiler, const struct scene_material *from,
                     struct compiled_material *material) {
    struct compiled_scene *scene = compiler->scene;
    const struct scene_pattern *pattern = &from->pattern;
    double origin[3];
    if (!pattern->present) {
        return true;
    }
    material->pattern = (uint8_t)scene->pattern_count;
    struct compiled_pattern *compiled = &scene->patterns[scene->pattern_count++];
    compiled->line = from->line;
    memcpy(compiled->colour, pattern->colour, sizeof compiled->colour);
    affine_point(&compiler->scaling, pattern->origin, origin);
    for (int i = 0; i < 3; i++) {
        if (pattern->size[i] > 0 &&
            !place_cells(pattern, i, ldexp(1, scene->exponent), origin[i], compiled)) {
            return compile_fail(compiler, from->line,
                                "a pattern of cells larger than the scene, whose origin lies "
                                "outside of it: at most %g units from the middle are allowed",
                                ldexp(COMPILE_WORLD, -scene->exponent));
        }
    }
    return true;
}

static bool is_odd(double cell) {
    return fmod(cell, 2) != 0;
}

/* Finds the cells of a pattern on both sides of a plane across one of its axes. Returns false if no
 * cell ends near the plane. */
static bool find_cells(const struct compiler *compiler, const struct compiled_pattern *pattern,
                       int axis, double place, struct compiled_pattern_face *face) {
    double nearest = round((place - pattern->origin[axis]) / pattern->size[axis]);
    double beyond = place - (pattern->origin[axis] + nearest * pattern->size[axis]);
    if (fabs(beyond) > BORDER_NEAR) {
        return false;
    }
    bool ends_there = compile_same(compiler, beyond, 0);
    face->axis = (uint8_t)axis;
    face->odd_above = is_odd(ends_there || beyond > 0 ? nearest : nearest - 1);
    face->odd_below = is_odd(ends_there || beyond < 0 ? nearest - 1 : nearest);
    return true;
}

/* Notes a face in which cells of a pattern end, if they do. noted[] says which surfaces the pattern
 * has already. Returns false with the failure recorded. */
static bool note_face(struct compiler *compiler, struct compiled_pattern *pattern,
                      const struct compiled_face *face, bool noted[]) {
    struct compiled_scene *scene = compiler->scene;
    struct compiled_pattern_face found;
    for (int axis = 0; axis < 3; axis++) {
        if ((pattern->axes >> axis & 1) == 0 || fabs(face->normal[axis]) != 1 ||
            noted[face->surface] ||
            !find_cells(compiler, pattern, axis, face->normal[axis] * face->offset, &found)) {
            continue;
        }
        if (!GROW(scene->pattern_faces, scene->pattern_face_count)) {
            return compile_fail_memory(compiler);
        }
        found.surface = face->surface;
        noted[face->surface] = true;
        scene->pattern_faces[scene->pattern_face_count++] = found;
        pattern->face_count++;
    }
    return true;
}

/* Notes the faces of all primitives for one pattern. */
static bool note_faces(struct compiler *compiler, struct compiled_pattern *pattern, bool noted[]) {
    const struct compiled_scene *scene = compiler->scene;
    for (uint32_t i = 0; i < scene->primitive_count; i++) {
        struct compiled_face faces[COMPILED_FACES_MOST];
        int count = compiled_faces(scene, i, faces);
        for (int j = 0; j < count; j++) {
            if (!note_face(compiler, pattern, &faces[j], noted)) {
                return false;
            }
        }
    }
    return true;
}

bool compile_pattern_faces(struct compiler *compiler) {
    struct compiled_scene *scene = compiler->scene;
    bool is_done = true;
    for (uint32_t i = 0; i < scene->pattern_count && is_done; i++) {
        bool *noted = calloc((size_t)scene->surface_count + 1, sizeof *noted);
        scene->patterns[i].first_face = scene->pattern_face_count;
        is_done = noted != NULL ? note_faces(compiler, &scene->patterns[i], noted)
                                : compile_fail_memory(compiler);
        free(noted);
    }
    return is_done;
}
