/* SPDX-License-Identifier: MIT */
/* Checks that an arithmetic can hold a scene: what differs still differs, and keeps its shape. */
#ifndef SUPERFRAME_ARITHMETIC_HOLDS_H
#define SUPERFRAME_ARITHMETIC_HOLDS_H

#include "compiler/tables.h"

/* Checks what the tables become in this arithmetic. Returns false, with *error filled, where two
 * surfaces become one: light never sees such a wall. Returns false as well where a solid or a
 * pattern's cell is too small, or moves visibly. */
bool arithmetic_holds(const struct compiled_scene *scene, struct scene_error *error);

#endif
