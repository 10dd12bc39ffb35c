/* SPDX-License-Identifier: MIT */
/* Declarations that the board's source files share. */
#ifndef SUPERFRAME_EMULATOR_BOARD_INTERNAL_H
#define SUPERFRAME_EMULATOR_BOARD_INTERNAL_H

#include "board.h"
#include "board_controller.h"

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

/* Does any write, also those that board_write() does by itself. */
void board_write_any(struct board *board, uint16_t port, uint32_t value, unsigned width);

#endif
