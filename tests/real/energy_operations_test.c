/* SPDX-License-Identifier: MIT */
/* Holds the operations on energies and colours against their definitions in __float128. */
#include "reference.h"

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

int main(int argc, char **argv) {
    const struct CMUnitTest tests[] = {
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
    };
    int failed =
        cmocka_run_group_tests_name("energies and colours, " STRING(REAL_NAME), tests, NULL, NULL);
    report_measures(argc, argv);
    return failed;
}
