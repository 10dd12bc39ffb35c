/* SPDX-License-Identifier: MIT */
/* Rounding, saturation and bit counting: what the fixed-point operations are made of. */
#ifndef SUPERFRAME_FIXED_BITS_H
#define SUPERFRAME_FIXED_BITS_H

#include "fixed_operations.h"

#include <stdbool.h>
#include <stdint.h>

/* Two things that C99 leaves to the compiler, and this code builds on, are checked here alone. A
 * negative number keeps its sign under >>, and a conversion to a signed type keeps the low bits.
 * (The exact-width types of stdint.h are two's complement by definition.) A compiler that does
 * otherwise stops here, at an array of negative size. */
typedef char fixed_needs_arithmetic_shift[((int64_t)-3 >> 1) == -2 ? 1 : -1];
typedef char fixed_needs_modular_conversion[(int64_t)UINT64_MAX == -1 ? 1 : -1];

/* The ends of every 32-bit format are symmetric: -2^31 is no value. So negation and the
 * magnitude of a value always exist. */
#define FIXED_MOST INT32_MAX

/* Adds to v what makes v / 2^shift, by a shift of 1 <= shift <= 32, come out to nearest. Halves go
 * away from zero, so that a mirrored scene gives a mirrored picture. A negative v is lowered by
 * one, so that the floor of >> no longer rounds a half up. |v| + 2^(shift - 1) < 2^63. */
static inline int64_t fixed_with_half(int64_t v, unsigned shift) {
    return v + (int64_t)((UINT32_C(1) << (shift - 1)) - (uint32_t)(v < 0));
}

/* Returns v / 2^shift to nearest, halves away from zero, 1 <= shift <= 62. */
static inline int64_t fixed_rounded(int64_t v, unsigned shift) {
    return (v + ((int64_t)1 << (shift - 1)) + (v >> 63)) >> shift;
}

/* Brings an exact result into a 32-bit format, from its low 32 bits. `fits` tells whether these are
 * all of the result. Where bits are missing, returns the end with the sign of `sign`. */
static inline int32_t fixed_ended(int32_t low, bool fits, int32_t sign) {
    int32_t whole = low == INT32_MIN ? -FIXED_MOST : low;
    int32_t end = sign < 0 ? -FIXED_MOST : FIXED_MOST;
    return fits ? whole : end;
}

/* Returns v, brought into a 32-bit format. */
static inline int32_t fixed_saturated(enum fixed_operation operation, int64_t v) {
    fixed_watch(operation, v, v > FIXED_MOST || v < -(int64_t)FIXED_MOST);
    return fixed_ended((int32_t)v, fixed_fits(v), (int32_t)(v >> 32));
}

/* Returns v / 2^shift to nearest, where that is known to fit, 1 <= shift <= 32. */
static inline int32_t fixed_near(int64_t v, unsigned shift) {
    bool fits;
    return fixed_shifted(fixed_with_half(v, shift), shift, &fits);
}

/* Returns v >> shift, 1 <= shift <= 32, brought into a 32-bit format. */
static inline int32_t fixed_shortened(enum fixed_operation operation, int64_t v, unsigned shift) {
    bool fits;
    int32_t low = fixed_shifted(v, shift, &fits);
    fixed_watch(operation, v >> shift, !fits || low == INT32_MIN);
    return fixed_ended(low, fits, (int32_t)(v >> 32));
}

/* Returns a + b, brought into a 32-bit format. A sum that does not fit has the sign of a. */
static inline int32_t fixed_ended_sum(enum fixed_operation operation, int32_t a, int32_t b) {
    bool fits;
    int32_t low = fixed_sum(a, b, &fits);
    fixed_watch(operation, (int64_t)a + b, !fits || low == INT32_MIN);
    return fixed_ended(low, fits, a);
}

/* Returns a - b, brought into a 32-bit format. A difference that does not fit has the sign of a. */
static inline int32_t fixed_ended_difference(enum fixed_operation operation, int32_t a, int32_t b) {
    bool fits;
    int32_t low = fixed_difference(a, b, &fits);
    fixed_watch(operation, (int64_t)a - b, !fits || low == INT32_MIN);
    return fixed_ended(low, fits, a);
}

static inline uint32_t fixed_magnitude(int32_t a) {
    return a < 0 ? 0 - (uint32_t)a : (uint32_t)a;
}

static inline uint64_t fixed_magnitude64(int64_t a) {
    return a < 0 ? 0 - (uint64_t)a : (uint64_t)a;
}

static inline unsigned fixed_leading_zeros64(uint64_t x) {
    uint32_t high = (uint32_t)(x >> 32);
    return high != 0 ? fixed_leading_zeros(high) : 32 + fixed_leading_zeros((uint32_t)x);
}

#endif
