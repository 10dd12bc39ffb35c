/* SPDX-License-Identifier: MIT */
/* A board behind outp() for the suites that speak to it through ports only. */
#ifndef SUPERFRAME_TESTS_BOARD_FIXTURE_H
#define SUPERFRAME_TESTS_BOARD_FIXTURE_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

#include <cmocka.h>

#include "board.h"
#include "bus.h"
#include "outp.h"

/* The board of the running test, and the bus that it hangs on. */
static struct board board;
static struct board_bus board_bus;

/* Powers a board on and binds it. */
static inline void power_on_desc(const struct board_desc *desc) {
    assert_true(board_init(&board, desc));
    board_bus_init(&board_bus, &board);
    bus_bind(&board_bus.bus);
}

static inline void power_on(enum board_profile profile) {
    struct board_desc desc = board_default_desc(profile);
    power_on_desc(&desc);
}

/* With memory full of seeded noise. */
static inline void power_on_noise(enum board_profile profile, uint64_t seed) {
    struct board_desc desc = board_default_desc(profile);
    desc.noise = true;
    desc.noise_seed = seed;
    power_on_desc(&desc);
}

/* The fifteen index/data pairs of the drivers (docs/board.md, grade D), and mode 00. */
static inline void initialise(void) {
    static const uint8_t pairs[15][2] = {{0x00, 0x6B}, {0x01, 0x50}, {0x02, 0x5B}, {0x03, 0x0E},
                                         {0x04, 0x1A}, {0x05, 0x02}, {0x06, 0x19}, {0x07, 0x19},
                                         {0x08, 0x80}, {0x09, 0x0F}, {0x0C, 0xFF}, {0x0D, 0xFF},
                                         {0x1B, 0x01}, {0x1E, 0x8C}, {0x1F, 0x00}};
    for (unsigned i = 0; i < 15; i++) {
        outp(0x00D0, pairs[i][0]);
        outp(0x00D2, pairs[i][1]);
    }
    outp(0x00DE, 0x00);
}

static inline void go_to(unsigned x, unsigned y) {
    outpw(0x00D4, (uint16_t)x);
    outpw(0x00D6, (uint16_t)y);
}

static inline void put_pixel(unsigned x, unsigned y, unsigned rgb) {
    go_to(x, y);
    outp(0x00D8, (uint8_t)(rgb >> 16));
    outp(0x00DA, (uint8_t)(rgb >> 8));
    outp(0x00DC, (uint8_t)rgb);
}

/* The pixel at X, Y as they are. */
static inline unsigned get_here(void) {
    unsigned red = inp(0x00D8);
    unsigned green = inp(0x00DA);
    return red << 16 | green << 8 | inp(0x00DC);
}

static inline unsigned get_pixel(unsigned x, unsigned y) {
    go_to(x, y);
    return get_here();
}

/* A seeded generator for property tests: xorshift64*, state not 0. */
static inline uint32_t next_random(uint64_t *state) {
    *state ^= *state >> 12;
    *state ^= *state << 25;
    *state ^= *state >> 27;
    return (uint32_t)(*state * 0x2545F4914F6CDD1DU >> 32);
}

#endif
