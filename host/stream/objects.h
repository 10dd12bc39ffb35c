/* SPDX-License-Identifier: MIT */
/* Which object, and so which material, fills the place where each lane's ray is. */
#ifndef SUPERFRAME_MEDIA_H
#define SUPERFRAME_MEDIA_H

#include "set_memory.h"

/* Finds the object that each ray runs in. */
void media_before(struct set_memory *memory, const struct ray_lanes *rays, uint32_t object[LANES]);

/* Finds the last object of the table that holds each set of primitives: object_behind() of
 * firmware/ray.c. OBJECT_AIR: none does. */
void media_objects(struct set_memory *memory, const struct scene *scene,
                   const uint32_t inside[LANES], uint32_t object[LANES]);

/* Finds the lanes that are inside of something that keeps light off, as 1 or 0: throws_shadow() of
 * firmware/ray.c. */
void media_shadows(struct set_memory *memory, const struct scene *scene,
                   const uint32_t inside[LANES], uint32_t shadow[LANES]);

/* Finds the number of each object's material. */
void media_materials(const struct scene *scene, const uint32_t object[LANES],
                     uint32_t material[LANES]);

#endif
