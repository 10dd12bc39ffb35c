/* SPDX-License-Identifier: MIT */
/* The board's facts: ports, bases, screen, modes, and what a driver writes first. Whoever drives,
 * plays or describes the board takes the facts from here.
 *
 * A letter tells how a fact is known. docs/board.md explains the letters.
 *
 *     P  the paper's Table 2
 *     D  drivers of 1991-93
 *     S  a jumper sheet of a later board */
#ifndef SUPERFRAME_HAL_BOARD_PORTS_H
#define SUPERFRAME_HAL_BOARD_PORTS_H

#include <stdbool.h>
#include <stdint.h>

/* Eight registers of 16 bits, by offset from the base. */
enum {
    BOARD_CONTROL_1 = 0x0, /* W    index of a register of the CRT controller       D */
    BOARD_CONTROL_2 = 0x2, /* R/W  data of the indexed register                    D */
    BOARD_X = 0x4,         /* W    0..639, bits 9-0                                P */
    BOARD_Y = 0x6,         /* W    0..399, bits 8-0                                P */
    BOARD_RED = 0x8,       /* R/W  0..255 of the pixel at (X, Y), at once          P */
    BOARD_GREEN = 0xA,     /* R/W  as red                                          P */
    BOARD_BLUE = 0xC,      /* R/W  as red                                          P */
    BOARD_MODE = 0xE,      /* W    which of the two pictures is shown              P, values D */
    BOARD_PORTS = 16       /* decoded from the base upwards                        P */
};

/* The base: 00D0h from the factory (P), or by a jumper one of seven (S). */
enum { BOARD_FACTORY_BASE = 0x00D0, BOARD_LAST_BASE = 0x0CD0, BOARD_JUMPER_BITS = 0x0E00 };
#define BOARD_BASES_TEXT "00D0, 02D0, 04D0, 06D0, 08D0, 0AD0 or 0CD0"

/* Tells whether the jumper offers a base. */
static inline bool board_base_is_offered(uint16_t base) {
    return (base | BOARD_JUMPER_BITS) == (BOARD_FACTORY_BASE | BOARD_JUMPER_BITS) &&
           base <= BOARD_LAST_BASE;
}

/* Dots of the screen (P). */
enum { BOARD_WIDTH = 640, BOARD_HEIGHT = 400 };

/* Returns the dots along each side of a pixel of a picture: 2 for a picture of up to 320 x 200. The
 * rule is the firmware's; the board knows dots alone. */
static inline uint8_t board_dots_a_pixel(unsigned width, unsigned height) {
    return width <= BOARD_WIDTH / 2 && height <= BOARD_HEIGHT / 2 ? 2 : 1;
}

/* Values of the mode register (D). */
enum { BOARD_MODE_PC = 0x00, BOARD_MODE_BOTH = 0x01, BOARD_MODE_BOARD = 0x03 };

/* The index of the controller's status. Bit 1 is set in the vertical blanking (D). */
enum { BOARD_STATUS_INDEX = 0x1F, BOARD_STATUS_BLANK = 0x02 };

/* Lists what a driver writes before mode 00 (D): index and data of the controller's registers, in
 * order. */
#define BOARD_INITIALISATION(ENTRY)                                                                \
    ENTRY(0x00, 0x6B)                                                                              \
    ENTRY(0x01, 0x50)                                                                              \
    ENTRY(0x02, 0x5B)                                                                              \
    ENTRY(0x03, 0x0E)                                                                              \
    ENTRY(0x04, 0x1A)                                                                              \
    ENTRY(0x05, 0x02)                                                                              \
    ENTRY(0x06, 0x19)                                                                              \
    ENTRY(0x07, 0x19)                                                                              \
    ENTRY(0x08, 0x80)                                                                              \
    ENTRY(0x09, 0x0F)                                                                              \
    ENTRY(0x0C, 0xFF)                                                                              \
    ENTRY(0x0D, 0xFF)                                                                              \
    ENTRY(0x1B, 0x01)                                                                              \
    ENTRY(0x1E, 0x8C)                                                                              \
    ENTRY(BOARD_STATUS_INDEX, 0x00)

#endif
