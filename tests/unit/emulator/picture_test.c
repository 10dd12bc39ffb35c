/* SPDX-License-Identifier: MIT */
/* What the CRT shows: initialisation, timing, mode, scroll, and the PC-9801's own screen. */
#include "board_fixture.h"

#include "checksum.h"
#include "picture.h"

static uint8_t rgb[PICTURE_BYTES];
static struct native_screen native;

static unsigned shown(unsigned x, unsigned y) {
    const uint8_t *pixel = rgb + ((size_t)y * 640 + x) * 3;
    return (unsigned)pixel[0] << 16 | (unsigned)pixel[1] << 8 | pixel[2];
}

static void set_register(unsigned index, unsigned value) {
    outp(0x00D0, (uint8_t)index);
    outp(0x00D2, (uint8_t)value);
}

/* picture_draw(), and with it: the memory is offered as the picture only where it is the picture.
 */
static enum picture_state draw(const struct native_screen *screen) {
    enum picture_state drawn = picture_draw(&board, screen, rgb);
    const uint8_t *plain = picture_in_memory(&board, screen);
    if (plain != NULL) {
        assert_memory_equal(plain, rgb, PICTURE_BYTES);
    }
    return drawn;
}

static bool is_black(void) {
    for (size_t i = 0; i < PICTURE_BYTES; i++) {
        if (rgb[i] != 0) {
            return false;
        }
    }
    return true;
}

static void nothing_is_shown_before_the_initialisation(void **state) {
    (void)state;
    power_on_noise(BOARD_1987, 1);
    outp(0x00DE, 0x01);
    assert_int_equal(draw(NULL), PICTURE_NOT_INITIALISED);
    assert_true(is_black());
}

static void each_of_the_fifteen_registers_is_needed(void **state) {
    static const uint8_t indices[15] = {0x00, 0x01, 0x02, 0x03, 0x04, 0x05, 0x06, 0x07,
                                        0x08, 0x09, 0x0C, 0x0D, 0x1B, 0x1E, 0x1F};
    static const uint8_t values[15] = {0x6B, 0x50, 0x5B, 0x0E, 0x1A, 0x02, 0x19, 0x19,
                                       0x80, 0x0F, 0xFF, 0xFF, 0x01, 0x8C, 0x00};
    (void)state;
    for (unsigned left_out = 0; left_out < 15; left_out++) {
        power_on(BOARD_1987);
        for (unsigned i = 0; i < 15; i++) {
            if (i != left_out) {
                set_register(indices[i], values[i]);
            }
        }
        assert_int_equal(picture_timing(&board).state, PICTURE_NOT_INITIALISED);
        set_register(indices[left_out], values[left_out]);
        assert_int_equal(picture_timing(&board).state, PICTURE_OK);
    }
}

static void timing_that_gives_another_size_is_reported_and_shows_nothing(void **state) {
    static const struct {
        uint8_t index, value;
        unsigned width, height;
    } cases[] = {{0x01, 0x4F, 632, 400}, {0x01, 0x51, 648, 400}, {0x01, 0x00, 0, 400},
                 {0x06, 0x18, 640, 384}, {0x09, 0x07, 640, 200}, {0x09, 0xFF, 640, 6400}};
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        power_on_noise(BOARD_1987, 1);
        initialise();
        outp(0x00DE, 0x01);
        set_register(cases[i].index, cases[i].value);
        struct picture_timing timing = picture_timing(&board);
        assert_int_equal(timing.state, PICTURE_WRONG_TIMING);
        assert_int_equal(timing.width, cases[i].width);
        assert_int_equal(timing.height, cases[i].height);
        assert_int_equal(draw(NULL), PICTURE_WRONG_TIMING);
        assert_true(is_black());
    }
}

static void the_picture_is_the_frame_memory_from_the_top_left(void **state) {
    (void)state;
    power_on(BOARD_1987);
    initialise();
    outp(0x00DE, 0x01);
    put_pixel(0, 0, 0x010203);
    put_pixel(639, 0, 0x040506);
    put_pixel(0, 1, 0x070809);
    put_pixel(639, 399, 0x0A0B0C);
    assert_int_equal(draw(NULL), PICTURE_OK);
    assert_int_equal(shown(0, 0), 0x010203);
    assert_int_equal(shown(639, 0), 0x040506);
    assert_int_equal(shown(0, 1), 0x070809);
    assert_int_equal(shown(639, 399), 0x0A0B0C);
    assert_int_equal(shown(1, 0), 0);
    assert_ptr_equal(picture_in_memory(&board, NULL), board.memory);
    outp(0x00DE, 0x00);
    draw(NULL);
    assert_true(is_black());
    assert_null(picture_in_memory(&board, NULL));
}

/* Board: white at x = 0 and 1. PC: red (colour 2) at x = 1 and 2. */
static void the_mode_chooses_among_three_pictures(void **state) {
    static const struct {
        uint8_t mode;
        unsigned pixels[4];
    } cases[] = {{0x00, {0x000000, 0xFF0000, 0xFF0000, 0}},
                 {0x01, {0xFFFFFF, 0xFF0000, 0xFF0000, 0}},
                 {0x02, {0x000000, 0xFF0000, 0xFF0000, 0}},
                 {0x03, {0xFFFFFF, 0xFFFFFF, 0x000000, 0}}};
    (void)state;
    native_screen_init(&native);
    native.pixels[1] = 2;
    native.pixels[2] = 2;
    power_on(BOARD_1987);
    initialise();
    put_pixel(0, 0, 0xFFFFFF);
    put_pixel(1, 0, 0xFFFFFF);
    for (unsigned i = 0; i < 4; i++) {
        outp(0x00DE, cases[i].mode);
        assert_int_equal(draw(&native), PICTURE_OK);
        for (unsigned x = 0; x < 4; x++) {
            assert_int_equal(shown(x, 0), cases[i].pixels[x]);
        }
    }
}

