/* SPDX-License-Identifier: MIT */
/* What the CRT shows of the board, and of the PC-9801's own screen under it. */
#ifndef SUPERFRAME_EMULATOR_PICTURE_H
#define SUPERFRAME_EMULATOR_PICTURE_H

#include "board.h"
#include "native_screen.h"

#include <stdint.h>

enum {
    PICTURE_WIDTH = BOARD_WIDTH,
    PICTURE_HEIGHT = BOARD_HEIGHT,
    PICTURE_BYTES = PICTURE_WIDTH * PICTURE_HEIGHT * 3 /* 768,000: R, G, B from the top left */
};

/* Whether the board's controller makes a picture. */
enum picture_state {
    PICTURE_OK,
    PICTURE_NOT_INITIALISED, /* not all of the fifteen registers have been written (grade A) */
    PICTURE_WRONG_TIMING     /* the timing registers don't give 640 x 400 */
};

/* What the controller's registers say, for messages. */
struct picture_timing {
    enum picture_state state;
    unsigned width;  /* pixels shown on a line: (01) x 8 */
    unsigned height; /* lines shown: (06) x ((09) + 1) */
};

/* Reads the timing out of the controller's registers (meanings: grade I, strong). */
struct picture_timing picture_timing(const struct board *board);

/* Returns one English phrase for a state, for messages. */
const char *picture_state_text(enum picture_state state);

/* Draws what the CRT shows into rgb. The board's picture is black unless the returned state is
 * PICTURE_OK. native is the PC-9801's own screen; NULL: black.
 *
 * board_draw_over() says what the mode chooses. */
enum picture_state picture_draw(const struct board *board, const struct native_screen *native,
                                uint8_t rgb[PICTURE_BYTES]);

/* Returns the PICTURE_BYTES that picture_draw() would draw, if they lie in the board's memory as
 * they are. The board is then shown, set up and not scrolled, and native is NULL. The pointer is
 * valid until the next port access. Returns NULL if the picture has to be drawn. */
const uint8_t *picture_in_memory(const struct board *board, const struct native_screen *native);

/* Returns the CRC-32 (IEEE 802.3, as in zlib and PNG) of the 768,000 bytes. */
uint32_t picture_crc(const uint8_t rgb[PICTURE_BYTES]);

#endif
