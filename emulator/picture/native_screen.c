/* SPDX-License-Identifier: MIT */
/* The PC-9801's own screen, from planes or from a picture. */
#include "native_screen.h"

#include <stdio.h>
#include <string.h>

void native_screen_init(struct native_screen *screen) {
    memset(screen, 0, sizeof *screen);
    for (unsigned colour = 0; colour < NATIVE_COLOURS; colour++) {
        unsigned blue = (colour & 1) != 0 ? 0x00F : 0;
        unsigned red = (colour & 2) != 0 ? 0xF00 : 0;
        unsigned green = (colour & 4) != 0 ? 0x0F0 : 0;
        screen->palette[colour] = (uint16_t)(red | green | blue);
    }
}

void native_screen_from_planes(struct native_screen *screen, const uint8_t blue[NATIVE_PLANE_BYTES],
                               const uint8_t red[NATIVE_PLANE_BYTES],
                               const uint8_t green[NATIVE_PLANE_BYTES], const uint8_t *intensity) {
    for (unsigned i = 0; i < NATIVE_WIDTH * NATIVE_HEIGHT; i++) {
        unsigned byte = i / 8;
        unsigned shift = 7 - i % 8;
        unsigned bright = intensity == NULL ? 0 : (unsigned)intensity[byte] >> shift & 1;
        screen->pixels[i] = (uint8_t)(((unsigned)blue[byte] >> shift & 1) |
                                      ((unsigned)red[byte] >> shift & 1) << 1 |
                                      ((unsigned)green[byte] >> shift & 1) << 2 | bright << 3);
    }
}

/* Returns the palette's number for a colour, which is entered if new. Returns NATIVE_COLOURS if
 * there is no room. */
static unsigned find_colour(struct native_screen *screen, unsigned *used, uint16_t colour) {
    unsigned i = 0;
    while (i < *used && screen->palette[i] != colour) {
        i++;
    }
    if (i == *used && i < NATIVE_COLOURS) {
        screen->palette[(*used)++] = colour;
    }
    return i;
}

bool native_screen_from_rgb(struct native_screen *screen,
                            const uint8_t rgb[NATIVE_WIDTH * NATIVE_HEIGHT * 3], char *message,
                            unsigned size) {
    unsigned used = 1; /* colour 0 is black */
    memset(screen, 0, sizeof *screen);
    for (unsigned i = 0; i < NATIVE_WIDTH * NATIVE_HEIGHT; i++) {
        const uint8_t *pixel = rgb + (size_t)i * 3;
        unsigned x = i % NATIVE_WIDTH;
        unsigned y = i / NATIVE_WIDTH;
        if (pixel[0] % 17 != 0 || pixel[1] % 17 != 0 || pixel[2] % 17 != 0) {
            snprintf(message, size,
                     "the pixel at x=%u y=%u is %02X %02X %02X; the PC-9801 has the levels 00, 11, "
                     "22 ... FF",
                     x, y, pixel[0], pixel[1], pixel[2]);
            return false;
        }
        unsigned colour = pixel[0] / 17U << 8 | pixel[1] / 17U << 4 | pixel[2] / 17U;
        unsigned number = find_colour(screen, &used, (uint16_t)colour);
        if (number == NATIVE_COLOURS) {
            snprintf(message, size,
                     "the pixel at x=%u y=%u has a 17th colour; the PC-9801 shows 16 at a time", x,
                     y);
            return false;
        }
        screen->pixels[i] = (uint8_t)number;
    }
    return true;
}

void native_colour_levels(const struct native_screen *screen, unsigned colour, uint8_t rgb[3]) {
    unsigned packed = screen->palette[colour];
    rgb[0] = (uint8_t)((packed >> 8 & 15) * 17);
    rgb[1] = (uint8_t)((packed >> 4 & 15) * 17);
    rgb[2] = (uint8_t)((packed & 15) * 17);
}
