/* SPDX-License-Identifier: MIT */
/* A picture as a PNG in its place. */
#ifndef SUPERFRAME_PNG_OUTPUT_H
#define SUPERFRAME_PNG_OUTPUT_H

#include <stdbool.h>
#include <stdint.h>

#include "base/output.h"

/* Writes width x height pixels of R, G, B to the output and commits that. False, with the reason
 * printed, if it can't be written. The output is closed either way. */
bool png_output(struct output *output, const uint8_t *rgb, unsigned width, unsigned height);

#endif
