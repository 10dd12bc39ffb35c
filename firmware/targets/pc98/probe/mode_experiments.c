/* SPDX-License-Identifier: MIT */
/* Experiments with the bits of the mode register that drivers do not use. */
#include "experiments.h"
#include "outp.h"
#include "registers.h"

enum { MODE_STEP = 0x40, MODE_STEAL = 0x80 };

/* Finds by a marker how far X has gone: one write of red goes to where X points by then. Returns
 * FFh if the marker is not in the next 15 dots. */
static uint32_t steps_since(void) {
    uint32_t steps = 0xFF;
    outp(RED, MARKER);
    outp(MODE, BOARD_MODE_BOTH);
    for (uint16_t i = 0; i < 16; i++) {
        dot_select(BENCH_X + i, BENCH_Y);
        if (inp(RED) == MARKER) {
            steps = i;
        }
        outp(RED, 0);
    }
    return steps;
}

static void stepping_begin(void) {
    outp(MODE, MODE_STEP | BOARD_MODE_BOTH);
    dot_select(BENCH_X, BENCH_Y);
}

/* Returns the steps after a write of each primary, a byte each, red first. */
uint32_t steps_after_writes(void) {
    uint32_t steps = 0;
    for (uint16_t port = RED; port <= BLUE; port += 2) {
        stepping_begin();
        outp(port, 0);
        steps = steps << 8 | steps_since();
    }
    return steps;
}

uint32_t steps_after_reads(void) {
    uint32_t steps = 0;
    for (uint16_t port = RED; port <= BLUE; port += 2) {
        stepping_begin();
        (void)inp(port);
        steps = steps << 8 | steps_since();
    }
    return steps;
}

/* Checks whether the odd port of mode is taken for the mode: X then steps. */
uint32_t steps_after_odd_mode(void) {
    outp(MODE, BOARD_MODE_BOTH);
    outp(MODE + 1, MODE_STEP | BOARD_MODE_BOTH);
    dot_select(BENCH_X, BENCH_Y);
    outp(BLUE, 0);
    return steps_since();
}

/* Writes and reads a dot with the bit set. Returns the dot's colour, then how many of its primaries
 * differ without the bit. */
static uint32_t with_mode_bit(uint8_t bit) {
    outp(MODE, bit | BOARD_MODE_BOTH);
    dot_write(BENCH_X, BENCH_Y, BENCH_COLOUR);
    uint32_t with = dot_read(BENCH_X, BENCH_Y);
    outp(MODE, BOARD_MODE_BOTH);
    uint32_t differs = primaries_lit(dot_read(BENCH_X, BENCH_Y) ^ with);
    dot_write(BENCH_X, BENCH_Y, 0);
    return with << 8 | differs;
}

uint32_t mode_bit_04(void) {
    return with_mode_bit(0x04);
}

uint32_t mode_bit_08(void) {
    return with_mode_bit(0x08);
}

uint32_t mode_bit_10(void) {
    return with_mode_bit(0x10);
}

uint32_t mode_bit_20(void) {
    return with_mode_bit(0x20);
}

uint32_t mode_bit_80(void) {
    return with_mode_bit(MODE_STEAL);
}

/* Lights eight dots of the PC-9801's own blue plane with STEALWR set. The bit may mean that the
 * board takes the writes to that graphics memory. Returns the board's colour of the first of the
 * dots, then what a read of the plane gives. */
uint32_t steal(void) {
    volatile uint8_t *plane = (volatile uint8_t *)(UINT32_C(0xA8000) + 80 * BENCH_Y + BENCH_X / 8);
    dot_write(BENCH_X, BENCH_Y, BENCH_COLOUR);
    outp(MODE, MODE_STEAL | BOARD_MODE_BOTH);
    *plane = 0xFF;
    uint32_t kept = *plane;
    outp(MODE, BOARD_MODE_BOTH);
    uint32_t rgb = dot_read(BENCH_X, BENCH_Y);
    *plane = 0x00;
    dot_write(BENCH_X, BENCH_Y, 0);
    return rgb << 8 | kept;
}

/* Reads the mode after 01 and 41 were written, a byte each. A driver's clear that is switched off
 * reads the mode. */
uint32_t mode_reads(void) {
    outp(MODE, BOARD_MODE_BOTH);
    uint32_t first = inp(MODE);
    outp(MODE, MODE_STEP | BOARD_MODE_BOTH);
    uint32_t second = inp(MODE);
    outp(MODE, BOARD_MODE_BOTH);
    return first << 8 | second;
}

/* Writes red four times without X while X may step, as a driver's clear does that is switched off.
 * Returns which dots changed. */
uint32_t red_run(void) {
    bench_prepare();
    stepping_begin();
    for (uint8_t i = 0; i < 4; i++) {
        outp(RED, MARKER);
    }
    outp(MODE, BOARD_MODE_BOTH);
    uint32_t changes = bench_changes();
    bench_clear();
    return changes;
}
