/* SPDX-License-Identifier: MIT */
/* The board's registers, and the dots that they reach. */
#include "registers.h"

#include "outp.h"

void dot_select(uint16_t x, uint16_t y) {
    outpw(X_AXIS, x);
    outpw(Y_AXIS, y);
}

void dot_write(uint16_t x, uint16_t y, uint32_t rgb) {
    dot_select(x, y);
    outp(RED, (uint8_t)(rgb >> 16));
    outp(GREEN, (uint8_t)(rgb >> 8));
    outp(BLUE, (uint8_t)rgb);
}

uint32_t dot_read(uint16_t x, uint16_t y) {
    dot_select(x, y);
    uint32_t red = inp(RED);
    uint32_t green = inp(GREEN);
    return red << 16 | green << 8 | inp(BLUE);
}

uint8_t primaries_lit(uint32_t rgb) {
    return (uint8_t)((rgb >> 16 != 0) + ((rgb & 0xFF00) != 0) + ((rgb & 0xFF) != 0));
}

/* Goes over the whole screen, as dot_find() does: Y is set once a row. */
void screen_clear(void) {
    for (uint16_t y = 0; y < BOARD_HEIGHT; y++) {
        outpw(Y_AXIS, y);
        for (uint16_t x = 0; x < BOARD_WIDTH; x++) {
            outpw(X_AXIS, x);
            outp(RED, 0);
            outp(GREEN, 0);
            outp(BLUE, 0);
        }
    }
}

uint32_t dot_find(void) {
    for (uint16_t y = 0; y < BOARD_HEIGHT; y++) {
        outpw(Y_AXIS, y);
        for (uint16_t x = 0; x < BOARD_WIDTH; x++) {
            outpw(X_AXIS, x);
            if (inp(RED) == MARKER) {
                outp(RED, 0);
                return (uint32_t)x << 12 | y;
            }
        }
    }
    return NOWHERE;
}

void controller_write(uint8_t index, uint8_t value) {
    outp(CONTROL_1, index);
    outp(CONTROL_2, value);
}

uint8_t controller_read(uint8_t index) {
    outp(CONTROL_1, index);
    return inp(CONTROL_2);
}

enum { WINDOW = 8, WINDOW_X = BENCH_X - 2 };

void bench_prepare(void) {
    for (uint16_t i = 0; i < WINDOW; i++) {
        dot_write(WINDOW_X + i, BENCH_Y, BENCH_COLOUR);
    }
}

uint32_t bench_changes(void) {
    uint32_t changes = 0;
    for (uint16_t i = 0; i < WINDOW; i++) {
        uint32_t differs = dot_read(WINDOW_X + i, BENCH_Y) ^ BENCH_COLOUR;
        uint32_t here = (differs >> 16 != 0 ? UINT32_C(0x10000) : 0) |
                        ((differs & 0xFF00) != 0 ? UINT32_C(0x100) : 0) |
                        ((differs & 0xFF) != 0 ? 1 : 0);
        changes = changes << 1 | here;
    }
    return changes;
}

void bench_clear(void) {
    for (uint16_t x = BENCH_X - 8; x < BENCH_X + 16; x++) {
        dot_write(x, BENCH_Y, 0);
    }
}
