/* SPDX-License-Identifier: MIT */
/* A picture to draw over the cable of usb_fixture.h, and what may be claimed of it afterwards. */
#ifndef SUPERFRAME_TESTS_USB_PICTURE_H
#define SUPERFRAME_TESTS_USB_PICTURE_H

#include "usb_fixture.h"

enum { LINES = 24 };

static struct board far_board;
static struct board_bus far_board_bus;
static struct cable cable;
static uint8_t picture[LINES][BOARD_WIDTH][3];

static inline void plug_in(const struct cable_faults *faults, uint64_t seed) {
    struct board_desc desc = board_default_desc(BOARD_1987);
    desc.noise = true;
    desc.noise_seed = seed + 1000;
    assert_true(board_init(&far_board, &desc));
    board_bus_init(&far_board_bus, &far_board);
    cable_plug(&cable, faults, seed, &far_board_bus.bus, &far_board);
}

/* Something of everything: flat parts, ramps, doubled pixels, extremes, lines like the one above,
 * and noise. */
static inline void paint(uint64_t seed) {
    uint64_t random = seed * 2 + 1;
    for (unsigned y = 0; y < LINES; y++) {
        unsigned kind = next_random(&random) % 6;
        for (unsigned x = 0; x < BOARD_WIDTH; x++) {
            uint32_t noise = next_random(&random);
            uint8_t *pixel = picture[y][x];
            for (unsigned i = 0; i < 3; i++) {
                unsigned old = x > 0 ? picture[y][x - 1][i] : 7U;
                pixel[i] = (uint8_t)(kind == 0   ? old
                                     : kind == 1 ? old + (i == y % 3)
                                     : kind == 2 ? (x % 2 == 1 ? old : noise >> 8 * i & 0xFF)
                                     : kind == 3 ? (noise >> i & 1) * 0xFF
                                     : kind == 4 ? (y > 0 ? picture[y - 1][x][i] : 0U)
                                                 : noise >> 8 * i & 0xFF);
            }
        }
    }
}

/* As the firmware's driver draws: Y a line; X, R, G, B a pixel. */
static inline void draw(struct bus *bus) {
    for (unsigned y = 0; y < LINES; y++) {
        bus_write(bus, 0x00D6, (uint16_t)y, BUS_WORD);
        for (unsigned x = 0; x < BOARD_WIDTH; x++) {
            bus_write(bus, 0x00D4, (uint16_t)x, BUS_WORD);
            for (unsigned i = 0; i < 3; i++) {
                bus_write(bus, (uint16_t)(0x00D8 + 2 * i), picture[y][x][i], BUS_BYTE);
            }
        }
    }
}

static inline bool is_line_right(unsigned y) {
    return memcmp(far_board.memory + (size_t)y * BOARD_WIDTH * 3, picture[y], BOARD_WIDTH * 3) == 0;
}

static inline struct usb_bus *start(uint64_t seed) {
    struct usb_limits limits = quick_limits(seed);
    struct usb_bus *usb_bus = usb_bus_new(&cable.link, 0x00D0, &limits);
    assert_non_null(usb_bus);
    return usb_bus;
}

/* Draws the picture of a seed over a cable without faults, to its end. */
static inline struct usb_bus *draw_over_a_good_cable(uint64_t seed) {
    const struct cable_faults none = {0};
    plug_in(&none, seed);
    paint(seed);
    struct usb_bus *usb_bus = start(seed);
    draw(&usb_bus->bus);
    assert_int_equal(bus_flush(&usb_bus->bus), BUS_OK);
    return usb_bus;
}

/* Checks what the bus has counted against what went through the link. */
static inline void assert_counts(const struct usb_bus *usb_bus) {
    const struct usb_counts *counts = &usb_bus->counts;
    const struct cable_tally *tally = &cable.tally;
    assert_int_equal(counts->sent_bytes, tally->sent_bytes);
    assert_int_equal(counts->received_bytes, tally->received_bytes);
    assert_int_equal(counts->resent, tally->resent);
    assert_int_equal(counts->timeouts, tally->timeouts);
    assert_int_equal(counts->stalls, tally->stalls);
    assert_int_equal(counts->reconnects, tally->reconnects);
    assert_int_equal(counts->restarts, tally->sessions - 1);
    assert_int_equal(counts->frames, usb_bus->sealed);
    assert_int_equal(counts->payload_bytes, usb_bus->journal.used);
}

/* Draws once; true if the bus said that all went well. Checks what can be claimed either way. */
static inline bool run_once(uint64_t seed, struct usb_counts *counts) {
    paint(seed);
    struct usb_bus *usb_bus = start(seed);
    draw(&usb_bus->bus);
    bool is_done = bus_flush(&usb_bus->bus) == BUS_OK;
    *counts = usb_bus->counts;
    for (unsigned y = 0; y < LINES; y++) {
        bool is_claimed = usb_bus_line_is_there(usb_bus, y);
        assert_true(!is_done || is_claimed);
        if (is_claimed && !(cable.faults.is_board_cleared && !is_done)) {
            assert_true(is_line_right(y));
        }
    }
    assert_int_equal(is_done, usb_bus->reason[0] == '\0');
    assert_false(usb_bus_line_is_there(usb_bus, LINES));
    assert_counts(usb_bus);
    usb_bus_free(usb_bus);
    return is_done;
}

#endif
