/* SPDX-License-Identifier: MIT */
/* What a booting floppy meets: the disk's geometry, the text screen, the keyboard's ports. */
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <string.h>

#include "board.h"
#include "boot/pc98_machine.h"

static void sectors_lie_side_by_side(void **state) {
    (void)state;
    size_t offset = 1;
    assert_true(pc98_disk_place(0, 0, 1, 1024, &offset));
    assert_int_equal(offset, 0);
    assert_true(pc98_disk_place(0, 0, 8, 1024, &offset));
    assert_int_equal(offset, 7 * 1024);
    assert_true(pc98_disk_place(0, 1, 1, 1024, &offset));
    assert_int_equal(offset, 8 * 1024);
    assert_true(pc98_disk_place(1, 0, 1, 1024, &offset));
    assert_int_equal(offset, 16 * 1024);
    assert_true(pc98_disk_place(76, 1, 8, 1024, &offset));
    assert_int_equal(offset, 1261568 - 1024);
}

static void what_is_no_sector_is_refused(void **state) {
    (void)state;
    size_t offset;
    assert_false(pc98_disk_place(77, 0, 1, 1024, &offset));
    assert_false(pc98_disk_place(0, 2, 1, 1024, &offset));
    assert_false(pc98_disk_place(0, 0, 0, 1024, &offset));
    assert_false(pc98_disk_place(0, 0, 9, 1024, &offset));
    assert_false(pc98_disk_place(76, 1, 8, 1025, &offset));
    assert_false(pc98_disk_place(0, 0, 1, 1261569, &offset));
}

static void text_loses_its_blanks_and_keeps_its_rows(void **state) {
    (void)state;
    uint8_t vram[PC98_TEXT_BYTES] = {0};
    static struct pc98_text text;
    vram[2] = 'A';
    vram[4] = ' ';
    vram[6] = 0x41;
    vram[7] = 0x09; /* half of a kanji */
    vram[2 * 80 * 24 + 2 * 79] = 'Z';
    pc98_text_read(vram, &text);
    assert_string_equal(text.row[0], " A ?");
    assert_string_equal(text.row[1], "");
    assert_int_equal(strlen(text.row[24]), 80);
    assert_int_equal(text.row[24][79], 'Z');
}

/* All 65,536 codes of a cell, 79 to a row; the last column keeps the blanks before it. */
static void a_code_is_read_as_its_letter_a_blank_or_a_question_mark(void **state) {
    static uint8_t vram[PC98_TEXT_BYTES];
    static struct pc98_text text;
    enum { CODES = 65536, IN_ROW = PC98_TEXT_COLUMNS - 1, IN_ALL = IN_ROW * PC98_TEXT_ROWS };
    (void)state;
    for (unsigned first = 0; first < CODES; first += IN_ALL) {
        memset(vram, 0, sizeof vram);
        for (unsigned i = 0; i < IN_ALL; i++) {
            uint8_t *cell = vram + 2 * (i / IN_ROW * PC98_TEXT_COLUMNS + i % IN_ROW);
            cell[0] = (uint8_t)(first + i);
            cell[1] = (uint8_t)((first + i) >> 8);
            vram[2 * (i / IN_ROW * PC98_TEXT_COLUMNS + IN_ROW)] = '.';
        }
        pc98_text_read(vram, &text);
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

static void escape_is_pressed_once(void **state) {
    (void)state;
    struct pc98_ports ports = {.escape_after = 2};
    assert_int_equal(pc98_port_read(&ports, 0x43, 1), 0);
    assert_int_equal(pc98_port_read(&ports, 0x41, 1), 0xFF);
    assert_int_equal(pc98_port_read(&ports, 0x43, 1), 2);
    assert_int_equal(pc98_port_read(&ports, 0x41, 1), 0);
    assert_int_equal(pc98_port_read(&ports, 0x43, 1), 0);
    struct pc98_ports untouched = {.escape_after = 0};
    for (int i = 0; i < 10; i++) {
        assert_int_equal(pc98_port_read(&untouched, 0x43, 1), 0);
    }
}

static void other_ports_are_the_boards(void **state) {
    (void)state;
    static struct board board;
    const struct board_desc desc = board_default_desc(BOARD_1987);
    struct board_bus bus;
    assert_true(board_init(&board, &desc));
    board_bus_init(&bus, &board);
    struct pc98_ports ports = {.bus = &bus.bus};
    pc98_port_write(&ports, 0x00D4, UINT32_C(0x01230045), 4); /* X = 45h, Y = 123h */
    assert_int_equal(board.x, 0x45);
    assert_int_equal(board.y, 0x123);
    pc98_port_write(&ports, 0x00D8, 0xAA, 1);
    assert_int_equal(pc98_port_read(&ports, 0x00D8, 1), 0xAA);
    assert_int_equal(pc98_port_read(&ports, 0x00DA, 1), 0);
    assert_int_equal(board_violations(&board), 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sectors_lie_side_by_side),
        cmocka_unit_test(what_is_no_sector_is_refused),
        cmocka_unit_test(text_loses_its_blanks_and_keeps_its_rows),
        cmocka_unit_test(a_code_is_read_as_its_letter_a_blank_or_a_question_mark),
        cmocka_unit_test(escape_is_pressed_once),
        cmocka_unit_test(other_ports_are_the_boards),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
