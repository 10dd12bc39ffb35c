/* SPDX-License-Identifier: MIT */
/* Holds the operations on directions, cosines and indices of refraction against their definitions
 * in __float128. */
#include "reference.h"

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

static void a_null_vector_has_the_direction_null(void **state) {
    (void)state;
    real_unit zero = REAL_UNIT(0), one = REAL_UNIT(1), minus = REAL_UNIT(-1), got[3];
    unit_normalise_wide(wide_sum(one, minus), wide_sum(zero, zero), wide_sum(minus, one), &got[0],
                        &got[1], &got[2]);
    assert_true(of_unit(got[0]) == 0 && of_unit(got[1]) == 0 && of_unit(got[2]) == 0);
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
    const struct CMUnitTest tests[] = {
        TEST(unit_signs_and_order_are_those_of_the_numbers),
        TEST(unit_dot_rounds_once),
        TEST(unit_product_rounds_once),
        TEST(unit_add_is_exact_or_saturates),
        TEST(wide_components_are_formed_and_normalised_to_two_lsb),
        TEST(wide_sums_are_normalised_to_two_lsb),
        TEST(a_null_vector_has_the_direction_null),
        TEST(axes_stay_axes_when_normalised),
        TEST(normalising_lengths_gives_direction_and_length),
        TEST(unit_mirrored_rounds_once),
        TEST(refraction_obeys_snell_up_to_the_critical_angle),
        TEST(refraction_between_equal_media_keeps_the_cosine),
        TEST(index_bend_rounds_once),
        TEST(unit_bent_rounds_once),
        TEST(index_operations_round_once),
        TEST(a_mirrored_argument_gives_the_mirrored_result),
        TEST(bent_and_mirrored_directions_keep_their_length),
    };
    int failed = cmocka_run_group_tests_name(
        "directions, cosines and indices of refraction, " STRING(REAL_NAME), tests, NULL, NULL);
    report_measures(argc, argv);
    return failed;
}
