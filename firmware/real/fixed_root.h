/* SPDX-License-Identifier: MIT */
/* The integer square root of 64 bits: exact by definition, so any faster method gives the same. */
#ifndef SUPERFRAME_FIXED_ROOT_H
#define SUPERFRAME_FIXED_ROOT_H

#include "fixed_bits.h"

/* Returns floor(sqrt(m)) for 2^62 <= m, which lies in [2^31, 2^32). *rest = m - root^2,
 * 0 <= rest <= 2 root.
 *
 * An estimate of 1/sqrt(m) comes first, then one step of Newton for the root, then one exact
 * correction. */
static inline uint32_t fixed_root_of_normal(uint64_t m, uint64_t *rest) {
    uint32_t high = (uint32_t)(m >> 32);
    uint32_t y = fixed_root_estimate(high);            /* 2^54 / sqrt(m) */
    uint64_t estimate = fixed_times_unsigned(high, y); /* 2^22 sqrt(m), relative 2^-18.5 */
    bool is_past = (uint32_t)(estimate >> 32) >> 22 != 0;
    uint32_t root = is_past ? UINT32_MAX : (uint32_t)(estimate >> 22);
    /* Newton: root + (m - root^2) / (2 root). |m - root^2| < 2^46.5. With y for 1 / sqrt(m), the
     * step by itself ends below the root, by 3/2 of the relative error squared. What is truncated
     * before the step adds less than 2^-15, and the floors and shifts take 1 + 2^-4 at most. So the
     * root is at most one too small, and hardly ever one too large. */
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

/* Returns floor(sqrt(x)). */
static inline uint32_t fixed_root64(uint64_t x) {
    if (x == 0) {
        return 0;
    }
    uint64_t rest;
    unsigned half = fixed_leading_zeros64(x) / 2;
    return fixed_root_of_normal(x << (2 * half), &rest) >> half;
}

/* Returns sqrt(x) to nearest, x < 2^64 - 2^32. (A half cannot occur: (n + 1/2)^2 is no integer.) */
static inline uint32_t fixed_nearest_root64(uint64_t x) {
    uint32_t root = fixed_root64(x);
    return root + (x - fixed_times_unsigned(root, root) > root);
}

#endif
