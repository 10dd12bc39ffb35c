/* SPDX-License-Identifier: MIT */
/* Numbers of 64 bits on a CPU of 32: what registers_64.h says, by their halves. */
#ifndef SUPERFRAME_FIXED_REGISTERS_H
#define SUPERFRAME_FIXED_REGISTERS_H

#include <stdbool.h>
#include <stdint.h>

/* A compiler makes more of 64-bit comparisons and shifts than is needed here. Even with numbers
 * that are seen to fit, a compiler goes on in 64 bits: three products instead of one. */

static inline bool fixed_fits(int64_t v) {
    return (int32_t)(v >> 32) == (int32_t)v >> 31;
}

/* Returns the low 32 bits of v >> shift. The result fits where all bits above its bit 31 are as
 * bit 31. */
static inline int32_t fixed_shifted(int64_t v, unsigned shift, bool *fits) {
    int32_t high = (int32_t)(v >> 32);
    uint32_t low = (uint32_t)high << (32 - shift) | ((uint32_t)v >> 1) >> (shift - 1);
    *fits = high >> (shift - 1) == high >> 31;
    return (int32_t)low;
}

/* Returns the low 32 bits of a + b. The sum does not fit where its sign is neither that of a nor
 * that of b. */
static inline int32_t fixed_sum(int32_t a, int32_t b, bool *fits) {
    int32_t sum = (int32_t)((uint32_t)a + (uint32_t)b);
    *fits = ((sum ^ a) & (sum ^ b)) >= 0;
    return sum;
}

static inline int32_t fixed_difference(int32_t a, int32_t b, bool *fits) {
    int32_t difference = (int32_t)((uint32_t)a - (uint32_t)b);
    *fits = ((a ^ b) & (difference ^ a)) >= 0;
    return difference;
}

static inline int64_t fixed_raised(int32_t a, unsigned shift) {
    uint32_t high = (uint32_t)(a >> (32 - shift));
    return (int64_t)((uint64_t)high << 32 | (uint32_t)a << shift);
}

#endif
