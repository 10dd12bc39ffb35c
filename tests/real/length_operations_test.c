/* SPDX-License-Identifier: MIT */
/* Holds the operations on constants, lengths and areas against their definitions in __float128. */
#include "reference.h"

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
    if (!is_fixed() && magnitude(of_unit(u)) < 0x1p-90) {
        /* Where the slope itself is bounded, all that matters is that it is far, and on its side.
         */
        assert_true(of_length(a) == 0 || magnitude(got) >= 2047 || magnitude(want) < 2047);
        assert_true(got == 0 || (got > 0) == (want > 0));
        return;
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

int main(int argc, char **argv) {
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
    };
    int failed = cmocka_run_group_tests_name("constants, lengths and areas, " STRING(REAL_NAME),
                                             tests, NULL, NULL);
    report_measures(argc, argv);
    return failed;
}
