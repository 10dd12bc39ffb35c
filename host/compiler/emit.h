/* SPDX-License-Identifier: MIT */
/* A compiled scene as C source: const tables for an image of the firmware. */
#ifndef SUPERFRAME_EMIT_H
#define SUPERFRAME_EMIT_H

#include <stdbool.h>
#include <stdio.h>

#include "compiler/tables.h"

/* Writes a C99 file that defines `const struct scene scene_NAME` and includes firmware/scene.h. The
 * same file serves every arithmetic, and the tables are those that arithmetic.h's load() makes.
 * Each character of `name` that is no letter or digit becomes '_'. Returns 0, or -1 where writing
 * failed. */
int scene_emit(FILE *out, const struct compiled_scene *scene, const char *name);

enum { SCENE_DIGEST_SIZE = 17 };

/* Writes sixteen hexadecimal digits: XXH3-64 of the tables that scene_emit() writes. They stay the
 * same for as long as a compiled scene does. Returns false if memory is out. */
bool scene_digest(const struct compiled_scene *scene, char digest[SCENE_DIGEST_SIZE]);

#endif
