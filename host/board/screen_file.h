/* SPDX-License-Identifier: MIT */
/* PNG files into and out of the emulated board: the PC's own screen, and the three pictures. */
#ifndef SUPERFRAME_BOARD_PICTURE_H
#define SUPERFRAME_BOARD_PICTURE_H

#include <stdbool.h>

#include "base/output.h"
#include "board.h"
#include "board/options.h"
#include "native_screen.h"

/* Reads the PC-9801's own screen from a PNG of 640 x 400 pixels. False, with the reason and what is
 * allowed printed, if the file can't be read or can't be such a screen. */
bool native_read(struct native_screen *native, const char *path);

/* Writes a picture of the board to the output and commits the output. native may be NULL: black. A
 * screen that is black because the board was not set up is written as well, with the reason on
 * standard error. False, with the reason printed, on failure; then discard the output. */
bool board_picture_write(struct output *output, const struct board *board,
                         const struct native_screen *native, enum picture_kind kind);

#endif
