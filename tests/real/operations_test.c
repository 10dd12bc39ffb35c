/* SPDX-License-Identifier: MIT */
/* Holds every operation of real.h against its definition in __float128, within its stated error. */

/* Compiled once for each arithmetic, which the include path picks. An argument of the test is first
 * brought into its format, so that only the operation's own error is measured. `measured` as the
 * first argument of the program prints the largest error of each operation that was met. */

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

enum { RANDOM_ROUNDS = 20000 };

/* The REAL_... macros evaluate their argument more than once: none is given a random number here.
 */

/* ---- The format under test ------------------------------------------------------------------- */

/* What one is in the format's own unit: 1 for a floating-point format. */
#define SCALE_LENGTH ((quad)REAL_LENGTH(1.0))
#define SCALE_AREA   ((quad)REAL_AREA(1.0))
#define SCALE_UNIT   ((quad)REAL_UNIT(1.0))
#define SCALE_INDEX  ((quad)REAL_INDEX(1.0))
#define SCALE_ENERGY ((quad)REAL_ENERGY(1.0))
#define SCALE_COLOUR ((quad)REAL_COLOUR(1.0))
#define SCALE_EXT    ((quad)REAL_EXTINCTION(1.0))

static bool is_fixed(void) {
    return SCALE_LENGTH > 1;
}

static quad of_length(real_length x) {
    return (quad)x / SCALE_LENGTH;
}
static quad of_area(real_area x) {
    return (quad)x / SCALE_AREA;
}
static quad of_unit(real_unit x) {
    return (quad)x / SCALE_UNIT;
}
static quad of_index(real_index x) {
    return (quad)x / SCALE_INDEX;
}
static quad of_energy(real_energy x) {
    return (quad)x / SCALE_ENERGY;
}
static quad of_colour(real_colour x) {
    return (quad)x / SCALE_COLOUR;
}
static quad of_extinction(real_extinction x) {
    return (quad)x / SCALE_EXT;
}

/* The relative error of one rounding: half the distance of 1 to the next number. Only asked for
 * where the format is a floating-point one. */
