/* SPDX-License-Identifier: MIT */
/* Products of 32 by 32 bits on a CPU that has them, or whose compiler knows best. */
#ifndef SUPERFRAME_FIXED_PRODUCT_H
#define SUPERFRAME_FIXED_PRODUCT_H

#include <stdint.h>

static inline int64_t fixed_times(int32_t a, int32_t b) {
    return (int64_t)a * b;
}

static inline uint64_t fixed_times_unsigned(uint32_t a, uint32_t b) {
    return (uint64_t)a * b;
}

#endif
