/* SPDX-License-Identifier: MIT */
/* Results brought into their formats, on a CPU of 32 bits: what room_unasked.h says, in less time
 * and more code. */
#ifndef SUPERFRAME_FIXED_ROOM_H
#define SUPERFRAME_FIXED_ROOM_H

#include "fixed_bits.h"

/* Nearly every result is far from the ends of its format. Where it is asked for that first, one
 * comparison stands for those with both ends. */

/* The number in the upper half without its sign, less one where it is negative. */
static inline uint32_t fixed_spread(int64_t v) {
    int32_t high = (int32_t)(v >> 32);
    return (uint32_t)(high ^ high >> 31);
}

/* The low 32 bits of v >> shift. */
static inline int32_t fixed_low(int64_t v, unsigned shift) {
    bool fits;
    return fixed_shifted(v, shift, &fits);
}

/* The last 256th of a format counts as near its end: that makes a constant of 8 bits, which fits
 * into an instruction. */
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

/* Whether both are in the middle half of the format, from -2^30 to below 2^30: their difference
 * fits then, and is not -2^31. */
static inline bool fixed_are_middle(int32_t a, int32_t b) {
    uint32_t x = (uint32_t)a, y = (uint32_t)b;
    return (int32_t)((x ^ x << 1) | (y ^ y << 1)) >= 0;
}

/* Where a and the low bits of the sum are in the middle, b is the difference of the two, and
 * nothing was lost. Of a and b it could not be asked: -2^30 twice is -2^31. */
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
