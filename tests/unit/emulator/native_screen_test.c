/* SPDX-License-Identifier: MIT */
/* The PC-9801's own screen, from planes and from pictures. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <string.h>

#include <cmocka.h>

#include "native_screen.h"

static struct native_screen screen;
static uint8_t planes[4][NATIVE_PLANE_BYTES];
static uint8_t rgb[NATIVE_WIDTH * NATIVE_HEIGHT * 3];
static char message[160];

static int clear(void **state) {
    (void)state;
    memset(planes, 0, sizeof planes);
    memset(rgb, 0, sizeof rgb);
    memset(message, 0, sizeof message);
    native_screen_init(&screen);
    return 0;
}

static void set_pixel(unsigned x, unsigned y, unsigned colour) {
    for (unsigned primary = 0; primary < 3; primary++) {
        rgb[(y * 640 + x) * 3 + primary] = (uint8_t)(colour >> (16 - 8 * primary));
    }
}

static unsigned levels_of(unsigned colour) {
    uint8_t levels[3];
    native_colour_levels(&screen, colour, levels);
    return (unsigned)levels[0] << 16 | (unsigned)levels[1] << 8 | levels[2];
}

static void the_first_palette_is_the_eight_digital_colours(void **state) {
    static const unsigned colours[8] = {0x000000, 0x0000FF, 0xFF0000, 0xFF00FF,
                                        0x00FF00, 0x00FFFF, 0xFFFF00, 0xFFFFFF};
    (void)state;
    for (unsigned i = 0; i < 16; i++) {
        assert_int_equal(levels_of(i), colours[i % 8]);
        assert_int_equal(screen.pixels[i], 0);
    }
}

static void planes_have_the_leftmost_pixel_in_bit_7_and_80_bytes_a_line(void **state) {
    (void)state;
    planes[0][0] = 0x80;     /* blue at 0, 0 */
    planes[1][0] = 0xC0;     /* red at 0, 0 and 1, 0 */
    planes[2][80] = 0x01;    /* green at 7, 1 */
    planes[3][0] = 0x20;     /* intensity at 2, 0 */
    planes[3][31999] = 0x01; /* and at 639, 399 */
    native_screen_from_planes(&screen, planes[0], planes[1], planes[2], planes[3]);
    assert_int_equal(screen.pixels[0], 3);
    assert_int_equal(screen.pixels[1], 2);
    assert_int_equal(screen.pixels[2], 8);
    assert_int_equal(screen.pixels[640 + 7], 4);
    assert_int_equal(screen.pixels[640 * 400 - 1], 8);
    native_screen_from_planes(&screen, planes[0], planes[1], planes[2], NULL);
    assert_int_equal(screen.pixels[2], 0);
    assert_int_equal(screen.pixels[0], 3);
}

static void a_picture_of_16_colours_becomes_a_screen(void **state) {
    (void)state;
    for (unsigned i = 0; i < 15; i++) {
        set_pixel(i * 40, 399, (i + 1) * 0x111111);
    }
    assert_true(native_screen_from_rgb(&screen, rgb, message, sizeof message));
    assert_int_equal(screen.pixels[1], 0);
    for (unsigned i = 0; i < 15; i++) {
        unsigned colour = screen.pixels[399 * 640 + i * 40];
        assert_in_range(colour, 1, 15);
        assert_int_equal(levels_of(colour), (i + 1) * 0x111111);
    }
}

static void a_17th_colour_is_refused_with_its_place(void **state) {
    (void)state;
    for (unsigned i = 0; i < 16; i++) {
        set_pixel(i, 3, i < 15 ? (i + 1) * 0x111111 : 0x110000);
    }
    assert_false(native_screen_from_rgb(&screen, rgb, message, sizeof message));
    assert_non_null(strstr(message, "x=15 y=3"));
    assert_non_null(strstr(message, "16"));
}

static void a_level_that_the_machine_does_not_have_is_refused_with_its_place(void **state) {
    static const unsigned colours[] = {0x100000, 0x001200, 0x0000FE};
    (void)state;
    for (unsigned i = 0; i < 3; i++) {
        clear(NULL);
        set_pixel(639, 399, colours[i]);
        assert_false(native_screen_from_rgb(&screen, rgb, message, sizeof message));
        assert_non_null(strstr(message, "x=639 y=399"));
        assert_non_null(strstr(message, "00, 11, 22"));
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(the_first_palette_is_the_eight_digital_colours, clear),
        cmocka_unit_test_setup(planes_have_the_leftmost_pixel_in_bit_7_and_80_bytes_a_line, clear),
        cmocka_unit_test_setup(a_picture_of_16_colours_becomes_a_screen, clear),
        cmocka_unit_test_setup(a_17th_colour_is_refused_with_its_place, clear),
        cmocka_unit_test_setup(a_level_that_the_machine_does_not_have_is_refused_with_its_place,
                               clear),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
