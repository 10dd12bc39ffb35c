/* SPDX-License-Identifier: MIT */
/* Colour bars, and what of the board only an eye can tell. */
#ifndef SUPERFRAME_TARGETS_PC98_PROBE_BARS_H
#define SUPERFRAME_TARGETS_PC98_PROBE_BARS_H

#include <stdint.h>

/* Draws eight bars of 80 dots in the upper half, white to black. Below lie red, green, blue and
 * grey, 50 lines each, from 0 at the left to 255 at the right. */
void bars_draw(void);

/* A setting of the board to look at, and what is expected to be seen. */
struct view {
    uint8_t mode;
    uint16_t start; /* the block that is shown first, 0..2047 */
    char expected[60];
};

enum { VIEWS = 8 };
extern const struct view views[VIEWS];

/* Sets the board as a view says. */
void view_show(const struct view *view);

#endif
