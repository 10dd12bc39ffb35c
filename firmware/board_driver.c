/* SPDX-License-Identifier: MIT */
/* The driver of the SuperFrame board. */
#include "board_driver.h"

#include "board_ports.h"
#include "outp.h"

static uint16_t port(uint16_t base, uint16_t offset) {
    return (uint16_t)(base + offset);
}

void board_start(uint16_t base) {
#define PAIR(index, data) {index, data},
    static const uint8_t setting[][2] = {BOARD_INITIALISATION(PAIR)};
    for (uint8_t i = 0; i < sizeof setting / sizeof setting[0]; i++) {
        outp(port(base, BOARD_CONTROL_1), setting[i][0]);
        outp(port(base, BOARD_CONTROL_2), setting[i][1]);
    }
    outp(port(base, BOARD_MODE), BOARD_MODE_PC);
    outp(port(base, BOARD_MODE), BOARD_MODE_BOTH);
}

bool board_is_present(uint16_t base) {
    outpw(port(base, BOARD_X), 0);
    outpw(port(base, BOARD_Y), 0);
    uint8_t before = inp(port(base, BOARD_RED));
    outp(port(base, BOARD_RED), 0xAA);
    bool present = inp(port(base, BOARD_RED)) == 0xAA;
    outp(port(base, BOARD_RED), before);
    return present;
}

static void dot(uint16_t base, uint16_t x, const uint8_t *rgb) {
    outpw(port(base, BOARD_X), x);
    outp(port(base, BOARD_RED), rgb[0]);
    outp(port(base, BOARD_GREEN), rgb[1]);
    outp(port(base, BOARD_BLUE), rgb[2]);
}

static void black_dots(uint16_t base, uint16_t x) {
    static const uint8_t black[3] = {0, 0, 0};
    for (; x < BOARD_WIDTH; x++) {
        dot(base, x, black);
    }
}

void board_row(uint16_t base, uint16_t y, const uint8_t *rgb, uint16_t width, uint8_t dots) {
    for (uint8_t line = 0; line < dots; line++) {
        uint16_t x = 0;
        outpw(port(base, BOARD_Y), (uint16_t)(y * dots + line));
        for (uint16_t pixel = 0; pixel < width; pixel++) {
            for (uint8_t i = 0; i < dots; i++) {
                dot(base, x++, &rgb[3 * pixel]);
            }
        }
        black_dots(base, x);
    }
}

void board_dots(uint16_t base, uint16_t y, const uint8_t *lit, uint16_t width) {
    for (uint8_t line = 0; line < 2; line++) {
        uint16_t x = 0;
        outpw(port(base, BOARD_Y), (uint16_t)(2 * y + line));
        for (uint16_t pixel = 0; pixel < width; pixel++) {
            const uint8_t *sets = &lit[3 * pixel];
            for (uint8_t bit = (uint8_t)(2 * line); bit < 2 * line + 2; bit++) {
                uint8_t rgb[3];
                for (uint8_t primary = 0; primary < 3; primary++) {
                    rgb[primary] = sets[primary] >> bit & 1 ? 0xFF : 0x00;
                }
                dot(base, x++, rgb);
            }
        }
        black_dots(base, x);
    }
}

void board_blank(uint16_t base, uint16_t first, uint16_t last) {
    for (uint16_t y = first; y < last; y++) {
        outpw(port(base, BOARD_Y), y);
        black_dots(base, 0);
    }
}
