/* SPDX-License-Identifier: MIT */
/* The writes of a picture, X and three primaries a pixel, done without a further call. */
#include "board.h"

#include "board_internal.h"

/* Both functions below do what board_write_any() would do. Where board_write_any() has more to do,
 * they do nothing and return false. The short path has a file of its own. A compiler that sees both
 * paths makes room for the long path in the short one. */

static inline bool put_primary(struct board *board, unsigned offset, uint16_t value) {
    if (!board_pixel_is_plain(board) || board->is_stepping) {
        return false;
    }
    board->accesses++;
    board->writes[offset][BOARD_BYTE - 1]++;
    board_note_use(board, BOARD_PRIMARY_WRITE);
    board->changes.is_written = true;
    board->memory[(uint32_t)board->place + offset / 2 - BOARD_RED / 2] = (uint8_t)value;
    return true;
}

static inline bool put_x(struct board *board, unsigned offset, uint16_t x) {
    if (x >= BOARD_WIDTH || board->y >= BOARD_HEIGHT) {
        return false;
    }
    board->accesses++;
    board->writes[offset][BOARD_WORD - 1]++;
    board_note_use(board, BOARD_POSITION_WRITE);
    board_note_columns(board, x, x + 1U);
    board->x = x;
    board->is_wrapped = false;
    board->place = (int32_t)((board->y * (uint32_t)BOARD_WIDTH + x) * 3);
    return true;
}

void board_write(struct board *board, uint16_t port, uint32_t value, unsigned width) {
    unsigned offset = (uint16_t)(port - board->desc.base);
    bool is_primary = offset == BOARD_RED || offset == BOARD_GREEN || offset == BOARD_BLUE;
    bool is_done =
        (is_primary && width == BOARD_BYTE && put_primary(board, offset, (uint16_t)value)) ||
        (offset == BOARD_X && width == BOARD_WORD && put_x(board, offset, (uint16_t)value));
    if (!is_done) {
        board_write_any(board, port, value, width);
    }
}
