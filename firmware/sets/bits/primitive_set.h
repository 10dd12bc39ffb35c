/* SPDX-License-Identifier: MIT */
/* Sets of primitives as bits, one for each of a scene's few: where a ray is, and what a surface
 * bounds. A feature set includes this form or lists. */
#ifndef SUPERFRAME_PRIMITIVE_SET_BITS_H
#define SUPERFRAME_PRIMITIVE_SET_BITS_H

#include <stdbool.h>
#include <stdint.h>

/* Names the header with what a ray does with these sets (ray.c). */
#define SETS_WALK "sets/bits/walk.h"

/* Stands behind the names of what a host makes for these sets. */
#define SETS_SUFFIX

/* The numbers of a scene's tables, as small as this form lets them be. */
typedef uint8_t entry_number;
typedef uint16_t surface_number;
typedef uint16_t run_first;
typedef uint8_t run_count;
typedef uint8_t program_code;

#define SURFACE_NONE UINT16_C(0xFFFF) /* more than an int of 16 bits holds: no enumerator */

/* Codes of a program: below PROGRAM_UNION the number of a primitive. */
enum { PROGRAM_UNION = 0xFD, PROGRAM_INTERSECTION = 0xFE, PROGRAM_DIFFERENCE = 0xFF };

/* These numbers stand for no entry of a table. */
enum { FRAME_WORLD = 0xFF, ENCLOSURE_NONE = 0xFF };

enum { PRIMITIVES_MOST = 32 * FEATURE_PRIMITIVE_WORDS };

/* A set that has room for all of a scene's primitives is a set like another. */
#define PRIMITIVE_MARKS(name) struct primitive_set name;

/* By surface: the primitives that it bounds. By primitive: those that a ray leaves before it can
 * cross this one. */
#define PRIMITIVE_TABLES                                                                           \
    const struct primitive_set *surfaces;                                                          \
    const struct primitive_set *hidden_by;

struct primitive_set {
    uint32_t word[FEATURE_PRIMITIVE_WORDS];
};

/* Holds what a ray crosses at one place. */
typedef struct primitive_set crossed_set;

/* Returns the index of the word that holds a primitive's bit. Where there is but one word, nothing
 * is worked out. */
static inline uint8_t set_word_of(entry_number primitive) {
    return FEATURE_PRIMITIVE_WORDS > 1 ? primitive >> 5 : 0;
}

static inline bool set_has(const struct primitive_set *set, entry_number primitive) {
    return (set->word[set_word_of(primitive)] >> (primitive & 31) & 1) != 0;
}

static inline void set_include(struct primitive_set *set, entry_number primitive) {
    set->word[set_word_of(primitive)] |= (uint32_t)1 << (primitive & 31);
}

static inline bool sets_overlap(const struct primitive_set *a, const struct primitive_set *b) {
    uint32_t common = 0;
    for (uint8_t i = 0; i < FEATURE_PRIMITIVE_WORDS; i++) {
        common |= a->word[i] & b->word[i];
    }
    return common != 0;
}

static inline void set_clear(struct primitive_set *set) {
    for (uint8_t i = 0; i < FEATURE_PRIMITIVE_WORDS; i++) {
        set->word[i] = 0;
    }
}

/* Takes out what is not in the set `to`. */
static inline void set_restrict(struct primitive_set *set, const struct primitive_set *to) {
    for (uint8_t i = 0; i < FEATURE_PRIMITIVE_WORDS; i++) {
        set->word[i] &= to->word[i];
    }
}

/* Enters the primitives of `which` that the set is outside of, and leaves the others of `which`. */
static inline void set_toggle(struct primitive_set *set, const crossed_set *which) {
    for (uint8_t i = 0; i < FEATURE_PRIMITIVE_WORDS; i++) {
        set->word[i] ^= which->word[i];
    }
}

#endif
