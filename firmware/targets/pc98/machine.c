/* SPDX-License-Identifier: MIT */
/* The PC-9801 as far as the image uses it: text VRAM by the segment fs, keyboard by its ports. */
#include "machine.h"

#include "outp.h"

/* The start code has pointed fs at A0000h. A cell is a word: the character there, the attribute
 * 2000h farther. */
enum { ATTRIBUTES = 0x2000, WHITE = 0xE1, SECRET = 0xE0 };

/* The keyboard's 8251: data and status. The status of one that is there and sends nothing has both
 * bits of KEYBOARD_IS_THERE; no keyboard reads as FFh. */
enum {
    KEYBOARD_DATA = 0x41,
    KEYBOARD_STATUS = 0x43,
    KEYBOARD_IS_THERE = 0x05,
    KEY_IS_WAITING = 0x02,
    KEY_IS_RELEASED = 0x80, /* of a key's number */
    KEY_ESCAPE = 0x00
};

static void text_word(uint32_t offset, uint16_t word) {
    __asm__ volatile("movw %w0, %%fs:(%k1)" : : "r"(word), "r"(offset) : "memory");
}

static void text_cell(uint8_t row, uint8_t column, char letter) {
    uint32_t offset = 2 * ((uint32_t)row * TEXT_COLUMNS + column);
    text_word(offset, (uint8_t)letter);
    text_word(offset + ATTRIBUTES, WHITE);
}

void text_clear(void) {
    for (uint8_t row = 0; row < TEXT_ROWS; row++) {
        for (uint8_t column = 0; column < TEXT_COLUMNS; column++) {
            text_cell(row, column, ' ');
        }
    }
}

uint8_t text_put(uint8_t row, uint8_t column, const char *text) {
    for (; *text != '\0' && column < TEXT_COLUMNS; column++) {
        text_cell(row, column, *text++);
    }
    return column;
}

uint8_t text_put_number(uint8_t row, uint8_t column, uint16_t number) {
    char digits[6];
    uint8_t first = sizeof digits - 1;
    digits[first] = '\0';
    do {
        digits[--first] = (char)('0' + number % 10);
        number /= 10;
    } while (number != 0);
    return text_put(row, column, &digits[first]);
}

void text_show(bool is_shown) {
    for (uint16_t cell = 0; cell < TEXT_ROWS * TEXT_COLUMNS; cell++) {
        text_word(ATTRIBUTES + 2 * (uint32_t)cell, is_shown ? WHITE : SECRET);
    }
}

bool key_wait(void) {
    for (;;) {
        uint8_t status = inp(KEYBOARD_STATUS);
        if (status == 0xFF || (status & KEYBOARD_IS_THERE) != KEYBOARD_IS_THERE) {
            return false;
        }
        if ((status & KEY_IS_WAITING) != 0 && (inp(KEYBOARD_DATA) & KEY_IS_RELEASED) == 0) {
            return true;
        }
    }
}

bool escape_pressed(void) {
    /* Bounded: a status that always says "waiting" (FFh: no keyboard) must not hang the image. */
    for (uint8_t keys = 0; keys < 4; keys++) {
        uint8_t status = inp(KEYBOARD_STATUS);
        if (status == 0xFF || (status & KEY_IS_WAITING) == 0) {
            return false;
        }
        if (inp(KEYBOARD_DATA) == KEY_ESCAPE) {
            return true;
        }
    }
    return false;
}
