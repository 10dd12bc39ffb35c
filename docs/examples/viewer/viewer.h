/* SPDX-License-Identifier: MIT */
/* Shows a picture on the SuperFrame board at 00D0h. */
#ifndef VIEWER_H
#define VIEWER_H

#include <stdbool.h>
#include <stdint.h>

/* True if a board of this family answers: red at (0, 0) gives back what is written to it. The pixel
 * has its own value again afterwards. */
bool board_is_present(void);

/* Sets the board up and shows width x height pixels, at most 640 x 400, of R, G, B bytes from the
 * top left, in the middle of a black screen. False, and nothing written, if it is larger or has
 * none. */
bool show_picture(const uint8_t *rgb, unsigned width, unsigned height);

#endif
