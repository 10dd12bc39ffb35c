/* SPDX-License-Identifier: MIT */
/* The text screen of a PC-9801: what its memory shows. */
#include "boot/pc98_text.h"

#include <string.h>

void pc98_text_clear(uint8_t memory[PC98_TEXT_MEMORY_BYTES]) {
    memset(memory, 0, PC98_TEXT_MEMORY_BYTES);
    for (unsigned i = 0; i < PC98_TEXT_ROWS * PC98_TEXT_COLUMNS; i++) {
        memory[PC98_TEXT_ATTRIBUTES + 2 * i] = PC98_TEXT_WHITE;
    }
}

/* Returns what is seen of a cell whose code has these two bytes. */
static char letter_of(const uint8_t *cell, uint8_t attribute) {
    if ((attribute & PC98_TEXT_SHOWN) == 0 || (cell[0] == 0 && cell[1] == 0)) {
        return ' ';
    }
    return cell[1] == 0 && cell[0] >= 0x20 && cell[0] < 0x7F ? (char)cell[0] : '?';
}

void pc98_text_read(const uint8_t memory[PC98_TEXT_MEMORY_BYTES], struct pc98_text *text) {
    for (unsigned row = 0; row < PC98_TEXT_ROWS; row++) {
        unsigned length = 0;
        for (unsigned column = 0; column < PC98_TEXT_COLUMNS; column++) {
            unsigned place = 2 * (row * PC98_TEXT_COLUMNS + column);
            uint8_t attribute = memory[PC98_TEXT_ATTRIBUTES + place];
            char letter = letter_of(&memory[place], attribute);
            text->row[row][column] = letter;
            text->attribute[row][column] = attribute;
            length = letter == ' ' ? length : column + 1;
        }
        text->row[row][length] = '\0';
    }
}

/* The colours, by the attribute's bits 5 (blue), 6 (red) and 7 (green). */
static const char *const colours[] = {"black", "blue", "red",    "magenta",
                                      "green", "cyan", "yellow", "white"};

static const struct {
    uint8_t bit;
    const char *word;
} marks[] = {{PC98_TEXT_BLINK, " blink"},
             {PC98_TEXT_REVERSE, " reverse"},
             {PC98_TEXT_UNDERLINE, " underline"},
             {PC98_TEXT_VERTICAL_LINE, " vertical-line"}};

/* Tells whether a cell has an attribute worth a line. A blank shows some marks, but no colour. */
static bool is_marked(const struct pc98_text *text, unsigned row, unsigned column) {
    uint8_t attribute = text->attribute[row][column];
    bool is_blank = column >= strlen(text->row[row]) || text->row[row][column] == ' ';
    const unsigned lines = PC98_TEXT_REVERSE | PC98_TEXT_UNDERLINE | PC98_TEXT_VERTICAL_LINE;
    return (attribute & PC98_TEXT_SHOWN) != 0 && attribute != PC98_TEXT_WHITE &&
           (!is_blank || (attribute & lines) != 0);
}

static void write_run(FILE *file, unsigned row, unsigned first, unsigned last, uint8_t attribute) {
    (void)fprintf(file, "row %u, columns %u-%u: %s", row, first, last, colours[attribute >> 5]);
    for (unsigned i = 0; i < sizeof marks / sizeof marks[0]; i++) {
        if ((attribute & marks[i].bit) != 0) {
            (void)fputs(marks[i].word, file);
        }
    }
    (void)fputc('\n', file);
}

bool pc98_text_write(FILE *file, const struct pc98_text *text) {
    for (unsigned row = 0; row < PC98_TEXT_ROWS; row++) {
        (void)fprintf(file, "%s\n", text->row[row]);
    }
    for (unsigned row = 0; row < PC98_TEXT_ROWS; row++) {
        for (unsigned first = 0; first < PC98_TEXT_COLUMNS; first++) {
            unsigned last = first;
            if (!is_marked(text, row, first)) {
                continue;
            }
            while (last + 1 < PC98_TEXT_COLUMNS && is_marked(text, row, last + 1) &&
                   text->attribute[row][last + 1] == text->attribute[row][first]) {
                last++;
            }
            write_run(file, row, first, last, text->attribute[row][first]);
            first = last;
        }
    }
    return ferror(file) == 0;
}
