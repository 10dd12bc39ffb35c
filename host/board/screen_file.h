/* SPDX-License-Identifier: MIT */
/* Pictures into and out of the emulated board: the PC's own screen, and what is shown of it. */
#ifndef SUPERFRAME_SCREEN_FILE_H
#define SUPERFRAME_SCREEN_FILE_H

#include <stdbool.h>
#include <stdint.h>

#include "board.h"
#include "board/options.h"
#include "native_screen.h"
#include "picture.h"
#include "picture/sink.h"

/* Reads the PC-9801's own screen from a PNG of 640 x 400 pixels. False, with the reason and what is
 * allowed printed, if the file can't be read or can't be such a screen. */
bool native_read(struct native_screen *native, const char *path);

/* Returns a picture of the board as it is now. native may be NULL: black. A screen that does not
 * lie in the board's memory as it is gets drawn into rgb. The picture holds until the next access.
 */
struct shown_picture board_picture(const struct board *board, const struct native_screen *native,
                                   enum picture_kind kind, uint8_t rgb[PICTURE_BYTES]);

/* Shows a picture of the board, as board_picture() returns it, and commits the sink. A screen that
 * is black because the board was not set up is reported on standard error. False, with the reason
 * printed, on failure. */
bool board_picture_finish(struct picture_sink *sink, const struct board *board,
                          const struct native_screen *native, enum picture_kind kind,
                          uint8_t rgb[PICTURE_BYTES]);

#endif
