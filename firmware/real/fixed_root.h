/* SPDX-License-Identifier: MIT */
/* The integer square root of 64 bits: exact by definition, so any faster method gives the same. */
#ifndef SUPERFRAME_FIXED_ROOT_H
#define SUPERFRAME_FIXED_ROOT_H

#include "fixed_bits.h"

/* 128 / sqrt(m) at m = (i + 32) / 128 ... (i + 33) / 128, as the byte with the smallest worst
 * relative error over that range: at most 2^-6.78. */
static const uint8_t fixed_root_seeds[96] = {
    254, 250, 247, 243, 240, 236, 233, 230, 228, 225, 222, 220, 217, 215, 212, 210,
    208, 206, 204, 202, 200, 198, 196, 194, 193, 191, 189, 188, 186, 185, 183, 182,
    180, 179, 178, 176, 175, 174, 172, 171, 170, 169, 168, 167, 166, 164, 163, 162,
    161, 160, 159, 158, 158, 157, 156, 155, 154, 153, 152, 151, 151, 150, 149, 148,
    147, 147, 146, 145, 144, 144, 143, 142, 142, 141, 140, 140, 139, 138, 138, 137,
    137, 136, 135, 135, 134, 134, 133, 132, 132, 131, 131, 130, 130, 129, 129, 128};

/* floor(sqrt(m)) for 2^62 <= m; it lies in [2^31, 2^32). *rest = m - root^2, 0 <= rest <= 2 root.
 *
 * y ~ 1/sqrt(m) from the table, one step of third order for y, one of Newton for the root, then
 * one exact correction. With e = 1 - m y^2: 1/sqrt(m) = y (1 + e/2 + 3 e^2/8 + ...). */
static inline uint32_t fixed_root_of_normal(uint64_t m, uint64_t *rest) {
    uint32_t high = (uint32_t)(m >> 32);
    uint32_t seed = fixed_root_seeds[(high >> 25) - 32];
    /* |e| < 2^-5.7; the step leaves 5/16 |e|^3 < 2^-18.8 and 2^-21 of truncation. */
    int32_t e =
        (int32_t)(INT32_C(0x40000000) - (int32_t)((fixed_times_unsigned(seed * seed, high)) >> 16));
    int32_t e_top = e >> 10;                                              /* e 2^20, below 2^14.4 */
    int32_t step = (e >> 3) + (((e_top * e_top) >> 12) * 3 >> 3);         /* (e/2 + 3 e^2/8) 2^28 */
    uint32_t y = (seed << 15) + (uint32_t)(((int32_t)seed * step) >> 13); /* 2^22 / sqrt(m) */
    uint64_t estimate = (fixed_times_unsigned(high, y)) >> 22; /* 2^32 sqrt(m), relative 2^-18.5 */
    uint32_t root = estimate > UINT32_MAX ? UINT32_MAX : (uint32_t)estimate;
    /* Newton: root + (m - root^2) / (2 root). |m - root^2| < 2^46.5. With y
     * for 1 / sqrt(m) the step by itself ends below the root, by 3/2 of the relative error squared;
     * what is truncated before it adds less than 2^-15, and the floors and shifts take 1 + 2^-4 at
     * most. So the root is at most one too small, and hardly ever one too large. */
    int64_t error = (int64_t)(m - fixed_times_unsigned(root, root));
    int64_t better = (int64_t)root + ((fixed_times((int32_t)(error >> 26), (int32_t)y)) >> 29);
    root = better > (int64_t)UINT32_MAX ? UINT32_MAX : (uint32_t)better;
    error = (int64_t)(m - fixed_times_unsigned(root, root));
    if (error < 0) {
        root--;
        error += 2 * (int64_t)root + 1;
    } else if (error > 2 * (int64_t)root) {
        error -= 2 * (int64_t)root + 1;
        root++;
    }
    *rest = (uint64_t)error;
    return root;
}

/* floor(sqrt(x)). */
static inline uint32_t fixed_root64(uint64_t x) {
    if (x == 0) {
        return 0;
    }
    uint64_t rest;
    unsigned half = fixed_leading_zeros64(x) / 2;
    return fixed_root_of_normal(x << (2 * half), &rest) >> half;
}

/* sqrt(x) to nearest, x < 2^64 - 2^32. (A half cannot occur: (n + 1/2)^2 is no integer.) */
static inline uint32_t fixed_nearest_root64(uint64_t x) {
    uint32_t root = fixed_root64(x);
    return root + (x - fixed_times_unsigned(root, root) > root);
}

#endif
