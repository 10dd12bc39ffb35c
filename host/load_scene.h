/* SPDX-License-Identifier: MIT */
/* Scenes by the names that people give them: a built-in one or a file. */
#ifndef SUPERFRAME_LOAD_SCENE_H
#define SUPERFRAME_LOAD_SCENE_H

#include <stddef.h>

#include "compiled_scene.h"
#include "overrides.h"
#include "scene_description.h"

/* Reads the built-in scene of that name, or else the file. NULL with *error filled on failure. The
 * caller gives the result to scene_description_free(). */
struct scene_description *load_scene(const char *name_or_path, struct scene_error *error);

/* As load_scene(), with overrides put in and compiled. The caller frees the result with
 * free(). */
struct compiled_scene *load_compiled_scene(const char *name_or_path,
                                           const struct scene_overrides *overrides,
                                           struct scene_error *error);

/* The scene's name without folder and extension, for the names of other files, in at most size
 * bytes with the NUL. */
void scene_short_name(const char *name_or_path, char *name, size_t size);

#endif
