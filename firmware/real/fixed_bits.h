/* SPDX-License-Identifier: MIT */
/* Rounding, saturation and bit counting: what the fixed-point operations are made of. */
#ifndef SUPERFRAME_FIXED_BITS_H
#define SUPERFRAME_FIXED_BITS_H

#include "fixed_operations.h"

#include <stdbool.h>
#include <stdint.h>

/* What C99 leaves to the compiler and this code builds on, checked in one place: >> of a negative
 * number keeps its sign, and a conversion to a signed type keeps the low bits. (The exact-width
 * types of stdint.h are two's complement by definition.) A compiler that does otherwise stops here,
 * at an array of negative size. */
typedef char fixed_needs_arithmetic_shift[((int64_t)-3 >> 1) == -2 ? 1 : -1];
typedef char fixed_needs_modular_conversion[(int64_t)UINT64_MAX == -1 ? 1 : -1];

/* The ends of every 32-bit format are symmetric: -2^31 is no value, so that negation and the
 * magnitude of a value always exist. */
#define FIXED_MOST INT32_MAX

/* v / 2^shift to nearest, halves away from zero, so that a mirrored scene gives a mirrored picture.
 * 1 <= shift <= 62, |v| + 2^(shift - 1) < 2^63.
 * A negative v is lowered by one first: then a half is no longer rounded up by the floor of >>. */
static inline int64_t fixed_rounded(int64_t v, unsigned shift) {
    return (v + ((int64_t)1 << (shift - 1)) + (v >> 63)) >> shift;
}

/* The same for 1 <= shift <= 32, in halves of 32 bits: a shift of 64 bits by a variable costs a
 * CPU of 32 bits a call or three times the instructions. */
static inline int64_t fixed_rounded_near(int64_t v, unsigned shift) {
    v += (int64_t)(UINT32_C(1) << (shift - 1)) + (v >> 63);
    int32_t high = (int32_t)(v >> 32);
    uint32_t low = (uint32_t)high << (32 - shift) | ((uint32_t)v >> 1) >> (shift - 1);
    return (int64_t)((uint64_t)(uint32_t)((high >> 1) >> (shift - 1)) << 32 | low);
}

/* v brought into a 32-bit format. */
static inline int32_t fixed_saturated(enum fixed_operation operation, int64_t v) {
    fixed_watch(operation, v, v > FIXED_MOST || v < -(int64_t)FIXED_MOST);
    /* One comparison of the upper half, where a CPU of 32 bits would need four for the two ends. */
    int32_t low = (int32_t)v;
    if (low != v) {
        return v < 0 ? -FIXED_MOST : FIXED_MOST;
    }
    return low < -FIXED_MOST ? -FIXED_MOST : low;
}

/* Both in one; the precondition is that of fixed_rounded(). */
static inline int32_t fixed_result(enum fixed_operation operation, int64_t v, unsigned shift) {
    return fixed_saturated(operation, fixed_rounded(v, shift));
}

static inline int64_t fixed_times(int32_t a, int32_t b) {
    return (int64_t)a * b;
}

static inline uint32_t fixed_magnitude(int32_t a) {
    return a < 0 ? 0 - (uint32_t)a : (uint32_t)a;
}

static inline uint64_t fixed_magnitude64(int64_t a) {
    return a < 0 ? 0 - (uint64_t)a : (uint64_t)a;
}

/* The number of zero bits above the highest one; x > 0. */
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

static inline unsigned fixed_leading_zeros64(uint64_t x) {
    uint32_t high = (uint32_t)(x >> 32);
    return high != 0 ? fixed_leading_zeros(high) : 32 + fixed_leading_zeros((uint32_t)x);
}

#endif
