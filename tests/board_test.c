/* SPDX-License-Identifier: MIT */
/* The board's registers, spoken to through ports with literal numbers (FACTS and Table 2). */
#include "board_fixture.h"

static uint64_t count_of(enum board_behaviour behaviour) {
    return board.notes[behaviour].count;
}

/* ---- Pixels --------------------------------------------------------------------------------- */

static void a_primary_lands_at_once_and_by_itself(void **state) {
    (void)state;
    power_on(BOARD_1987);
    go_to(5, 7);
    outp(0x00D8, 0x11);
    assert_int_equal(get_here(), 0x110000);
    outp(0x00DC, 0x33);
    assert_int_equal(get_here(), 0x110033);
    outp(0x00DA, 0x22);
    assert_int_equal(get_here(), 0x112233);
    assert_int_equal(get_pixel(6, 7), 0x000000);
    assert_int_equal(get_pixel(5, 8), 0x000000);
    assert_int_equal(board_violations(&board), 0);
}

static void the_four_corners_hold_pixels_of_their_own(void **state) {
    (void)state;
    power_on(BOARD_1987);
    put_pixel(0, 0, 0x010203);
    put_pixel(639, 0, 0x111213);
    put_pixel(0, 399, 0x212223);
    put_pixel(639, 399, 0x313233);
    assert_int_equal(get_pixel(0, 0), 0x010203);
    assert_int_equal(get_pixel(639, 0), 0x111213);
    assert_int_equal(get_pixel(0, 399), 0x212223);
    assert_int_equal(get_pixel(639, 399), 0x313233);
    assert_int_equal(board_violations(&board), 0);
}

static void x_and_y_keep_their_values_over_pixel_accesses(void **state) {
    (void)state;
    power_on(BOARD_1987);
    put_pixel(100, 50, 0xABCDEF);
    outpw(0x00D4, 101); /* Y stays 50 */
    outp(0x00D8, 0x77);
    outpw(0x00D6, 51); /* X stays 101 */
    outp(0x00D8, 0x88);
    assert_int_equal(get_pixel(101, 50), 0x770000);
    assert_int_equal(get_pixel(101, 51), 0x880000);
}

static void the_upper_bits_of_x_and_y_are_dont_care(void **state) {
    (void)state;
    power_on(BOARD_1987);
    put_pixel(0x0123, 0x0145, 0x654321);
    outpw(0x00D4, 0xFD23); /* bits 9-8: 01 */
    outpw(0x00D6, 0xFF45); /* bit 8: 1 */
    assert_int_equal(get_here(), 0x654321);
    assert_int_equal(board_violations(&board), 0);
}

static void a_byte_to_x_or_y_replaces_the_low_byte_only(void **state) {
    (void)state;
    power_on(BOARD_1987);
    put_pixel(0x0210, 0x0120, 0x102030);
    go_to(0x02FF, 0x01FF);
    outp(0x00D4, 0x10);
    outp(0x00D6, 0x20);
    assert_int_equal(get_here(), 0x102030);
    assert_int_equal(board_violations(&board), 0);
    assert_int_equal(board_reliances(&board, GRADE_INFERRED), 2);
}

static void a_byte_to_the_odd_port_of_x_or_y_is_taken_and_reported(void **state) {
    (void)state;
    power_on(BOARD_1987);
    put_pixel(0x0210, 0x0120, 0x102030);
    go_to(0x0010, 0x0020);
    outp(0x00D5, 0xFE); /* bits 9-8: 10 */
    outp(0x00D7, 0x01);
    assert_int_equal(get_here(), 0x102030);
    assert_int_equal(board_violations(&board), 2);
    assert_int_equal(count_of(BOARD_POSITION_HIGH_WRITE), 2);
}

/* Every pixel has its own three bytes: written in one order, read back in another. */
static void all_256000_pixels_are_independent(void **state) {
    (void)state;
    power_on(BOARD_1987);
    for (unsigned y = 0; y < 400; y++) {
        for (unsigned x = 0; x < 640; x++) {
            put_pixel(x, y, (y * 640 + x) * 61);
        }
    }
    for (unsigned x = 640; x-- > 0;) {
        for (unsigned y = 400; y-- > 0;) {
            if (get_pixel(x, y) != (((y * 640 + x) * 61) & 0xFFFFFF)) {
                fail_msg("the pixel at %u, %u is wrong", x, y);
            }
        }
    }
    assert_int_equal(board_violations(&board), 0);
}

