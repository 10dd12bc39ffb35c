/* SPDX-License-Identifier: MIT */
/* The board over the PC-9801's picture: by screen, line and rectangle; what has changed; and the
 * blanking from outside. */
#include "board_fixture.h"

#include <limits.h>

#include "board_screen.h"

enum { SCREEN_BYTES = 640 * 400 * 3 };

static uint8_t pc[SCREEN_BYTES], whole[SCREEN_BYTES], parts[SCREEN_BYTES];

/* A PC's picture with black and other dots in turn, and dots that are black but in one primary. */
static void draw_pc(void) {
    for (size_t i = 0; i < SCREEN_BYTES / 3; i++) {
        uint8_t *pixel = pc + i * 3;
        memset(pixel, 0, 3);
        if (i % 5 == 1) {
            pixel[i / 5 % 3] = (uint8_t)(1 + i % 255);
        }
    }
    memcpy(whole, pc, sizeof whole);
    memcpy(parts, pc, sizeof parts);
}

/* A board full of noise, set up. */
static void power_on_shown(enum board_profile profile, unsigned mode) {
    power_on_noise(profile, 99);
    initialise();
    outp(0x00DE, (uint8_t)mode);
}

static void the_board_shows_where_the_pcs_picture_is_black(void **state) {
    (void)state;
    power_on_shown(BOARD_1987, 0x01);
    draw_pc();
    board_draw_over(&board, whole);
    for (size_t i = 0; i < SCREEN_BYTES; i += 3) {
        bool is_black = pc[i] == 0 && pc[i + 1] == 0 && pc[i + 2] == 0;
        assert_memory_equal(whole + i, is_black ? board.memory + i : pc + i, 3);
    }
}

static void the_mode_chooses_whose_picture_is_shown(void **state) {
    (void)state;
    for (unsigned mode = 0; mode < 4; mode++) {
        power_on_shown(BOARD_1987, mode);
        draw_pc();
        board_draw_over(&board, whole);
        if (mode == 3) {
            assert_memory_equal(whole, board.memory, SCREEN_BYTES);
        } else if (mode != 1) {
            assert_memory_equal(whole, pc, SCREEN_BYTES);
        }
    }
}

static void a_board_without_a_picture_is_black(void **state) {
    (void)state;
    power_on_noise(BOARD_1987, 99);
    outp(0x00DE, 0x03);
    draw_pc();
    board_draw_over(&board, whole);
    for (size_t i = 0; i < SCREEN_BYTES; i++) {
        assert_int_equal(whole[i], 0);
    }
    outp(0x00DE, 0x01);
    draw_pc();
    board_draw_over(&board, whole);
    assert_memory_equal(whole, pc, SCREEN_BYTES);
}

/* Line by line and rectangle by rectangle, the same pictures come out; scrolled too. */
static void lines_and_rectangles_make_the_same_screen(void **state) {
    (void)state;
    for (unsigned start = 0; start < 3; start++) {
        for (unsigned mode = 0; mode < 4; mode++) {
            power_on_shown(BOARD_LATER, mode);
            outp(0x00D0, 0x0D);
            outp(0x00D2, (uint8_t)(0xFF - 81 * start));
            draw_pc();
            board_draw_over(&board, whole);
            for (unsigned y = 0; y < 400; y++) {
                board_draw_over_line(&board, y, parts + (size_t)y * 640 * 3);
            }
            assert_memory_equal(parts, whole, SCREEN_BYTES);
            draw_pc();
            board_draw_over(&board, whole);
            for (unsigned y = 0; y < 400; y += 37) {
                for (unsigned x = 0; x < 640; x += 53) {
                    struct board_area area = {x, y, 53, 37}; /* beyond the edges at last */
                    board_draw_over_area(&board, area, parts + ((size_t)y * 640 + x) * 3, 640 * 3);
                }
            }
            assert_memory_equal(parts, whole, SCREEN_BYTES);
        }
    }
}

/* Scrolled by one row and one column: the block of the memory at (8, 16) comes to the top left. */
static void a_rectangle_of_a_scrolled_board_is_taken_from_its_blocks(void **state) {
    uint8_t rgb[3 * 3] = {0};
    struct board_area area = {6, 2, 3, 1};
    (void)state;
    power_on_shown(BOARD_LATER, 0x03);
    outp(0x00D0, 0x0D);
    outp(0x00D2, 0xFF - 81);
    put_pixel(14, 18, 0x111213);
    put_pixel(15, 18, 0x212223);
    put_pixel(16, 18, 0x313233);
    board_draw_over_area(&board, area, rgb, 0);
    static const uint8_t expected[9] = {0x11, 0x12, 0x13, 0x21, 0x22, 0x23, 0x31, 0x32, 0x33};
    assert_memory_equal(rgb, expected, sizeof rgb);
}

