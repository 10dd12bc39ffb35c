/* SPDX-License-Identifier: MIT */
/* The picture viewer: where the pixels land, what it refuses, and that it finds the board. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <superframe/testing.h>

#include "viewer.h"

/* Two lines of three pixels. */
static const uint8_t small[18] = {0xFF, 0,    0,    0, 0xFF, 0,    0, 0, 0xFF,
                                  0x12, 0x34, 0x56, 0, 0,    0x01, 9, 8, 7};

static int power_on(void **state) {
    struct board_desc desc = board_default_desc(BOARD_1987);
    desc.noise = true; /* a real board's memory is not black */
    desc.noise_seed = 4;
    *state = superframe_kit_new_desc(&desc);
    return *state != NULL ? 0 : -1;
}

static int power_off(void **state) {
    superframe_kit_free(*state);
    return 0;
}

static void a_small_picture_is_in_the_middle_of_black(void **state) {
    const struct superframe_rectangle middle = {318, 199, 3, 2};
    const struct superframe_rectangle above = {0, 0, 640, 199}, below = {0, 201, 640, 199};
    const struct superframe_rectangle left = {0, 199, 318, 2}, right = {321, 199, 319, 2};
    assert_true(show_picture(small, 3, 2));
    superframe_assert_region(*state, middle, small, 0);
    superframe_assert_region_colour(*state, above, 0x000000);
    superframe_assert_region_colour(*state, below, 0x000000);
    superframe_assert_region_colour(*state, left, 0x000000);
    superframe_assert_region_colour(*state, right, 0x000000);
}

static void the_screen_is_switched_on_when_the_picture_is_there(void **state) {
    assert_true(show_picture(small, 3, 2));
    superframe_assert_writes(*state, "...\n"
                                     "out8 00DE 00\n"
                                     "...\n"
                                     "out16 00D4 027F\n"
                                     "out8 00D8 00\n"
                                     "out8 00DA 00\n"
                                     "out8 00DC 00\n"
                                     "out8 00DE 01\n");
}

static void what_does_not_fit_is_refused_and_nothing_written(void **state) {
    assert_false(show_picture(small, 641, 1));
    assert_false(show_picture(small, 1, 401));
    assert_false(show_picture(small, 0, 1));
    assert_false(show_picture(small, 1, 0));
    superframe_assert_writes(*state, "");
}

static void the_board_is_found_and_left_as_it_was(void **state) {
    struct superframe_kit *kit = *state;
    const struct superframe_rectangle whole = {0, 0, 640, 400};
    static uint8_t before[640 * 400 * 3];
    for (size_t i = 0; i < sizeof before; i++) {
        before[i] = kit->board.memory[i];
    }
    assert_true(board_is_present());
    superframe_assert_region(kit, whole, before, 0);
    superframe_kit_free(kit);
    *state = NULL;
    assert_false(board_is_present()); /* nothing is bound any more */
}

static void it_relies_on_nothing_that_is_only_inferred(void **state) {
    assert_true(board_is_present());
    assert_true(show_picture(small, 3, 2));
    superframe_assert_strict(*state, GRADE_INFERRED);
}

#define TEST(function) cmocka_unit_test_setup_teardown(function, power_on, power_off)

int main(void) {
    const struct CMUnitTest tests[] = {
        TEST(a_small_picture_is_in_the_middle_of_black),
        TEST(the_screen_is_switched_on_when_the_picture_is_there),
        TEST(what_does_not_fit_is_refused_and_nothing_written),
        TEST(the_board_is_found_and_left_as_it_was),
        TEST(it_relies_on_nothing_that_is_only_inferred),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
