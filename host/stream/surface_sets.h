/* SPDX-License-Identifier: MIT */
/* The primitives that each surface bounds, one word a surface, for many lanes to look up at once.
 */
#ifndef SUPERFRAME_TOUCHES_H
#define SUPERFRAME_TOUCHES_H

#include "scene.h"

/* The low bits of a surface's number are its place. SURFACE_NONE, all of whose bits are set, has
 * the last place, and bounds nothing. */
enum { TOUCHES = 256 };

/* Tells whether there is a place for each of the scene's surfaces. */
bool touches_fit(const struct scene *scene);

/* Fills the table for a scene that fits, and that has no more primitives than a word has bits. */
void touches_set(const struct scene *scene, uint32_t touches[TOUCHES]);

static inline uint32_t touches_of(const uint32_t touches[TOUCHES], uint32_t surface) {
    return touches[surface % TOUCHES];
}

#endif
