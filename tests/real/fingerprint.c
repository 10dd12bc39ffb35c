/* SPDX-License-Identifier: MIT */
/* One number for all that the fixed-point operations compute: the same on every CPU and compiler.
 */

/* Usage: fingerprint [EXPECTED]. Prints a hash of seeded results of every operation; with a
 * hexadecimal argument, exit status 1 where it differs. Build it with -Ifirmware/real/fx by any
 * compiler with any options: the hash is always the one in docs/numerics.md. */

#include "real.h"

#include <stdio.h>
#include <stdlib.h>

enum { ROUNDS = 200000 };

static uint64_t hash = UINT64_C(0xCBF29CE484222325);
static uint64_t random_state = UINT64_C(88172645463325252);

/* Of eight bytes, low first. */
static void take(int64_t result) {
    for (unsigned i = 0; i < 64; i += 8) {
        hash = (hash ^ (((uint64_t)result >> i) & 0xFF)) * UINT64_C(0x100000001B3);
    }
}

static uint64_t random_bits(void) {
    random_state ^= random_state << 13;
    random_state ^= random_state >> 7;
    random_state ^= random_state << 17;
    return random_state;
}

/* |result| < 2^bits, its logarithm spread evenly half of the time. */
static int32_t some(unsigned bits) {
    uint64_t random = random_bits();
    uint32_t magnitude = (uint32_t)(random >> 8) & ((UINT32_C(1) << bits) - 1);
    if (random & 1) {
        magnitude >>= (unsigned)(random >> 56) % bits;
    }
    return random & 2 ? -(int32_t)magnitude : (int32_t)magnitude;
}

static int32_t some_positive(unsigned bits) {
    int32_t x = some(bits);
    return x < 0 ? -x : x > 0 ? x : 1;
}

/* Random numbers are drawn one by one: the order of evaluation of arguments is the compiler's. */
static void one_round(void) {
    int32_t a = some(31), b = some(31), c = some(31);
    int32_t u = some(30), v = some(30), w = some(30), p = some(31);
    int32_t eta = some_positive(30), cosine = some_positive(30);
    int32_t energy = some_positive(30), share = some_positive(30);
    int32_t extinction = some_positive(24), way = some_positive(28);
    int64_t area = (int64_t)some(31) * some(31);
    take(length_add(a, b));
    take(length_subtract(a, c));
    take(length_along(a, b, p));
    take(length_dot(a, b, c, u, v, w));
    take(length_scaled(a, p));
    real_slope slope = slope_of(p | 1);
    take(slope.mantissa);
    take(slope.shift);
    take(length_over(a, slope));
    take(length_cell_is_odd(a, some_positive(31)));
    take(area_product(a, b));
    take(area_norm(a, b, c));
    take(area_add(2 * area, area_product(a, c)));
    take(area_subtract(2 * area, area_product(a, c)));
    take(area_scaled(area, p));
    take(length_root(area));
    take(length_quotient(area, b | 1));
    take(unit_dot(u, v, w, v, w, u));
    take(unit_product(u, p));
    take(unit_add(u, p));
    real_unit x, y, z;
    real_length length;
    int16_t column = (int16_t)(random_bits() % 2561), row = (int16_t)(random_bits() % 2561);
    unsigned shift = (unsigned)(random_bits() % 17);
    unit_normalise_wide(wide_component(u, v, (int16_t)(column - 1280), w, row, shift),
                        wide_sum(v | 1, p), wide_sum(w, 0), &x, &y, &z);
    take(x);
    take(y);
    take(z);
    unit_normalise_lengths(a, b, c, &x, &y, &z, &length);
    take(x);
    take(y);
    take(z);
    take(length);
    take(unit_mirrored(u, v, w));
    real_unit refracted = 0;
    take(unit_refracted_cosine(cosine, eta, &refracted));
    take(refracted);
    real_index bend = index_bend(eta, cosine, refracted);
    take(bend);
    take(unit_bent(u, eta, bend, v));
    take(index_product(a, b));
    take(index_scaled(a, p));
    take(index_of_unit(p));
    take(index_add(a, b));
    take(index_subtract(a, b));
    take(energy_product(energy, share));
    take(energy_complement(energy));
    take(energy_of_cosine(u));
    take(energy_ratio(a, b));
    take(energy_mean_square(energy, share));
    take(energy_power(energy, (uint16_t)(random_bits() % 300)));
    take(energy_transmitted(extinction, way));
    take(colour_add(a, b));
    take(colour_scaled(a, energy));
    take(colour_lit(a, b));
    take(colour_faded(a, b, (int)(random_bits() % 61) - 30));
    take(colour_level(some(25)));
    volatile double number = (double)a * 0x1.8p-24;
    take(REAL_LENGTH(number));
    take(REAL_UNIT(number * 0x1p-9));
}

int main(int argc, char **argv) {
    for (long i = 0; i < ROUNDS; i++) {
        one_round();
    }
    printf("%08lX%08lX\n", (unsigned long)(hash >> 32), (unsigned long)(hash & 0xFFFFFFFF));
    return argc > 1 && strtoull(argv[1], NULL, 16) != hash ? 1 : 0;
}
