/* SPDX-License-Identifier: MIT */
/* The tables of firmware/sets/bits in memory. The include path chooses this form. */
#ifndef SUPERFRAME_LOAD_SETS_H
#define SUPERFRAME_LOAD_SETS_H

#include <stdio.h>

#include "render/per_arithmetic/block.h"

/* Tells whether bits have room for a scene. */
static bool sets_have_room(const struct compiled_scene *from) {
    return compiled_fits_bits(from) && from->primitive_count <= PRIMITIVES_MOST;
}

static bool sets_fit(const struct compiled_scene *from, struct scene_error *error) {
    if (sets_have_room(from)) {
        return true;
    }
    snprintf(error->text, sizeof error->text,
             "%.200s: more solids, objects or lights than this arithmetic has room for: choose "
             "another --arith",
             from->path);
    return false;
}

static struct primitive_set set_of(const struct compiled_set *from) {
    struct primitive_set set;
    set_clear(&set);
    for (uint32_t i = 0; i < from->count; i++) {
        set_include(&set, (entry_number)from->members[i]);
    }
    return set;
}

#define LOAD_SET(name)   to->name = set_of(&from->name);
#define LOAD_MARKS(name) LOAD_SET(name)

static void load_set(struct primitive_set *to, const struct compiled_set *from) {
    *to = set_of(from);
}

static void sets_load(struct block *block, struct scene *to, const struct compiled_scene *from) {
    LOAD_TABLE(struct primitive_set, from->surface_count, surfaces, from->surfaces, load_set)
    LOAD_TABLE(struct primitive_set, from->primitive_count, hidden_by, from->hidden_by, load_set)
}

#endif