static void a_word_write_of_green_or_blue_counts_as_its_low_byte_and_is_reported(void **state) {
    (void)state;
    for (int profile = 0; profile < 2; profile++) {
        power_on((enum board_profile)profile);
        put_pixel(4, 4, 0x010101);
        outpw(0x00DA, 0x9922);
        outpw(0x00DC, 0x9933);
        assert_int_equal(get_here(), 0x012233);
        assert_int_equal(get_pixel(5, 4), 0x000000);
        assert_int_equal(board_violations(&board), 2);
    }
}

static void the_high_byte_of_a_primary_reads_ff_and_is_reported(void **state) {
    (void)state;
    power_on(BOARD_1987);
    put_pixel(4, 4, 0x112233);
    assert_int_equal(inpw(0x00D8), 0xFF11);
    assert_int_equal(inpw(0x00DA), 0xFF22);
    assert_int_equal(inpw(0x00DC), 0xFF33);
    assert_int_equal(inp(0x00D9), 0xFF);
    assert_int_equal(count_of(BOARD_PRIMARY_WORD_READ), 3);
    assert_int_equal(count_of(BOARD_ODD_READ), 1);
    assert_int_equal(board_violations(&board), 4);
}

/* ---- Outside -------------------------------------------------------------------------------- */

static void outside_writes_are_ignored_reads_give_ff_and_both_are_reported(void **state) {
    static const struct {
        uint16_t x, y;
        bool is_outside[2]; /* 1987, later */
    } places[] = {{639, 399, {false, false}}, {640, 0, {true, true}},   {640, 399, {true, true}},
                  {1023, 0, {true, true}},    {0, 400, {true, false}},  {383, 407, {true, false}},
                  {384, 400, {true, true}},   {0, 408, {true, true}},   {383, 408, {true, true}},
                  {0, 511, {true, true}},     {1023, 511, {true, true}}};
    (void)state;
    for (int profile = 0; profile < 2; profile++) {
        for (size_t i = 0; i < sizeof places / sizeof places[0]; i++) {
            power_on((enum board_profile)profile);
            go_to(places[i].x, places[i].y);
            assert_int_equal(board_violations(&board), 0); /* naming it is allowed */
            outp(0x00D8, 0x5A);
            bool is_outside = places[i].is_outside[profile];
            assert_int_equal(inp(0x00D8), is_outside ? 0xFF : 0x5A);
            assert_int_equal(board_violations(&board), is_outside ? 2 : 0);
            assert_int_equal(count_of(BOARD_OUTSIDE_WRITE), is_outside ? 1 : 0);
            assert_int_equal(count_of(BOARD_OUTSIDE_READ), is_outside ? 1 : 0);
        }
    }
}

static void nothing_written_outside_shows_anywhere(void **state) {
    (void)state;
    power_on(BOARD_LATER);
    for (unsigned x = 0; x < 1024; x++) {
        for (unsigned y = x < 640 ? 408 : 0; y < 512; y += 7) {
            put_pixel(x, y, 0xFFFFFF);
        }
    }
    for (unsigned y = 0; y < 408; y++) {
        for (unsigned x = 0; x < (y < 400 ? 640U : 384U); x++) {
            if (get_pixel(x, y) != 0) {
                fail_msg("the pixel at %u, %u was written", x, y);
            }
        }
    }
}

static void with_the_wrapping_board_x_640_is_x_0_of_the_same_line_and_is_reported(void **state) {
    (void)state;
    struct board_desc desc = board_default_desc(BOARD_LATER);
    desc.outside = BOARD_OUTSIDE_WRAPS;
    power_on_desc(&desc);
    put_pixel(640 + 13, 21, 0x445566);
    assert_int_equal(board_violations(&board), 3);
    assert_int_equal(get_pixel(13, 21), 0x445566);
    assert_int_equal(get_pixel(13, 22), 0x000000);
    assert_int_equal(board_violations(&board), 3);
}

static void the_hidden_blocks_belong_to_the_later_board_only(void **state) {
    (void)state;
    power_on(BOARD_LATER);
    put_pixel(132, 403, 0x123456);
    put_pixel(135, 403, 0x654321);
    assert_int_equal(get_pixel(132, 403), 0x123456);
    assert_int_equal(get_pixel(135, 403), 0x654321);
    assert_int_equal(board_violations(&board), 0);
    assert_int_equal(count_of(BOARD_HIDDEN_ACCESS), 12);
}

/* ---- The fill ------------------------------------------------------------------------------- */

