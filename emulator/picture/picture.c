/* SPDX-License-Identifier: MIT */
/* What the CRT shows: the controller's timing, the scroll and the mode's three pictures. */
#include "picture.h"

#include "board_controller.h"

#include <libdeflate.h>
#include <stdbool.h>
#include <string.h>

static bool is_initialised(const struct board *board) {
    for (unsigned index = 0; index < 32; index++) {
        if (board_index_is_initialised(index) && board->controller_written[index] == 0) {
            return false;
        }
    }
    return true;
}

struct picture_timing picture_timing(const struct board *board) {
    const uint8_t *registers = board->controller;
    struct picture_timing timing = {PICTURE_OK, 0, 0};
    timing.width = registers[CONTROLLER_COLUMNS] * (unsigned)BOARD_BLOCK_WIDTH;
    timing.height = registers[CONTROLLER_ROWS] * (registers[CONTROLLER_LAST_LINE] + 1U);
    if (!is_initialised(board)) {
        timing.state = PICTURE_NOT_INITIALISED;
    } else if (timing.width != PICTURE_WIDTH || timing.height != PICTURE_HEIGHT) {
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

/* Returns the number of the block at the top left, 0..2047. */
static unsigned start_block(const struct board *board) {
    if (board->desc.profile == BOARD_1987) {
        return 0;
    }
    unsigned high = board->controller[CONTROLLER_START_HIGH];
    unsigned low = board->controller[CONTROLLER_START_LOW];
    return ~(high << 8 | low) & (BOARD_BLOCKS - 1U);
}

/* Draws one line of the frame memory as the controller walks the memory: 80 blocks from the start
 * address on. */
static void draw_board_line(const struct board *board, unsigned start, unsigned y, uint8_t *line) {
    const size_t block_bytes = BOARD_BLOCK_WIDTH * 3;
    unsigned first = start + y / BOARD_BLOCK_HEIGHT * BOARD_BLOCKS_ON_A_ROW;
    for (unsigned column = 0; column < BOARD_BLOCKS_ON_A_ROW; column++) {
        unsigned block = (first + column) % BOARD_BLOCKS;
        size_t memory_y =
            block / BOARD_BLOCKS_ON_A_ROW * BOARD_BLOCK_HEIGHT + y % BOARD_BLOCK_HEIGHT;
        size_t memory_x = block % BOARD_BLOCKS_ON_A_ROW * BOARD_BLOCK_WIDTH;
        memcpy(line + column * block_bytes, board->memory + (memory_y * BOARD_WIDTH + memory_x) * 3,
               block_bytes);
    }
}

static void draw_board(const struct board *board, uint8_t *rgb) {
    unsigned start = start_block(board);
    if (start == 0) {
        memcpy(rgb, board->memory, PICTURE_BYTES);
        return;
    }
    for (unsigned y = 0; y < PICTURE_HEIGHT; y++) {
        draw_board_line(board, start, y, rgb + (size_t)y * PICTURE_WIDTH * 3);
    }
}

/* Lays the PC's screen over rgb. Where that screen is black, what is there stays. */
static void draw_native(const struct native_screen *native, uint8_t *rgb) {
    uint8_t levels[NATIVE_COLOURS][3];
    for (unsigned colour = 0; colour < NATIVE_COLOURS; colour++) {
        native_colour_levels(native, colour, levels[colour]);
    }
    for (size_t i = 0; i < (size_t)PICTURE_WIDTH * PICTURE_HEIGHT; i++) {
        unsigned colour = native->pixels[i] & (NATIVE_COLOURS - 1U);
        if (native->palette[colour] != 0) {
            memcpy(rgb + i * 3, levels[colour], 3);
        }
    }
}

enum picture_state picture_draw(const struct board *board, const struct native_screen *native,
                                uint8_t rgb[PICTURE_BYTES]) {
    enum picture_state state = picture_timing(board).state;
    bool shows_board = (board->mode & BOARD_MODE_SHOWN) != 0;
    bool shows_native = !shows_board || (board->mode & BOARD_MODE_PC_OFF) == 0;
    memset(rgb, 0, PICTURE_BYTES);
    if (shows_board && state == PICTURE_OK) {
        draw_board(board, rgb);
    }
    if (shows_native && native != NULL) {
        draw_native(native, rgb);
    }
    return state;
}

const uint8_t *picture_in_memory(const struct board *board, const struct native_screen *native) {
    bool is_plain = (board->mode & BOARD_MODE_SHOWN) != 0 && native == NULL &&
                    picture_timing(board).state == PICTURE_OK && start_block(board) == 0;
    return is_plain ? board->memory : NULL;
}

uint32_t picture_crc(const uint8_t rgb[PICTURE_BYTES]) {
    return libdeflate_crc32(0, rgb, PICTURE_BYTES);
}
