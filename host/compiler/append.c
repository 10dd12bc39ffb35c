/* SPDX-License-Identifier: MIT */
/* The scene compiler: entries that are appended to the tables, or found there. */
#include "compiler/compiler_internal.h"

#include <string.h>

bool compile_append(struct compiler *compiler, uint8_t code) {
    struct compiled_scene *scene = compiler->scene;
    struct compiled_object *object = &scene->objects[scene->object_count];
    if (object->length == 255) {
        return compile_fail(compiler, compiler->line,
                            "an object of more than 128 solids: split it into several objects");
    }
    if (scene->program_length == COMPILED_PROGRAM_BYTES_MOST) {
        return compile_fail(compiler, compiler->line,
                            "more than %d solids and operations in all objects: leave some out",
                            COMPILED_PROGRAM_BYTES_MOST);
    }
    scene->programs[scene->program_length++] = code;
    object->length++;
    return true;
}

int compile_new_primitive(struct compiler *compiler, enum primitive_kind kind, uint8_t index,
                          uint8_t frame, bool left_for_good) {
    struct compiled_scene *scene = compiler->scene;
    if (scene->primitive_count == COMPILED_DRAFTS_MOST ||
        scene->box_count == COMPILED_DRAFTS_MOST) {
        compile_fail(compiler, compiler->line, "more than %d different solids",
                     COMPILED_PRIMITIVES_MOST);
        return -1;
    }
    struct compiled_primitive *primitive = &scene->primitives[scene->primitive_count];
    primitive->kind = kind;
    primitive->index = index;
    primitive->frame = frame;
    primitive->left_for_good = left_for_good;
    primitive->line = compiler->line;
    return scene->primitive_count++;
}

/* Sets the faces of a box: faces of one surface lie at the same place to the last bit. Returns
 * false with the failure recorded. */
static bool set_faces(struct compiler *compiler, struct compiled_box *box, uint8_t frame,
                      const double low[3], const double high[3]) {
    for (int face = 0; face < 6; face++) {
        const double *axis = compiled_axis(compiler->scene, frame, face % 3);
        int surface = compile_plane_surface(compiler, axis, face < 3 ? low[face] : high[face - 3]);
        if (surface < 0) {
            return false;
        }
        double place = compile_place_of_plane(compiler, surface, axis);
        *(face < 3 ? &box->minimum[face] : &box->maximum[face - 3]) = place;
        box->surface[face] = (uint16_t)surface;
    }
    return true;
}

int compile_box_in(struct compiler *compiler, uint8_t frame, const double low[3],
                   const double high[3]) {
    struct compiled_scene *scene = compiler->scene;
    struct compiled_box box = {{0}, {0}, {0}};
    if (!set_faces(compiler, &box, frame, low, high)) {
        return -1;
    }
    for (int i = 0; i < 3; i++) {
        if (box.surface[i] == box.surface[i + 3]) {
            return compile_fail_thin(compiler);
        }
    }
    for (int i = 0; i < scene->primitive_count; i++) {
        const struct compiled_primitive *other = &scene->primitives[i];
        if (other->kind == PRIMITIVE_BOX && other->frame == frame &&
            memcmp(box.surface, scene->boxes[other->index].surface, sizeof box.surface) == 0) {
            return i;
        }
    }
    int primitive = compile_new_primitive(compiler, PRIMITIVE_BOX, scene->box_count, frame, false);
    if (primitive >= 0) {
        scene->boxes[scene->box_count++] = box;
    }
    return primitive;
}

int compile_world_box(struct compiler *compiler, const double low[3], const double high[3]) {
    return compile_box_in(compiler, FRAME_WORLD, low, high);
}
