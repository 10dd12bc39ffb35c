/* SPDX-License-Identifier: MIT */
/* Numbers of 64 bits on a CPU whose registers have 64, or whose compiler knows best. */
#ifndef SUPERFRAME_FIXED_REGISTERS_H
#define SUPERFRAME_FIXED_REGISTERS_H

#include <stdbool.h>
#include <stdint.h>

/* The siblings of this file, registers_32.h and product_quarters.h, give the same results on other
 * CPUs. An arithmetic's real.h chooses. */

/* Tells whether v is a number of 32 bits. */
static inline bool fixed_fits(int64_t v) {
    return (int32_t)v == v;
}

/* Returns the low 32 bits of v >> shift, 1 <= shift <= 32. *fits tells whether these bits are all
 * of the result. */
static inline int32_t fixed_shifted(int64_t v, unsigned shift, bool *fits) {
    int64_t shifted = v >> shift;
    *fits = (int32_t)shifted == shifted;
    return (int32_t)shifted;
}

/* Returns the low 32 bits of a + b. *fits tells whether these bits are all of the sum. */
static inline int32_t fixed_sum(int32_t a, int32_t b, bool *fits) {
    int64_t sum = (int64_t)a + b;
    *fits = (int32_t)sum == sum;
    return (int32_t)sum;
}

/* Returns the low 32 bits of a - b. *fits tells whether these bits are all of the difference. */
static inline int32_t fixed_difference(int32_t a, int32_t b, bool *fits) {
    int64_t difference = (int64_t)a - b;
    *fits = (int32_t)difference == difference;
    return (int32_t)difference;
}

/* Returns a 2^shift, 0 < shift < 32. */
static inline int64_t fixed_raised(int32_t a, unsigned shift) {
    return (int64_t)a * ((int64_t)1 << shift);
}

#endif
