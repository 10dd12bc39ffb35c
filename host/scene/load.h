/* SPDX-License-Identifier: MIT */
/* Scenes by the names that people give them: a built-in one or a file. */
#ifndef SUPERFRAME_LOAD_SCENE_H
#define SUPERFRAME_LOAD_SCENE_H

#include <stdbool.h>
#include <stddef.h>

#include "scene/description.h"

/* Reads the built-in scene of that name, or else the file. NULL with *error filled on failure. The
 * caller gives the result to scene_description_free(). */
struct scene_description *load_scene(const char *name_or_path, struct scene_error *error);

/* The scene's name without folder and extension, for the names of other files, in at most size
 * bytes with the NUL. */
void scene_short_name(const char *name_or_path, char *name, size_t size);

/* The name of the scene's picture where none is asked for: the short name and ".png", in at most
 * size bytes with the NUL, 8 or more. */
void scene_picture_name(const char *name_or_path, char *name, size_t size);

/* Whether it is the name of a built-in scene. */
bool scene_is_builtin(const char *name_or_path);

#endif
