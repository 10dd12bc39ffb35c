/* SPDX-License-Identifier: MIT */
/* The exponential of a negative number by a polynomial for the power of two. */
#ifndef SUPERFRAME_FIXED_EXP_H
#define SUPERFRAME_FIXED_EXP_H

#include "fixed_bits.h"

/* The upper half of a product of fractions. */
static inline uint32_t fixed_fraction_product(uint32_t a, uint32_t b) {
    return (uint32_t)(((uint64_t)a * b) >> 32);
}

/* 2^(32 - f / 2^32): f is a fraction in 32 bits, the result lies in [2^31, 2^32].
 *
 * 1 - f (c1 - f (c2 - ... f c7)), where the polynomial in brackets interpolates (1 - 2^-f) / f at
 * the seven Chebyshev nodes of [0, 1], with coefficients rounded to 2^-32: it is within 2^-32.1,
 * and exact at 0. The truncated products add at most 1.8 2^-32, upwards. */
static inline uint64_t fixed_power_of_half(uint32_t f) {
    uint32_t sum = UINT32_C(0xBDA6);
    sum = UINT32_C(0x9C200) - fixed_fraction_product(f, sum);
    sum = UINT32_C(0x5728B0) - fixed_fraction_product(f, sum);
    sum = UINT32_C(0x27641A9) - fixed_fraction_product(f, sum);
    sum = UINT32_C(0xE358127) - fixed_fraction_product(f, sum);
    sum = UINT32_C(0x3D7F7BCB) - fixed_fraction_product(f, sum);
    sum = UINT32_C(0xB17217F7) - fixed_fraction_product(f, sum);
    return (UINT64_C(1) << 32) - (((uint64_t)f * sum + (UINT64_C(1) << 31)) >> 32);
}

/* exp(-x / 2^48) 2^30 to nearest, for 0 <= x < 2^63; the error is below 1.4. */
static inline int32_t fixed_exponential(uint64_t x) {
    const uint32_t log2_e = UINT32_C(0xB8AA3B29); /* 2^31 log2(e), relative 2^-33 */
    if (x >= UINT64_C(22) << 48) {                /* exp(-22) 2^30 = 0.3 */
        return 0;
    }
    /* Halvings in 47 bits of fraction: below 2^52. */
    uint64_t halvings = (x >> 32) * log2_e + (((x & UINT32_MAX) * log2_e) >> 32);
    halvings += UINT32_C(1) << 14; /* the fraction to nearest */
    uint64_t power = fixed_power_of_half((uint32_t)(halvings >> 15));
    unsigned shift = 2 + (unsigned)(halvings >> 47);
    return (int32_t)((power + (UINT64_C(1) << (shift - 1))) >> shift);
}

#endif
