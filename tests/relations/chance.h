/* SPDX-License-Identifier: MIT */
/* Random choices that a seed repeats. */
#ifndef SUPERFRAME_RELATIONS_CHANCE_H
#define SUPERFRAME_RELATIONS_CHANCE_H

#include <stdbool.h>
#include <stdint.h>

#include "splitmix64.h"

/* Returns one of 0 .. count-1. */
static inline int chance_pick(uint64_t *random, int count) {
    return (int)((splitmix64(random) >> 33) % (uint64_t)count);
}

/* Returns true in so many of 100 cases. */
static inline bool chance_is(uint64_t *random, int percent) {
    return chance_pick(random, 100) < percent;
}

/* Returns a sixteenth between two whole numbers: sums and differences of these are exact, so that
 * faces meet where they are meant to. */
static inline double chance_step(uint64_t *random, int low, int high) {
    return low + chance_pick(random, 16 * (high - low) + 1) / 16.0;
}

/* Returns a number that meets no other one: odd multiples of 2^-16. */
static inline double chance_odd(uint64_t *random, int low, int high) {
    return low + (2 * chance_pick(random, 32768 * (high - low)) + 1) / 65536.0;
}

#endif
