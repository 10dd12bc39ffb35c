/* SPDX-License-Identifier: MIT */
/* The PC-9801's own screen: 640 x 400 in 16 of 4096 colours, from planes or from a picture. */
#ifndef SUPERFRAME_EMULATOR_NATIVE_SCREEN_H
#define SUPERFRAME_EMULATOR_NATIVE_SCREEN_H

#include <stdbool.h>
#include <stdint.h>

#include "board_ports.h"

enum {
    NATIVE_WIDTH = BOARD_WIDTH, /* the two pictures lie dot upon dot */
    NATIVE_HEIGHT = BOARD_HEIGHT,
    NATIVE_COLOURS = 16,
    NATIVE_PLANE_BYTES = NATIVE_WIDTH / 8 * NATIVE_HEIGHT /* 32,000 */
};

/* The screen. Source of the whole layout: NP2kai and UNDOCUMENTED, see docs/board.md. */
struct native_screen {
    uint16_t palette[NATIVE_COLOURS];             /* 0RGBh, four bits each: 0000h..0FFFh */
    uint8_t pixels[NATIVE_WIDTH * NATIVE_HEIGHT]; /* 0..15: bit 0 B, 1 R, 2 G, 3 I */
};

/* Makes a black screen with the palette of the eight digital colours. Entries 8..15 repeat entries
 * 0..7. */
void native_screen_init(struct native_screen *screen);

/* Loads the planes as they lie at A8000h (B), B0000h (R), B8000h (G) and E0000h (I). A line has 80
 * bytes, its leftmost pixel in bit 7. If intensity is NULL, there are 8 colours. The palette
 * stays. */
void native_screen_from_planes(struct native_screen *screen, const uint8_t blue[NATIVE_PLANE_BYTES],
                               const uint8_t red[NATIVE_PLANE_BYTES],
                               const uint8_t green[NATIVE_PLANE_BYTES], const uint8_t *intensity);

/* Loads a picture of R, G, B bytes. The caller makes sure that the picture has 640 x 400 pixels.
 * Black becomes colour 0. Returns false if a level is not one of 00h, 11h, ... FFh, or if there is
 * a 17th colour. message (at most `size` bytes, 0 included) then gets the place and the reason. The
 * screen is not to be used after a failure. */
bool native_screen_from_rgb(struct native_screen *screen,
                            const uint8_t rgb[NATIVE_WIDTH * NATIVE_HEIGHT * 3], char *message,
                            unsigned size);

/* Gives the levels of a colour 0..15: R, G, B, 0..255 each. */
void native_colour_levels(const struct native_screen *screen, unsigned colour, uint8_t rgb[3]);

#endif
