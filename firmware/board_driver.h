/* SPDX-License-Identifier: MIT */
/* The driver of the SuperFrame board: the only part of the firmware that touches ports. */
#ifndef SUPERFRAME_FIRMWARE_BOARD_H
#define SUPERFRAME_FIRMWARE_BOARD_H

#include <stdbool.h>
#include <stdint.h>

/* Initialises the board for 640 x 400 and shows its picture over the PC-9801's (mode 01). The
 * sequence of index and data is the drivers' (grade D). */
void board_start(uint16_t base);

/* Tells whether a board answers at an address: what is written to red at (0, 0) must come back
 * (grade D). Leaves the frame memory as it was, and X and Y at 0. */
bool board_is_present(uint16_t base);

/* Draws one row of a picture of `width` pixels (R G B each), from dot line y * dots. Each pixel
 * becomes `dots` x `dots` dots. What is right of the picture becomes black. dots: 1 or 2; width *
 * dots: up to 640; y: 0..399 for 1 dot, 0..199 for 2. */
void board_row(uint16_t base, uint16_t y, const uint8_t *rgb, uint16_t width, uint8_t dots);

/* Draws one row of a picture in the 8 digital colours, with 2 x 2 dots a pixel. The row begins at
 * dot line 2 * y. Each pixel's R G B are the sets of its dots that are lit, bit 2 * line + column.
 * A lit dot has level 255, the others 0. What is right of the picture becomes black. width: up to
 * 320; y: 0..199. */
void board_dots(uint16_t base, uint16_t y, const uint8_t *lit, uint16_t width);

/* Makes the dot lines first .. last-1 black; last: up to 400. */
void board_blank(uint16_t base, uint16_t first, uint16_t last);

#endif
