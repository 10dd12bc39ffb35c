/* SPDX-License-Identifier: MIT */
/* Which objects a primitive takes part in. */
#ifndef SUPERFRAME_COMPILE_USES_H
#define SUPERFRAME_COMPILE_USES_H

#include "compiler/hierarchy.h"

/* Fills in the keys, uses and parents, and the leads' runs of them. Returns false where memory is
 * out. */
bool uses_make(const struct compiled_scene *scene, struct compiled_hierarchy *to);

#endif
