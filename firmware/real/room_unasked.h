/* SPDX-License-Identifier: MIT */
/* Results brought into their formats, by one path for all. */
#ifndef SUPERFRAME_FIXED_ROOM_H
#define SUPERFRAME_FIXED_ROOM_H

#include "fixed_bits.h"

/* The sibling of this file, room_asked.h, gives the same results by two paths. */

/* Returns v / 2^shift to nearest, brought into a 32-bit format, for a constant 9 <= shift <= 32. */
static inline int32_t fixed_result(enum fixed_operation operation, int64_t v, unsigned shift) {
    return fixed_shortened(operation, fixed_with_half(v, shift), shift);
}

/* Returns v / 2^shift to nearest, brought into a 32-bit format, for any 1 <= shift <= 32. */
static inline int32_t fixed_result_by(enum fixed_operation operation, int64_t v, unsigned shift) {
    return fixed_shortened(operation, fixed_with_half(v, shift), shift);
}

/* Returns a + b, brought into a 32-bit format. */
static inline int32_t fixed_added(enum fixed_operation operation, int32_t a, int32_t b) {
    return fixed_ended_sum(operation, a, b);
}

/* Returns a - b, brought into a 32-bit format. */
static inline int32_t fixed_subtracted(enum fixed_operation operation, int32_t a, int32_t b) {
    return fixed_ended_difference(operation, a, b);
}

#endif
