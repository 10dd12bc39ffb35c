/* SPDX-License-Identifier: MIT */
/* Colour bars, and what of the board only an eye can tell. */
#ifndef SUPERFRAME_TARGETS_PC98_PROBE_BARS_H
#define SUPERFRAME_TARGETS_PC98_PROBE_BARS_H

#include <stdint.h>

/* Eight bars of 80 dots in the upper half, white to black; below them red, green, blue and grey
 * from 0 at the left to 255 at the right, 50 lines each. */
void bars_draw(void);

/* A setting of the board to look at, and what is expected to be seen. */
struct view {
    uint8_t mode;
    uint8_t start; /* data of index 0Dh */
    char expected[60];
};

enum { VIEWS = 6 };
extern const struct view views[VIEWS];

/* Sets the board so. */
void view_show(const struct view *view);

#endif
