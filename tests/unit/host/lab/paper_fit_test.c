/* SPDX-License-Identifier: MIT */
/* The paper's formula fitted to curves whose answer is known beforehand. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "lab/paper/curves.h"
#include "lab/paper/fit.h"

enum { DEPTHS = 17 };

static bool is_near(double a, double b) {
    return fabs(a - b) < 1e-9;
}

/* Where C1 N^C2 + 1 is a power of ten. */
static void the_form(void **state) {
    (void)state;
    assert_true(is_near(paper_form(50, 5, 0), 1));
    assert_true(is_near(paper_form(9, 4, 1), 2));
    assert_true(is_near(paper_form(9, 1, 11), 3));
    assert_true(is_near(paper_form(37, 3, 3), 4));
    assert_true(is_near(paper_form(1, 2, 3), 2));
}

/* Every pair of constants, the corners of the range among them, is found again from its own curve,
 * and from the same curve with errors that are far smaller than the way to the next one. */
static void known_constants_are_found(void **state) {
    (void)state;
    static const int known[][2] = {{1, 1},  {1, 9}, {100, 1}, {100, 9},
                                   {37, 3}, {2, 7}, {99, 2},  {64, 5}};
    for (size_t i = 0; i < sizeof known / sizeof known[0]; i++) {
        for (int noisy = 0; noisy < 2; noisy++) {
            double depths[DEPTHS], values[DEPTHS];
            for (int n = 0; n < DEPTHS; n++) {
                depths[n] = n;
                values[n] =
                    paper_form(known[i][0], known[i][1], n) + noisy * (n % 2 == 0 ? 1e-4 : -1e-4);
            }
            struct paper_fit fit = paper_fit_form(depths, values, DEPTHS);
            assert_int_equal(fit.c1, known[i][0]);
            assert_int_equal(fit.c2, known[i][1]);
            assert_true(noisy ? fit.r_squared > 0.9999 && fit.r_squared < 1
                              : is_near(fit.r_squared, 1));
        }
    }
}

/* Curves of constants beyond the range: the nearest ones within the range are taken. */
static void no_constant_leaves_its_range(void **state) {
    (void)state;
    static const int beyond[][2] = {{50, 14}, {1, 30}, {500, 4}, {2000, 20}};
    for (size_t i = 0; i < sizeof beyond / sizeof beyond[0]; i++) {
        double depths[DEPTHS], values[DEPTHS];
        for (int n = 0; n < DEPTHS; n++) {
            depths[n] = n;
            values[n] = paper_form(beyond[i][0], beyond[i][1], n);
        }
        struct paper_fit fit = paper_fit_form(depths, values, DEPTHS);
        assert_in_range(fit.c1, 1, PAPER_C1_MOST);
        assert_in_range(fit.c2, 1, PAPER_C2_MOST);
        assert_true(beyond[i][0] <= PAPER_C1_MOST || fit.c1 == PAPER_C1_MOST || fit.c2 > 4);
        assert_true(beyond[i][1] <= PAPER_C2_MOST || fit.c2 == PAPER_C2_MOST);
    }
}

/* Values 1 and 100 at N = 0 and 1: the best is C1 = 100, which gives 1 and log10(101) + 1. Their
 * spread around the mean is 2 * 49.5^2. */
static void a_bad_fit_is_told(void **state) {
    (void)state;
    static const double depths[] = {0, 1}, values[] = {1, 100};
    struct paper_fit fit = paper_fit_form(depths, values, 2);
    double error = 99 - log10(101);
    assert_int_equal(fit.c1, 100);
    assert_int_equal(fit.c2, 1); /* at N = 1 all are the same: the first */
    assert_true(is_near(fit.r_squared, 1 - error * error / 4900.5));
}

static void a_level_curve_explains_nothing(void **state) {
    (void)state;
    static const double depths[] = {0, 1, 2}, values[] = {3, 3, 3};
    assert_true(paper_fit_form(depths, values, 3).r_squared == 0);
}

/* A curve of rays that is the form itself, times 1000, and one of tests whose log10 is. */
static void both_readings(void **state) {
    (void)state;
    struct paper_curve curve;
    for (int n = 0; n < PAPER_DEPTHS; n++) {
        curve.rays[n] = 1000 * paper_form(12, 2, n);
        curve.tests[n] = 7 * (3 * pow(n, 4) + 1);
    }
    struct paper_fit ratio = paper_fit_curve(&curve, PAPER_RAYS, PAPER_READING_RATIO);
    struct paper_fit log = paper_fit_curve(&curve, PAPER_TESTS, PAPER_READING_LOG);
    assert_int_equal(ratio.c1, 12);
    assert_int_equal(ratio.c2, 2);
    assert_true(is_near(ratio.r_squared, 1));
    assert_int_equal(log.c1, 3);
    assert_int_equal(log.c2, 4);
    assert_true(is_near(log.r_squared, 1));
    assert_true(paper_fit_curve(&curve, PAPER_RAYS, PAPER_READING_LOG).r_squared < 0.99);
    assert_true(paper_fit_curve(&curve, PAPER_TESTS, PAPER_READING_RATIO).r_squared < 0.5);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_form),
        cmocka_unit_test(known_constants_are_found),
        cmocka_unit_test(no_constant_leaves_its_range),
        cmocka_unit_test(a_bad_fit_is_told),
        cmocka_unit_test(a_level_curve_explains_nothing),
        cmocka_unit_test(both_readings),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