static void the_pcs_screen_passes_a_board_that_is_not_initialised(void **state) {
    (void)state;
    native_screen_init(&native);
    native.pixels[640] = 7;
    power_on_noise(BOARD_1987, 5);
    assert_int_equal(draw(&native), PICTURE_NOT_INITIALISED);
    assert_int_equal(shown(0, 1), 0xFFFFFF);
    assert_int_equal(shown(0, 0), 0x000000);
}

static void a_colour_whose_palette_entry_is_black_lets_the_board_through(void **state) {
    (void)state;
    native_screen_init(&native);
    native.palette[5] = 0x000;
    native.palette[8] = 0x123;
    native.pixels[0] = 5;
    native.pixels[1] = 8;
    power_on(BOARD_1987);
    initialise();
    outp(0x00DE, 0x01);
    put_pixel(0, 0, 0xABCDEF);
    put_pixel(1, 0, 0xABCDEF);
    draw(&native);
    assert_int_equal(shown(0, 0), 0xABCDEF);
    assert_int_equal(shown(1, 0), 0x112233);
}

/* A start of 81 blocks is one row of 16 lines and one column of 8 pixels. */
static void the_later_board_scrolls_by_the_complemented_start_address(void **state) {
    (void)state;
    for (int profile = 0; profile < 2; profile++) {
        power_on((enum board_profile)profile);
        initialise();
        outp(0x00DE, 0x03);
        put_pixel(0, 0, 0x111111);
        put_pixel(8 + 3, 16 + 5, 0x222222);
        set_register(0x0C, 0xFF);
        set_register(0x0D, 0xFF - 81);
        draw(NULL);
        if (profile == BOARD_LATER) {
            assert_int_equal(shown(3, 5), 0x222222);
            assert_int_equal(shown(11, 21), 0x000000);
        } else {
            assert_int_equal(shown(11, 21), 0x222222);
        }
        assert_int_equal(board_violations(&board), profile == BOARD_LATER ? 0 : 1);
    }
}

/* Scrolled by one row, row 24 of the screen shows the blocks after the 2000 visible ones: the 48
 * hidden blocks, then block 0 again, because there are 2048. */
static void scrolling_shows_the_hidden_blocks_and_wraps_after_2048(void **state) {
    (void)state;
    power_on(BOARD_LATER);
    initialise();
    outp(0x00DE, 0x03);
    put_pixel(0, 0, 0x111111);
    put_pixel(383, 407, 0x222222);
    set_register(0x0D, 0xFF - 80);
    draw(NULL);
    assert_int_equal(shown(383, 384 + 7), 0x222222);
    assert_int_equal(shown(384, 384), 0x111111);
    set_register(0x0C, 0xF8); /* start 0700h + 80 = 1872 */
    put_pixel(0, 0, 0x333333);
    draw(NULL);
    /* Block 0 is 2048 - 1872 = 176 blocks on: row 2, column 16. */
    assert_int_equal(shown(16 * 8, 2 * 16), 0x333333);
    set_register(0x0C, 0xF7); /* 0800h more: the same picture */
    set_register(0x0D, 0xFF);
    draw(NULL);
    assert_int_equal(shown(0, 0), 0x333333);
}

static void the_crc_is_crc_32_of_the_768000_bytes(void **state) {
    (void)state;
    assert_int_equal(crc_by_definition((const uint8_t *)"123456789", 9), 0xCBF43926U);
    for (size_t i = 0; i < PICTURE_BYTES; i++) {
        rgb[i] = (uint8_t)(i * 7 + (i >> 8));
    }
    assert_int_equal(picture_crc(rgb), crc_by_definition(rgb, 768000));
    rgb[767999] ^= 1;
    assert_int_equal(picture_crc(rgb), crc_by_definition(rgb, 768000));
}

static void every_state_has_a_text(void **state) {
    (void)state;
    assert_non_null(strstr(picture_state_text(PICTURE_OK), "640"));
    assert_non_null(strstr(picture_state_text(PICTURE_NOT_INITIALISED), "initialised"));
    assert_non_null(strstr(picture_state_text(PICTURE_WRONG_TIMING), "timing"));
    assert_non_null(picture_state_text((enum picture_state)9));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(nothing_is_shown_before_the_initialisation),
        cmocka_unit_test(each_of_the_fifteen_registers_is_needed),
        cmocka_unit_test(timing_that_gives_another_size_is_reported_and_shows_nothing),
        cmocka_unit_test(the_picture_is_the_frame_memory_from_the_top_left),
        cmocka_unit_test(the_mode_chooses_among_three_pictures),
        cmocka_unit_test(the_pcs_screen_passes_a_board_that_is_not_initialised),
        cmocka_unit_test(a_colour_whose_palette_entry_is_black_lets_the_board_through),
        cmocka_unit_test(the_later_board_scrolls_by_the_complemented_start_address),
        cmocka_unit_test(scrolling_shows_the_hidden_blocks_and_wraps_after_2048),
        cmocka_unit_test(the_crc_is_crc_32_of_the_768000_bytes),
        cmocka_unit_test(every_state_has_a_text),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
