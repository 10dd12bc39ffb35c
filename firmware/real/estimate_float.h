/* SPDX-License-Identifier: MIT */
/* First estimates of a reciprocal and of that of a root, on a CPU with floating point in vectors.
 */
#ifndef SUPERFRAME_FIXED_ESTIMATE_H
#define SUPERFRAME_FIXED_ESTIMATE_H

#include <stdint.h>

/* The results are made exact in integers afterwards: floating point, in any rounding mode, decides
 * no bit. */

extern float sqrtf(float);

/* Returns 2^48 / m, as estimate_division.h says. The 2^24 steps of a float are finer than the error
 * allowed there. */
static inline uint32_t fixed_reciprocal_estimate(uint32_t m) {
    return (uint32_t)(int32_t)(0x1p47f / (float)(int32_t)(m >> 1));
}

/* Returns 2^38 / sqrt(high), as root_table.h says. */
static inline uint32_t fixed_root_estimate(uint32_t high) {
    return (uint32_t)(int32_t)(0x1p37f / sqrtf(0.5F * (float)(int32_t)(high >> 1)));
}

#endif
