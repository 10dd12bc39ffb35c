/* SPDX-License-Identifier: MIT */
/* Whether surfaces and cells that differ in the file still differ in an arithmetic. */
#ifndef SUPERFRAME_ARITHMETIC_DISTINCT_H
#define SUPERFRAME_ARITHMETIC_DISTINCT_H

#include "compiled_scene.h"

/* False, with *error filled, where two surfaces become one: a wall that light never sees; and where
 * a pattern's cells become nothing. */
bool surfaces_are_distinct(const struct compiled_scene *scene, struct scene_error *error);

#endif
