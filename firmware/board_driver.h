/* SPDX-License-Identifier: MIT */
/* The driver of the SuperFrame board: the only part of the firmware that touches ports. */
#ifndef SUPERFRAME_FIRMWARE_BOARD_H
#define SUPERFRAME_FIRMWARE_BOARD_H

#include <stdbool.h>
#include <stdint.h>

enum { BOARD_WIDTH = 640, BOARD_HEIGHT = 400, BOARD_BASE = 0x00D0 };

/* Initialises the board for 640 x 400 and shows its picture over the PC-9801's (mode 01). The
 * sequence of index and data is the drivers' (grade D). */
void board_start(uint16_t base);

/* Whether a board answers at this address: what is written to red at (0, 0) must come back (grade
 * D). Leaves the frame memory as it was, and X and Y at 0. */
bool board_is_present(uint16_t base);

/* Draws one row of a picture of `width` pixels (R G B each) as `dots` x `dots` dots a pixel, from
 * dot line y * dots. What is right of the picture becomes black. dots: 1 or 2; width * dots: up to
 * 640; y: 0..399 for 1 dot, 0..199 for 2. */
void board_row(uint16_t base, uint16_t y, const uint8_t *rgb, uint16_t width, uint8_t dots);

/* The same for a row of dots in the 8 digital colours: each pixel's R G B are the sets of its
 * 2 x 2 dots that are lit (255, else 0), bit 2 * line + column. width: up to 320; y: 0..199. */
void board_dots(uint16_t base, uint16_t y, const uint8_t *lit, uint16_t width);

/* Makes the dot lines first .. last-1 black; last: up to 400. */
void board_blank(uint16_t base, uint16_t first, uint16_t last);

#endif
