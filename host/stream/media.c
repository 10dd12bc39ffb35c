/* SPDX-License-Identifier: MIT */
/* Objects as Boolean functions of sets of primitives, for all lanes at once. */
#include "media.h"

enum { STACK_MOST = 32 }; /* the firmware's stack of Booleans is a word */

/* Runs an object's program: 1 where it holds the lane's set. */
static void object_holds(const struct scene *scene, const struct object *object,
                         const uint32_t inside[restrict LANES], uint32_t holds[restrict LANES]) {
    const uint8_t *program = &scene->programs[object->program];
    uint32_t stack[STACK_MOST][LANES];
    uint32_t height = 0;
    for (uint8_t step = 0; step < object->length; step++) {
        uint8_t code = program[step];
        if (code < PROGRAM_UNION) {
            for (int i = 0; i < LANES; i++) {
                stack[height][i] = inside[i] >> code % STREAM_PRIMITIVES_MOST & 1;
            }
            height++;
            continue;
        }
        height--;
        uint32_t *left = stack[height - 1];
        const uint32_t *right = stack[height];
        for (int i = 0; i < LANES; i++) {
            left[i] = code == PROGRAM_UNION          ? left[i] | right[i]
                      : code == PROGRAM_INTERSECTION ? left[i] & right[i]
                                                     : left[i] & ~right[i];
        }
    }
    for (int i = 0; i < LANES; i++) {
        holds[i] = stack[0][i];
    }
}

void media_objects(const struct scene *scene, const uint32_t inside[restrict LANES],
                   uint32_t object[restrict LANES]) {
    uint32_t holds[LANES];
    for (int i = 0; i < LANES; i++) {
        object[i] = OBJECT_AIR;
    }
    for (uint32_t number = OBJECT_AIR + 1; number < scene->object_count; number++) {
        object_holds(scene, &scene->objects[number], inside, holds);
        for (int i = 0; i < LANES; i++) {
            object[i] = holds[i] != 0 ? number : object[i];
        }
    }
}

void media_shadows(const struct scene *scene, const uint32_t inside[restrict LANES],
                   uint32_t shadow[restrict LANES]) {
    uint32_t holds[LANES];
    for (int i = 0; i < LANES; i++) {
        shadow[i] = scene->materials[MATERIAL_AIR].casts_shadow ? 1 : 0;
    }
    for (uint32_t number = OBJECT_AIR + 1; number < scene->object_count; number++) {
        const struct object *object = &scene->objects[number];
        uint32_t casts = scene->materials[object->material].casts_shadow ? 1 : 0;
        if (!object->in_shadow_test) {
            continue;
        }
        object_holds(scene, object, inside, holds);
        for (int i = 0; i < LANES; i++) {
            shadow[i] = holds[i] != 0 ? casts : shadow[i];
        }
    }
}

void media_materials(const struct scene *scene, const uint32_t object[restrict LANES],
                     uint32_t material[restrict LANES]) {
    for (int i = 0; i < LANES; i++) {
        material[i] = MATERIAL_AIR;
    }
    for (uint32_t number = OBJECT_AIR + 1; number < scene->object_count; number++) {
        uint32_t its = scene->objects[number].material;
        for (int i = 0; i < LANES; i++) {
            material[i] = object[i] == number ? its : material[i];
        }
    }
}
