/* SPDX-License-Identifier: MIT */
/* What the board's source files and the picture share: the controller's known registers. */
#ifndef SUPERFRAME_EMULATOR_BOARD_INTERNAL_H
#define SUPERFRAME_EMULATOR_BOARD_INTERNAL_H

#include "board.h"

/* Bits of the mode register that have a meaning here. 08h (GRAYMODE) and 80h (STEALWR) have a
 * name and no known effect. */
enum { BOARD_MODE_SHOWN = 0x01, BOARD_MODE_PC_OFF = 0x02, BOARD_MODE_STEP = 0x40 };

/* Registers of the CRT controller that the model reads, by index. */
enum {
    CONTROLLER_COLUMNS = 0x01,   /* characters shown on a line, of 8 pixels */
    CONTROLLER_ROWS = 0x06,      /* rows of characters shown */
    CONTROLLER_LAST_LINE = 0x09, /* lines of a row, minus 1 */
    CONTROLLER_START_HIGH = 0x0C,
    CONTROLLER_START_LOW = 0x0D
};

/* True for the fifteen indices that the drivers' initialisation writes (grade D). */
static inline bool board_index_is_initialised(unsigned index) {
    const uint32_t initialised =
        0x000003FFU | 1U << 0x0C | 1U << 0x0D | 1U << 0x1B | 1U << 0x1E | 1U << 0x1F;
    return index < 32 && (initialised >> index & 1U) != 0;
}

/* True for the two halves of the display start address. */
static inline bool board_index_is_start_address(unsigned index) {
    return index == CONTROLLER_START_HIGH || index == CONTROLLER_START_LOW;
}

/* True if a port is one of the board's sixteen. */
static inline bool board_decodes(const struct board *board, uint16_t port) {
    return (uint16_t)(port - board->desc.base) < BOARD_PORTS;
}

/* True for the widths that a 16-bit bus has. */
static inline bool board_width_is_there(unsigned width) {
    return width == BUS_BYTE || width == BUS_WORD;
}

/* Counts a use of a behaviour; for those that are no violation in either profile. */
static inline void board_note_use(struct board *board, enum board_behaviour behaviour) {
    struct board_note *entry = &board->notes[behaviour];
    if (entry->count++ == 0) {
        entry->first = board->accesses;
    }
}

/* True where an access to the pixel has nothing to report: in one comparison. */
static inline bool board_pixel_is_plain(const struct board *board) {
    return (uint32_t)board->place < (uint32_t)(BOARD_WIDTH * BOARD_HEIGHT * 3) &&
           !board->is_wrapped;
}

/* board_write() for every write, those included that it does itself. */
void board_write_any(struct board *board, uint16_t port, uint16_t value, unsigned width);

#endif
