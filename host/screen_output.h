/* SPDX-License-Identifier: MIT */
/* What the CRT shows as a PNG in its place. */
#ifndef SUPERFRAME_SCREEN_OUTPUT_H
#define SUPERFRAME_SCREEN_OUTPUT_H

#include <stdbool.h>
#include <stdint.h>

#include "output.h"
#include "picture.h"

/* Writes 640 x 400 pixels of R, G, B to the output and commits that. False, with the reason
 * printed, if it can't be written; the output is then still to be discarded. */
bool picture_write(struct output *output, const uint8_t rgb[PICTURE_BYTES]);

#endif
