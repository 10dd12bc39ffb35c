/* SPDX-License-Identifier: MIT */
/* The controller's timing, the scroll, and the mode's three pictures. */
#include "board_screen.h"

#include "board_internal.h"

#include <string.h>

struct board_timing board_read_timing(const struct board *board) {
    const uint8_t *registers = board->controller;
    struct board_timing timing = {true, 0, 0};
    for (unsigned index = 0; index < 32; index++) {
        if (board_index_is_initialised(index) && board->controller_written[index] == 0) {
            timing.is_initialised = false;
        }
    }
    timing.width = registers[CONTROLLER_COLUMNS] * (unsigned)BOARD_BLOCK_WIDTH;
    timing.height = registers[CONTROLLER_ROWS] * (registers[CONTROLLER_LAST_LINE] + 1U);
    return timing;
}

bool board_makes_picture(const struct board *board) {
    struct board_timing timing = board_read_timing(board);
    return timing.is_initialised && timing.width == BOARD_WIDTH && timing.height == BOARD_HEIGHT;
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

/* ---- Pixels --------------------------------------------------------------------------------- */

static bool is_shown(const struct board *board) {
    return (board->mode & BOARD_MODE_SHOWN) != 0;
}

/* Returns the board's pixel at a dot of the screen. The controller walks the memory from the start
 * address on, 80 blocks a row. */
static const uint8_t *shown_pixel(const struct board *board, unsigned start, unsigned x,
                                  unsigned y) {
    unsigned row = start + y / BOARD_BLOCK_HEIGHT * BOARD_BLOCKS_ON_A_ROW;
    unsigned block = (row + x / BOARD_BLOCK_WIDTH) % BOARD_BLOCKS;
    size_t memory_y = block / BOARD_BLOCKS_ON_A_ROW * BOARD_BLOCK_HEIGHT + y % BOARD_BLOCK_HEIGHT;
    size_t memory_x = block % BOARD_BLOCKS_ON_A_ROW * BOARD_BLOCK_WIDTH + x % BOARD_BLOCK_WIDTH;
    return board->memory + (memory_y * BOARD_WIDTH + memory_x) * 3;
}

/* Draws over the pixels x..end - 1 of a line. A block's eight pixels lie side by side in memory. */
static void draw_over_pixels(const struct board *board, unsigned x, unsigned end, unsigned y,
                             uint8_t *pixel) {
    static const uint8_t black[3] = {0, 0, 0};
    bool has_picture = board_makes_picture(board);
    bool hides_pc = (board->mode & BOARD_MODE_PC_OFF) != 0;
    unsigned start = start_block(board);
    const uint8_t *source = black;
    for (bool is_first = true; x < end; x++, pixel += 3, is_first = false) {
        if (has_picture && (is_first || x % BOARD_BLOCK_WIDTH == 0)) {
            source = shown_pixel(board, start, x, y);
        }
        if (hides_pc || (pixel[0] | pixel[1] | pixel[2]) == 0) {
            memcpy(pixel, source, 3);
        }
        source += has_picture ? 3 : 0;
    }
}

void board_draw_over_area(const struct board *board, struct board_area area, uint8_t *rgb,
                          size_t pitch) {
    if (!is_shown(board) || area.x >= BOARD_WIDTH || area.y >= BOARD_HEIGHT) {
        return;
    }
    unsigned width = area.width < BOARD_WIDTH - area.x ? area.width : BOARD_WIDTH - area.x;
    unsigned height = area.height < BOARD_HEIGHT - area.y ? area.height : BOARD_HEIGHT - area.y;
    for (unsigned line = 0; line < height; line++) {
        draw_over_pixels(board, area.x, area.x + width, area.y + line, rgb + line * pitch);
    }
}

void board_draw_over_line(const struct board *board, unsigned y, uint8_t rgb[BOARD_WIDTH * 3]) {
    struct board_area area = {0, y, BOARD_WIDTH, 1};
    board_draw_over_area(board, area, rgb, 0);
}

void board_draw_over(const struct board *board, uint8_t rgb[BOARD_WIDTH * BOARD_HEIGHT * 3]) {
    struct board_area screen = {0, 0, BOARD_WIDTH, BOARD_HEIGHT};
    board_draw_over_area(board, screen, rgb, BOARD_WIDTH * 3);
}

const uint8_t *board_screen_in_memory(const struct board *board) {
    bool is_plain = is_shown(board) && board_makes_picture(board) && start_block(board) == 0;
    return is_plain ? board->memory : NULL;
}

/* ---- Changes -------------------------------------------------------------------------------- */

struct board_area board_take_changes(struct board *board) {
    struct board_area area = {0, 0, BOARD_WIDTH, BOARD_HEIGHT};
    struct board_changes changes = board->changes;
    bool is_any = changes.is_written && is_shown(board);
    board_forget_changes(board);
    if (changes.is_all || (is_any && start_block(board) != 0)) {
        return area;
    }
    unsigned bottom = changes.bottom;
    if (bottom > BOARD_HEIGHT) {
        bottom = BOARD_HEIGHT;
    }
    if (!is_any || changes.top >= bottom) {
        area.width = 0;
        area.height = 0;
        return area;
    }
    area.x = changes.left;
    area.y = changes.top;
    area.width = (unsigned)changes.right - changes.left;
    area.height = bottom - changes.top;
    return area;
}
