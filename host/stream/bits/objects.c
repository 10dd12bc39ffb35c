/* SPDX-License-Identifier: MIT */
/* Objects as Boolean functions of sets of primitives, for all lanes at once. */
#include "stream/objects.h"

/* Runs an object's program: sets 1 where the object holds the lane's set. As in firmware/ray.c,
 * each lane's stack of Booleans is a word. */
static void object_holds(const struct scene *scene, const struct object *object,
                         const uint32_t inside[restrict LANES], uint32_t holds[restrict LANES]) {
    const uint8_t *program = &scene->programs[object->program];
    for (int i = 0; i < LANES; i++) {
        holds[i] = 0;
    }
    for (uint8_t step = 0; step < object->length; step++) {
        uint8_t code = program[step];
        if (code < PROGRAM_UNION) {
            for (int i = 0; i < LANES; i++) {
                holds[i] = holds[i] << 1 | (inside[i] >> code % STREAM_PRIMITIVES_MOST & 1);
            }
            continue;
        }
        for (int i = 0; i < LANES; i++) {
            uint32_t right = holds[i] & 1, left = holds[i] >> 1 & 1;
            uint32_t value = code == PROGRAM_UNION          ? left | right
                             : code == PROGRAM_INTERSECTION ? left & right
                                                            : left & ~right;
            holds[i] = holds[i] >> 2 << 1 | value;
        }
    }
}

/* Returns the primitives that any lane is inside of: an object holds no place that is in none of
 * its primitives. */
static uint32_t union_of(const uint32_t sets[restrict LANES]) {
    uint32_t all = 0;
    for (int i = 0; i < LANES; i++) {
        all |= sets[i];
    }
    return all;
}

void media_before(struct set_memory *memory, const struct ray_lanes *restrict rays,
                  uint32_t object[restrict LANES]) {
    (void)memory;
    for (int i = 0; i < LANES; i++) {
        object[i] = path_object(rays->path[i]);
    }
}

void media_objects(struct set_memory *memory, const struct scene *scene,
                   const uint32_t inside[restrict LANES], uint32_t object[restrict LANES]) {
    const uint32_t any = union_of(inside);
    uint32_t holds[LANES];
    (void)memory;
    for (int i = 0; i < LANES; i++) {
        object[i] = OBJECT_AIR;
    }
    for (uint32_t number = OBJECT_AIR + 1; number < scene->object_count; number++) {
        if ((any & scene->objects[number].uses.word[0]) == 0) {
            continue;
        }
        object_holds(scene, &scene->objects[number], inside, holds);
        for (int i = 0; i < LANES; i++) {
            object[i] = holds[i] != 0 ? number : object[i];
        }
    }
}

void media_shadows(struct set_memory *memory, const struct scene *scene,
                   const uint32_t inside[restrict LANES], uint32_t shadow[restrict LANES]) {
    const uint32_t any = union_of(inside);
    uint32_t holds[LANES];
    (void)memory;
    for (int i = 0; i < LANES; i++) {
        shadow[i] = scene->materials[MATERIAL_AIR].casts_shadow ? 1 : 0;
    }
    for (uint32_t number = OBJECT_AIR + 1; number < scene->object_count; number++) {
        const struct object *object = &scene->objects[number];
        uint32_t casts = scene->materials[object->material].casts_shadow ? 1 : 0;
        if (!object->in_shadow_test || (any & object->uses.word[0]) == 0) {
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