static void nothing_is_drawn_outside_the_screen(void **state) {
    static const struct board_area outside[] = {{640, 0, 1, 1},      {0, 400, 1, 1},
                                                {UINT_MAX, 0, 2, 1}, {0, UINT_MAX, 1, 2},
                                                {5, 5, 0, 9},        {5, 5, 9, 0}};
    uint8_t rgb[3] = {0};
    (void)state;
    power_on_shown(BOARD_LATER, 0x03);
    for (size_t i = 0; i < sizeof outside / sizeof outside[0]; i++) {
        board_draw_over_area(&board, outside[i], rgb, 3);
        assert_int_equal(rgb[0] | rgb[1] | rgb[2], 0);
    }
    memset(parts, 0, 640 * 3);
    board_draw_over_line(&board, 400, parts);
    for (size_t i = 0; i < 640 * 3; i++) {
        assert_int_equal(parts[i], 0);
    }
    struct board_area corner = {639, 399, UINT_MAX, UINT_MAX};
    put_pixel(639, 399, 0x090807);
    board_draw_over_area(&board, corner, rgb, 0);
    assert_int_equal(rgb[0] << 16 | rgb[1] << 8 | rgb[2], 0x090807);
}

/* ---- Changes -------------------------------------------------------------------------------- */

static void expect_changes(unsigned x, unsigned y, unsigned width, unsigned height) {
    struct board_area area = board_take_changes(&board);
    assert_int_equal(area.width, width);
    assert_int_equal(area.height, height);
    if (width != 0) {
        assert_int_equal(area.x, x);
        assert_int_equal(area.y, y);
    }
}

/* Goes to a pixel before the changes begin anew. */
static void begin_at(unsigned x, unsigned y) {
    go_to(x, y);
    (void)board_take_changes(&board);
}

static void the_changed_rectangle_holds_whatever_was_written(void **state) {
    (void)state;
    power_on_shown(BOARD_LATER, 0x01);
    expect_changes(0, 0, 640, 400);
    expect_changes(0, 0, 0, 0);
    begin_at(10, 20);
    outp(0x00DA, 0x55);
    expect_changes(10, 20, 1, 1);
    put_pixel(12, 20, 0x010203);
    expect_changes(10, 20, 3, 1); /* from the place at which the changes began */
    begin_at(3, 390);
    put_pixel(639, 399, 0x010203);
    put_pixel(5, 395, 0x010203);
    expect_changes(3, 390, 637, 10);
    go_to(14, 7);
    expect_changes(0, 0, 0, 0); /* X and Y alone draw nothing */
    get_here();
    expect_changes(0, 0, 0, 0);
    outpw(0x00D8, 0);
    expect_changes(12, 7, 4, 1); /* the fill of four pixels */
    outpw(0x00DA, 0x1234);
    expect_changes(14, 7, 1, 1);
    outp(0x00D5, 0x01); /* X by its bytes, Y by its low one */
    outp(0x00D4, 0x02);
    outp(0x00D6, 0x09);
    outp(0x00DC, 1);
    expect_changes(14, 7, 257, 3); /* X was 14, 270 and 258, Y was 7 and 9 */
}

static void what_is_not_shown_has_not_changed(void **state) {
    (void)state;
    power_on_shown(BOARD_LATER, 0x01);
    begin_at(100, 403); /* the hidden blocks */
    outp(0x00D8, 1);
    expect_changes(0, 0, 0, 0);
    begin_at(700, 100); /* outside */
    outp(0x00D8, 1);
    expect_changes(0, 0, 0, 0);
    outp(0x00DE, 0x00);
    (void)board_take_changes(&board);
    put_pixel(1, 1, 0x010203);
    expect_changes(0, 0, 0, 0);
    outp(0x00DE, 0x01);
    expect_changes(0, 0, 640, 400);
}

static void mode_controller_scrolling_and_reset_change_the_whole_screen(void **state) {
    (void)state;
    power_on_shown(BOARD_LATER, 0x01);
    (void)board_take_changes(&board);
    outp(0x00D0, 0x0D);
    expect_changes(0, 0, 0, 0);
    outp(0x00D2, 0xFE);
    expect_changes(0, 0, 640, 400);
    put_pixel(9, 9, 0x010203); /* a start other than 0: it may be anywhere */
    expect_changes(0, 0, 640, 400);
    expect_changes(0, 0, 0, 0);
    board_reset(&board);
    expect_changes(0, 0, 640, 400);
}

static void x_that_wraps_or_steps_changes_where_it_writes(void **state) {
    struct board_desc desc = board_default_desc(BOARD_LATER);
    (void)state;
    desc.outside = BOARD_OUTSIDE_WRAPS;
    power_on_desc(&desc);
    initialise();
    outp(0x00DE, 0x41);
    (void)board_take_changes(&board);
    begin_at(650, 8);
    outp(0x00D8, 1);
    expect_changes(10, 8, 1, 1);
    begin_at(20, 8);
    outp(0x00DC, 1); /* and X is 21 */
    outp(0x00D8, 1);
    expect_changes(20, 8, 2, 1);
    outp(0x00D8, 1);
    expect_changes(21, 8, 1, 1);
}

