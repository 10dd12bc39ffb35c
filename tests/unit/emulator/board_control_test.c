/* SPDX-License-Identifier: MIT */
/* The board's control and mode registers, odd ports and foreign ports, with literal numbers. */
#include "board_fixture.h"

static uint64_t count_of(enum board_behaviour behaviour) {
    return board.notes[behaviour].count;
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
