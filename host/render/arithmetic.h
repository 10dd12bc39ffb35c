/* SPDX-License-Identifier: MIT */
/* The images of the firmware that the host links, one for each arithmetic. */
#ifndef SUPERFRAME_ARITHMETIC_H
#define SUPERFRAME_ARITHMETIC_H

#include <stdbool.h>
#include <stddef.h>

#include "compiler/tables.h"
#include "image.h"
#include "render/observed.h"

struct arithmetic {
    const struct image *image;
    const char *name; /* the image's; behind it "_many" where sets are lists */

    /* How far a distance along a ray may be off by rounding, in scaled units. */
    double noise;

    /* Tells whether sets have room for a scene's primitives, and numbers for its tables. */
    bool (*has_room)(const struct compiled_scene *compiled);

    /* Returns the scene's tables in this arithmetic, in one block that free() takes back. Returns
     * NULL with *error filled where the arithmetic cannot hold the scene, or memory is out. */
    struct scene *(*load)(const struct compiled_scene *compiled, struct scene_error *error);

    /* Learns the radiance of the scene's pruned branches, if the scene asks for an estimate. To be
     * called once, before rows and pixels. The estimate is all 0 where pruned branches count as
     * black. */
    void (*learn)(struct scene *scene, struct estimate *estimate, struct render_counts *counts);

    /* Renders one pixel: its intensities are in levels, neither rounded nor clamped. Adds what the
     * pixel took to *counts, and tells its tree to the observer, if there is one. */
    void (*pixel)(const struct scene *scene, uint16_t x, uint16_t y, double intensity[3],
                  struct render_counts *counts, const struct pixel_observer *observer);
};

extern const struct arithmetic arithmetic_fx;
extern const struct arithmetic arithmetic_f32;
extern const struct arithmetic arithmetic_f64;
extern const struct arithmetic arithmetic_f32_many;

/* Two forms of plain Q16.16, to be measured against the others; arithmetic_find() knows neither. */
extern const struct arithmetic arithmetic_q16;
extern const struct arithmetic arithmetic_q16_epsilon;

/* The arithmetics of this build, in a list that make writes; NULL ends the list. */
extern const struct arithmetic *const arithmetics_built[];

/* The same arithmetics with sets as lists; NULL ends the list. */
extern const struct arithmetic *const arithmetics_many_built[];

/* Returns the same arithmetic with sets as lists; NULL where there is none. */
const struct arithmetic *arithmetic_with_lists(const struct arithmetic *arithmetic);

/* Returns an arithmetic, or the same one with sets as lists where a scene needs these, or is faster
 * with them. An arithmetic that has no such form is returned as it is, and may refuse the scene. */
const struct arithmetic *arithmetic_for(const struct arithmetic *arithmetic,
                                        const struct compiled_scene *compiled);

/* Finds the arithmetic of that name in this build; NULL if there is none. */
const struct arithmetic *arithmetic_find(const char *name);

/* Finds the arithmetic of that name, also among those that are only measured; NULL if there is
 * none. */
const struct arithmetic *arithmetic_find_any(const char *name);

/* Tells whether an arithmetic of that name exists but is missing from this build. */
bool arithmetic_is_missing(const char *name);

/* The names of the arithmetics of this build; ended by NULL. */
extern const char *const arithmetics_names[];

#endif
