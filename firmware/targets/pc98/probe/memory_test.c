/* SPDX-License-Identifier: MIT */
/* The memory test: every primary of every dot of the screen, with a pattern and its complement. */
#include "experiments.h"
#include "outp.h"
#include "registers.h"

/* Returns a colour that is different for dots that differ in one bit of X or Y. The primaries of a
 * dot are different too. So a stuck or crossed line of the address shows. */
static uint32_t pattern(uint16_t x, uint16_t y) {
    uint32_t mixed = ((uint32_t)y * BOARD_WIDTH + x + 1) * UINT32_C(0x9E3779B1);
    return mixed >> 8;
}

static void write_all(uint32_t inverted) {
    for (uint16_t y = 0; y < BOARD_HEIGHT; y++) {
        for (uint16_t x = 0; x < BOARD_WIDTH; x++) {
            dot_write(x, y, pattern(x, y) ^ inverted);
        }
    }
}

/* Wrong dots so far and the first one's place: errors, then 00XXXYYYh. */
struct tally {
    uint32_t errors;
    uint32_t place;
};

static void read_all(uint32_t inverted, struct tally *tally) {
    for (uint16_t y = 0; y < BOARD_HEIGHT; y++) {
        for (uint16_t x = 0; x < BOARD_WIDTH; x++) {
            if (dot_read(x, y) == (pattern(x, y) ^ inverted)) {
                continue;
            }
            if (tally->errors == 0) {
                tally->place = (uint32_t)x << 12 | y;
            }
            tally->errors += tally->errors < 0xFF;
        }
    }
}

/* Returns the number of wrong dots, FFh for 255 and more, then the first one's place. */
uint32_t memory_errors(void) {
    struct tally tally = {0, NOWHERE};
    write_all(0);
    read_all(0, &tally);
    write_all(0xFFFFFF);
    read_all(0xFFFFFF, &tally);
    screen_clear();
    return tally.errors << 24 | tally.place;
}
