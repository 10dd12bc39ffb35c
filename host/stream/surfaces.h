/* SPDX-License-Identifier: MIT */
/* The surfaces of a scene. */
#ifndef SUPERFRAME_SURFACES_H
#define SUPERFRAME_SURFACES_H

#include "scene.h"

/* Returns the largest number of a surface that a primitive of the scene has; 0 where none has
 * one. */
uint32_t surface_last(const struct scene *scene);

#endif
