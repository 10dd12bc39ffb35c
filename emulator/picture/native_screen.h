/* SPDX-License-Identifier: MIT */
/* The PC-9801's own screen: 640 x 400 in 16 of 4096 colours, from planes or from a picture. */
#ifndef SUPERFRAME_EMULATOR_NATIVE_SCREEN_H
#define SUPERFRAME_EMULATOR_NATIVE_SCREEN_H

#include <stdbool.h>
#include <stdint.h>

enum {
    NATIVE_WIDTH = 640,
    NATIVE_HEIGHT = 400,
    NATIVE_COLOURS = 16,
    NATIVE_PLANE_BYTES = NATIVE_WIDTH / 8 * NATIVE_HEIGHT /* 32,000 */
};

/* The screen. Its source for all of this: NP2kai and UNDOCUMENTED, see docs/board.md. */
struct native_screen {
    uint16_t palette[NATIVE_COLOURS];             /* 0RGBh, four bits each: 0000h..0FFFh */
    uint8_t pixels[NATIVE_WIDTH * NATIVE_HEIGHT]; /* 0..15: bit 0 B, 1 R, 2 G, 3 I */
};

/* A black screen with the palette of the eight digital colours (entries 8..15: the same). */
void native_screen_init(struct native_screen *screen);

/* Loads the planes as they lie at A8000h (B), B0000h (R), B8000h (G) and E0000h (I): 80 bytes a
 * line, the leftmost pixel in bit 7. intensity may be NULL: 8 colours. The palette stays. */
void native_screen_from_planes(struct native_screen *screen, const uint8_t blue[NATIVE_PLANE_BYTES],
                               const uint8_t red[NATIVE_PLANE_BYTES],
                               const uint8_t green[NATIVE_PLANE_BYTES], const uint8_t *intensity);

/* Loads a picture of R, G, B bytes. It is the caller's to see that it has 640 x 400 pixels. False
 * if it can't be such a screen, with the place and the reason in message (at most `size` bytes, 0
 * included): a level that is not one of 00h, 11h, ... FFh, or a 17th colour. Black becomes
 * colour 0; the screen is not to be used after a failure. */
bool native_screen_from_rgb(struct native_screen *screen,
                            const uint8_t rgb[NATIVE_WIDTH * NATIVE_HEIGHT * 3], char *message,
                            unsigned size);

/* The levels of a colour 0..15, 0..255 each. */
void native_colour_levels(const struct native_screen *screen, unsigned colour, uint8_t rgb[3]);

#endif
