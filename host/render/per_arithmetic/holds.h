/* SPDX-License-Identifier: MIT */
/* Checks that an arithmetic can hold a scene: what differs still differs, and keeps its shape. */
#ifndef SUPERFRAME_ARITHMETIC_HOLDS_H
#define SUPERFRAME_ARITHMETIC_HOLDS_H

#include "compiler/tables.h"

/* Checks what the tables become in this arithmetic. False, with *error filled, where two surfaces
 * become one, a wall that light never sees; where a solid is too small, or moves visibly; and where
 * a pattern's cells do. */
bool arithmetic_holds(const struct compiled_scene *scene, struct scene_error *error);

#endif
