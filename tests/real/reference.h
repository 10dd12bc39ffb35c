/* SPDX-License-Identifier: MIT */
/* What the tests of the operations share: the format under test, random arguments, the judgement.
 */
#ifndef SUPERFRAME_TESTS_REAL_REFERENCE_H
#define SUPERFRAME_TESTS_REAL_REFERENCE_H

/* The tests are compiled once for each arithmetic, which the include path picks. An argument is
 * first brought into its format, so that only the operation's own error is measured. `measured` as
 * the first argument of a test program prints the largest error of each operation that was met. */

#include "real.h"

#include <quadmath.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

typedef __float128 quad;

#define COUNT(array) (sizeof(array) / sizeof(array)[0])
#define STRING_OF(x) #x
#define STRING(x)    STRING_OF(x)
#define TEST(name)   cmocka_unit_test_setup(name, reseed)

enum { RANDOM_ROUNDS = 20000 };

/* The REAL_... macros evaluate their argument more than once: no test gives one a random number. */

/* ---- The format under test ------------------------------------------------------------------- */

/* What one is in the format's own unit: 1 for a floating-point format. */
#define SCALE_LENGTH ((quad)REAL_LENGTH(1.0))
#define SCALE_AREA   ((quad)REAL_AREA(1.0))
#define SCALE_UNIT   ((quad)REAL_UNIT(1.0))
#define SCALE_INDEX  ((quad)REAL_INDEX(1.0))
#define SCALE_ENERGY ((quad)REAL_ENERGY(1.0))
#define SCALE_COLOUR ((quad)REAL_COLOUR(1.0))
#define SCALE_EXT    ((quad)REAL_EXTINCTION(1.0))

static inline bool is_fixed(void) {
    return SCALE_LENGTH > 1;
}

static inline quad of_length(real_length x) {
    return (quad)x / SCALE_LENGTH;
}
static inline quad of_area(real_area x) {
    return (quad)x / SCALE_AREA;
}
static inline quad of_unit(real_unit x) {
    return (quad)x / SCALE_UNIT;
}
static inline quad of_index(real_index x) {
    return (quad)x / SCALE_INDEX;
}
static inline quad of_energy(real_energy x) {
    return (quad)x / SCALE_ENERGY;
}
static inline quad of_colour(real_colour x) {
    return (quad)x / SCALE_COLOUR;
}
static inline quad of_extinction(real_extinction x) {
    return (quad)x / SCALE_EXT;
}

/* The relative error of one rounding: half the distance of 1 to the next number. Only asked for
 * where the format is a floating-point one. */
static inline quad rounding(void) {
    static quad found;
    if (!(found > 0)) {
        volatile real_length half = (real_length)1;
        volatile real_length sum;
        do {
            half = (real_length)(half / 2);
            sum = (real_length)(1 + half);
        } while (sum > (real_length)1 && half > 0);
        found = (quad)half;
    }
    return found;
}

/* ---- Random numbers and edges ---------------------------------------------------------------- */

static uint64_t random_state;

static inline int reseed(void **state) {
    (void)state;
    random_state = UINT64_C(0x9E3779B97F4A7C15);
    return 0;
}

static inline uint64_t random_bits(void) {
    random_state ^= random_state << 13;
    random_state ^= random_state >> 7;
    random_state ^= random_state << 17;
    return random_state * UINT64_C(0x2545F4914F6CDD1D);
}

/* Evenly in -1 .. 1. */
static inline double random_even(void) {
    return (double)((int64_t)random_bits() >> 11) * 0x1p-52;
}

/* In -most .. most: half of them evenly, half of them with an evenly spread exponent. */
static inline double random_within(double most) {
    double x = random_even() * most;
    unsigned down = (unsigned)(random_bits() >> 40) % 64;
    for (unsigned i = 0; down < 32 && i < down; i++) {
        x /= 2;
    }
    return x;
}

static const double length_edges[] = {
    0,        0x1p-20,  0x1p-19, 0x1.8p-19, 0x1p-10,  0.1,    0.5,      1 - 0x1p-20,    1,
    1.1,      100.7,    511.99,  512,       1023.999, 1024,   1536,     2047 - 0x1p-20, 2047,
    -0x1p-20, -0x1p-19, -0.3,    -0.5,      -1,       -333.3, -1023.99, -2048 + 0x1p-20};
static const double unit_edges[] = {0,
                                    0x1p-30,
                                    0x1p-29,
                                    0x1.8p-29,
                                    0x1p-20,
                                    0x1p-10,
                                    0.25,
                                    0.5,
                                    0.57735026918962576,
                                    0.70710678118654752,
                                    1 - 0x1p-30,
                                    1,
                                    1 + 0x1p-29,
                                    -0x1p-30,
                                    -0x1p-29,
                                    -0x1p-15,
                                    -0.3,
                                    -0.5,
                                    -0.8,
                                    -1,
                                    -1.3333333};
static const double index_edges[] = {0,      0x1p-28, 0x1p-27, 0.25, 0.66666666666, 1 - 0x1p-28, 1,
                                     1.0001, 1.5,     2.5,     4,    7.99999,       -0.5,        -1,
                                     -1.5,   -4.1,    -7.99999};
