/* SPDX-License-Identifier: MIT */
/* One number for all that the fixed-point operations compute, on every CPU and compiler. */
#ifndef SUPERFRAME_TESTS_FINGERPRINT_H
#define SUPERFRAME_TESTS_FINGERPRINT_H

/* For a real.h made of fixed.h, which the includer has included. */

#include <stdint.h>

/* Of 200,000 rounds. A change of fixed.h that changes it changes pictures. */
#define FINGERPRINT_OF_FX UINT64_C(0x7843BF4A4F8B374B)

static uint64_t fingerprint_hash;
static uint64_t fingerprint_random_state;

/* Of eight bytes, low first. */
static void fingerprint_take(int64_t result) {
    for (unsigned i = 0; i < 64; i += 8) {
        fingerprint_hash =
            (fingerprint_hash ^ (((uint64_t)result >> i) & 0xFF)) * UINT64_C(0x100000001B3);
    }
}

static uint64_t fingerprint_random_bits(void) {
    fingerprint_random_state ^= fingerprint_random_state << 13;
    fingerprint_random_state ^= fingerprint_random_state >> 7;
    fingerprint_random_state ^= fingerprint_random_state << 17;
    return fingerprint_random_state;
}

/* |result| < 2^bits, its logarithm spread evenly half of the time. */
static int32_t fingerprint_some(unsigned bits) {
    uint64_t random = fingerprint_random_bits();
    uint32_t magnitude = (uint32_t)(random >> 8) & ((UINT32_C(1) << bits) - 1);
    if (random & 1) {
        magnitude >>= (unsigned)(random >> 56) % bits;
    }
    return random & 2 ? -(int32_t)magnitude : (int32_t)magnitude;
}

static int32_t fingerprint_some_positive(unsigned bits) {
    int32_t x = fingerprint_some(bits);
    return x < 0 ? -x : x > 0 ? x : 1;
}

/* Random numbers are drawn one by one: the order of evaluation of arguments is the compiler's. */
static void fingerprint_one_round(void) {
    int32_t a = fingerprint_some(31), b = fingerprint_some(31), c = fingerprint_some(31);
    int32_t u = fingerprint_some(30), v = fingerprint_some(30), w = fingerprint_some(30),
            p = fingerprint_some(31);
    int32_t eta = fingerprint_some_positive(30), cosine = fingerprint_some_positive(30);
    int32_t energy = fingerprint_some_positive(30), share = fingerprint_some_positive(30);
    int32_t extinction = fingerprint_some_positive(24), way = fingerprint_some_positive(28);
    int64_t area = (int64_t)fingerprint_some(31) * fingerprint_some(31);
    fingerprint_take(length_add(a, b));
    fingerprint_take(length_subtract(a, c));
    fingerprint_take(length_along(a, b, p));
    fingerprint_take(length_dot(a, b, c, u, v, w));
    fingerprint_take(length_scaled(a, p));
    real_slope slope = slope_of(p | 1);
    fingerprint_take(slope.mantissa);
    fingerprint_take(slope.shift);
    fingerprint_take(length_over(a, slope));
    fingerprint_take(length_cell_is_odd(a, fingerprint_some_positive(31)));
    fingerprint_take(area_product(a, b));
    fingerprint_take(area_norm(a, b, c));
    fingerprint_take(area_add(2 * area, area_product(a, c)));
    fingerprint_take(area_subtract(2 * area, area_product(a, c)));
    fingerprint_take(area_scaled(area, p));
    fingerprint_take(length_root(area));
    fingerprint_take(length_quotient(area, b | 1));
    fingerprint_take(unit_dot(u, v, w, v, w, u));
    fingerprint_take(unit_product(u, p));
    fingerprint_take(unit_add(u, p));
    real_unit x, y, z;
    real_length length;
    int16_t column = (int16_t)(fingerprint_random_bits() % 2561),
            row = (int16_t)(fingerprint_random_bits() % 2561);
    unsigned shift = (unsigned)(fingerprint_random_bits() % 17);
    unit_normalise_wide(wide_component(u, v, (int16_t)(column - 1280), w, row, shift),
                        wide_sum(v | 1, p), wide_sum(w, 0), &x, &y, &z);
    fingerprint_take(x);
    fingerprint_take(y);
    fingerprint_take(z);
    unit_normalise_lengths(a, b, c, &x, &y, &z, &length);
    fingerprint_take(x);
    fingerprint_take(y);
    fingerprint_take(z);
    fingerprint_take(length);
    fingerprint_take(unit_mirrored(u, v, w));
    real_unit refracted = 0;
    fingerprint_take(unit_refracted_cosine(cosine, eta, &refracted));
    fingerprint_take(refracted);
    real_index bend = index_bend(eta, cosine, refracted);
    fingerprint_take(bend);
    fingerprint_take(unit_bent(u, eta, bend, v));
    fingerprint_take(index_product(a, b));
    fingerprint_take(index_scaled(a, p));
    fingerprint_take(index_of_unit(p));
    fingerprint_take(index_add(a, b));
    fingerprint_take(index_subtract(a, b));
    fingerprint_take(energy_product(energy, share));
    fingerprint_take(energy_complement(energy));
    fingerprint_take(energy_of_cosine(u));
    fingerprint_take(energy_ratio(a, b));
    fingerprint_take(energy_mean_square(energy, share));
    fingerprint_take(energy_power(energy, (uint16_t)(fingerprint_random_bits() % 300)));
    fingerprint_take(energy_transmitted(extinction, way));
    fingerprint_take(colour_add(a, b));
    fingerprint_take(colour_scaled(a, energy));
    fingerprint_take(colour_lit(a, b));
    fingerprint_take(colour_faded(a, b, (int)(fingerprint_random_bits() % 61) - 30));
    fingerprint_take(colour_level(fingerprint_some(25)));
    volatile double number = (double)a * 0x1.8p-24;
    fingerprint_take(REAL_LENGTH(number));
    fingerprint_take(REAL_UNIT(number * 0x1p-9));
}

/* The FNV-1a hash of so many rounds of seeded results of every operation. */
static inline uint64_t fingerprint_of_operations(long rounds) {
    fingerprint_hash = UINT64_C(0xCBF29CE484222325);
    fingerprint_random_state = UINT64_C(88172645463325252);
    for (long i = 0; i < rounds; i++) {
        fingerprint_one_round();
    }
    return fingerprint_hash;
}

#endif
