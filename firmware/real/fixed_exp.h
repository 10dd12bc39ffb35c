/* SPDX-License-Identifier: MIT */
/* The exponential of a negative number by a polynomial for the power of two. */
#ifndef SUPERFRAME_FIXED_EXP_H
#define SUPERFRAME_FIXED_EXP_H

#include "fixed_bits.h"

/* Returns 2^(32 - f / 2^32): f is a fraction in 32 bits, the result lies in [2^31, 2^32].
 *
 * The formula is 1 - f (c1 - f (c2 - ... f c7)). The polynomial in brackets interpolates
 * (1 - 2^-f) / f at the seven Chebyshev nodes of [0, 1], within 2^-33. Each coefficient has so many
 * bits of fraction that it fills 32 bits (32, 34, 36, 38, 41, 44, 48). So only the last two
 * products lose anything to speak of. All errors together are within 1.9 2^-32; f = 0 is exact. */
static inline uint64_t fixed_power_of_half(uint32_t f) {
    const uint64_t half = UINT64_C(1) << 31;
    uint32_t sum = UINT32_C(0xBDA5A379);
    sum = UINT32_C(0x9C1FFE34) - (uint32_t)((fixed_times_unsigned(f, sum)) >> 36);
    sum = UINT32_C(0xAE51609A) - (uint32_t)((fixed_times_unsigned(f, sum)) >> 35);
    sum = UINT32_C(0x9D906A32) - (uint32_t)((fixed_times_unsigned(f, sum)) >> 35);
    sum = UINT32_C(0xE358126E) - (uint32_t)((fixed_times_unsigned(f, sum)) >> 34);
    sum = UINT32_C(0xF5FDEF2C) - (uint32_t)((fixed_times_unsigned(f, sum)) >> 34);
    sum = UINT32_C(0xB17217F7) - (uint32_t)((fixed_times_unsigned(f, sum) + 2 * half) >> 34);
    return (UINT64_C(1) << 32) - ((fixed_times_unsigned(f, sum) + half) >> 32);
}

/* Returns exp(-x / 2^48) 2^30 for 0 <= x < 2^63. The last step rounds to nearest; the error of the
 * result is below 1.1. */
static inline int32_t fixed_exponential(uint64_t x) {
    const uint32_t log2_e = UINT32_C(0xB8AA3B29); /* 2^31 log2(e), relative 2^-33 */
    if (x >= UINT64_C(22) << 48) {                /* exp(-22) 2^30 = 0.3 */
        return 0;
    }
    /* Halvings in 47 bits of fraction: below 2^52. */
    uint64_t halvings = fixed_times_unsigned((uint32_t)(x >> 32), log2_e) +
                        ((fixed_times_unsigned((uint32_t)x, log2_e)) >> 32);
    halvings += UINT32_C(1) << 14; /* the fraction to nearest */
    uint64_t power = fixed_power_of_half((uint32_t)(halvings >> 15));
    unsigned shift = 2 + (unsigned)(halvings >> 47);
    return (int32_t)((power + (UINT64_C(1) << (shift - 1))) >> shift);
}

#endif
