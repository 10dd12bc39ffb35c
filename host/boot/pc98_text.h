/* SPDX-License-Identifier: MIT */
/* The text screen of a PC-9801: what its memory shows. */
#ifndef SUPERFRAME_PC98_TEXT_H
#define SUPERFRAME_PC98_TEXT_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

enum {
    PC98_TEXT_COLUMNS = 80,
    PC98_TEXT_ROWS = 25,
    PC98_TEXT_ATTRIBUTES = 0x2000,  /* where they begin in the memory of the text */
    PC98_TEXT_MEMORY_BYTES = 0x4000 /* from A0000h on */
};

/* Bits of a cell's attribute. Source: UNDOCUMENTED (memory map, A2000h). */
enum {
    PC98_TEXT_SHOWN = 0x01, /* clear: the cell is secret, and nothing of it is seen */
    PC98_TEXT_BLINK = 0x02,
    PC98_TEXT_REVERSE = 0x04,
    PC98_TEXT_UNDERLINE = 0x08,
    PC98_TEXT_VERTICAL_LINE = 0x10,
    PC98_TEXT_WHITE = 0xE1 /* shown; as the machine's start leaves every cell */
};

/* The text screen: a string a row as it is seen, trailing blanks cut, and each cell's attribute. */
struct pc98_text {
    char row[PC98_TEXT_ROWS][PC98_TEXT_COLUMNS + 1];
    uint8_t attribute[PC98_TEXT_ROWS][PC98_TEXT_COLUMNS];
};

/* Makes the memory as the machine's start leaves it: no characters, every cell white. */
void pc98_text_clear(uint8_t memory[PC98_TEXT_MEMORY_BYTES]);

/* Reads the memory. What is not printable ASCII becomes '?'; 0 and a secret cell become blanks. */
void pc98_text_read(const uint8_t memory[PC98_TEXT_MEMORY_BYTES], struct pc98_text *text);

/* Writes the 25 rows. Then comes a line for each run of cells that are not plain white and not
 * blank, as "row 3, columns 0-14: green reverse". Returns false if the file cannot be written. */
bool pc98_text_write(FILE *file, const struct pc98_text *text);

#endif
