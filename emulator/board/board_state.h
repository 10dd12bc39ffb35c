/* SPDX-License-Identifier: MIT */
/* The board's state as bytes, for an emulator's save states. The form is the same on every machine;
 * docs/emulators.md has the layout. */
#ifndef SUPERFRAME_EMULATOR_BOARD_STATE_H
#define SUPERFRAME_EMULATOR_BOARD_STATE_H

#include "board.h"

#include <stddef.h>
#include <stdint.h>

enum {
    BOARD_STATE_VERSION = 1,
    BOARD_STATE_BYTES = 801233 /* a whole state, with its checksum */
};

/* Names what is wrong with a state. Whatever comes first in the list is told first. */
enum board_state_status {
    BOARD_STATE_OK,
    BOARD_STATE_FOREIGN, /* no state of the board, or not even its first bytes */
    BOARD_STATE_WRONG_VERSION,
    BOARD_STATE_WRONG_LENGTH, /* cut off, or followed by other bytes */
    BOARD_STATE_DAMAGED,      /* the checksum is wrong */
    BOARD_STATE_IMPOSSIBLE /* the checksum is right, and a value that no board can have is there */
};

/* Writes the whole state: registers, frame memory, counters, log and the desc. Equal boards give
 * equal bytes. */
void board_save(const struct board *board, uint8_t bytes[BOARD_STATE_BYTES]);

/* Makes the board what it was when the `count` bytes were saved. Whatever is checked is checked
 * before the board changes: unless BOARD_STATE_OK is returned, the board is as it was. The board
 * needs no board_init() before. bytes may be NULL if count is 0. After success,
 * board_take_changes() gives the whole screen. */
enum board_state_status board_restore(struct board *board, const uint8_t *bytes, size_t count);

/* Returns one English phrase for a status, for messages. */
const char *board_state_text(enum board_state_status status);

#endif
