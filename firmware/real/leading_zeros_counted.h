/* SPDX-License-Identifier: MIT */
/* Leading zeros, on a CPU that has no instruction for them. */
#ifndef SUPERFRAME_FIXED_ZEROS_H
#define SUPERFRAME_FIXED_ZEROS_H

#include <stdint.h>

/* Returns the number of zero bits above the highest one; x > 0. */
static inline unsigned fixed_leading_zeros(uint32_t x) {
    unsigned zeros = 0;
    if (x < UINT32_C(1) << 16) {
        zeros += 16;
        x <<= 16;
    }
    if (x < UINT32_C(1) << 24) {
        zeros += 8;
        x <<= 8;
    }
    if (x < UINT32_C(1) << 28) {
        zeros += 4;
        x <<= 4;
    }
    if (x < UINT32_C(1) << 30) {
        zeros += 2;
        x <<= 2;
    }
    return x < UINT32_C(1) << 31 ? zeros + 1 : zeros;
}

#endif
