/* SPDX-License-Identifier: MIT */
/* The objects of numbered sets: each is found once. */
#include "stream/objects.h"

#include "sets/list/objects.h"

/* Returns the object that fills the place of a set. */
static uint32_t object_of(struct set_memory *memory, const struct scene *scene, uint32_t number) {
    struct numbered_set *numbered = &memory->sets[number];
    if (numbered->object == SET_UNKNOWN) {
        numbered->object = object_at(scene, &numbered->set, false);
    }
    return numbered->object;
}

void media_before(struct set_memory *memory, const struct ray_lanes *restrict rays,
                  uint32_t object[restrict LANES]) {
    media_objects(memory, memory->scene, rays->inside, object);
}

void media_objects(struct set_memory *memory, const struct scene *scene,
                   const uint32_t inside[restrict LANES], uint32_t object[restrict LANES]) {
    for (int i = 0; i < LANES; i++) {
        object[i] = object_of(memory, scene, inside[i]);
    }
}

void media_shadows(struct set_memory *memory, const struct scene *scene,
                   const uint32_t inside[restrict LANES], uint32_t shadow[restrict LANES]) {
    for (int i = 0; i < LANES; i++) {
        struct numbered_set *numbered = &memory->sets[inside[i]];
        if (numbered->shadows == SET_UNKNOWN) {
            const struct object *object = &scene->objects[object_at(scene, &numbered->set, true)];
            numbered->shadows = scene->materials[object->material].casts_shadow ? 1 : 0;
        }
        shadow[i] = numbered->shadows;
    }
}

void media_materials(const struct scene *scene, const uint32_t object[restrict LANES],
                     uint32_t material[restrict LANES]) {
    for (int i = 0; i < LANES; i++) {
        material[i] = scene->objects[object[i]].material;
    }
}