static void a_line_that_y_named_while_x_was_outside_has_changed(void **state) {
    (void)state;
    power_on_shown(BOARD_LATER, 0x01);
    begin_at(700, 10);
    outpw(0x00D6, 50);
    outpw(0x00D4, 5);
    outp(0x00D8, 1);
    struct board_area area = board_take_changes(&board);
    assert_true(area.x <= 5 && area.x + area.width >= 6);
    assert_true(area.y <= 50 && area.y + area.height >= 51);
}

/* Whatever is written, redrawing what has changed keeps the screen up to date. */
static void redrawing_the_changes_keeps_the_screen(void **state) {
    uint64_t random = 88172645463325252U;
    (void)state;
    power_on_shown(BOARD_LATER, 0x03);
    memset(parts, 0, sizeof parts);
    for (unsigned i = 0; i < 500; i++) {
        for (unsigned k = 0; k < i % 12; k++) {
            random = random * 6364136223846793005U + 1442695040888963407U;
            uint16_t port = (uint16_t)(0x00D4 + (random >> 33) % 10);
            board_write(&board, port, (uint32_t)(random >> 40), 1U << (random >> 61) % 3);
        }
        outp(0x00DE, i % 50 == 0 ? 0x43 : 0x03);
        struct board_area area = board_take_changes(&board);
        board_draw_over_area(&board, area, parts + ((size_t)area.y * 640 + area.x) * 3, 640 * 3);
        assert_ptr_equal(board_screen_in_memory(&board), board.memory);
        assert_memory_equal(parts, board.memory, SCREEN_BYTES);
    }
}

/* ---- The blanking --------------------------------------------------------------------------- */

static void the_blanking_can_come_from_outside(void **state) {
    (void)state;
    power_on(BOARD_LATER);
    outp(0x00D0, 0x1F);
    for (unsigned i = 0; i < 3; i++) {
        board_set_blanking(&board, BOARD_BLANKING_ON);
        assert_int_equal(inp(0x00D2), 0x02);
        assert_int_equal(inpw(0x00D2), 0xFF02);
        board_set_blanking(&board, BOARD_BLANKING_OFF);
        assert_int_equal(inp(0x00D2), 0x00);
    }
    while (board.accesses < 44326 - 1) {
        assert_int_equal(inp(0x00D2), 0x00);
    }
    board_set_blanking(&board, BOARD_BLANKING_COUNTED);
    assert_int_equal(inp(0x00D2), 0x00); /* access 44326: a frame begins */
    board.accesses -= 2;
    assert_int_equal(inp(0x00D2), 0x02); /* the last access of a frame */
}

static void the_blanking_stays_over_a_reset_and_is_no_matter_of_1987(void **state) {
    (void)state;
    power_on(BOARD_LATER);
    board_set_blanking(&board, BOARD_BLANKING_ON);
    board_reset(&board);
    outp(0x00D0, 0x1F);
    assert_int_equal(inp(0x00D2), 0x02);
    power_on(BOARD_1987);
    board_set_blanking(&board, BOARD_BLANKING_ON);
    outp(0x00D0, 0x1F);
    outp(0x00D2, 0x55);
    assert_int_equal(inp(0x00D2), 0x55);
}

static void the_timing_is_read_from_the_registers(void **state) {
    (void)state;
    power_on(BOARD_1987);
    assert_false(board_read_timing(&board).is_initialised);
    assert_false(board_makes_picture(&board));
    initialise();
    assert_true(board_read_timing(&board).is_initialised);
    assert_int_equal(board_read_timing(&board).width, 640);
    assert_int_equal(board_read_timing(&board).height, 400);
    assert_true(board_makes_picture(&board));
    outp(0x00D0, 0x01);
    outp(0x00D2, 0x4F);
    assert_false(board_makes_picture(&board));
    assert_null(board_screen_in_memory(&board));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_board_shows_where_the_pcs_picture_is_black),
        cmocka_unit_test(the_mode_chooses_whose_picture_is_shown),
        cmocka_unit_test(a_board_without_a_picture_is_black),
        cmocka_unit_test(lines_and_rectangles_make_the_same_screen),
        cmocka_unit_test(a_rectangle_of_a_scrolled_board_is_taken_from_its_blocks),
        cmocka_unit_test(nothing_is_drawn_outside_the_screen),
        cmocka_unit_test(the_changed_rectangle_holds_whatever_was_written),
        cmocka_unit_test(what_is_not_shown_has_not_changed),
        cmocka_unit_test(mode_controller_scrolling_and_reset_change_the_whole_screen),
        cmocka_unit_test(x_that_wraps_or_steps_changes_where_it_writes),
        cmocka_unit_test(a_line_that_y_named_while_x_was_outside_has_changed),
        cmocka_unit_test(redrawing_the_changes_keeps_the_screen),
        cmocka_unit_test(the_blanking_can_come_from_outside),
        cmocka_unit_test(the_blanking_stays_over_a_reset_and_is_no_matter_of_1987),
        cmocka_unit_test(the_timing_is_read_from_the_registers),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
