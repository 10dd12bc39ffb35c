/* SPDX-License-Identifier: MIT */
/* A first estimate of a reciprocal, on a CPU that divides. */
#ifndef SUPERFRAME_FIXED_ESTIMATE_H
#define SUPERFRAME_FIXED_ESTIMATE_H

#include <stdint.h>

/* Returns 2^48 / m for 2^31 <= m < 2^32, with a relative error below 2^-14. What is made of the
 * estimate does not depend on that error, so the sibling, estimate_table.h, may differ. */
static inline uint32_t fixed_reciprocal_estimate(uint32_t m) {
    uint32_t divisor = (m >> 16) + ((m >> 15) & 1); /* m / 2^16 to 2^-16 */
    return UINT32_MAX / divisor;
}

#endif
