/* SPDX-License-Identifier: MIT */
/* Results brought into their formats on a CPU of 32 bits: those of room_unasked.h, in less time and
 * more code. */
#ifndef SUPERFRAME_FIXED_ROOM_H
#define SUPERFRAME_FIXED_ROOM_H

#include "fixed_bits.h"

/* Nearly every result is far from the ends of its format. Where the code asks for that first, one
 * comparison stands for those with both ends. */

/* Returns the number in the upper half of v without its sign, less one where the number is
 * negative. */
static inline uint32_t fixed_spread(int64_t v) {
    int32_t high = (int32_t)(v >> 32);
    return (uint32_t)(high ^ high >> 31);
}

/* Returns the low 32 bits of v >> shift. */
static inline int32_t fixed_low(int64_t v, unsigned shift) {
    bool fits;
    return fixed_shifted(v, shift, &fits);
}

/* Returns v / 2^shift to nearest, brought into a 32-bit format, for a constant 9 <= shift <= 32.
 * The last 256th of a format counts as near its end. The bound is then a constant of 8 bits, which
 * fits into an instruction. */
static inline int32_t fixed_result(enum fixed_operation operation, int64_t v, unsigned shift) {
    const uint32_t end = UINT32_C(1) << (shift - 1);
    v = fixed_with_half(v, shift);
    bool is_near = fixed_spread(v) >= end - (end >> 8);
    if (is_near) {
        return fixed_shortened(operation, v, shift);
    }
    return fixed_low(v, shift);
}

static inline int32_t fixed_result_by(enum fixed_operation operation, int64_t v, unsigned shift) {
    v = fixed_with_half(v, shift);
    bool is_near = fixed_spread(v) + 1 >= UINT32_C(1) << (shift - 1);
    if (is_near) {
        return fixed_shortened(operation, v, shift);
    }
    return fixed_low(v, shift);
}

/* Tells whether a and b are in the middle half of the format, from -2^30 to below 2^30. The
 * difference of the two then fits, and is not -2^31. */
static inline bool fixed_are_middle(int32_t a, int32_t b) {
    uint32_t x = (uint32_t)a, y = (uint32_t)b;
    return (int32_t)((x ^ x << 1) | (y ^ y << 1)) >= 0;
}

/* Returns a + b, brought into a 32-bit format. Where a and the low bits of the sum are in the
 * middle half, b is their difference, and nothing was lost. A test of a and b would not do: -2^30
 * twice is -2^31. */
static inline int32_t fixed_added(enum fixed_operation operation, int32_t a, int32_t b) {
    int32_t low = (int32_t)((uint32_t)a + (uint32_t)b);
    if (!fixed_are_middle(a, low)) {
        return fixed_ended_sum(operation, a, b);
    }
    return low;
}

static inline int32_t fixed_subtracted(enum fixed_operation operation, int32_t a, int32_t b) {
    int32_t low = (int32_t)((uint32_t)a - (uint32_t)b);
    if (!fixed_are_middle(a, b)) {
        return fixed_ended_difference(operation, a, b);
    }
    return low;
}

#endif
