/* SPDX-License-Identifier: MIT */
/* Experiments with positions, primaries, fills, and what lies outside the screen. */
#include "experiments.h"
#include "outp.h"
#include "registers.h"

/* Returns how many primaries of every 64th dot, from the corner on, are not 0. Clears the screen
 * for what follows. */
uint32_t memory_at_first(void) {
    uint32_t lit = 0;
    for (uint16_t y = 0; y < BOARD_HEIGHT; y += 8) {
        for (uint16_t x = 0; x < BOARD_WIDTH; x += 8) {
            lit += primaries_lit(dot_read(x, y));
        }
    }
    screen_clear();
    return lit;
}

/* ---- Positions: where does a marker go? --------------------------------------------------------
 */

static uint32_t place_of_marker(void) {
    outp(RED, MARKER);
    return dot_find();
}

uint32_t x_by_byte(void) {
    dot_select(0x0123, BENCH_Y);
    outp(X_AXIS, 0x45);
    return place_of_marker();
}

uint32_t y_by_byte(void) {
    dot_select(BENCH_X, 0x0123);
    outp(Y_AXIS, 0x45);
    return place_of_marker();
}

uint32_t x_by_odd_byte(void) {
    dot_select(0x0023, BENCH_Y);
    outp(X_AXIS + 1, 0x01);
    return place_of_marker();
}

uint32_t y_by_odd_byte(void) {
    dot_select(BENCH_X, 0x0023);
    outp(Y_AXIS + 1, 0x01);
    return place_of_marker();
}

uint32_t word_at_odd_port(void) {
    dot_select(0x0023, 0x0010);
    outpw(X_AXIS + 1, 0x4401);
    return place_of_marker();
}

uint32_t x_upper_bits(void) {
    dot_select(0xFC00 | BENCH_X, 0xFE00 | BENCH_Y);
    return place_of_marker();
}

/* ---- Primaries ---------------------------------------------------------------------------------
 */

uint32_t primaries_by_odd_byte(void) {
    dot_write(BENCH_X, BENCH_Y, BENCH_COLOUR);
    outp(RED + 1, 0x5A);
    outp(GREEN + 1, 0x5A);
    outp(BLUE + 1, 0x5A);
    uint32_t rgb = dot_read(BENCH_X, BENCH_Y);
    dot_write(BENCH_X, BENCH_Y, 0);
    return rgb;
}

/* Returns the primaries' upper bytes alone: the lower ones are known. */
uint32_t primary_words_read(void) {
    dot_write(BENCH_X, BENCH_Y, BENCH_COLOUR);
    uint32_t red = inpw(RED) >> 8;
    uint32_t green = inpw(GREEN) >> 8;
    uint32_t values = red << 16 | green << 8 | inpw(BLUE) >> 8;
    dot_write(BENCH_X, BENCH_Y, 0);
    return values;
}

/* ---- Words to a primary ------------------------------------------------------------------------
 */

static uint32_t word_changes(uint16_t offset, uint16_t port, uint16_t value) {
    bench_prepare();
    dot_select(BENCH_X + offset, BENCH_Y);
    outpw(port, value);
    uint32_t changes = bench_changes();
    bench_clear();
    return changes;
}

uint32_t fill_at_0(void) {
    return word_changes(0, RED, 0);
}

uint32_t fill_at_1(void) {
    return word_changes(1, RED, 0);
}

uint32_t fill_at_3(void) {
    return word_changes(3, RED, 0);
}

/* Returns the colour of a dot after a word to a primary at BENCH_X. */
static uint32_t dot_after_word(uint16_t offset, uint16_t port) {
    bench_prepare();
    dot_select(BENCH_X, BENCH_Y);
    outpw(port, 0xA55A);
    uint32_t rgb = dot_read(BENCH_X + offset, BENCH_Y);
    bench_clear();
    return rgb;
}

uint32_t fill_first_dot(void) {
    return dot_after_word(0, RED);
}

uint32_t fill_second_dot(void) {
    return dot_after_word(1, RED);
}

/* Returns the dots that changed, then the primary's value at the dot itself. */
uint32_t green_by_word(void) {
    return word_changes(0, GREEN, 0xA55A) << 8 | (dot_after_word(0, GREEN) >> 8 & 0xFF);
}

uint32_t blue_by_word(void) {
    return word_changes(0, BLUE, 0xA55A) << 8 | (dot_after_word(0, BLUE) & 0xFF);
}

/* ---- Outside the screen ------------------------------------------------------------------------
 */

/* Writes a marker to a place outside. Returns red read back there, then where on the screen the
 * marker is. */
static uint32_t outside(uint16_t x, uint16_t y) {
    dot_select(x, y);
    outp(RED, MARKER);
    dot_select(BENCH_X, BENCH_Y);
    dot_select(x, y);
    uint32_t kept = inp(RED);
    uint32_t place = dot_find();
    dot_select(x, y);
    outp(RED, 0);
    return kept << 24 | place;
}

uint32_t right_of_screen(void) {
    return outside(BOARD_WIDTH + 8, 8);
}

uint32_t far_right_of_screen(void) {
    return outside(1016, 8);
}

uint32_t hidden_first(void) {
    return outside(0, 400);
}

uint32_t hidden_last(void) {
    return outside(383, 407);
}

uint32_t hidden_right(void) {
    return outside(384, 400);
}

uint32_t hidden_lower(void) {
    return outside(0, 408);
}

uint32_t below_memory(void) {
    return outside(0, 416);
}
