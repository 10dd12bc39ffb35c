/* SPDX-License-Identifier: MIT */
/* The driver of the SuperFrame board: registers by the offsets of the paper's Table 2. */
#include "board_driver.h"

#include "outp.h"

enum {
    CONTROL_1 = 0x0, /* index of a register of the CRT controller (grade D) */
    CONTROL_2 = 0x2, /* its data */
    X_AXIS = 0x4,
    Y_AXIS = 0x6,
    RED = 0x8,
    GREEN = 0xA,
    BLUE = 0xC,
    MODE = 0xE
};

enum { MODE_SUPERIMPOSED = 0x01 };

static uint16_t port(uint16_t base, uint16_t offset) {
    return (uint16_t)(base + offset);
}

void board_start(uint16_t base) {
    static const uint8_t setting[][2] = {{0x00, 0x6B}, {0x01, 0x50}, {0x02, 0x5B}, {0x03, 0x0E},
                                         {0x04, 0x1A}, {0x05, 0x02}, {0x06, 0x19}, {0x07, 0x19},
                                         {0x08, 0x80}, {0x09, 0x0F}, {0x0C, 0xFF}, {0x0D, 0xFF},
                                         {0x1B, 0x01}, {0x1E, 0x8C}, {0x1F, 0x00}};
    for (uint8_t i = 0; i < sizeof setting / sizeof setting[0]; i++) {
        outp(port(base, CONTROL_1), setting[i][0]);
        outp(port(base, CONTROL_2), setting[i][1]);
    }
    outp(port(base, MODE), 0x00);
    outp(port(base, MODE), MODE_SUPERIMPOSED);
}

bool board_is_present(uint16_t base) {
    outpw(port(base, X_AXIS), 0);
    outpw(port(base, Y_AXIS), 0);
    uint8_t before = inp(port(base, RED));
    outp(port(base, RED), 0xAA);
    bool present = inp(port(base, RED)) == 0xAA;
    outp(port(base, RED), before);
    return present;
}

static void dot(uint16_t base, uint16_t x, const uint8_t *rgb) {
    outpw(port(base, X_AXIS), x);
    outp(port(base, RED), rgb[0]);
    outp(port(base, GREEN), rgb[1]);
    outp(port(base, BLUE), rgb[2]);
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
        outpw(port(base, Y_AXIS), (uint16_t)(y * dots + line));
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
        outpw(port(base, Y_AXIS), (uint16_t)(2 * y + line));
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
        outpw(port(base, Y_AXIS), y);
        black_dots(base, 0);
    }
}