static void a_word_zero_to_red_clears_four_pixels_of_the_later_board(void **state) {
    (void)state;
    power_on(BOARD_LATER);
    for (unsigned x = 0; x < 12; x++) {
        put_pixel(x, 9, 0xA0A0A0 + x);
    }
    go_to(4, 9);
    outpw(0x00D8, 0x0000);
    for (unsigned x = 0; x < 12; x++) {
        assert_int_equal(get_pixel(x, 9), x / 4 == 1 ? 0 : 0xA0A0A0 + x);
    }
    assert_int_equal(board_violations(&board), 0);
    assert_int_equal(count_of(BOARD_RED_WORD_WRITE), 1);
}

static void a_fill_that_nobody_has_seen_rounds_x_down_and_is_reported(void **state) {
    (void)state;
    power_on(BOARD_LATER);
    go_to(638, 9);
    outpw(0x00D8, 0x7742);
    assert_int_equal(get_pixel(635, 9), 0);
    for (unsigned x = 636; x < 640; x++) {
        assert_int_equal(get_pixel(x, 9), 0x424242);
    }
    assert_int_equal(get_pixel(0, 10), 0);
    assert_int_equal(board_violations(&board), 1);
    go_to(8, 9);
    outpw(0x00D8, 0x0001); /* X is right, the value is not */
    go_to(9, 9);
    outpw(0x00D8, 0x0000); /* the other way round */
    go_to(640, 9);
    outpw(0x00D8, 0x0000); /* outside */
    assert_int_equal(count_of(BOARD_FILL_UNSEEN), 3);
    assert_int_equal(count_of(BOARD_OUTSIDE_WRITE), 1);
    assert_int_equal(board_violations(&board), 4);
}

static void in_1987_a_word_to_red_is_a_byte_and_reported(void **state) {
    (void)state;
    power_on(BOARD_1987);
    put_pixel(4, 9, 0x111111);
    outpw(0x00D8, 0x5500);
    assert_int_equal(get_here(), 0x001111);
    assert_int_equal(get_pixel(5, 9), 0x000000);
    assert_int_equal(board_violations(&board), 1);
}

/* ---- Control 1, control 2 and mode ---------------------------------------------------------- */

static void control_2_holds_a_value_for_each_index(void **state) {
    (void)state;
    power_on(BOARD_1987);
    outp(0x00D0, 0x01);
    outp(0x00D2, 0x50);
    outp(0x00D0, 0x09);
    outp(0x00D2, 0x0F);
    assert_int_equal(inp(0x00D2), 0x0F);
    outpw(0x00D0, 0xAA01); /* the high byte is "don't care" */
    assert_int_equal(inp(0x00D2), 0x50);
    assert_int_equal(inpw(0x00D2), 0xFF50);
    outpw(0x00D2, 0xBB51);
    assert_int_equal(inp(0x00D2), 0x51);
    assert_int_equal(board_violations(&board), 0);
}

static void data_for_an_unknown_index_is_stored_and_reported(void **state) {
    static const struct {
        uint8_t index;
        unsigned violations[2]; /* 1987, later */
    } cases[] = {{0x00, {0, 0}}, {0x08, {0, 0}}, {0x0A, {1, 1}}, {0x0B, {1, 1}}, {0x0E, {1, 1}},
                 {0x13, {1, 1}}, {0x14, {1, 1}}, {0x1B, {0, 0}}, {0x1E, {0, 0}}, {0x1D, {1, 1}},
                 {0x20, {1, 1}}, {0x81, {1, 1}}, {0xFF, {1, 1}}, {0x0C, {1, 0}}, {0x0D, {1, 0}}};
    (void)state;
    for (int profile = 0; profile < 2; profile++) {
        for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
            power_on((enum board_profile)profile);
            outp(0x00D0, cases[i].index);
            assert_int_equal(board_violations(&board), 0);
            outp(0x00D2, 0x5A);
            assert_int_equal(board_violations(&board), cases[i].violations[profile]);
            assert_int_equal(inp(0x00D2), 0x5A);
        }
    }
}

static void data_never_written_reads_0_and_is_reported(void **state) {
    (void)state;
    power_on(BOARD_1987);
    outp(0x00D0, 0x06);
    assert_int_equal(inp(0x00D2), 0x00);
    assert_int_equal(count_of(BOARD_UNWRITTEN_READ), 1);
    assert_int_equal(board_violations(&board), 1);
}

static void the_status_of_the_later_board_blanks_and_shows_in_turn(void **state) {
    (void)state;
    unsigned blank = 0;
    unsigned changes = 0;
    uint8_t before = 0;
    power_on(BOARD_LATER);
    outp(0x00D0, 0x1F);
    for (unsigned i = 0; i < 2 * 44326; i++) {
        uint8_t status = inp(0x00D2);
        assert_int_equal(status & 0xFD, 0);
        blank += status >> 1;
        changes += status != before ? 1 : 0;
        before = status;
    }
    assert_in_range(blank, 2 * 44326 / 11 - 2, 2 * 44326 / 11 + 2);
    assert_in_range(changes, 3, 4);
    assert_int_equal(board_violations(&board), 0);
}

