/* SPDX-License-Identifier: MIT */
/* The board's registers, and the dots that they reach. */
#ifndef SUPERFRAME_TARGETS_PC98_PROBE_REGISTERS_H
#define SUPERFRAME_TARGETS_PC98_PROBE_REGISTERS_H

#include <stdbool.h>
#include <stdint.h>

#include "board_ports.h"

/* Ports, at the base from the factory. */
enum {
    CONTROL_1 = BOARD_FACTORY_BASE + BOARD_CONTROL_1,
    CONTROL_2 = BOARD_FACTORY_BASE + BOARD_CONTROL_2,
    X_AXIS = BOARD_FACTORY_BASE + BOARD_X,
    Y_AXIS = BOARD_FACTORY_BASE + BOARD_Y,
    RED = BOARD_FACTORY_BASE + BOARD_RED,
    GREEN = BOARD_FACTORY_BASE + BOARD_GREEN,
    BLUE = BOARD_FACTORY_BASE + BOARD_BLUE,
    MODE = BOARD_FACTORY_BASE + BOARD_MODE
};

enum {
    MARKER = 0xA5,     /* a primary that is nowhere else on the screen while a place is sought */
    NOWHERE = 0xFFFFFF /* what dot_find() says of a marker that is on no dot of the screen */
};

/* Selects the dot that the primaries' ports reach: X and Y as words. */
void dot_select(uint16_t x, uint16_t y);

/* Writes a colour, 00RRGGBBh. */
void dot_write(uint16_t x, uint16_t y, uint32_t rgb);

/* Reads a dot's colour, 00RRGGBBh. */
uint32_t dot_read(uint16_t x, uint16_t y);

/* Returns how many of three primaries are not 0. */
uint8_t primaries_lit(uint32_t rgb);

/* Makes the dots of the screen black. */
void screen_clear(void);

/* Looks over the whole screen for a dot with MARKER in red, and sets its red to 0. Returns
 * 00XXXYYYh, three digits each, or NOWHERE. */
uint32_t dot_find(void);

/* Selects a register of the controller, and writes or reads it. */
void controller_write(uint8_t index, uint8_t value);
uint8_t controller_read(uint8_t index);

/* Where experiments with a few dots are made: black when the experiments begin and when they
 * end. */
enum { BENCH_Y = 200, BENCH_X = 64 };

/* bench_prepare() draws eight dots of the colour 112233h from BENCH_X - 2 on. bench_changes()
 * returns what changed of those dots since. A bit stands for each dot, the leftmost highest; the
 * bytes are red, green, blue from the highest down. */
enum { BENCH_COLOUR = 0x112233 };
void bench_prepare(void);
uint32_t bench_changes(void);

/* Makes the dots of the bench, and some on either side, black. */
void bench_clear(void);

#endif
