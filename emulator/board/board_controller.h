/* SPDX-License-Identifier: MIT */
/* The known bits of the mode register, and the known registers of the CRT controller. */
#ifndef SUPERFRAME_BOARD_CONTROLLER_H
#define SUPERFRAME_BOARD_CONTROLLER_H

#include <stdbool.h>
#include <stdint.h>

#include "board_ports.h"

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

/* Tells whether an index is one of the fifteen that the drivers' initialisation writes (grade
 * D). */
static inline bool board_index_is_initialised(unsigned index) {
#define INDEX_BIT(index, data) | UINT32_C(1) << (index)
    const uint32_t initialised = 0 BOARD_INITIALISATION(INDEX_BIT);
    return index < 32 && (initialised >> index & 1U) != 0;
}

/* Tells whether an index is one of the two halves of the display start address. */
static inline bool board_index_is_start_address(unsigned index) {
    return index == CONTROLLER_START_HIGH || index == CONTROLLER_START_LOW;
}

#endif