static void in_1987_index_1f_reads_what_was_written(void **state) {
    (void)state;
    power_on(BOARD_1987);
    outp(0x00D0, 0x1F);
    outp(0x00D2, 0xFD);
    assert_int_equal(inp(0x00D2), 0xFD);
    assert_int_equal(board_violations(&board), 0);
}

static void control_1_reads_0000_whatever_was_written(void **state) {
    static const uint16_t values[] = {0x0000, 0x0081, 0xFFFF, 0xFF7E, 0x1234};
    (void)state;
    for (int profile = 0; profile < 2; profile++) {
        power_on((enum board_profile)profile);
        for (size_t i = 0; i < sizeof values / sizeof values[0]; i++) {
            outpw(0x00D0, values[i]);
            assert_int_equal(inpw(0x00D0), 0x0000);
            assert_int_equal(inp(0x00D0), 0x00);
        }
        assert_int_equal(board_violations(&board), profile == BOARD_1987 ? 10 : 0);
    }
}

static void reading_a_write_only_register_gives_ff_and_is_reported(void **state) {
    static const uint16_t ports[] = {0x00D4, 0x00D6, 0x00DE};
    (void)state;
    power_on(BOARD_LATER);
    for (unsigned i = 0; i < 3; i++) {
        assert_int_equal(inp(ports[i]), 0xFF);
        assert_int_equal(inpw(ports[i]), 0xFFFF);
    }
    assert_int_equal(count_of(BOARD_WRITE_ONLY_READ), 6);
    assert_int_equal(board_violations(&board), 6);
}

static void modes_other_than_00_01_03_are_reported(void **state) {
    (void)state;
    for (int profile = 0; profile < 2; profile++) {
        for (unsigned mode = 0; mode < 256; mode++) {
            power_on((enum board_profile)profile);
            outp(0x00DE, (uint8_t)mode);
            bool is_known = mode == 0 || mode == 1 || mode == 3;
            assert_int_equal(board_violations(&board), is_known ? 0 : 1);
            outpw(0x00DE, (uint16_t)(0x5500 | mode));
            assert_int_equal(board_violations(&board), is_known ? 0 : 2);
        }
    }
}

static void mode_40_steps_x_after_blue_on_the_later_board_only(void **state) {
    (void)state;
    for (int profile = 0; profile < 2; profile++) {
        power_on((enum board_profile)profile);
        outp(0x00DE, 0x41);
        put_pixel(10, 0, 0x111111);
        outp(0x00D8, 0x22);
        outp(0x00DE, 0x01);
        assert_int_equal(get_pixel(11, 0), profile == BOARD_LATER ? 0x220000 : 0);
        assert_int_equal(get_pixel(10, 0), profile == BOARD_LATER ? 0x111111 : 0x221111);
        assert_int_equal(count_of(BOARD_AUTO_INCREMENT), profile == BOARD_LATER ? 1 : 0);
    }
    power_on(BOARD_LATER); /* past the right edge it falls off, and doesn't wrap */
    outp(0x00DE, 0x41);
    put_pixel(639, 0, 0x333333);
    outp(0x00D8, 0x44);
    outp(0x00DE, 0x01);
    assert_int_equal(get_pixel(0, 0), 0);
    assert_int_equal(get_pixel(0, 1), 0);
    assert_int_equal(count_of(BOARD_OUTSIDE_WRITE), 1);
}

/* ---- Odd ports and foreign ports ------------------------------------------------------------ */

static void a_word_at_an_odd_port_is_two_bytes_the_lower_port_first(void **state) {
    (void)state;
    power_on(BOARD_1987);
    put_pixel(0x0210, 0x0030, 0x102030);
    go_to(0x0010, 0x01FF);
    outpw(0x00D5, 0x3002); /* X's high byte 02, then Y's low byte 30 */
    outp(0x00D7, 0x00);
    assert_int_equal(get_here(), 0x102030);
    assert_int_equal(inpw(0x00D7), 0x10FF); /* FF of the odd port, then red */
    assert_int_equal(inpw(0x00DF), 0xFFFF);
    outpw(0x00CF, 0x0955); /* the upper half reaches control 1 */
    outp(0x00D2, 0x0F);
    outp(0x00D0, 0x09);
    assert_int_equal(inp(0x00D2), 0x0F);
    outpw(0x00DF, 0xFFFF); /* the upper half reaches nothing */
    assert_int_equal(count_of(BOARD_WORD_SPLIT), 5);
}

