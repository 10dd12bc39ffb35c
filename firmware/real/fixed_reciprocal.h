/* SPDX-License-Identifier: MIT */
/* Reciprocals and quotients by an estimate and three products. */
#ifndef SUPERFRAME_FIXED_RECIPROCAL_H
#define SUPERFRAME_FIXED_RECIPROCAL_H

#include "fixed_bits.h"

/* 2^30 / u as mantissa / 2^shift, where u is the raw 32-bit divisor. 2^30 <= |mantissa| < 2^31,
 * 1 <= shift <= 32. */
struct fixed_slope {
    int32_t mantissa;
    uint32_t shift;
};

/* Returns the integer nearest to 2^62 / m, for 2^31 <= m < 2^32. The result lies in (2^30, 2^31].
 * (A half cannot occur: a half would need an odd divisor of 2^63.) tests/proofs/root_exhaustive.c
 * tries every m.
 *
 * With e = 1 - q m / 2^48 for an estimate q of 2^48 / m: 1/m = q / 2^48 (1 + e + e^2 + ...). */
static inline uint32_t fixed_reciprocal(uint32_t m) {
    uint32_t q = fixed_reciprocal_estimate(m); /* 2^16 - 1 <= q <= 2^17, to 2^-15 */
    int64_t e =
        (int64_t)((UINT64_C(1) << 48) - fixed_times_unsigned(q, m)); /* e 2^48: |e| < 2^34 */
    int32_t e_near = (int32_t)(e >> 4);                              /* e 2^44: |e_near| < 2^30 */
    int32_t e_top = e_near >> 15;                                    /* e 2^29: |e_top| < 2^15 */
    int32_t series = e_near + ((e_top * e_top) >> 14);               /* (e + e^2) 2^44 */
    /* r is the floor of q 2^14 (1 + e + e^2). The rest of the series and what the shifts lose stay
     * below 2^-9. So r is at most 1 + 2^-9 under the quotient and 2^-9 over it. */
    uint32_t r = (uint32_t)((int64_t)((uint64_t)q << 14) + (fixed_times((int32_t)q, series) >> 30));
    /* One more where 2^62 - r m > m / 2. */
    uint64_t reach = fixed_times_unsigned(r, m) + (m >> 1);
    return r + ((uint32_t)(reach >> 32) < UINT32_C(1) << 30);
}

/* Returns the slope of m / 2^zeros, where 2^31 <= m < 2^32, 0 <= zeros <= 31. */
static inline struct fixed_slope fixed_slope_of(uint32_t m, unsigned zeros) {
    struct fixed_slope slope;
    uint32_t r = fixed_reciprocal(m);
    uint32_t shift = 32 - zeros;
    if (r > (uint32_t)INT32_MAX) { /* m is 2^31: a power of two stays exact */
        if (shift > 1) {
            r >>= 1;
            shift--;
        } else { /* of 1 LSB: the relative error is 2^-31 */
            r--;
        }
    }
    slope.mantissa = (int32_t)r;
    slope.shift = shift;
    return slope;
}

/* Returns a 2^30 / u to nearest, for the slope of u, brought into a 32-bit format. */
static inline int32_t fixed_over(enum fixed_operation operation, int32_t a,
                                 struct fixed_slope slope) {
    return fixed_result_by(operation, fixed_times(a, slope.mantissa), slope.shift);
}

#endif
