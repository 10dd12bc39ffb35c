/* SPDX-License-Identifier: MIT */
/* What the CRT shows as a PNG in its place. */
#ifndef SUPERFRAME_SCREEN_OUTPUT_H
#define SUPERFRAME_SCREEN_OUTPUT_H

#include <stdbool.h>
#include <stdint.h>

#include "output.h"
#include "port_chain.h"

/* Writes 640 x 400 pixels of R, G, B to the output and commits that. False, with the reason
 * printed, if it can't be written; the output is then still to be discarded. */
bool picture_write(struct output *output, const uint8_t rgb[PICTURE_BYTES]);

/* Draws the chain's picture, writes it to the output and commits that. A picture that is black
 * because the board was not set up is written as well, with a word on standard error. False, with
 * the reason printed, if it can't be written; the output is then still to be discarded. */
bool screen_write(struct output *output, struct port_chain *chain);

#endif
