/* SPDX-License-Identifier: MIT */
/* A compiled scene as C source: const tables for an image of the firmware. */
#ifndef SUPERFRAME_EMIT_H
#define SUPERFRAME_EMIT_H

#include <stdio.h>

#include "compiler/tables.h"

/* Writes a C99 file that defines `const struct scene scene_NAME` and includes firmware/scene.h. The
 * same file serves every arithmetic, and the tables are those that arithmetic.h's load() makes.
 * Each character of `name` that is no letter or digit becomes '_'. Returns 0, or -1 where writing
 * failed. */
int scene_emit(FILE *out, const struct compiled_scene *scene, const char *name);

#endif
