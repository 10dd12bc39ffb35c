/* SPDX-License-Identifier: MIT */
/* Random numbers that a seed repeats: for faults, noise and samples, not for secrets. */
#ifndef SUPERFRAME_HAL_SPLITMIX64_H
#define SUPERFRAME_HAL_SPLITMIX64_H

#include <stdint.h>

/* Returns the next number, all of whose 64 bits are equally good. *state is the seed at first, and
 * every seed is as good as another. */
static inline uint64_t splitmix64(uint64_t *state) {
    uint64_t z = (*state += UINT64_C(0x9E3779B97F4A7C15));
    z = (z ^ z >> 30) * UINT64_C(0xBF58476D1CE4E5B9);
    z = (z ^ z >> 27) * UINT64_C(0x94D049BB133111EB);
    return z ^ z >> 31;
}

#endif
