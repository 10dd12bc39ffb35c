/* SPDX-License-Identifier: MIT */
/* The board's position and pixel registers, spoken to through ports with literal numbers. */
#include "board_fixture.h"

#include <limits.h>

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

/* Writes X and Y after an X that lies outside, in one order or the other, then red. */
static void write_red_at(const struct board_desc *desc, uint16_t x, uint16_t y, bool x_is_last) {
    power_on_desc(desc);
    outpw(0x00D4, 650);
    outpw(x_is_last ? 0x00D6 : 0x00D4, x_is_last ? y : x);
    outpw(x_is_last ? 0x00D4 : 0x00D6, x_is_last ? x : y);
    outp(0x00D8, 0x5A);
}

/* All edges of the memory, then don't-care bits, on every kind of board. */
static void x_and_y_name_the_same_pixel_in_either_order(void **state) {
    static const uint16_t xs[] = {0, 383, 384, 639, 640, 650, 1023, 1024, 0xFD23, 0xFE80};
    static const uint16_t ys[] = {0, 399, 400, 407, 408, 415, 416, 511, 512, 0xFF45};
    static struct board other;
    (void)state;
    for (unsigned i = 0; i < 400; i++) {
        struct board_desc desc = board_default_desc(i & 1 ? BOARD_LATER : BOARD_1987);
        desc.outside = i & 2 ? BOARD_OUTSIDE_WRAPS : BOARD_OUTSIDE_IGNORED;
        write_red_at(&desc, xs[i / 4 % 10], ys[i / 40], false);
        other = board;
        write_red_at(&desc, xs[i / 4 % 10], ys[i / 40], true);
        assert_int_equal(board.x, other.x);
        assert_int_equal(board.y, other.y);
        assert_memory_equal(board.memory, other.memory, sizeof board.memory);
        assert_int_equal(board_violations(&board), board_violations(&other));
        for (int behaviour = 0; behaviour < BOARD_BEHAVIOURS; behaviour++) {
            assert_int_equal(board.notes[behaviour].count, other.notes[behaviour].count);
        }
    }
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
    go_to(10, 9);
    outpw(0x00D8, 0x0000); /* an even X is not enough */
    go_to(640, 9);
    outpw(0x00D8, 0x0000); /* outside */
    assert_int_equal(count_of(BOARD_FILL_UNSEEN), 4);
    assert_int_equal(count_of(BOARD_OUTSIDE_WRITE), 1);
    assert_int_equal(board_violations(&board), 5);
}

static void in_1987_a_word_to_red_is_a_byte_and_reported(void **state) {
    (void)state;
    power_on(BOARD_1987);
    put_pixel(4, 9, 0x111111);
    outpw(0x00D8, 0x5500);
    assert_int_equal(get_here(), 0x001111);
    assert_int_equal(get_pixel(5, 9), 0x000000);
    assert_int_equal(board_violations(&board), 1);
    assert_int_equal(board.log_count, 1);
    assert_int_equal(board.log[0].behaviour, BOARD_RED_WORD_WRITE);
    assert_int_equal(board.log[0].value, 0x5500);
}

static void an_access_of_another_width_is_none(void **state) {
    static const unsigned widths[] = {0, 3, 5, 8, 256, UINT_MAX};
    static struct board before;
    (void)state;
    for (int profile = 0; profile < BOARD_PROFILES; profile++) {
        power_on_noise((enum board_profile)profile, 1);
        before = board;
        for (unsigned port = 0x00CF; port <= 0x00E0; port++) {
            for (size_t i = 0; i < sizeof widths / sizeof widths[0]; i++) {
                board_write(&board, (uint16_t)port, 0x1234, widths[i]);
                assert_int_equal(board_read(&board, (uint16_t)port, widths[i]), UINT32_MAX);
            }
        }
        assert_memory_equal(&board, &before, sizeof board);
    }
}

/* At every port, also those that wrap: two words, the low one first. */
static void an_access_of_four_bytes_is_two_words(void **state) {
    static struct board wide;
    (void)state;
    for (int profile = 0; profile < BOARD_PROFILES; profile++) {
        power_on_noise((enum board_profile)profile, 1);
        wide = board;
        for (unsigned port = 0; port <= 0xFFFF; port += port >= 0xC0 && port < 0xF0 ? 1 : 0x1FF) {
            uint16_t next = (uint16_t)(port + 2);
            board_write(&board, (uint16_t)port, 0x5678, 2);
            board_write(&board, next, 0x1234, 2);
            board_write(&wide, (uint16_t)port, 0x12345678, 4);
            uint32_t low = board_read(&board, (uint16_t)port, 2);
            uint32_t high = board_read(&board, next, 2);
            assert_int_equal(board_read(&wide, (uint16_t)port, 4), high << 16 | low);
        }
        assert_memory_equal(&board, &wide, sizeof board);
    }
}

/* A board that was kept in a file comes back as that file has it. */
static void a_restored_board_with_a_bad_place_has_no_pixel_there(void **state) {
    static const int32_t places[] = {-1,
                                     INT32_MIN,
                                     BOARD_MEMORY_BYTES - 2,
                                     BOARD_MEMORY_BYTES - 1,
                                     BOARD_MEMORY_BYTES,
                                     BOARD_MEMORY_BYTES + 3,
                                     INT32_MAX};
    static uint8_t before[BOARD_MEMORY_BYTES];
    (void)state;
    for (int profile = 0; profile < BOARD_PROFILES; profile++) {
        for (size_t i = 0; i < sizeof places / sizeof places[0]; i++) {
            power_on_noise((enum board_profile)profile, 2);
            memcpy(before, board.memory, sizeof before);
            board.place = places[i];
            for (uint16_t port = 0x00D8; port <= 0x00DC; port += 2) {
                outp(port, 0x12);
                outpw(port, 0x1234);
                assert_int_equal(inp(port), 0xFF);
                assert_int_equal(inpw(port), 0xFFFF);
            }
            assert_memory_equal(board.memory, before, sizeof before);
        }
    }
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
        cmocka_unit_test(x_and_y_name_the_same_pixel_in_either_order),
        cmocka_unit_test(the_hidden_blocks_belong_to_the_later_board_only),
        cmocka_unit_test(a_word_zero_to_red_clears_four_pixels_of_the_later_board),
        cmocka_unit_test(a_fill_that_nobody_has_seen_rounds_x_down_and_is_reported),
        cmocka_unit_test(in_1987_a_word_to_red_is_a_byte_and_reported),
        cmocka_unit_test(an_access_of_another_width_is_none),
        cmocka_unit_test(an_access_of_four_bytes_is_two_words),
        cmocka_unit_test(a_restored_board_with_a_bad_place_has_no_pixel_there),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
