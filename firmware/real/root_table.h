/* SPDX-License-Identifier: MIT */
/* A first estimate of the reciprocal of a root, in integers. */
#ifndef SUPERFRAME_FIXED_ROOT_ESTIMATE_H
#define SUPERFRAME_FIXED_ROOT_ESTIMATE_H

#include <stdint.h>

/* 128 / sqrt(m) at m = (i + 32) / 128 ... (i + 33) / 128, as the byte with the smallest worst
 * relative error over that range: at most 2^-6.78. */
static const uint8_t fixed_root_seeds[96] = {
    254, 250, 247, 243, 240, 236, 233, 230, 228, 225, 222, 220, 217, 215, 212, 210,
    208, 206, 204, 202, 200, 198, 196, 194, 193, 191, 189, 188, 186, 185, 183, 182,
    180, 179, 178, 176, 175, 174, 172, 171, 170, 169, 168, 167, 166, 164, 163, 162,
    161, 160, 159, 158, 158, 157, 156, 155, 154, 153, 152, 151, 151, 150, 149, 148,
    147, 147, 146, 145, 144, 144, 143, 142, 142, 141, 140, 140, 139, 138, 138, 137,
    137, 136, 135, 135, 134, 134, 133, 132, 132, 131, 131, 130, 130, 129, 129, 128};

/* Returns 2^38 / sqrt(high) for 2^30 <= high < 2^32, with a relative error below 2^-18.5. What is
 * made of the estimate does not depend on that error: the sibling, estimate_float.h, differs.
 *
 * The table gives a seed, and one step of third order refines the seed. With e = 1 - m y^2 for an
 * estimate y of 1/sqrt(m): 1/sqrt(m) = y (1 + e/2 + 3 e^2/8 + ...). */
static inline uint32_t fixed_root_estimate(uint32_t high) {
    uint32_t seed = fixed_root_seeds[(high >> 25) - 32];
    /* |e| < 2^-5.7; the step leaves 5/16 |e|^3 < 2^-18.8 and 2^-21 of truncation. */
    int32_t e =
        (int32_t)(INT32_C(0x40000000) - (int32_t)((fixed_times_unsigned(seed * seed, high)) >> 16));
    int32_t e_top = e >> 10;                                      /* e 2^20, below 2^14.4 */
    int32_t step = (e >> 3) + (((e_top * e_top) >> 12) * 3 >> 3); /* (e/2 + 3 e^2/8) 2^28 */
    return (seed << 15) + (uint32_t)(((int32_t)seed * step) >> 13);
}

#endif
