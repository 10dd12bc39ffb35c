/* SPDX-License-Identifier: MIT */
/* What is shown of a row of full colours: all of it, the upper bits, 8 colours by dither or bit. */
#include "show.h"

#include "board_ports.h"

enum { PRIMARIES = 3, LEVEL_MOST = 255 };

/* Scrambles a number by the finaliser of MurmurHash3 (Austin Appleby, public domain). The finaliser
 * is one-to-one, and each bit of its argument changes about half of the bits of the result. */
static uint32_t scramble(uint32_t value) {
    value ^= value >> 16;
    value *= UINT32_C(0x85EBCA6B);
    value ^= value >> 13;
    value *= UINT32_C(0xC2B2AE35);
    return value ^ value >> 16;
}

/* Returns the number 0..254 that a dot of the screen draws for one primary. The place is scrambled
 * before the seed is added: neighbouring seeds would otherwise give the same dots, moved by one. */
static uint8_t draw_number(uint32_t seed, uint16_t x, uint16_t y, uint8_t primary) {
    uint32_t place = ((uint32_t)y * BOARD_WIDTH + x) * PRIMARIES + primary;
    uint32_t upper = scramble(scramble(place) + seed) >> 16;
    return (uint8_t)(upper * LEVEL_MOST >> 16);
}

static void dither_row(const struct scene *scene, uint16_t y, uint8_t *rgb) {
    for (uint16_t x = 0; x < scene->width; x++) {
        for (uint8_t primary = 0; primary < PRIMARIES; primary++, rgb++) {
            uint8_t lit = 0;
            for (uint8_t dot = 0; dot < 4; dot++) {
                uint8_t number = draw_number(scene->seed, (uint16_t)(2 * x + dot % 2),
                                             (uint16_t)(2 * y + dot / 2), primary);
                lit = (uint8_t)(lit | (number < *rgb ? 1 : 0) << dot);
            }
            *rgb = lit;
        }
    }
}

void show_row(const struct scene *scene, uint16_t y, uint8_t exposure, uint8_t *rgb) {
    uint16_t bytes = (uint16_t)(PRIMARIES * scene->width);
    uint8_t kept = (uint8_t)(LEVEL_MOST << (8 - scene->show_bits));
    switch (scene->show) {
    case SHOW_BITS:
        for (uint16_t i = 0; i < bytes; i++) {
            rgb[i] = rgb[i] & kept;
        }
        break;
    case SHOW_EXPOSURES:
        for (uint16_t i = 0; i < bytes; i++) {
            rgb[i] = rgb[i] >> exposure & 1 ? LEVEL_MOST : 0;
        }
        break;
    case SHOW_DITHER:
        dither_row(scene, y, rgb);
        break;
    default:
        break;
    }
}
