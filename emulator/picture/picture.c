/* SPDX-License-Identifier: MIT */
/* The CRT shows the PC's own screen, and the board's picture over it. */
#include "picture.h"

#include "board_screen.h"

#include <libdeflate.h>
#include <string.h>

struct picture_timing picture_timing(const struct board *board) {
    struct board_timing registers = board_read_timing(board);
    struct picture_timing timing = {PICTURE_OK, registers.width, registers.height};
    if (!registers.is_initialised) {
        timing.state = PICTURE_NOT_INITIALISED;
    } else if (!board_makes_picture(board)) {
        timing.state = PICTURE_WRONG_TIMING;
    }
    return timing;
}

const char *picture_state_text(enum picture_state state) {
    switch (state) {
    case PICTURE_OK:
        return "the controller shows 640 x 400";
    case PICTURE_NOT_INITIALISED:
        return "the controller has not been initialised, so the board shows nothing";
    case PICTURE_WRONG_TIMING:
        return "the timing registers don't give 640 x 400, so the board shows nothing";
    }
    return "unknown state";
}

/* Draws the PC's own screen. */
static void draw_native(const struct native_screen *native, uint8_t *rgb) {
    uint8_t levels[NATIVE_COLOURS][3];
    for (unsigned colour = 0; colour < NATIVE_COLOURS; colour++) {
        native_colour_levels(native, colour, levels[colour]);
    }
    for (size_t i = 0; i < (size_t)PICTURE_WIDTH * PICTURE_HEIGHT; i++) {
        memcpy(rgb + i * 3, levels[native->pixels[i] & (NATIVE_COLOURS - 1U)], 3);
    }
}

enum picture_state picture_draw(const struct board *board, const struct native_screen *native,
                                uint8_t rgb[PICTURE_BYTES]) {
    if (native != NULL) {
        draw_native(native, rgb);
    } else {
        memset(rgb, 0, PICTURE_BYTES);
    }
    board_draw_over(board, rgb);
    return picture_timing(board).state;
}

const uint8_t *picture_in_memory(const struct board *board, const struct native_screen *native) {
    return native == NULL ? board_screen_in_memory(board) : NULL;
}

uint32_t picture_crc(const uint8_t rgb[PICTURE_BYTES]) {
    return libdeflate_crc32(0, rgb, PICTURE_BYTES);
}
