/* SPDX-License-Identifier: MIT */
/* The arithmetic q16: results are whole multiples of 2^-16, rounded as integers are. */
#include "real/lab/q16/real.h"

#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>

#include <cmocka.h>

static void assert_steps(double value, double steps) {
    assert_true(fabs(value * 65536 - steps) < 1e-9);
}

static void results_are_rounded_to_nearest(void **state) {
    (void)state;
    const real_unit third = REAL_UNIT(1.0 / 3); /* 21845 */
    assert_steps(third, 21845);
    assert_steps(REAL_UNIT(-1.0 / 3), -21845);
    assert_steps(unit_product(third, third), 7282); /* 21845^2 / 65536 = 7281.55 */
    assert_steps(unit_product(unit_negate(third), third), -7282);
    assert_steps(length_over(REAL_LENGTH(1.0), slope_of(third)), 196611);
    assert_steps(length_root(REAL_AREA(2.0)), 92682); /* 92681.9 */
    assert_steps(energy_power(REAL_ENERGY(0.5), 16), 1);
    assert_steps(energy_power(REAL_ENERGY(0.5), 20), 0);
}

static void one_rounding_for_a_dot_product(void **state) {
    (void)state;
    const real_unit least = REAL_UNIT(1.0 / 65536), half = REAL_UNIT(0.5);
    /* Three halves of a step: two after one rounding, three after three. */
    assert_steps(unit_dot(least, least, least, half, half, half), 2);
}

static void what_does_not_fit_saturates(void **state) {
    (void)state;
    const real_length far = REAL_LENGTH(30000.0);
    assert_true(length_add(far, far) > 32767.9 && length_add(far, far) < 32768);
    assert_true(length_subtract(length_negate(far), far) < -32767.9);
    assert_true(area_product(REAL_LENGTH(400.0), REAL_LENGTH(400.0)) > 159999);
}

static void a_vector_of_length_one_has_its_rounding(void **state) {
    (void)state;
    real_unit u, v, w;
    real_length length;
    unit_normalise_lengths(REAL_LENGTH(1.0), REAL_LENGTH(2.0), REAL_LENGTH(2.0), &u, &v, &w,
                           &length);
    assert_steps(u, 21845);
    assert_steps(v, 43691);
    assert_steps(w, 43691);
    assert_steps(length, 3 * 65536);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(results_are_rounded_to_nearest),
        cmocka_unit_test(one_rounding_for_a_dot_product),
        cmocka_unit_test(what_does_not_fit_saturates),
        cmocka_unit_test(a_vector_of_length_one_has_its_rounding),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
