/* SPDX-License-Identifier: MIT */
/* The scene files that the program carries with it; embed_scenes.sh makes the table. */
#ifndef SUPERFRAME_BUILTIN_SCENES_H
#define SUPERFRAME_BUILTIN_SCENES_H

#include <stddef.h>

struct builtin_scene {
    const char *name; /* of the file, without folder and .scene */
    const char *text; /* the whole file; a NUL follows its last byte */
    size_t length;    /* in bytes, without that NUL */
};

/* The scenes stand in the order in which embed_scenes.sh was given their files. */
extern const struct builtin_scene builtin_scenes[];
extern const size_t builtin_scene_count;

#endif
