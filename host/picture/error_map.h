/* SPDX-License-Identifier: MIT */
/* A picture of where two pictures differ, and by how much. */
#ifndef SUPERFRAME_DIFFERENCE_PICTURE_H
#define SUPERFRAME_DIFFERENCE_PICTURE_H

#include <stddef.h>
#include <stdint.h>

/* One colour of the scale: a worst channel that is off by `from` LSB or more has it. */
struct difference_step {
    unsigned from;
    uint8_t rgb[3];
    const char *name;
};

enum { DIFFERENCE_STEPS = 6 };

/* Black 0, blue 1, green 2, yellow 4, red 9, white 33. */
extern const struct difference_step difference_steps[DIFFERENCE_STEPS];

/* Writes 3 bytes for each of the pixels; the result may be written over one of the two pictures. */
void difference_picture(const uint8_t *a, const uint8_t *b, size_t pixels, uint8_t *rgb);

#endif
