/* SPDX-License-Identifier: MIT */
/* Shows a picture through the ports. */
#include "viewer.h"

#include <stddef.h>

#include <superframe/outp.h>

/* The board's registers, even ports from 00D0h on. */
enum {
    CONTROL_1 = 0x00D0,
    CONTROL_2 = 0x00D2,
    X_AXIS = 0x00D4,
    Y_AXIS = 0x00D6,
    RED = 0x00D8,
    GREEN = 0x00DA,
    BLUE = 0x00DC,
    MODE = 0x00DE,
    WIDTH = 640,
    HEIGHT = 400
};

static void initialise(void) {
    static const uint8_t controller[15][2] = {
        {0x00, 0x6B}, {0x01, 0x50}, {0x02, 0x5B}, {0x03, 0x0E}, {0x04, 0x1A},
        {0x05, 0x02}, {0x06, 0x19}, {0x07, 0x19}, {0x08, 0x80}, {0x09, 0x0F},
        {0x0C, 0xFF}, {0x0D, 0xFF}, {0x1B, 0x01}, {0x1E, 0x8C}, {0x1F, 0x00}};
    for (unsigned i = 0; i < 15; i++) {
        outp(CONTROL_1, controller[i][0]);
        outp(CONTROL_2, controller[i][1]);
    }
    outp(MODE, 0x00);
}

bool board_is_present(void) {
    outpw(X_AXIS, 0);
    outpw(Y_AXIS, 0);
    uint8_t before = inp(RED);
    outp(RED, 0xAA);
    bool is_present = inp(RED) == 0xAA;
    outp(RED, 0x55); /* an empty slot may remember a value for a moment: ask for another */
    is_present = is_present && inp(RED) == 0x55;
    outp(RED, before);
    return is_present;
}

/* One pixel of the screen; black outside the picture. */
static void put_pixel(const uint8_t *pixel) {
    static const uint8_t black[3] = {0, 0, 0};
    const uint8_t *rgb = pixel != 0 ? pixel : black;
    outp(RED, rgb[0]);
    outp(GREEN, rgb[1]);
    outp(BLUE, rgb[2]);
}

bool show_picture(const uint8_t *rgb, unsigned width, unsigned height) {
    if (width < 1 || height < 1 || width > WIDTH || height > HEIGHT) {
        return false;
    }
    unsigned left = (WIDTH - width) / 2, top = (HEIGHT - height) / 2;
    initialise();
    for (unsigned y = 0; y < HEIGHT; y++) {
        outpw(Y_AXIS, (uint16_t)y);
        for (unsigned x = 0; x < WIDTH; x++) {
            bool is_inside = x - left < width && y - top < height; /* unsigned: also not below 0 */
            outpw(X_AXIS, (uint16_t)x);
            put_pixel(is_inside ? rgb + ((size_t)(y - top) * width + (x - left)) * 3 : 0);
        }
    }
    outp(MODE, 0x01);
    return true;
}
