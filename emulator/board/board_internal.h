/* SPDX-License-Identifier: MIT */
/* Declarations that the board's source files share. */
#ifndef SUPERFRAME_EMULATOR_BOARD_INTERNAL_H
#define SUPERFRAME_EMULATOR_BOARD_INTERNAL_H

#include "board.h"
#include "board_controller.h"

/* Widths of accesses, in bytes. */
enum { BOARD_BYTE = 1, BOARD_WORD = 2, BOARD_TWO_WORDS = 4 };

enum { BOARD_X_MASK = 0x03FF, BOARD_Y_MASK = 0x01FF };

/* Tells whether a port is one of the board's sixteen. */
static inline bool board_decodes(const struct board *board, uint16_t port) {
    return (uint16_t)(port - board->desc.base) < BOARD_PORTS;
}

/* Counts a use of a behaviour. Suffices by itself for behaviours that are no violation in either
 * profile. */
static inline void board_note_use(struct board *board, enum board_behaviour behaviour) {
    struct board_note *entry = &board->notes[behaviour];
    if (entry->count++ == 0) {
        entry->first = board->accesses;
    }
}

/* Tells whether an access to the pixel has nothing to report. One comparison checks both ends of
 * place. */
static inline bool board_pixel_is_plain(const struct board *board) {
    return (uint32_t)board->place < (uint32_t)(BOARD_WIDTH * BOARD_HEIGHT * 3) &&
           !board->is_wrapped;
}

/* Widens the changes by the columns x..end - 1. */
static inline void board_note_columns(struct board *board, unsigned x, unsigned end) {
    if (x < board->changes.left) {
        board->changes.left = (uint16_t)x;
    }
    if (end > board->changes.right) {
        board->changes.right = (uint16_t)end;
    }
}

/* Tells whether the mode steps X: its bit 40h does on the later boards. */
static inline bool board_steps(const struct board *board) {
    return board->desc.profile == BOARD_LATER && (board->mode & BOARD_MODE_STEP) != 0;
}

/* Finds the pixel that X and Y name, and begins the changes anew with that pixel: it may be written
 * next. */
void board_forget_changes(struct board *board);

/* Finds the pixel that X and Y name, so that a pixel write is one store. */
void board_locate(struct board *board);

/* Does any write, also those that board_write() does by itself. */
void board_write_any(struct board *board, uint16_t port, uint32_t value, unsigned width);

#endif
