/* SPDX-License-Identifier: MIT */
/* The measures of host/picture/compare.h against values worked out by hand. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "picture/compare.h"

static void assert_close(double actual, double expected) {
    assert_true(fabs(actual - expected) <= 1e-12 * (1 + fabs(expected)));
}

/* Four pixels: equal; 1 off in one channel; 3 and 4 off the other way; white against black. */
static const uint8_t left[] = {10, 20, 30, 10, 20, 30, 100, 104, 7, 255, 255, 255};
static const uint8_t right[] = {10, 20, 30, 10, 21, 30, 103, 100, 7, 0, 0, 0};

static void measures_of_four_pixels(void **state) {
    (void)state;
    struct comparison comparison;
    compare_pictures(left, right, 4, &comparison);
    assert_int_equal(comparison.pixels, 4);
    assert_int_equal(comparison_largest(&comparison), 255);
    /* 1 + 9 + 16 + 3 * 65025 = 195101, over 12 values */
    assert_int_equal(comparison.square_sum, 195101);
    assert_close(comparison_rmse(&comparison), 127.50849644892949);
    assert_close(comparison_psnr(&comparison), 6.020021115170761);
    assert_int_equal(comparison_within(&comparison, 0), 1);
    assert_int_equal(comparison_within(&comparison, 1), 2);
    assert_int_equal(comparison_within(&comparison, 3), 2);
    assert_int_equal(comparison_within(&comparison, 4), 3);
    assert_int_equal(comparison_within(&comparison, 254), 3);
    assert_int_equal(comparison_within(&comparison, 255), 4);
    assert_close(comparison_share(&comparison, 1), 50);
}

static void a_measure_is_symmetric(void **state) {
    (void)state;
    struct comparison there, back;
    compare_pictures(left, right, 4, &there);
    compare_pictures(right, left, 4, &back);
    assert_memory_equal(&there, &back, sizeof there);
}

static void equal_pictures(void **state) {
    (void)state;
    struct comparison comparison;
    compare_pictures(left, left, 4, &comparison);
    assert_int_equal(comparison_largest(&comparison), 0);
    assert_true(comparison_rmse(&comparison) == 0);
    assert_true(isinf(comparison_psnr(&comparison)));
    assert_true(comparison_share(&comparison, 0) == 100);
    assert_true(comparison_holds(&comparison, 0, 100));
}

static void one_step_everywhere_is_48_13_decibels(void **state) {
    (void)state;
    uint8_t a[300], b[300];
    memset(a, 100, sizeof a);
    memset(b, 101, sizeof b);
    struct comparison comparison;
    compare_pictures(a, b, 100, &comparison);
    assert_close(comparison_rmse(&comparison), 1);
    assert_close(comparison_psnr(&comparison), 48.1308036086791); /* 20 log10 255 */
}

static void no_pixels_are_equal_pixels(void **state) {
    (void)state;
    struct comparison comparison;
    compare_pictures(left, right, 0, &comparison);
    assert_int_equal(comparison_largest(&comparison), 0);
    assert_true(comparison_rmse(&comparison) == 0);
    assert_true(comparison_share(&comparison, 0) == 100);
    assert_true(comparison_holds(&comparison, 0, 100));
}

/* 1000 pixels of which `wrong` are 2 off. */
static void compare_a_thousand(unsigned wrong, struct comparison *comparison) {
    static uint8_t a[3000], b[3000];
    memset(a, 50, sizeof a);
    memset(b, 50, sizeof b);
    for (unsigned i = 0; i < wrong; i++) {
        b[3 * i + 2] = 52;
    }
    compare_pictures(a, b, 1000, comparison);
}

static void the_share_is_met_to_the_pixel(void **state) {
    (void)state;
    struct comparison comparison;
    compare_a_thousand(1, &comparison);
    assert_true(comparison_holds(&comparison, 1, 99.9)); /* 999 of 1000 */
    assert_false(comparison_holds(&comparison, 1, 99.91));
    assert_false(comparison_holds(&comparison, 1, 100));
    assert_true(comparison_holds(&comparison, 2, 100));
    compare_a_thousand(2, &comparison);
    assert_false(comparison_holds(&comparison, 1, 99.9));
    assert_true(comparison_holds(&comparison, 1, 99.8));
    compare_a_thousand(1000, &comparison);
    assert_true(comparison_holds(&comparison, 1, 0));
    assert_false(comparison_holds(&comparison, 1, 0.1));
    /* Every tenth of a per cent, against whole numbers. */
    for (unsigned wrong = 0; wrong <= 1000; wrong++) {
        compare_a_thousand(wrong, &comparison);
        assert_true(comparison_holds(&comparison, 1, (1000 - wrong) / 10.0));
        assert_int_equal(comparison_holds(&comparison, 1, (1000 - wrong + 1) / 10.0), 0);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(measures_of_four_pixels),
        cmocka_unit_test(a_measure_is_symmetric),
        cmocka_unit_test(equal_pictures),
        cmocka_unit_test(one_step_everywhere_is_48_13_decibels),
        cmocka_unit_test(no_pixels_are_equal_pixels),
        cmocka_unit_test(the_share_is_met_to_the_pixel),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
