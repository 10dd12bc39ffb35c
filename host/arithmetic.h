/* SPDX-License-Identifier: MIT */
/* The images of the firmware that the host links, one for each arithmetic. */
#ifndef SUPERFRAME_ARITHMETIC_H
#define SUPERFRAME_ARITHMETIC_H

#include <stddef.h>

#include "compiled_scene.h"
#include "image.h"

struct arithmetic {
    const struct image *image;

    /* The scene's tables in this arithmetic, in one block that free() takes back. NULL with *error
     * filled where the arithmetic cannot hold the scene, or memory is out. */
    struct scene *(*load)(const struct compiled_scene *compiled, struct scene_error *error);
};

extern const struct arithmetic arithmetic_fx;
extern const struct arithmetic arithmetic_f32;
extern const struct arithmetic arithmetic_f64;
extern const struct arithmetic arithmetic_f128;

/* The arithmetic of that name; NULL if there is none. */
const struct arithmetic *arithmetic_find(const char *name);

/* The names, as "fx, f32, f64 or f128", for messages. */
extern const char arithmetic_names[];

#endif
