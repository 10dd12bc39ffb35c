/* SPDX-License-Identifier: MIT */
#ifndef SUPERFRAME_TESTS_DOSBOX_VGA_H
#define SUPERFRAME_TESTS_DOSBOX_VGA_H

#include <cstdint>

struct VGA_Type {
    struct {
        struct {
            double framestart, vdend; /* when the frame began; how long lines are shown */
        } delay;
    } draw;
};

extern VGA_Type vga;
extern unsigned char GFX_Rshift, GFX_Gshift, GFX_Bshift;
extern uint32_t GFX_Amask;

#endif