static const double energy_edges[] = {0,   0x1p-30, 0x1p-29, 0x1p-15,     0.1,         0.25,
                                      0.5, 0.75,    0.9,     1 - 0x1p-15, 1 - 0x1p-30, 1};
static const double colour_edges[] = {0,      0x1p-16, 0x1p-15, 0.4999, 0.5,          1,
                                      127.5,  128,     254.9,   255,    255 + 0x1p-8, 1000,
                                      4096.1, 32000,   32767};

/* A number of a table (every other time) or a random one. */
static inline double pick(const double *edges, size_t count, double most) {
    uint64_t bits = random_bits();
    return bits & 1 ? edges[(bits >> 1) % count] : random_within(most);
}

static inline real_length some_length(void) {
    double x = pick(length_edges, COUNT(length_edges), 2047.0);
    return REAL_LENGTH(x);
}
/* A component of a direction: what sums of three products may be given. */
static inline real_unit some_unit(void) {
    double x = pick(unit_edges, COUNT(unit_edges), 1.0);
    return REAL_UNIT(x);
}
/* Anything that the format of directions holds. */
static inline real_unit any_unit(void) {
    double x = random_within(1.999);
    return random_bits() & 4 ? some_unit() : REAL_UNIT(x);
}
static inline real_index some_index(void) {
    double x = pick(index_edges, COUNT(index_edges), 7.999);
    return REAL_INDEX(x);
}
static inline real_energy some_energy(void) {
    double x = pick(energy_edges, COUNT(energy_edges), 1.0);
    return REAL_ENERGY(x < 0 ? -x : x);
}
static inline real_colour some_colour(void) {
    double x = pick(colour_edges, COUNT(colour_edges), 32000.0);
    return REAL_COLOUR(x < 0 ? -x : x);
}
static inline real_area some_area(void) {
    double x = random_within(4194303.0);
    return REAL_AREA(x);
}

/* ---- Judging --------------------------------------------------------------------------------- */

/* The largest error of an operation: in LSB of the result, or in roundings of the magnitude. */
struct measure {
    const char *operation;
    quad worst;
};

static struct measure measures[64];

static inline void measure(const char *operation, quad error) {
    struct measure *m = measures;
    while (m->operation != NULL && strcmp(m->operation, operation) != 0) {
        m++;
    }
    m->operation = operation;
    if (error > m->worst) {
        m->worst = error;
    }
}

static inline quad magnitude(quad x) {
    return x < 0 ? -x : x;
}

static inline void fail_with(const char *operation, quad got, quad want, quad bound) {
    char texts[3][64];
    quadmath_snprintf(texts[0], sizeof texts[0], "%.36Qg", got);
    quadmath_snprintf(texts[1], sizeof texts[1], "%.36Qg", want);
    quadmath_snprintf(texts[2], sizeof texts[2], "%.6Qg", bound);
    fail_msg("%s gave %s, not %s to %s", operation, texts[0], texts[1], texts[2]);
}

/* What a result may differ by. In a fixed-point format of the scale given: `lsb` last bits and the
 * share `relative` of the result. In a floating-point format: `roundings` of the magnitude `of`,
 * the sum of the formula's terms without their signs (with one more for the reference's own). */
struct bound {
    quad scale;
    quad lsb;
    quad relative;
    quad roundings;
    quad of;
};

static inline quad allowed(struct bound bound, quad want) {
    if (is_fixed()) {
        return bound.lsb / bound.scale + magnitude(want) * bound.relative;
    }
    return (bound.roundings + 1) * rounding() * bound.of;
}

/* Also measures. The end of a fixed-point format is the right answer for all that lies beyond it.
 */
static inline void hold(const char *operation, quad got, quad want, struct bound bound) {
    if (is_fixed()) {
        quad most = (bound.scale > 0x1p32 ? (quad)INT64_MAX : (quad)INT32_MAX) / bound.scale;
        want = want > most ? most : want < -most ? -most : want;
    }
    quad error = magnitude(got - want);
    if (!(error <= allowed(bound, want))) {
        fail_with(operation, got, want, allowed(bound, want));
    }
    if (is_fixed()) {
        measure(operation, error * bound.scale);
    } else if (bound.of > 0) {
        measure(operation, error / (rounding() * bound.of));
    }
}

static inline struct bound exact(quad scale, quad of) {
    struct bound bound = {scale, 0, 0, 1, of};
    return bound;
}

/* One rounding in fixed point, so many in floating point. */
static inline struct bound nearest(quad scale, quad roundings, quad of) {
    struct bound bound = {scale, 0.5, 0, roundings, of};
    return bound;
}

/* For the end of main(). */
static inline void report_measures(int argc, char **argv) {
    if (argc > 1 && strcmp(argv[1], "measured") == 0) {
        printf("%s: the largest error met, in %s\n", STRING(REAL_NAME),
               is_fixed() ? "LSB" : "roundings (relative to the sum of the terms' magnitudes)");
        for (const struct measure *m = measures; m->operation != NULL; m++) {
            printf("  %-24s %8.3f\n", m->operation, (double)m->worst);
        }
    }
}

#endif
