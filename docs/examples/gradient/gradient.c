/* SPDX-License-Identifier: MIT */
/* A gradient on the SuperFrame board in 30 lines: red to the right, green downwards. */
#include "gradient.h"

#include <superframe/outp.h>

static const uint8_t controller[15][2] = {{0x00, 0x6B}, {0x01, 0x50}, {0x02, 0x5B}, {0x03, 0x0E},
                                          {0x04, 0x1A}, {0x05, 0x02}, {0x06, 0x19}, {0x07, 0x19},
                                          {0x08, 0x80}, {0x09, 0x0F}, {0x0C, 0xFF}, {0x0D, 0xFF},
                                          {0x1B, 0x01}, {0x1E, 0x8C}, {0x1F, 0x00}};

void draw_gradient(void) {
    for (unsigned i = 0; i < 15; i++) {
        outp(0x00D0, controller[i][0]); /* control 1: index */
        outp(0x00D2, controller[i][1]); /* control 2: data */
    }
    outp(0x00DE, 0x01); /* mode: both pictures */
    for (unsigned y = 0; y < 400; y++) {
        outpw(0x00D6, (uint16_t)y);
        for (unsigned x = 0; x < 640; x++) {
            outpw(0x00D4, (uint16_t)x);
            outp(0x00D8, (uint8_t)(x * 255 / 639)); /* red */
            outp(0x00DA, (uint8_t)(y * 255 / 399)); /* green */
            outp(0x00DC, 0x80);                     /* blue */
        }
    }
}
