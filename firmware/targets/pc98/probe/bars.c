/* SPDX-License-Identifier: MIT */
/* Colour bars, and what of the board only an eye can tell. */
#include "bars.h"

#include "outp.h"
#include "registers.h"

enum { START_HIGH = 0x0C, START_LOW = 0x0D, BLOCKS = 2048, BAR_DOTS = 80, RAMP_LINES = 50 };

const struct view views[VIEWS] = {
    {0x01, 0, "E1 mode 01: the bars, and this text on them"},
    {0x03, 0, "E2 mode 03: the bars without this text"},
    {0x02, 0, "E3 mode 02: not known"},
    {0x00, 0, "E4 mode 00: this text without the bars"},
    {0x01, 1, "E5 start 1: the bars one column to the left?"},
    {0x01, 80, "E6 start 80: the bars up by 16 lines, or down?"},
    {0x01, BLOCKS - 80, "E7 start 1968: the bars down by 16 lines, or up?"},
    {0x09, 0, "E8 mode 09: not known; grey bars?"},
};

/* Writes the start address complemented, as the initialisation has it: FFFF is 0. */
void view_show(const struct view *view) {
    controller_write(START_HIGH, (uint8_t) ~(view->start >> 8));
    controller_write(START_LOW, (uint8_t)~view->start);
    outp(MODE, view->mode);
}

static uint32_t colour_at(uint16_t x, uint16_t y) {
    static const uint32_t bars[8] = {0xFFFFFF, 0xFFFF00, 0x00FFFF, 0x00FF00,
                                     0xFF00FF, 0xFF0000, 0x0000FF, 0x000000};
    static const uint32_t ramps[4] = {0x010000, 0x000100, 0x000001, 0x010101};
    if (y < BOARD_HEIGHT / 2) {
        return bars[x / BAR_DOTS];
    }
    return ramps[(y - BOARD_HEIGHT / 2) / RAMP_LINES] * (2U * x / 5);
}

void bars_draw(void) {
    for (uint16_t y = 0; y < BOARD_HEIGHT; y++) {
        for (uint16_t x = 0; x < BOARD_WIDTH; x++) {
            dot_write(x, y, colour_at(x, y));
        }
    }
}
