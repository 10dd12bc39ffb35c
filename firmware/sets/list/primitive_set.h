/* SPDX-License-Identifier: MIT */
/* Sets of primitives as lists, for scenes of any number. A list grows with what a ray is inside of,
 * not with the scene. A feature set includes this form or bits. */
#ifndef SUPERFRAME_PRIMITIVE_SET_LIST_H
#define SUPERFRAME_PRIMITIVE_SET_LIST_H

#include <stdbool.h>
#include <stdint.h>

/* Names the header with what a ray does with these sets (ray.c). */
#define SETS_WALK "sets/list/walk.h"

/* Stands behind the names of what a host makes for these sets. */
#define SETS_SUFFIX _many

/* The numbers of a scene's tables. */
typedef uint32_t entry_number;
typedef uint32_t surface_number;
typedef uint32_t run_first;
typedef uint32_t run_count;
typedef uint32_t program_code;

#define SURFACE_NONE UINT32_C(0xFFFFFFFF)

/* Codes of a program: below PROGRAM_UNION the number of a primitive. */
#define PROGRAM_UNION        UINT32_C(0xFFFFFFFD)
#define PROGRAM_INTERSECTION UINT32_C(0xFFFFFFFE)
#define PROGRAM_DIFFERENCE   UINT32_C(0xFFFFFFFF)

/* These numbers stand for no entry of a table. */
#define FRAME_WORLD    UINT32_C(0xFFFFFFFF)
#define ENCLOSURE_NONE UINT32_C(0xFFFFFFFF)
#define NODE_NONE      UINT32_C(0xFFFFFFFF)
#define NODE_PRIMITIVE UINT32_C(0x80000000) /* in front of a primitive's number */
#define PLACE_ROOT     UINT32_C(0xFFFFFFFF)

/* Nothing goes by sets that would have to have room for all primitives. */
#define PRIMITIVE_MARKS(name)

/* The hierarchies that begin outside of all primitives, and the primitives without an end. Runs of
 * keys and uses by primitive, parents by code: see LEAD_FIELDS and USE_FIELDS. */
#define PRIMITIVE_TABLES                                                                           \
    SCENE_HIERARCHY_FIELDS(SCENE_MEMBER)                                                           \
    const struct bounds_node *nodes;                                                               \
    const entry_number *endless;                                                                   \
    const struct lead *leads;                                                                      \
    const entry_number *keys;                                                                      \
    const struct use *uses;                                                                        \
    const run_first *parents;

/* Rounding may let a ray enter what touches before the ray leaves what is touched: so many more. */
enum { SET_MOST = FEATURE_NESTING + 2 };

/* The members in rising order. */
struct primitive_set {
    uint16_t count;
    entry_number member[SET_MOST];
};

/* Holds what a ray crosses at one place: all that it was inside of, and as much again. */
typedef struct {
    uint16_t count;
    entry_number member[2 * SET_MOST];
} crossed_set;

/* Returns the place in the list of the first member that is no less. */
static inline uint16_t set_place(const struct primitive_set *set, entry_number primitive) {
    uint16_t place = 0;
    while (place < set->count && set->member[place] < primitive) {
        place++;
    }
    return place;
}

static inline bool set_has(const struct primitive_set *set, entry_number primitive) {
    uint16_t place = set_place(set, primitive);
    return place < set->count && set->member[place] == primitive;
}

static inline void set_clear(struct primitive_set *set) {
    set->count = 0;
}

/* Enters a primitive that the set is outside of, or leaves one. Returns false where the list is
 * full: then the set stays as it is. */
static inline bool set_flip(struct primitive_set *set, entry_number primitive) {
    uint16_t place = set_place(set, primitive);
    if (place < set->count && set->member[place] == primitive) {
        set->count--;
        for (uint16_t i = place; i < set->count; i++) {
            set->member[i] = set->member[i + 1];
        }
        return true;
    }
    if (set->count == SET_MOST) {
        return false;
    }
    for (uint16_t i = set->count; i > place; i--) {
        set->member[i] = set->member[i - 1];
    }
    set->member[place] = primitive;
    set->count++;
    return true;
}

#endif
