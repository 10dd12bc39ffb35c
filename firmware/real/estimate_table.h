/* SPDX-License-Identifier: MIT */
/* A first estimate of a reciprocal, on a CPU that needs a hundred instructions for a division. */
#ifndef SUPERFRAME_FIXED_ESTIMATE_H
#define SUPERFRAME_FIXED_ESTIMATE_H

#include <stdint.h>

/* 256 / x at x = (i + 64) / 64 ... (i + 65) / 64, as the byte with the smallest worst relative
 * error over that range: at most 2^-6.79. */
static const uint8_t fixed_reciprocal_seeds[64] = {
    254, 250, 246, 243, 239, 236, 232, 229, 226, 223, 220, 217, 214, 211, 209, 206,
    204, 201, 199, 196, 194, 192, 189, 187, 185, 183, 181, 179, 177, 175, 173, 172,
    170, 168, 166, 165, 163, 161, 160, 158, 157, 155, 154, 152, 151, 150, 148, 147,
    146, 144, 143, 142, 141, 139, 138, 137, 136, 135, 134, 133, 132, 131, 130, 128};

/* Returns 2^48 / m, as estimate_division.h says. With x = m / 2^31, a seed s of 256 / x and
 * e = 1 - s x / 256: 1/x = s / 256 (1 + e + e^2 + ...). The rest is below 2^-19. Rounding x and the
 * result loses 2^-16 and 2^-17, the shift in the square 2^-18. */
static inline uint32_t fixed_reciprocal_estimate(uint32_t m) {
    int32_t seed = fixed_reciprocal_seeds[(m >> 25) - 64];
    int32_t rounded = (int32_t)((m >> 16) + ((m >> 15) & 1)); /* x 2^15 */
    int32_t e = (INT32_C(1) << 23) - seed * rounded;          /* e 2^23, below 2^17 */
    int32_t e_top = e >> 8;
    int32_t step = seed * (e + ((e_top * e_top) >> 7)); /* s / 256 (e + e^2) 2^31 */
    return (uint32_t)((seed << 9) + ((step + (INT32_C(1) << 13)) >> 14));
}

#endif
