/* SPDX-License-Identifier: MIT */
/* Which object, and so which material, fills the place where each lane's ray is. */
#ifndef SUPERFRAME_MEDIA_H
#define SUPERFRAME_MEDIA_H

#include "stream/lanes.h"

/* The last object of the table that holds each set of primitives: object_behind() of
 * firmware/ray.c. */
void media_objects(const struct scene *scene, const uint32_t inside[LANES], uint32_t object[LANES]);

/* Which lanes are inside of something that keeps light off: throws_shadow(), as 1 or 0. */
void media_shadows(const struct scene *scene, const uint32_t inside[LANES], uint32_t shadow[LANES]);

/* The number of each object's material. */
void media_materials(const struct scene *scene, const uint32_t object[LANES],
                     uint32_t material[LANES]);

#endif
