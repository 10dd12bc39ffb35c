/* SPDX-License-Identifier: MIT */
/* A short text that stays the same for as long as a compiled scene does. */
#ifndef SUPERFRAME_SCENE_DIGEST_H
#define SUPERFRAME_SCENE_DIGEST_H

#include <stdbool.h>

#include "compiler/tables.h"

enum { SCENE_DIGEST_SIZE = 17 };

/* Writes sixteen hexadecimal digits: XXH3-64 of the tables that scene_emit() writes. Returns false
 * if memory is out. */
bool scene_digest(const struct compiled_scene *scene, char digest[SCENE_DIGEST_SIZE]);

#endif
