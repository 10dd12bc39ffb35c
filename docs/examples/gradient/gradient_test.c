/* SPDX-License-Identifier: MIT */
/* The gradient: what it writes, what then shows, and that a 1987 board is known to do all of it. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <superframe/testing.h>

#include "gradient.h"

static int power_on(void **state) {
    *state = superframe_kit_new(BOARD_1987);
    return *state != NULL ? 0 : -1;
}

static int power_off(void **state) {
    superframe_kit_free(*state);
    return 0;
}

static void the_first_and_the_last_pixel_are_written_in_order(void **state) {
    draw_gradient();
    superframe_assert_writes(*state, "out8 00D0 00\n" /* the controller's first register */
                                     "out8 00D2 6B\n"
                                     "...\n"
                                     "out8 00DE 01\n"
                                     "out16 00D6 0000\n" /* the first line */
                                     "out16 00D4 0000\n"
                                     "out8 00D8 00\n"
                                     "out8 00DA 00\n"
                                     "out8 00DC 80\n"
                                     "...\n"
                                     "out16 00D4 027F\n" /* X = 639 */
                                     "out8 00D8 FF\n"
                                     "out8 00DA FF\n"
                                     "out8 00DC 80\n");
}

static void the_corners_have_the_ends_of_the_gradient(void **state) {
    draw_gradient();
    superframe_assert_pixel(*state, 0, 0, 0x000080);
    superframe_assert_pixel(*state, 639, 0, 0xFF0080);
    superframe_assert_pixel(*state, 0, 399, 0x00FF80);
    superframe_assert_pixel(*state, 639, 399, 0xFFFF80);
    superframe_assert_pixel(*state, 320, 200, 0x7F7F80);
}

static void it_relies_on_nothing_that_is_only_inferred(void **state) {
    draw_gradient();
    superframe_assert_no_violation(*state);
    superframe_assert_strict(*state, GRADE_INFERRED);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(the_first_and_the_last_pixel_are_written_in_order, power_on,
                                        power_off),
        cmocka_unit_test_setup_teardown(the_corners_have_the_ends_of_the_gradient, power_on,
                                        power_off),
        cmocka_unit_test_setup_teardown(it_relies_on_nothing_that_is_only_inferred, power_on,
                                        power_off),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
