/* SPDX-License-Identifier: MIT */
/* The board draws over the PC-9801's own picture on the CRT, by screen, line or rectangle. */
#ifndef SUPERFRAME_EMULATOR_BOARD_SCREEN_H
#define SUPERFRAME_EMULATOR_BOARD_SCREEN_H

#include "board.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* A rectangle of the screen, in dots. A width or a height of 0: nothing. */
struct board_area {
    unsigned x, y, width, height;
};

/* Holds what the controller's registers say (meanings: grade I, strong). */
struct board_timing {
    bool is_initialised; /* all of the fifteen registers have been written (grade A) */
    unsigned width;      /* dots shown on a line: (01) x 8 */
    unsigned height;     /* lines shown: (06) x ((09) + 1) */
};

/* Reads the timing out of the controller's registers. */
struct board_timing board_read_timing(const struct board *board);

/* Tells whether the controller makes a picture: it has been initialised, and gives 640 x 400. */
bool board_makes_picture(const struct board *board);

/* Draws the board's picture over the PC-9801's. On entry rgb holds the PC-9801's picture: 640 x 400
 * pixels of R, G and B, 0..255 each, from the top left. On return rgb holds what the CRT shows.
 *
 * Mode bits 1-0: with 00 and 10, the PC's picture stays (grade D; 10: A). With 01, the board shows
 * where the PC's picture is black (grade I, weak). With 11, the board shows everywhere (grade D). A
 * board whose controller makes no picture is black. The later profile scrolls by the display start
 * address, blocks counted modulo 2048 (grade A). */
void board_draw_over(const struct board *board, uint8_t rgb[BOARD_WIDTH * BOARD_HEIGHT * 3]);

/* Does the same for line y, 0..399; of another line nothing is drawn. */
void board_draw_over_line(const struct board *board, unsigned y, uint8_t rgb[BOARD_WIDTH * 3]);

/* Does the same for a rectangle. rgb is the pixel at its top left, and pitch the bytes from a line
 * of rgb to the next. Of what lies outside the screen nothing is drawn. */
void board_draw_over_area(const struct board *board, struct board_area area, uint8_t *rgb,
                          size_t pitch);

/* Returns a rectangle that holds whatever board_draw_over() draws in another way than at the last
 * call, and begins anew. Where pixels were written, the rectangle holds each place that X and Y
 * have named. At first, and after mode, controller or a restored state have changed, it is the
 * screen. */
struct board_area board_take_changes(struct board *board);

/* Returns the screen's 768,000 bytes of R, G and B, if they lie in the board's memory as they are.
 * The board is then shown, set up and not scrolled, and the PC's picture is not shown or black. The
 * pointer is valid until the next port access. Returns NULL if the picture has to be drawn. */
const uint8_t *board_screen_in_memory(const struct board *board);

#endif
