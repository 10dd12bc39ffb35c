/* SPDX-License-Identifier: MIT */
/* Scenes by the names that people give them: a built-in one or a file. */
#ifndef SUPERFRAME_LOAD_SCENE_H
#define SUPERFRAME_LOAD_SCENE_H

#include <stdbool.h>
#include <stddef.h>

#include "scene/description.h"
#include "scene/overrides.h"

/* Reads the built-in scene of that name, or else the file; "-": standard input. Returns NULL with
 * *error filled on failure. The caller gives the result to scene_description_free(). */
struct scene_description *load_scene(const char *name_or_path, struct scene_error *error);

/* Loads a scene as load_scene() does, with the overrides put in. */
struct scene_description *load_scene_with(const char *name_or_path,
                                          const struct scene_overrides *overrides,
                                          struct scene_error *error);

/* Writes the scene's name without folder and extension, for the names of other files. A scene of
 * standard input is called "scene". `name` gets
 * at most size bytes with the NUL. */
void scene_short_name(const char *name_or_path, char *name, size_t size);

/* Writes the name of the scene's picture where none is asked for: the short name and ".png". `name`
 * gets at most size bytes with the NUL; size is 8 or more. */
void scene_picture_name(const char *name_or_path, char *name, size_t size);

/* Tells whether a built-in scene has that name. */
bool scene_is_builtin(const char *name_or_path);

#endif