static void ports_outside_the_sixteen_change_nothing(void **state) {
    (void)state;
    power_on_noise(BOARD_LATER, 3);
    static struct board before;
    before = board;
    static const uint16_t ports[] = {0x00CD, 0x00CE, 0x00E0, 0x00E1, 0x00EE, 0x01D8,
                                     0x02D8, 0x10D8, 0x0000, 0xFFFF, 0x00C8};
    for (size_t i = 0; i < sizeof ports / sizeof ports[0]; i++) {
        outp(ports[i], 0xC0);
        outpw(ports[i], 0xC0C0);
        assert_int_equal(inp(ports[i]), 0xFF);
        assert_int_equal(inpw(ports[i]), 0xFFFF);
    }
    assert_memory_equal(board.memory, before.memory, sizeof board.memory);
    assert_memory_equal(board.controller, before.controller, sizeof board.controller);
    assert_int_equal(board.mode, before.mode);
    assert_int_equal(board_violations(&board), 22); /* the reads */
    assert_int_equal(count_of(BOARD_FOREIGN_WRITE), 22);
}

static void an_odd_port_without_a_meaning_takes_nothing(void **state) {
    static const uint16_t ports[] = {0x00D1, 0x00D3, 0x00D9, 0x00DB, 0x00DD, 0x00DF};
    (void)state;
    power_on(BOARD_LATER);
    initialise();
    put_pixel(3, 3, 0x123456);
    outp(0x00D0, 0x06);
    for (unsigned i = 0; i < 6; i++) {
        outp(ports[i], 0x99);
    }
    assert_int_equal(inp(0x00D2), 0x19);
    assert_int_equal(get_here(), 0x123456);
    assert_int_equal(board.mode, 0x00);
    assert_int_equal(inp(0x00D1), 0x00);
    for (unsigned i = 1; i < 6; i++) {
        assert_int_equal(inp(ports[i]), 0xFF);
    }
    assert_int_equal(count_of(BOARD_ODD_WRITE), 6);
    assert_int_equal(count_of(BOARD_ODD_READ), 6);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_primary_lands_at_once_and_by_itself),
        cmocka_unit_test(the_four_corners_hold_pixels_of_their_own),
        cmocka_unit_test(x_and_y_keep_their_values_over_pixel_accesses),
        cmocka_unit_test(the_upper_bits_of_x_and_y_are_dont_care),
        cmocka_unit_test(a_byte_to_x_or_y_replaces_the_low_byte_only),
        cmocka_unit_test(a_byte_to_the_odd_port_of_x_or_y_is_taken_and_reported),
        cmocka_unit_test(all_256000_pixels_are_independent),
        cmocka_unit_test(a_word_write_of_green_or_blue_counts_as_its_low_byte_and_is_reported),
        cmocka_unit_test(the_high_byte_of_a_primary_reads_ff_and_is_reported),
        cmocka_unit_test(outside_writes_are_ignored_reads_give_ff_and_both_are_reported),
        cmocka_unit_test(nothing_written_outside_shows_anywhere),
        cmocka_unit_test(with_the_wrapping_board_x_640_is_x_0_of_the_same_line_and_is_reported),
        cmocka_unit_test(the_hidden_blocks_belong_to_the_later_board_only),
        cmocka_unit_test(a_word_zero_to_red_clears_four_pixels_of_the_later_board),
        cmocka_unit_test(a_fill_that_nobody_has_seen_rounds_x_down_and_is_reported),
        cmocka_unit_test(in_1987_a_word_to_red_is_a_byte_and_reported),
        cmocka_unit_test(control_2_holds_a_value_for_each_index),
        cmocka_unit_test(data_for_an_unknown_index_is_stored_and_reported),
        cmocka_unit_test(data_never_written_reads_0_and_is_reported),
        cmocka_unit_test(the_status_of_the_later_board_blanks_and_shows_in_turn),
        cmocka_unit_test(in_1987_index_1f_reads_what_was_written),
        cmocka_unit_test(control_1_reads_0000_whatever_was_written),
        cmocka_unit_test(reading_a_write_only_register_gives_ff_and_is_reported),
        cmocka_unit_test(modes_other_than_00_01_03_are_reported),
        cmocka_unit_test(mode_40_steps_x_after_blue_on_the_later_board_only),
        cmocka_unit_test(a_word_at_an_odd_port_is_two_bytes_the_lower_port_first),
        cmocka_unit_test(ports_outside_the_sixteen_change_nothing),
        cmocka_unit_test(an_odd_port_without_a_meaning_takes_nothing),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
