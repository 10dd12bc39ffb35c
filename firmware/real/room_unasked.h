/* SPDX-License-Identifier: MIT */
/* Results brought into their formats, by one way for all. */
#ifndef SUPERFRAME_FIXED_ROOM_H
#define SUPERFRAME_FIXED_ROOM_H

#include "fixed_bits.h"

/* The sibling of this file, room_asked.h, gives the same results by two ways. */

/* v / 2^shift to nearest, by a shift that is a constant, 9 <= shift <= 32. */
static inline int32_t fixed_result(enum fixed_operation operation, int64_t v, unsigned shift) {
    return fixed_shortened(operation, fixed_with_half(v, shift), shift);
}

/* The same by any shift, 1 <= shift <= 32. */
static inline int32_t fixed_result_by(enum fixed_operation operation, int64_t v, unsigned shift) {
    return fixed_shortened(operation, fixed_with_half(v, shift), shift);
}

/* a + b and a - b. */
static inline int32_t fixed_added(enum fixed_operation operation, int32_t a, int32_t b) {
    return fixed_ended_sum(operation, a, b);
}

static inline int32_t fixed_subtracted(enum fixed_operation operation, int32_t a, int32_t b) {
    return fixed_ended_difference(operation, a, b);
}

#endif
