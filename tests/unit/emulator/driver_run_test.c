/* SPDX-License-Identifier: MIT */
/* The run of the two picture loaders of 1991-93 (docs/board.md, grade D) as literal port accesses.
 */
#include "board_fixture.h"

#include "picture.h"

/* Control 1 is read, written with bits 0 and 7 set, and read again. Equal: the other family. */
static bool family_test_finds_this_family(void) {
    outp(0x00EE, 0xC0); /* the other family's bank register, twice */
    outp(0x00EE, 0xC0);
    uint16_t first = inpw(0x00D0);
    uint16_t written = (uint16_t)(first | 0x0081);
    outpw(0x00D0, written);
    return inpw(0x00D0) != written;
}

static bool presence_test_finds_a_board(void) {
    outpw(0x00D4, 0x0000);
    outpw(0x00D6, 0x0000);
    uint8_t before = inp(0x00D8);
    outp(0x00D8, 0xAA);
    bool is_there = inp(0x00D8) == 0xAA;
    outp(0x00D8, before);
    return is_there;
}

static void clear(void) {
    for (unsigned y = 0; y < 400; y++) {
        outpw(0x00D6, (uint16_t)y);
        for (unsigned x = 0; x < 640; x += 4) {
            outpw(0x00D4, (uint16_t)x);
            outpw(0x00D8, 0x0000);
        }
    }
}

/* All of it up to the picture. */
static void run_up_to_the_picture(void) {
    assert_true(family_test_finds_this_family());
    initialise();
    assert_true(presence_test_finds_a_board());
    outpw(0x00DE, 0x0001);
    clear();
}

static void on_the_later_board_it_clears_the_screen_without_a_violation(void **state) {
    static uint8_t rgb[PICTURE_BYTES];
    (void)state;
    power_on_noise(BOARD_LATER, 1991);
    run_up_to_the_picture();
    assert_int_equal(board_violations(&board), 0);
    assert_int_equal(picture_draw(&board, NULL, rgb), PICTURE_OK);
    for (size_t i = 0; i < PICTURE_BYTES; i++) {
        assert_int_equal(rgb[i], 0);
    }

    put_pixel(639, 399, 0x12FE56);
    assert_int_equal(get_here(), 0x12FE56);
    picture_draw(&board, NULL, rgb);
    assert_int_equal(rgb[PICTURE_BYTES - 3], 0x12);
    assert_int_equal(rgb[PICTURE_BYTES - 2], 0xFE);
    assert_int_equal(rgb[PICTURE_BYTES - 1], 0x56);
    outp(0x00DE, 0x00);
    assert_int_equal(board_violations(&board), 0);
}

static void
on_the_1987_board_the_family_test_and_the_fill_are_reported_and_nothing_else(void **state) {
    static uint8_t rgb[PICTURE_BYTES];
    (void)state;
    power_on_noise(BOARD_1987, 1991);
    run_up_to_the_picture();
    assert_int_equal(board.notes[BOARD_CONTROL1_READ].count, 2);
    assert_int_equal(board.notes[BOARD_CONTROL1_READ].first, 3);
    assert_int_equal(board.notes[BOARD_RED_WORD_WRITE].count, 64000);
    assert_int_equal(board_violations(&board), 2 + 64000);

    put_pixel(639, 399, 0x12FE56);
    assert_int_equal(get_here(), 0x12FE56);
    assert_int_equal(picture_draw(&board, NULL, rgb), PICTURE_OK);
    assert_int_equal(rgb[PICTURE_BYTES - 3], 0x12);
    assert_int_equal(rgb[PICTURE_BYTES - 2], 0xFE);
    assert_int_equal(rgb[PICTURE_BYTES - 1], 0x56);
    assert_int_equal(board_violations(&board), 2 + 64000);
}

/* A complete run of one of the loaders was seen to make 1,152,844 accesses. */
static void a_whole_picture_needs_as_many_accesses_as_were_seen(void **state) {
    (void)state;
    power_on(BOARD_LATER);
    run_up_to_the_picture();
    for (unsigned y = 0; y < 400; y++) {
        outpw(0x00D6, (uint16_t)y);
        for (unsigned x = 0; x < 640; x++) {
            outpw(0x00D4, (uint16_t)x);
            outp(0x00D8, (uint8_t)x);
            outp(0x00DA, (uint8_t)y);
            outp(0x00DC, (uint8_t)(x + y));
        }
    }
    outpw(0x00DE, 0x0000);
    assert_int_equal(board.accesses, 1152844);
    assert_int_equal(board_violations(&board), 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(on_the_later_board_it_clears_the_screen_without_a_violation),
        cmocka_unit_test(
            on_the_1987_board_the_family_test_and_the_fill_are_reported_and_nothing_else),
        cmocka_unit_test(a_whole_picture_needs_as_many_accesses_as_were_seen),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