static quad rounding(void) {
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

static int reseed(void **state) {
    (void)state;
    random_state = UINT64_C(0x9E3779B97F4A7C15);
    return 0;
}

static uint64_t random_bits(void) {
    random_state ^= random_state << 13;
    random_state ^= random_state >> 7;
    random_state ^= random_state << 17;
    return random_state * UINT64_C(0x2545F4914F6CDD1D);
}

/* Evenly in -1 .. 1. */
static double random_even(void) {
    return (double)((int64_t)random_bits() >> 11) * 0x1p-52;
}

/* In -most .. most: half of them evenly, half of them with an evenly spread exponent. */
static double random_within(double most) {
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
static double pick(const double *edges, size_t count, double most) {
    uint64_t bits = random_bits();
    return bits & 1 ? edges[(bits >> 1) % count] : random_within(most);
}

static real_length some_length(void) {
    double x = pick(length_edges, COUNT(length_edges), 2047.0);
    return REAL_LENGTH(x);
}
/* A component of a direction: what sums of three products may be given. */
static real_unit some_unit(void) {
    double x = pick(unit_edges, COUNT(unit_edges), 1.0);
    return REAL_UNIT(x);
}
/* Anything that the format of directions holds. */
static real_unit any_unit(void) {
    double x = random_within(1.999);
    return random_bits() & 4 ? some_unit() : REAL_UNIT(x);
}
static real_index some_index(void) {
    double x = pick(index_edges, COUNT(index_edges), 7.999);
    return REAL_INDEX(x);
}
static real_energy some_energy(void) {
    double x = pick(energy_edges, COUNT(energy_edges), 1.0);
    return REAL_ENERGY(x < 0 ? -x : x);
}
static real_colour some_colour(void) {
    double x = pick(colour_edges, COUNT(colour_edges), 32000.0);
    return REAL_COLOUR(x < 0 ? -x : x);
}
static real_area some_area(void) {
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

static void measure(const char *operation, quad error) {
    struct measure *m = measures;
    while (m->operation != NULL && strcmp(m->operation, operation) != 0) {
        m++;
    }
    m->operation = operation;
    if (error > m->worst) {
        m->worst = error;
    }
}

static quad magnitude(quad x) {
    return x < 0 ? -x : x;
}

static void fail_with(const char *operation, quad got, quad want, quad bound) {
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

static quad allowed(struct bound bound, quad want) {
    if (is_fixed()) {
        return bound.lsb / bound.scale + magnitude(want) * bound.relative;
    }
    return (bound.roundings + 1) * rounding() * bound.of;
}

/* Also measures. The end of a fixed-point format is the right answer for all that lies beyond it.
 */
static void hold(const char *operation, quad got, quad want, struct bound bound) {
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

static struct bound exact(quad scale, quad of) {
    struct bound bound = {scale, 0, 0, 1, of};
    return bound;
}

/* One rounding in fixed point, so many in floating point. */
static struct bound nearest(quad scale, quad roundings, quad of) {
    struct bound bound = {scale, 0.5, 0, roundings, of};
    return bound;
}

/* ---- Constants ------------------------------------------------------------------------------- */

static const real_length constant_lengths[] = {
    REAL_LENGTH(0.1),          REAL_LENGTH(-0.1),        REAL_LENGTH(1.0 / 3.0),
    REAL_LENGTH(0x1p-21),      REAL_LENGTH(-0x1p-21),    REAL_LENGTH(0x1.fffffffffffffp-22),
    REAL_LENGTH(-0x1.8p-20),   REAL_LENGTH(2047.99),     REAL_LENGTH(-1234.56789),
    REAL_LENGTH(511.99999999), REAL_LENGTH(0x1.8p-1000), REAL_LENGTH(1536.0000004768371582)};
static const double constant_values[] = {
    0.1,        -0.1,    1.0 / 3.0,   0x1p-21,      -0x1p-21,    0x1.fffffffffffffp-22,
    -0x1.8p-20, 2047.99, -1234.56789, 511.99999999, 0x1.8p-1000, 1536.0000004768371582};

static void constants_have_the_same_bits_at_compile_time_and_at_run_time(void **state) {
    (void)state;
    for (size_t i = 0; i < COUNT(constant_values); i++) {
        volatile double value = constant_values[i];
        real_length at_run_time = REAL_LENGTH(value);
        assert_true(memcmp(&constant_lengths[i], &at_run_time, sizeof at_run_time) == 0);
    }
}

static quad rounded_away(quad x) {
    return x < 0 ? -floorq(-x + 0.5) : floorq(x + 0.5);
}

static void constants_round_halves_away_from_zero(void **state) {
    (void)state;
    for (int i = 0; i < RANDOM_ROUNDS; i++) {
        double x = random_within(2047.0);
        if (i % 4 == 0) {
            x = (double)((int32_t)random_bits() >> 4) * 0x1p-21; /* whole and half LSBs */
        }
        if (is_fixed()) {
            assert_true((quad)REAL_LENGTH(x) == rounded_away(x * SCALE_LENGTH));
            assert_true((quad)REAL_AREA(x) == rounded_away(x * SCALE_AREA));
            x /= 2048;
            assert_true((quad)REAL_UNIT(x) == rounded_away(x * SCALE_UNIT));
            assert_true((quad)REAL_ENERGY(x) == rounded_away(x * SCALE_ENERGY));
            x *= 7;
            assert_true((quad)REAL_INDEX(x) == rounded_away(x * SCALE_INDEX));
            assert_true((quad)REAL_EXTINCTION(x) == rounded_away(x * SCALE_EXT));
            x *= 255;
            assert_true((quad)REAL_COLOUR(x) == rounded_away(x * SCALE_COLOUR));
        } else {
            hold("REAL_LENGTH", of_length(REAL_LENGTH(x)), x, nearest(1, 1, magnitude(x)));
        }
    }
}

static void values_lead_back_to_what_constants_made(void **state) {
    (void)state;
    for (int i = 0; i < RANDOM_ROUNDS; i++) {
        real_length length = some_length();
        real_unit unit = any_unit();
        real_energy energy = some_energy();
        real_colour colour = some_colour();
        assert_true(LENGTH_VALUE(length) == (double)of_length(length));
        assert_true(UNIT_VALUE(unit) == (double)of_unit(unit));
        assert_true(ENERGY_VALUE(energy) == (double)of_energy(energy));
        assert_true(COLOUR_VALUE(colour) == (double)of_colour(colour));
    }
}

static void constants_past_the_end_saturate(void **state) {
    (void)state;
    if (!is_fixed()) {
        return;
    }
    const double past[] = {2048, 2047.9999999, 1e6, 1e300, HUGE_VALQ};
    for (size_t i = 0; i < COUNT(past); i++) {
        assert_true((quad)REAL_LENGTH(past[i]) == INT32_MAX);
        assert_true((quad)REAL_LENGTH(-past[i]) == -INT32_MAX);
        assert_true((quad)REAL_UNIT(past[i]) == INT32_MAX);
        assert_true((quad)REAL_AREA(past[i] * past[i] * 16) == (quad)INT64_MAX);
        assert_true((quad)REAL_AREA(-past[i] * past[i] * 16) == -(quad)INT64_MAX);
    }
}

static void far_lies_above_every_scene_and_within_the_format(void **state) {
    (void)state;
    assert_true(of_length(LENGTH_FAR) == 2047);
    assert_true(length_less(LENGTH_NOISE, REAL_LENGTH(0x1p-10)));
    assert_true(length_less(REAL_LENGTH(0), LENGTH_NOISE));
}

/* ---- Lengths --------------------------------------------------------------------------------- */

static void length_add_is_exact_or_saturates(void **state) {
    (void)state;
    for (int i = 0; i < RANDOM_ROUNDS; i++) {
        real_length a = some_length(), b = some_length();
        quad sum = of_length(a) + of_length(b), difference = of_length(a) - of_length(b);
        hold("length_add", of_length(length_add(a, b)), sum, exact(SCALE_LENGTH, magnitude(sum)));
        hold("length_subtract", of_length(length_subtract(a, b)), difference,
             exact(SCALE_LENGTH, magnitude(difference)));
        assert_true(of_length(length_negate(a)) == -of_length(a));
    }
}

static void length_less_orders_strictly(void **state) {
    (void)state;
    for (int i = 0; i < RANDOM_ROUNDS; i++) {
        real_length a = some_length(), b = some_length();
        assert_true(length_less(a, b) == (of_length(a) < of_length(b)));
        assert_false(length_less(a, a));
        assert_true(length_is_zero(a) == (of_length(a) == 0));
    }
}

static void length_along_rounds_once(void **state) {
    (void)state;
    for (int i = 0; i < 2 * RANDOM_ROUNDS; i++) {
        real_length origin = some_length(), t = some_length();
        real_unit u = any_unit();
        quad term = of_length(t) * of_unit(u);
        hold("length_along", of_length(length_along(origin, t, u)), of_length(origin) + term,
             nearest(SCALE_LENGTH, 2, magnitude(of_length(origin)) + magnitude(term)));
    }
}

static void length_dot_rounds_once(void **state) {
    (void)state;
    for (int i = 0; i < 4 * RANDOM_ROUNDS; i++) {
        real_length x = some_length(), y = some_length(), z = some_length();
        real_unit u = some_unit(), v = some_unit(), w = some_unit();
        quad a = of_length(x) * of_unit(u), b = of_length(y) * of_unit(v),
             c = of_length(z) * of_unit(w);
        hold("length_dot", of_length(length_dot(x, y, z, u, v, w)), a + b + c,
             nearest(SCALE_LENGTH, 3, magnitude(a) + magnitude(b) + magnitude(c)));
    }
}

static void length_scaled_rounds_once(void **state) {
    (void)state;
    for (int i = 0; i < 2 * RANDOM_ROUNDS; i++) {
        real_length a = some_length();
        real_unit u = any_unit();
        quad want = of_length(a) * of_unit(u);
        hold("length_scaled", of_length(length_scaled(a, u)), want,
             nearest(SCALE_LENGTH, 1, magnitude(want)));
    }
}

static void hold_quotient(real_length a, real_unit u) {
    quad want = of_length(a) / of_unit(u);
    quad got = of_length(length_over(a, slope_of(u)));
    struct bound bound = {SCALE_LENGTH, 0.5, 0x1p-31, 2, magnitude(want)};
    if (!is_fixed() && magnitude(want) > 2048) {
        want = want > 0 ? 2048 : -2048;
    }
    hold("length_over", got, want, bound);
}

static void length_over_divides_and_saturates(void **state) {
    (void)state;
    for (size_t i = 0; i < COUNT(length_edges); i++) {
        for (size_t j = 0; j < COUNT(unit_edges); j++) {
            real_unit u = REAL_UNIT(unit_edges[j]);
            if (!unit_is_zero(u)) {
                hold_quotient(REAL_LENGTH(length_edges[i]), u);
            }
        }
    }
    for (int i = 0; i < 4 * RANDOM_ROUNDS; i++) {
        real_unit u = any_unit();
        if (!unit_is_zero(u)) {
            hold_quotient(some_length(), u);
        }
    }
}

static void length_over_is_exact_for_axes_and_powers_of_two(void **state) {
    (void)state;
    for (int i = 0; i < RANDOM_ROUNDS; i++) {
        double x = random_within(250.0);
        real_length a = REAL_LENGTH(x);
        for (double u = 1; u > 0.1; u /= 2) {
            assert_true(of_length(length_over(a, slope_of(REAL_UNIT(u)))) == of_length(a) / u);
            assert_true(of_length(length_over(a, slope_of(REAL_UNIT(-u)))) == -of_length(a) / u);
        }
    }
}

static void length_over_never_decreases(void **state) {
    (void)state;
    for (int i = 0; i < RANDOM_ROUNDS; i++) {
        real_unit u = any_unit();
        if (unit_is_zero(u)) {
            continue;
        }
        if (unit_is_negative(u)) {
            u = unit_negate(u);
        }
        real_slope slope = slope_of(u);
        real_length a = some_length();
        real_length before = length_over(a, slope);
        for (int step = 0; step < 16; step++) {
            a = length_add(a, REAL_LENGTH(step < 12 ? 0x1p-20 : 1.0));
            real_length after = length_over(a, slope);
            assert_false(length_less(after, before));
            before = after;
        }
    }
}

static void a_reciprocal_of_next_to_nothing_gives_no_nan(void **state) {
    (void)state;
    real_unit u = REAL_UNIT(0x1p-30);
    for (int i = 0; i < 20000 && !unit_is_zero(u); i++) {
        real_length t = length_over(REAL_LENGTH(0), slope_of(u));
        assert_true(of_length(t) == 0);
        assert_false(length_less(length_over(REAL_LENGTH(1), slope_of(u)), LENGTH_FAR) &&
                     of_unit(u) < 0x1p-12);
        if (is_fixed()) {
            break;
        }
        u = (real_unit)(u / 2);
    }
}

static void hold_cell(real_length a, real_length size) {
    quad ratio = of_length(a) / of_length(size);
    if (!is_fixed() && magnitude(ratio - rintq(ratio)) <= 2 * rounding() * magnitude(ratio) &&
        ratio != rintq(ratio)) {
        return; /* the quotient may round to the whole number */
    }
    quad cell = floorq(ratio);
    bool odd = cell - 2 * floorq(cell / 2) > 0;
    if (length_cell_is_odd(a, size) != odd) {
        fail_with("length_cell_is_odd", !odd, odd, of_length(a));
    }
}

static void length_cell_is_odd_floors_on_both_sides_of_zero(void **state) {
    (void)state;
    const double sizes[] = {0x1p-20, 0x1.8p-19, 0.1, 0.3, 1, 1.5, 25, 511, 2047};
    for (size_t j = 0; j < COUNT(sizes); j++) {
        for (size_t i = 0; i < COUNT(length_edges); i++) {
            hold_cell(REAL_LENGTH(length_edges[i]), REAL_LENGTH(sizes[j]));
        }
        for (int cell = -9; cell <= 9; cell++) {
            real_length border = REAL_LENGTH((double)cell * sizes[j]);
            hold_cell(border, REAL_LENGTH(sizes[j]));
            hold_cell(length_add(border, REAL_LENGTH(0x1p-20)), REAL_LENGTH(sizes[j]));
            hold_cell(length_subtract(border, REAL_LENGTH(0x1p-20)), REAL_LENGTH(sizes[j]));
        }
    }
    for (int i = 0; i < RANDOM_ROUNDS; i++) {
        real_length size = some_length();
        if (length_less(size, REAL_LENGTH(0))) {
            size = length_negate(size);
        }
        if (length_less(REAL_LENGTH(0x1p-18), size)) {
            hold_cell(some_length(), size);
        }
    }
    assert_false(length_cell_is_odd(REAL_LENGTH(0.5), REAL_LENGTH(1)));
    assert_true(length_cell_is_odd(REAL_LENGTH(1), REAL_LENGTH(1)));
    assert_true(length_cell_is_odd(REAL_LENGTH(-0.5), REAL_LENGTH(1)));
    assert_true(length_cell_is_odd(REAL_LENGTH(-1), REAL_LENGTH(1)));
    assert_false(length_cell_is_odd(REAL_LENGTH(-1.5), REAL_LENGTH(1)));
}

/* ---- Areas ----------------------------------------------------------------------------------- */

static void area_product_is_exact(void **state) {
    (void)state;
    for (int i = 0; i < RANDOM_ROUNDS; i++) {
        real_length a = some_length(), b = some_length();
        quad want = of_length(a) * of_length(b);
        hold("area_product", of_area(area_product(a, b)), want, exact(SCALE_AREA, magnitude(want)));
    }
}

static void area_norm_is_exact_or_saturates(void **state) {
    (void)state;
    for (int i = 0; i < 2 * RANDOM_ROUNDS; i++) {
        real_length x = some_length(), y = some_length(), z = some_length();
        quad want =
            of_length(x) * of_length(x) + of_length(y) * of_length(y) + of_length(z) * of_length(z);
        struct bound bound = {SCALE_AREA, 0, 0, 3, want};
        hold("area_norm", of_area(area_norm(x, y, z)), want, bound);
    }
    real_length most = REAL_LENGTH(2047.9999);
    assert_false(area_is_negative(area_norm(most, most, most)));
}

static void area_sums_are_exact_or_saturate(void **state) {
    (void)state;
    for (int i = 0; i < RANDOM_ROUNDS; i++) {
        real_area a = some_area(), b = some_area();
        if (i % 3 == 0) { /* to the ends of the format */
            a = area_add(a, area_add(a, a));
            b = area_add(b, area_add(b, b));
        }
        quad sum = of_area(a) + of_area(b), difference = of_area(a) - of_area(b);
        hold("area_add", of_area(area_add(a, b)), sum, exact(SCALE_AREA, magnitude(sum)));
        hold("area_subtract", of_area(area_subtract(a, b)), difference,
             exact(SCALE_AREA, magnitude(difference)));
        assert_true(area_is_negative(a) == (of_area(a) < 0));
    }
}

static void area_scaled_rounds_once_and_saturates(void **state) {
    (void)state;
    for (int i = 0; i < 4 * RANDOM_ROUNDS; i++) {
        real_area a = some_area();
        real_unit u = any_unit();
        if (i % 3 == 0) {
            a = area_add(a, a);
        }
        quad want = of_area(a) * of_unit(u);
        hold("area_scaled", of_area(area_scaled(a, u)), want,
             nearest(SCALE_AREA, 1, magnitude(want)));
    }
}

static void hold_root(real_area a) {
    quad area = of_area(a);
    quad want = area > 0 ? sqrtq(area) : 0;
    hold("length_root", of_length(length_root(a)), want, nearest(SCALE_LENGTH, 1, want));
}

static void length_root_rounds_to_nearest(void **state) {
    (void)state;
    for (size_t i = 0; i < COUNT(length_edges); i++) {
        real_area square = area_product(REAL_LENGTH(length_edges[i]), REAL_LENGTH(length_edges[i]));
        for (int step = -2; step <= 2; step++) {
            hold_root(area_add(square, REAL_AREA((double)step * 0x1p-40)));
        }
        hold_root(area_add(square, square));
    }
    for (int i = 0; i < 4 * RANDOM_ROUNDS; i++) {
        hold_root(some_area());
    }
    assert_true(of_length(length_root(REAL_AREA(-1))) == 0);
    assert_true(of_length(length_root(REAL_AREA(0))) == 0);
}

static void length_root_undoes_a_square(void **state) {
    (void)state;
    for (int i = 0; i < RANDOM_ROUNDS; i++) {
        real_length a = some_length();
        if (!length_less(a, REAL_LENGTH(0))) {
            hold("length_root", of_length(length_root(area_product(a, a))), of_length(a),
                 exact(SCALE_LENGTH, 2 * of_length(a)));
        }
    }
}

static void hold_area_quotient(real_area a, real_length b) {
    quad want = of_area(a) / of_length(b);
    struct bound bound = {SCALE_LENGTH, 1, 0x1p-30, 1, magnitude(want)};
    if (!is_fixed() && magnitude(want) > 2048) {
        want = want > 0 ? 2048 : -2048;
    }
    hold("length_quotient", of_length(length_quotient(a, b)), want, bound);
}

static void length_quotient_divides_to_one_lsb_and_saturates(void **state) {
    (void)state;
    for (int i = 0; i < 4 * RANDOM_ROUNDS; i++) {
        real_length b = some_length();
        if (length_is_zero(b)) {
            continue;
        }
        hold_area_quotient(some_area(), b);
        hold_area_quotient(area_product(some_length(), b), b);
        real_area most = REAL_AREA(8388607.99);
        hold_area_quotient(most, b);
        hold_area_quotient(-most, b);
    }
    for (int i = -16; i <= 16; i++) { /* divisors of a few LSB */
        for (int j = 0; j < 200 && i != 0; j++) {
            double a = random_within(0x1p-24);
            hold_area_quotient(REAL_AREA(a), REAL_LENGTH(i * 0x1p-20));
        }
    }
}

/* ---- Directions and cosines ------------------------------------------------------------------ */

static void unit_signs_and_order_are_those_of_the_numbers(void **state) {
    (void)state;
    for (int i = 0; i < RANDOM_ROUNDS; i++) {
        real_unit a = any_unit(), b = any_unit();
        assert_true(unit_is_zero(a) == (of_unit(a) == 0));
        assert_true(unit_is_negative(a) == (of_unit(a) < 0));
        assert_true(unit_less(a, b) == (of_unit(a) < of_unit(b)));
        assert_true(of_unit(unit_negate(a)) == -of_unit(a));
    }
}

static void unit_dot_rounds_once(void **state) {
    (void)state;
    for (int i = 0; i < 4 * RANDOM_ROUNDS; i++) {
        real_unit ax = some_unit(), ay = some_unit(), az = some_unit();
        real_unit bx = some_unit(), by = some_unit(), bz = some_unit();
        quad x = of_unit(ax) * of_unit(bx), y = of_unit(ay) * of_unit(by),
             z = of_unit(az) * of_unit(bz);
        hold("unit_dot", of_unit(unit_dot(ax, ay, az, bx, by, bz)), x + y + z,
             nearest(SCALE_UNIT, 3, magnitude(x) + magnitude(y) + magnitude(z)));
    }
}

static void unit_product_rounds_once(void **state) {
    (void)state;
    for (int i = 0; i < 2 * RANDOM_ROUNDS; i++) {
        real_unit a = any_unit(), b = any_unit();
        quad want = of_unit(a) * of_unit(b);
        hold("unit_product", of_unit(unit_product(a, b)), want,
             nearest(SCALE_UNIT, 1, magnitude(want)));
    }
}

static void unit_add_is_exact_or_saturates(void **state) {
    (void)state;
    for (int i = 0; i < RANDOM_ROUNDS; i++) {
        real_unit a = any_unit(), b = any_unit();
        quad want = of_unit(a) + of_unit(b);
        hold("unit_add", of_unit(unit_add(a, b)), want, exact(SCALE_UNIT, magnitude(want)));
    }
}

/* Of the direction given, which the result should be; the third power of ten is far above any. */
static void hold_direction(const char *operation, const real_unit got[3], const quad vector[3]) {
    quad length = sqrtq(vector[0] * vector[0] + vector[1] * vector[1] + vector[2] * vector[2]);
    for (int i = 0; i < 3; i++) {
        quad want = vector[i] / length;
        struct bound bound = {SCALE_UNIT, 2, 0, 5, magnitude(want)};
        hold(operation, of_unit(got[i]), want, bound);
    }
}

static void wide_components_are_formed_and_normalised_to_two_lsb(void **state) {
    (void)state;
    for (int i = 0; i < 2 * RANDOM_ROUNDS; i++) {
        unsigned shift = (unsigned)(random_bits() >> 20) % 17;
        int16_t x = (int16_t)((int)(random_bits() % 2561) - 1280);
        int16_t y = (int16_t)((int)(random_bits() % 2561) - 1280);
        real_wide wide[3];
        quad vector[3];
        quad most = 0;
        for (int axis = 0; axis < 3; axis++) {
            real_unit forward = some_unit(), column = some_unit(), row = some_unit();
            quad pixel = (quad)x * of_unit(column), line = (quad)y * of_unit(row);
            quad unit = scalbnq(1, -(int)shift);
            wide[axis] = wide_component(forward, column, x, row, y, shift);
            vector[axis] = of_unit(forward) + (pixel + line) * unit;
            /* A component that the terms' cancelling left small still has their rounding errors. */
            quad terms = magnitude(of_unit(forward)) + (magnitude(pixel) + magnitude(line)) * unit;
            most = terms > most ? terms : most;
        }
        quad length = sqrtq(vector[0] * vector[0] + vector[1] * vector[1] + vector[2] * vector[2]);
        if (length < 0x1p-12) {
            continue;
        }
        real_unit got[3];
        unit_normalise_wide(wide[0], wide[1], wide[2], &got[0], &got[1], &got[2]);
        for (int axis = 0; axis < 3; axis++) {
            struct bound bound = {SCALE_UNIT, 2, 0, 8, most / length * 2};
            hold("unit_normalise_wide", of_unit(got[axis]), vector[axis] / length, bound);
        }
    }
}

static void wide_sums_are_normalised_to_two_lsb(void **state) {
    (void)state;
    for (int i = 0; i < 2 * RANDOM_ROUNDS; i++) {
        real_wide wide[3];
        quad vector[3];
        for (int axis = 0; axis < 3; axis++) {
            real_unit a = any_unit(), b = i & 1 ? any_unit() : REAL_UNIT(0);
            wide[axis] = wide_sum(a, b);
            vector[axis] = is_fixed() ? of_unit(a) + of_unit(b) : (quad)wide[axis];
        }
        if (vector[0] == 0 && vector[1] == 0 && vector[2] == 0) {
            continue;
        }
        real_unit got[3];
        unit_normalise_wide(wide[0], wide[1], wide[2], &got[0], &got[1], &got[2]);
        hold_direction("unit_normalise_wide", got, vector);
    }
}

static void axes_stay_axes_when_normalised(void **state) {
    (void)state;
    real_unit zero = REAL_UNIT(0), got[3];
    real_length length;
    for (int sign = -1; sign <= 1; sign += 2) {
        real_unit axis = REAL_UNIT(sign);
        unit_normalise_wide(wide_sum(zero, zero), wide_sum(axis, zero), wide_sum(zero, zero),
                            &got[0], &got[1], &got[2]);
        assert_true(of_unit(got[0]) == 0 && of_unit(got[1]) == sign && of_unit(got[2]) == 0);
        for (double size = 0x1p-20; size < 2048; size *= 2) {
            unit_normalise_lengths(REAL_LENGTH(sign * size), REAL_LENGTH(0), REAL_LENGTH(0),
                                   &got[0], &got[1], &got[2], &length);
            assert_true(of_unit(got[0]) == sign && of_unit(got[1]) == 0 && of_unit(got[2]) == 0);
            assert_true(of_length(length) == size);
        }
    }
}

static void normalising_lengths_gives_direction_and_length(void **state) {
    (void)state;
    for (int i = 0; i < 4 * RANDOM_ROUNDS; i++) {
        real_length x = some_length(), y = some_length(), z = some_length(), length;
        real_unit got[3];
        const quad vector[3] = {of_length(x), of_length(y), of_length(z)};
        quad want = sqrtq(vector[0] * vector[0] + vector[1] * vector[1] + vector[2] * vector[2]);
        unit_normalise_lengths(x, y, z, &got[0], &got[1], &got[2], &length);
        if (want == 0) {
            assert_true(of_unit(got[0]) == 0 && of_unit(got[1]) == 0 && of_unit(got[2]) == 0);
            assert_true(of_length(length) == 0);
            continue;
        }
        hold_direction("unit_normalise_lengths", got, vector);
        hold("length of a vector", of_length(length), want, nearest(SCALE_LENGTH, 4, want));
    }
}

static void unit_mirrored_rounds_once(void **state) {
    (void)state;
    for (int i = 0; i < 4 * RANDOM_ROUNDS; i++) {
        real_unit d = any_unit(), c = any_unit(), n = any_unit();
        quad term = 2 * of_unit(c) * of_unit(n);
        hold("unit_mirrored", of_unit(unit_mirrored(d, c, n)), of_unit(d) + term,
             nearest(SCALE_UNIT, 2, magnitude(of_unit(d)) + magnitude(term)));
    }
}

/* The radicand may be off by a little, which the root makes much of where it is nearly zero: there
 * the result is held to the roots of the ends of that interval. */
static void hold_refraction(real_unit c, real_index eta) {
    quad cosine = is_fixed() && of_unit(c) > 1 ? 1 : of_unit(c); /* fixed point clamps it */
    quad square = of_index(eta) * of_index(eta) * (1 - cosine) * (1 + cosine);
    quad radicand = 1 - square;
    quad off = is_fixed() ? 0x1p-48 : 6 * rounding() * (square + magnitude(radicand));
    real_unit refracted = REAL_UNIT(0.123);
    if (!unit_refracted_cosine(c, eta, &refracted)) {
        if (radicand > off) {
            fail_with("unit_refracted_cosine (none)", 0, radicand, off);
        }
        return;
    }
    quad got = of_unit(refracted);
    quad highest = radicand + off > 0 ? sqrtq(radicand + off) : -1;
    quad lowest = radicand > off ? sqrtq(radicand - off) : 0;
    quad half = is_fixed() ? 0.5 / SCALE_UNIT : 2 * rounding() * got;
    if (!(got >= lowest - half && got <= highest + half)) {
        fail_with("unit_refracted_cosine", got, radicand > 0 ? sqrtq(radicand) : -1, half);
    }
    if (radicand > 0x1p-16) {
        quad want = sqrtq(radicand);
        struct bound bound = {SCALE_UNIT, 0.51, 0, 6, 1 + 1 / want};
        hold("unit_refracted_cosine", got, want, bound);
    }
}

static void refraction_obeys_snell_up_to_the_critical_angle(void **state) {
    (void)state;
    for (size_t i = 0; i < COUNT(unit_edges); i++) {
        for (size_t j = 0; j < COUNT(index_edges); j++) {
            if (unit_edges[i] >= 0 && index_edges[j] > 0) {
                hold_refraction(REAL_UNIT(unit_edges[i]), REAL_INDEX(index_edges[j]));
            }
        }
    }
    for (int i = 0; i < 4 * RANDOM_ROUNDS; i++) {
        double c = random_within(1.0), eta = random_within(4.0);
        real_unit cosine = REAL_UNIT(c < 0 ? -c : c);
        real_index ratio = REAL_INDEX(eta < 0 ? -eta : eta);
        hold_refraction(cosine, ratio);
        /* Around the critical angle of this ratio. */
        quad square = 1 - 1 / (of_index(ratio) * of_index(ratio));
        if (square > 0) {
            double critical = (double)sqrtq(square);
            for (int step = -2; step <= 2; step++) {
                hold_refraction(REAL_UNIT(critical + step * 0x1p-30), ratio);
            }
        }
    }
}

static void refraction_between_equal_media_keeps_the_cosine(void **state) {
    (void)state;
    real_unit refracted;
    for (int i = 0; i < RANDOM_ROUNDS; i++) {
        double cosine = 0.004 + 0.498 * (1 + random_even());
        real_unit c = REAL_UNIT(cosine);
        assert_true(unit_refracted_cosine(c, REAL_INDEX(1), &refracted));
        struct bound bound = {SCALE_UNIT, 0, 0, 6, 1 / of_unit(c)};
        hold("refraction at 1", of_unit(refracted), of_unit(c), bound);
    }
    assert_true(unit_refracted_cosine(REAL_UNIT(1), REAL_INDEX(2.5), &refracted));
    assert_true(of_unit(refracted) == 1);
}

static void index_bend_rounds_once(void **state) {
    (void)state;
    for (int i = 0; i < 4 * RANDOM_ROUNDS; i++) {
        real_index eta = some_index();
        real_unit c = any_unit(), refracted = any_unit();
        quad term = of_index(eta) * of_unit(c);
        hold("index_bend", of_index(index_bend(eta, c, refracted)), term - of_unit(refracted),
             nearest(SCALE_INDEX, 2, magnitude(term) + magnitude(of_unit(refracted))));
    }
}

static void unit_bent_rounds_once(void **state) {
    (void)state;
    for (int i = 0; i < 4 * RANDOM_ROUNDS; i++) {
        real_unit d = any_unit(), n = any_unit();
        real_index eta = some_index(), bend = some_index();
        quad along = of_index(eta) * of_unit(d), across = of_index(bend) * of_unit(n);
        hold("unit_bent", of_unit(unit_bent(d, eta, bend, n)), along + across,
             nearest(SCALE_UNIT, 2, magnitude(along) + magnitude(across)));
    }
}

/* ---- Indices of refraction ------------------------------------------------------------------- */

static void index_operations_round_once(void **state) {
    (void)state;
    for (int i = 0; i < 4 * RANDOM_ROUNDS; i++) {
        real_index a = some_index(), b = some_index();
        real_unit u = any_unit();
        quad product = of_index(a) * of_index(b), scaled = of_index(a) * of_unit(u);
        quad sum = of_index(a) + of_index(b), difference = of_index(a) - of_index(b);
        hold("index_product", of_index(index_product(a, b)), product,
             nearest(SCALE_INDEX, 1, magnitude(product)));
        hold("index_scaled", of_index(index_scaled(a, u)), scaled,
             nearest(SCALE_INDEX, 1, magnitude(scaled)));
        hold("index_of_unit", of_index(index_of_unit(u)), of_unit(u),
             nearest(SCALE_INDEX, 0, magnitude(of_unit(u))));
        hold("index_add", of_index(index_add(a, b)), sum, exact(SCALE_INDEX, magnitude(sum)));
        hold("index_subtract", of_index(index_subtract(a, b)), difference,
             exact(SCALE_INDEX, magnitude(difference)));
    }
}

/* ---- Energies -------------------------------------------------------------------------------- */

static void energy_product_rounds_once(void **state) {
    (void)state;
    for (int i = 0; i < 2 * RANDOM_ROUNDS; i++) {
        real_energy a = some_energy(), b = some_energy();
        quad want = of_energy(a) * of_energy(b);
        hold("energy_product", of_energy(energy_product(a, b)), want,
             nearest(SCALE_ENERGY, 1, want));
        assert_true(energy_less(a, b) == (of_energy(a) < of_energy(b)));
        assert_true(energy_is_zero(a) == (of_energy(a) == 0));
    }
}

static void energy_add_is_exact_or_saturates(void **state) {
    (void)state;
    for (int i = 0; i < RANDOM_ROUNDS; i++) {
        real_energy a = some_energy(), b = some_energy();
        quad want = of_energy(a) + of_energy(b);
        hold("energy_add", of_energy(energy_add(a, b)), want, exact(SCALE_ENERGY, want));
    }
}

static void energy_complement_is_exact(void **state) {
    (void)state;
    for (int i = 0; i < RANDOM_ROUNDS; i++) {
        real_energy a = some_energy();
        hold("energy_complement", of_energy(energy_complement(a)), 1 - of_energy(a),
             exact(SCALE_ENERGY, 1));
    }
}

static void energy_of_cosine_clamps_to_zero_and_one(void **state) {
    (void)state;
    for (int i = 0; i < RANDOM_ROUNDS; i++) {
        real_unit cosine = any_unit();
        quad want = of_unit(cosine) < 0 ? 0 : of_unit(cosine) > 1 ? 1 : of_unit(cosine);
        assert_true(of_energy(energy_of_cosine(cosine)) == want);
    }
}

static void hold_ratio(real_index part, real_index whole) {
    quad a = of_index(part), b = of_index(whole);
    if (b == 0) {
        assert_true(of_energy(energy_ratio(part, whole)) == 0);
    } else if (magnitude(a) <= magnitude(b)) {
        struct bound bound = {SCALE_ENERGY, 1, 0, 1, magnitude(a / b)};
        hold("energy_ratio", of_energy(energy_ratio(part, whole)), a / b, bound);
        assert_true(magnitude(of_energy(energy_ratio(part, whole))) <= 1);
    }
}

static void energy_ratio_divides_to_one_lsb_and_never_exceeds_one(void **state) {
    (void)state;
    for (size_t i = 0; i < COUNT(index_edges); i++) {
        for (size_t j = 0; j < COUNT(index_edges); j++) {
            hold_ratio(REAL_INDEX(index_edges[i]), REAL_INDEX(index_edges[j]));
        }
    }
    for (int i = 0; i < 4 * RANDOM_ROUNDS; i++) {
        real_index a = some_index(), b = some_index();
        hold_ratio(a, b);
        hold_ratio(b, a);
        hold_ratio(a, a);
    }
}

static void energy_mean_square_rounds_once(void **state) {
    (void)state;
    for (int i = 0; i < 2 * RANDOM_ROUNDS; i++) {
        real_energy a = some_energy(), b = some_energy();
        quad want = (of_energy(a) * of_energy(a) + of_energy(b) * of_energy(b)) / 2;
        hold("energy_mean_square", of_energy(energy_mean_square(a, b)), want,
             nearest(SCALE_ENERGY, 2, want));
    }
}

static void hold_power(real_energy base, uint16_t exponent) {
    quad want = powq(of_energy(base), exponent);
    quad got = of_energy(energy_power(base, exponent));
    /* In float, what falls below the normal numbers is as good as zero. */
    quad of_floating = (2 * (quad)exponent + 4) * want + (is_fixed() ? 0 : 0x1p-120 / rounding());
    struct bound bound = {SCALE_ENERGY, 1, 0x1p-32 * exponent, 1, of_floating};
    hold("energy_power", got, want, bound);
}

static void energy_power_is_right_from_zero_to_65535(void **state) {
    (void)state;
    const uint16_t exponents[] = {0,  1,  2,   3,   4,   5,   7,    8,     15,    16,
                                  31, 50, 100, 127, 255, 256, 1024, 32767, 32768, 65535};
    for (size_t j = 0; j < COUNT(exponents); j++) {
        for (size_t i = 0; i < COUNT(energy_edges); i++) {
            hold_power(REAL_ENERGY(energy_edges[i]), exponents[j]);
        }
        for (int i = 0; i < 500; i++) {
            hold_power(some_energy(), exponents[j]);
            double near_one = 1 - (1 + random_even()) / (1 + exponents[j]);
            hold_power(REAL_ENERGY(near_one), exponents[j]);
        }
    }
    for (int i = 0; i < RANDOM_ROUNDS / 4; i++) {
        hold_power(some_energy(), (uint16_t)random_bits());
    }
    assert_true(of_energy(energy_power(REAL_ENERGY(0), 0)) == 1);
    assert_true(of_energy(energy_power(REAL_ENERGY(1), 65535)) == 1);
    assert_true(of_energy(energy_power(REAL_ENERGY(0), 65535)) == 0);
}

static void hold_transmission(real_extinction extinction, real_length way) {
    quad x = of_extinction(extinction) * of_length(way);
    quad want = expq(-x);
    /* Past 2^-120 the floating-point formats give up, and __float128 knows e to 106 bits only. */
    quad rest = is_fixed() ? 0 : 0x1p-119 / rounding();
    struct bound bound = {SCALE_ENERGY, 1.1, 0, 1, (10 + 8 * x) * want + rest};
    if (!is_fixed() && rounding() < 0x1p-100) {
        bound.of *= 256;
    }
    hold("energy_transmitted", of_energy(energy_transmitted(extinction, way)), want, bound);
}

static void transmission_falls_exponentially_from_one_to_nothing(void **state) {
    (void)state;
    const double extinctions[] = {0, 0x1p-28, 0x1p-20, 0.001, 0.01, 0.1, 0.5, 0.693147, 1, 7.999};
    for (size_t j = 0; j < COUNT(extinctions); j++) {
        for (size_t i = 0; i < COUNT(length_edges); i++) {
            if (length_edges[i] >= 0) {
                hold_transmission(REAL_EXTINCTION(extinctions[j]), REAL_LENGTH(length_edges[i]));
            }
        }
    }
    for (int i = 0; i < RANDOM_ROUNDS; i++) {
        double extinction = random_within(7.999), way = random_within(2047);
        extinction = extinction < 0 ? -extinction : extinction;
        way = way < 0 ? -way : way;
        hold_transmission(REAL_EXTINCTION(extinction), REAL_LENGTH(way));
        hold_transmission(REAL_EXTINCTION(extinction),
                          REAL_LENGTH(way * extinction > 30 ? 20 / extinction : way));
    }
    assert_true(of_energy(energy_transmitted(REAL_EXTINCTION(0), REAL_LENGTH(2047))) == 1);
    assert_true(of_energy(energy_transmitted(REAL_EXTINCTION(7), REAL_LENGTH(0))) == 1);
    assert_true(of_energy(energy_transmitted(REAL_EXTINCTION(7.9), REAL_LENGTH(2047))) < 0x1p-99);
}

/* ---- Colours --------------------------------------------------------------------------------- */

static void colour_add_is_exact_or_saturates(void **state) {
    (void)state;
    for (int i = 0; i < RANDOM_ROUNDS; i++) {
        real_colour a = some_colour(), b = some_colour();
        quad want = of_colour(a) + of_colour(b);
        want = !is_fixed() && want > 32767.99 ? of_colour((real_colour)32767.99) : want;
        hold("colour_add", of_colour(colour_add(a, b)), want, exact(SCALE_COLOUR, want));
    }
}

static void colour_scaled_rounds_once(void **state) {
    (void)state;
    for (int i = 0; i < 2 * RANDOM_ROUNDS; i++) {
        real_colour a = some_colour();
        real_energy share = some_energy();
        quad want = of_colour(a) * of_energy(share);
        hold("colour_scaled", of_colour(colour_scaled(a, share)), want,
             nearest(SCALE_COLOUR, 1, want));
    }
}

static void colour_lit_by_white_is_itself(void **state) {
    (void)state;
    for (int i = 0; i < 2 * RANDOM_ROUNDS; i++) {
        real_colour a = some_colour(), light = some_colour();
        quad want = of_colour(a) * of_colour(light) / 255;
        struct bound bound = {SCALE_COLOUR, 0.5 + 0x1p-20, 0, 2, want};
        hold("colour_lit", of_colour(colour_lit(a, light)), want, bound);
        hold("colour_lit", of_colour(colour_lit(a, REAL_COLOUR(255))), of_colour(a),
             exact(SCALE_COLOUR, of_colour(a)));
    }
}

static void colour_faded_divides_by_the_scene_files_distance(void **state) {
    (void)state;
    for (int i = 0; i < 4 * RANDOM_ROUNDS; i++) {
        real_colour a = some_colour();
        real_length distance = some_length();
        int exponent = (int)(random_bits() % 61) - 30;
        real_colour faded = colour_faded(a, distance, exponent);
        quad most = is_fixed() ? (quad)INT32_MAX / SCALE_COLOUR : of_colour((real_colour)32767.99);
        if (of_length(distance) <= 0) {
            assert_true(of_colour(faded) == (of_colour(a) > 0 ? most : 0));
            continue;
        }
        quad want = of_colour(a) * scalbnq(1, exponent) / of_length(distance);
        want = want > most ? most : want;
        struct bound bound = {SCALE_COLOUR, 0.5, 0x1p-31, 2, want};
        hold("colour_faded", of_colour(faded), want, bound);
    }
    const double next_to_nothing[] = {0x1p-20, 0x1p-120, 0x1p-1010};
    for (size_t i = 0; i < COUNT(next_to_nothing); i++) {
        real_length distance = REAL_LENGTH(next_to_nothing[i]);
        assert_true(of_colour(colour_faded(REAL_COLOUR(0), distance, 30)) == 0);
    }
}

static void colour_level_rounds_and_clamps(void **state) {
    (void)state;
    for (int level = 0; level <= 255; level++) {
        for (int step = -3; step <= 3; step++) {
            for (double at = level - 0.5; at <= level + 0.5; at += 0.5) {
                real_colour a = REAL_COLOUR(at + step * 0x1p-16);
                quad want = floorq(of_colour(a) + 0.5);
                want = want < 0 ? 0 : want > 255 ? 255 : want;
                assert_true((quad)colour_level(a) == want);
            }
        }
    }
    for (int i = 0; i < RANDOM_ROUNDS; i++) {
        double x = random_within(500.0);
        real_colour a = REAL_COLOUR(x);
        quad want = floorq(of_colour(a) + 0.5);
        want = want < 0 ? 0 : want > 255 ? 255 : want;
        assert_true((quad)colour_level(a) == want);
    }
    assert_int_equal(colour_level(REAL_COLOUR(32767)), 255);
    assert_int_equal(colour_level(REAL_COLOUR(-32767)), 0);
    real_colour most = colour_add(REAL_COLOUR(32767), REAL_COLOUR(32767));
    assert_int_equal(colour_level(most), 255);
    if (!is_fixed()) { /* just below a half, where adding a half would round up */
        assert_int_equal(colour_level((real_colour)(0.5 - 0x1p-25)), 0);
    }
}

/* ---- Across operations ----------------------------------------------------------------------- */

/* A mirrored scene gives a mirrored picture only if no rounding prefers a side. */
static void a_mirrored_argument_gives_the_mirrored_result(void **state) {
    (void)state;
    for (int i = 0; i < RANDOM_ROUNDS; i++) {
        real_length x = some_length(), y = some_length(), z = some_length();
        real_unit u = some_unit(), v = some_unit(), w = some_unit();
        real_index eta = some_index(), bend = some_index();
        real_unit p[3], q[3];
        real_length length;
        real_length nx = length_negate(x), ny = length_negate(y), nz = length_negate(z);
        real_unit nu = unit_negate(u), nv = unit_negate(v), nw = unit_negate(w);
        assert_true(length_along(nx, y, nu) == length_negate(length_along(x, y, u)));
        assert_true(length_dot(nx, ny, nz, u, v, w) == length_negate(length_dot(x, y, z, u, v, w)));
        assert_true(length_scaled(x, nu) == length_negate(length_scaled(x, u)));
        assert_true(length_scaled(nx, nu) == length_scaled(x, u));
        assert_true(unit_dot(nu, nv, nw, v, w, u) == unit_negate(unit_dot(u, v, w, v, w, u)));
        assert_true(unit_mirrored(nu, v, nw) == unit_negate(unit_mirrored(u, v, w)));
        assert_true(unit_bent(nu, eta, bend, nv) == unit_negate(unit_bent(u, eta, bend, v)));
        assert_true(area_scaled(area_product(nx, y), u) + area_scaled(area_product(x, y), u) == 0);
        if (!length_is_zero(y)) {
            real_length quotient = length_quotient(area_norm(x, y, z), y);
            assert_true(length_quotient(area_norm(x, y, z), ny) == length_negate(quotient));
        }
        if (!unit_is_zero(u)) {
            real_length over = length_over(x, slope_of(u));
            assert_true(length_over(nx, slope_of(u)) == length_negate(over));
            assert_true(length_over(x, slope_of(nu)) == length_negate(over));
        }
        if (of_area(area_norm(x, y, z)) > 0) {
            unit_normalise_lengths(x, y, z, &p[0], &p[1], &p[2], &length);
            unit_normalise_lengths(nx, y, nz, &q[0], &q[1], &q[2], &length);
            assert_true(q[0] == -p[0] && q[1] == p[1] && q[2] == -p[2]);
            unit_normalise_wide(wide_sum(REAL_UNIT(1), REAL_UNIT(0)), wide_sum(u, v),
                                wide_sum(v, w), &p[0], &p[1], &p[2]);
            unit_normalise_wide(wide_sum(REAL_UNIT(1), REAL_UNIT(0)), wide_sum(nu, nv),
                                wide_sum(v, w), &q[0], &q[1], &q[2]);
            assert_true(q[0] == p[0] && q[1] == -p[1] && q[2] == p[2]);
        }
    }
}

/* A reflected and a refracted direction of unit length have unit length still. */
static void bent_and_mirrored_directions_keep_their_length(void **state) {
    (void)state;
    quad slack = is_fixed() ? 16 / SCALE_UNIT : 32 * rounding();
    for (int i = 0; i < RANDOM_ROUNDS; i++) {
        real_unit d[3], n[3], out[3], refracted;
        real_length length;
        unit_normalise_lengths(some_length(), some_length(), some_length(), &d[0], &d[1], &d[2],
                               &length);
        unit_normalise_lengths(some_length(), some_length(), some_length(), &n[0], &n[1], &n[2],
                               &length);
        if (unit_is_zero(d[0]) || unit_is_zero(n[0])) {
            continue;
        }
        real_unit c = unit_negate(unit_dot(d[0], d[1], d[2], n[0], n[1], n[2]));
        for (int axis = 0; axis < 3; axis++) {
            out[axis] = unit_mirrored(d[axis], c, n[axis]);
        }
        quad size = 0;
        for (int axis = 0; axis < 3; axis++) {
            size += of_unit(out[axis]) * of_unit(out[axis]);
        }
        if (magnitude(size - 1) > slack) {
            fail_with("the length of a mirrored direction", size, 1, slack);
        }
        double ratio = 0.4 + 0.3 * (1 + random_even());
        real_index eta = REAL_INDEX(ratio);
        if (unit_is_negative(c) || !unit_refracted_cosine(c, eta, &refracted)) {
            continue;
        }
        size = 0;
        for (int axis = 0; axis < 3; axis++) {
            out[axis] = unit_bent(d[axis], eta, index_bend(eta, c, refracted), n[axis]);
            size += of_unit(out[axis]) * of_unit(out[axis]);
        }
        if (magnitude(size - 1) > slack) {
            fail_with("the length of a bent direction", size, 1, slack);
        }
    }
}

int main(int argc, char **argv) {
#define TEST(name) cmocka_unit_test_setup(name, reseed)
    const struct CMUnitTest tests[] = {
        TEST(constants_have_the_same_bits_at_compile_time_and_at_run_time),
        TEST(constants_round_halves_away_from_zero),
        TEST(values_lead_back_to_what_constants_made),
        TEST(constants_past_the_end_saturate),
        TEST(far_lies_above_every_scene_and_within_the_format),
        TEST(length_add_is_exact_or_saturates),
        TEST(length_less_orders_strictly),
        TEST(length_along_rounds_once),
        TEST(length_dot_rounds_once),
        TEST(length_scaled_rounds_once),
        TEST(length_over_divides_and_saturates),
        TEST(length_over_is_exact_for_axes_and_powers_of_two),
        TEST(length_over_never_decreases),
        TEST(a_reciprocal_of_next_to_nothing_gives_no_nan),
        TEST(length_cell_is_odd_floors_on_both_sides_of_zero),
        TEST(area_product_is_exact),
        TEST(area_norm_is_exact_or_saturates),
        TEST(area_sums_are_exact_or_saturate),
        TEST(area_scaled_rounds_once_and_saturates),
        TEST(length_root_rounds_to_nearest),
        TEST(length_root_undoes_a_square),
        TEST(length_quotient_divides_to_one_lsb_and_saturates),
        TEST(unit_signs_and_order_are_those_of_the_numbers),
        TEST(unit_dot_rounds_once),
        TEST(unit_product_rounds_once),
        TEST(unit_add_is_exact_or_saturates),
        TEST(wide_components_are_formed_and_normalised_to_two_lsb),
        TEST(wide_sums_are_normalised_to_two_lsb),
        TEST(axes_stay_axes_when_normalised),
        TEST(normalising_lengths_gives_direction_and_length),
        TEST(unit_mirrored_rounds_once),
        TEST(refraction_obeys_snell_up_to_the_critical_angle),
        TEST(refraction_between_equal_media_keeps_the_cosine),
        TEST(index_bend_rounds_once),
        TEST(unit_bent_rounds_once),
        TEST(index_operations_round_once),
        TEST(energy_product_rounds_once),
        TEST(energy_add_is_exact_or_saturates),
        TEST(energy_complement_is_exact),
        TEST(energy_of_cosine_clamps_to_zero_and_one),
        TEST(energy_ratio_divides_to_one_lsb_and_never_exceeds_one),
        TEST(energy_mean_square_rounds_once),
        TEST(energy_power_is_right_from_zero_to_65535),
        TEST(transmission_falls_exponentially_from_one_to_nothing),
        TEST(colour_add_is_exact_or_saturates),
        TEST(colour_scaled_rounds_once),
        TEST(colour_lit_by_white_is_itself),
        TEST(colour_faded_divides_by_the_scene_files_distance),
        TEST(colour_level_rounds_and_clamps),
        TEST(a_mirrored_argument_gives_the_mirrored_result),
        TEST(bent_and_mirrored_directions_keep_their_length),
    };
    int failed = cmocka_run_group_tests_name("operations of " STRING(REAL_NAME), tests, NULL, NULL);
    if (argc > 1 && strcmp(argv[1], "measured") == 0) {
        printf("%s: the largest error met, in %s\n", STRING(REAL_NAME),
               is_fixed() ? "LSB" : "roundings (relative to the sum of the terms' magnitudes)");
        for (const struct measure *m = measures; m->operation != NULL; m++) {
            printf("  %-24s %8.3f\n", m->operation, (double)m->worst);
        }
    }
    return failed;
}
