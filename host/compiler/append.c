/* SPDX-License-Identifier: MIT */
/* The scene compiler: entries that are appended to the tables, or found there. */
#include "compiler/compiler_internal.h"

#include <string.h>

#include "base/grow.h"

bool compile_append(struct compiler *compiler, uint32_t code) {
    struct compiled_scene *scene = compiler->scene;
    struct compiled_object *object = &scene->objects[scene->object_count];
    if (!GROW(scene->programs, scene->program_length)) {
        return compile_fail_memory(compiler);
    }
    scene->programs[scene->program_length++] = code;
    object->length++;
    return true;
}

uint32_t compile_new_primitive(struct compiler *compiler, enum primitive_kind kind, uint32_t index,
                               uint32_t frame, bool left_for_good) {
    struct compiled_scene *scene = compiler->scene;
    if (!GROW(scene->primitives, scene->primitive_count)) {
        return compile_fail_room(compiler);
    }
    struct compiled_primitive *primitive = &scene->primitives[scene->primitive_count];
    primitive->kind = kind;
    primitive->index = index;
    primitive->frame = frame;
    primitive->left_for_good = left_for_good;
    primitive->line = compiler->line;
    return scene->primitive_count++;
}

uint64_t compile_quadric_key(const struct compiled_quadric *quadric, uint32_t frame,
                             const struct compiled_box *box) {
    uint64_t key = bucket_key(bucket_key(compile_key(KNOWN_QUADRIC), frame), quadric->surface);
    for (int i = 0; i < 6 && quadric->cuts != 0; i++) {
        key = bucket_key(key, (quadric->cuts >> i % 3 & 1) != 0 ? box->surface[i] : COMPILED_NONE);
    }
    return key;
}

uint32_t compile_new_quadric(struct compiler *compiler, const struct compiled_quadric *quadric,
                             uint32_t frame, bool left_for_good) {
    struct compiled_scene *scene = compiler->scene;
    if (!GROW(scene->quadrics, scene->quadric_count)) {
        return compile_fail_room(compiler);
    }
    scene->quadrics[scene->quadric_count++] = *quadric;
    const uint64_t key = compile_quadric_key(quadric, frame, compiled_box_of(scene, quadric));
    return compile_note(compiler, key,
                        compile_new_primitive(compiler, PRIMITIVE_QUADRIC, scene->quadric_count - 1,
                                              frame, left_for_good));
}

/* Sets the faces of a box: faces of one surface lie at the same place to the last bit. Returns
 * false with the failure recorded. */
static bool set_faces(struct compiler *compiler, struct compiled_box *box, uint32_t frame,
                      const double low[3], const double high[3]) {
    for (int face = 0; face < 6; face++) {
        const double *axis = compiled_axis(compiler->scene, frame, face % 3);
        uint32_t surface =
            compile_plane_surface(compiler, axis, face < 3 ? low[face] : high[face - 3]);
        if (surface == COMPILED_NONE) {
            return false;
        }
        double place = compile_place_of_plane(compiler, surface, axis);
        *(face < 3 ? &box->minimum[face] : &box->maximum[face - 3]) = place;
        box->surface[face] = surface;
    }
    return true;
}

static uint64_t box_key(uint32_t frame, const struct compiled_box *box) {
    uint64_t key = bucket_key(compile_key(KNOWN_BOX), frame);
    for (int i = 0; i < 6; i++) {
        key = bucket_key(key, box->surface[i]);
    }
    return key;
}

uint32_t compile_box_in(struct compiler *compiler, uint32_t frame, const double low[3],
                        const double high[3]) {
    struct compiled_scene *scene = compiler->scene;
    struct compiled_box box = {{0}, {0}, {0}};
    if (!set_faces(compiler, &box, frame, low, high)) {
        return COMPILED_NONE;
    }
    for (int i = 0; i < 3; i++) {
        if (box.surface[i] == box.surface[i + 3]) {
            return compile_fail_thin(compiler);
        }
    }
    const uint64_t key = box_key(frame, &box);
    uint32_t slot = buckets_first(&compiler->known, key);
    for (; slot != COMPILED_NONE; slot = buckets_next(&compiler->known, slot)) {
        const uint32_t known = compiler->known.slots[slot].entry;
        const struct compiled_primitive *other = &scene->primitives[known];
        if (other->kind == PRIMITIVE_BOX && other->frame == frame &&
            memcmp(box.surface, scene->boxes[other->index].surface, sizeof box.surface) == 0) {
            return known;
        }
    }
    if (!GROW(scene->boxes, scene->box_count)) {
        return compile_fail_room(compiler);
    }
    scene->boxes[scene->box_count++] = box;
    return compile_note(
        compiler, key,
        compile_new_primitive(compiler, PRIMITIVE_BOX, scene->box_count - 1, frame, false));
}

uint32_t compile_world_box(struct compiler *compiler, const double low[3], const double high[3]) {
    return compile_box_in(compiler, COMPILED_FRAME_WORLD, low, high);
}
