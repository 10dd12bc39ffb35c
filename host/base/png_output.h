/* SPDX-License-Identifier: MIT */
/* Writes a picture as a PNG and puts the file into its place. */
#ifndef SUPERFRAME_PNG_OUTPUT_H
#define SUPERFRAME_PNG_OUTPUT_H

#include <stdbool.h>
#include <stdint.h>

#include "base/output.h"

/* Writes width x height pixels of R, G, B to the output and commits that. False, with the reason
 * printed, if the picture can't be written. The output is closed either way. */
bool png_output(struct output *output, const uint8_t *rgb, unsigned width, unsigned height);

#endif
