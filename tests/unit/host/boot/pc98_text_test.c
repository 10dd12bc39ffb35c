/* SPDX-License-Identifier: MIT */
/* The text screen: letters, secret cells, attributes as words. */
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "boot/pc98_text.h"

static uint8_t memory[PC98_TEXT_MEMORY_BYTES];
static struct pc98_text text;

/* Puts a code and an attribute into a cell. */
static void put(unsigned row, unsigned column, unsigned code, uint8_t attribute) {
    unsigned place = 2 * (row * PC98_TEXT_COLUMNS + column);
    memory[place] = (uint8_t)code;
    memory[place + 1] = (uint8_t)(code >> 8);
    memory[0x2000 + place] = attribute;
}

static void text_loses_its_blanks_and_keeps_its_rows(void **state) {
    (void)state;
    pc98_text_clear(memory);
    put(0, 1, 'A', 0xE1);
    put(0, 2, ' ', 0xE1);
    put(0, 3, 0x0941, 0xE1); /* half of a kanji */
    put(24, 79, 'Z', 0xE1);
    pc98_text_read(memory, &text);
    assert_string_equal(text.row[0], " A ?");
    assert_string_equal(text.row[1], "");
    assert_int_equal(strlen(text.row[24]), 80);
    assert_int_equal(text.row[24][79], 'Z');
}

/* All 65,536 codes of a cell, 79 to a row; the last column keeps the blanks before it. */
static void a_code_is_read_as_its_letter_a_blank_or_a_question_mark(void **state) {
    enum { CODES = 65536, IN_ROW = PC98_TEXT_COLUMNS - 1, IN_ALL = IN_ROW * PC98_TEXT_ROWS };
    (void)state;
    for (unsigned first = 0; first < CODES; first += IN_ALL) {
        pc98_text_clear(memory);
        for (unsigned i = 0; i < IN_ALL; i++) {
            put(i / IN_ROW, i % IN_ROW, (first + i) % CODES, 0xE1);
            put(i / IN_ROW, IN_ROW, '.', 0xE1);
        }
        pc98_text_read(memory, &text);
        for (unsigned i = 0; i < IN_ALL; i++) {
            unsigned code = (first + i) % CODES;
            bool is_letter = code >= ' ' && code <= '~';
            assert_int_equal(text.row[i / IN_ROW][i % IN_ROW], is_letter   ? (char)code
                                                               : code == 0 ? ' '
                                                                           : '?');
        }
        assert_int_equal(strlen(text.row[0]), PC98_TEXT_COLUMNS);
    }
}

/* Whatever else the attribute says, bit 0 alone decides whether a cell is seen. */
static void a_secret_cell_is_a_blank(void **state) {
    (void)state;
    for (unsigned attribute = 0; attribute < 256; attribute++) {
        pc98_text_clear(memory);
        put(3, 0, 'S', (uint8_t)attribute);
        put(3, 1, 'T', 0xE1);
        pc98_text_read(memory, &text);
        assert_string_equal(text.row[3], (attribute & 1) != 0 ? "ST" : " T");
    }
}

/* Returns what pc98_text_write() writes, to be freed. */
static char *written(void) {
    char *bytes = NULL;
    size_t size = 0;
    FILE *file = open_memstream(&bytes, &size);
    assert_non_null(file);
    pc98_text_read(memory, &text);
    assert_true(pc98_text_write(file, &text));
    assert_int_equal(fclose(file), 0);
    return bytes;
}

static void attributes_are_written_as_words(void **state) {
    (void)state;
    static const char expected[] = "RGSW\n\n    L\n\n\n\n\n\n\n\n\n\n\n\n\n\n\n\n\n\n\n\n\n\n"
                                   "                                                              "
                                   "                 E\n"
                                   "row 0, columns 0-1: red\n"
                                   "row 0, columns 2-2: green blink reverse\n"
                                   "row 2, columns 4-5: white underline vertical-line\n"
                                   "row 24, columns 79-79: black\n";
    pc98_text_clear(memory);
    put(0, 0, 'R', 0x41);
    put(0, 1, 'G', 0x41);
    put(0, 2, 'S', 0x87);
    put(0, 3, 'W', 0xE1);
    put(1, 0, 'X', 0x40); /* secret: nothing is said of it */
    put(1, 1, 0, 0x41);   /* a blank has no colour */
    put(2, 4, 'L', 0xF9);
    put(2, 5, ' ', 0xF9);
    put(24, 79, 'E', 0x01);
    char *found = written();
    assert_string_equal(found, expected);
    free(found);
}

static void a_clear_screen_is_25_empty_lines(void **state) {
    (void)state;
    pc98_text_clear(memory);
    char *found = written();
    assert_string_equal(found, "\n\n\n\n\n\n\n\n\n\n\n\n\n\n\n\n\n\n\n\n\n\n\n\n\n");
    free(found);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(text_loses_its_blanks_and_keeps_its_rows),
        cmocka_unit_test(a_code_is_read_as_its_letter_a_blank_or_a_question_mark),
        cmocka_unit_test(a_secret_cell_is_a_blank),
        cmocka_unit_test(attributes_are_written_as_words),
        cmocka_unit_test(a_clear_screen_is_25_empty_lines),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
