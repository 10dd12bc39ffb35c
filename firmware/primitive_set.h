/* SPDX-License-Identifier: MIT */
/* A set of primitives, one bit each: where a ray is, and what a surface bounds. */
#ifndef SUPERFRAME_PRIMITIVE_SET_H
#define SUPERFRAME_PRIMITIVE_SET_H

#include <stdbool.h>
#include <stdint.h>

#include "feature_set.h"

enum { PRIMITIVES_MOST = 32 * FEATURE_PRIMITIVE_WORDS };

struct primitive_set {
    uint32_t word[FEATURE_PRIMITIVE_WORDS];
};

/* Returns the index of the word that holds a primitive's bit. Where there is but one word, nothing
 * is worked out. */
static inline uint8_t set_word_of(uint8_t primitive) {
    return FEATURE_PRIMITIVE_WORDS > 1 ? primitive >> 5 : 0;
}

static inline bool set_has(const struct primitive_set *set, uint8_t primitive) {
    return (set->word[set_word_of(primitive)] >> (primitive & 31) & 1) != 0;
}

static inline void set_include(struct primitive_set *set, uint8_t primitive) {
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
static inline void set_toggle(struct primitive_set *set, const struct primitive_set *which) {
    for (uint8_t i = 0; i < FEATURE_PRIMITIVE_WORDS; i++) {
        set->word[i] ^= which->word[i];
    }
}

#endif
