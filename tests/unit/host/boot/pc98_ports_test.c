/* SPDX-License-Identifier: MIT */
/* The ports that a booting floppy meets: the keyboard, line 20, the reset, the board behind them.
 */
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "board.h"
#include "boot/pc98_ports.h"

static struct board board;

/* Returns the bus of a new board, which is `board`. */
static struct bus *new_board(void) {
    static struct board_bus bus;
    const struct board_desc desc = board_default_desc(BOARD_1987);
    assert_true(board_init(&board, &desc));
    board_bus_init(&bus, &board);
    return &bus.bus;
}

static void escape_is_pressed_once(void **state) {
    (void)state;
    struct pc98_ports ports = {.escape_after = 2};
    assert_int_equal(pc98_port_read(&ports, 0x43, 1), 0x85);
    assert_int_equal(pc98_port_read(&ports, 0x41, 1), 0xFF);
    assert_int_equal(pc98_port_read(&ports, 0x43, 1), 0x87);
    assert_int_equal(pc98_port_read(&ports, 0x41, 1), 0);
    assert_int_equal(pc98_port_read(&ports, 0x43, 1), 0x85);
    struct pc98_ports untouched = {.escape_after = 0};
    for (int i = 0; i < 10; i++) {
        assert_int_equal(pc98_port_read(&untouched, 0x43, 1), 0x85);
    }
}

static void other_ports_are_the_boards(void **state) {
    (void)state;
    struct pc98_ports ports = {.bus = new_board()};
    pc98_port_write(&ports, 0x00D4, UINT32_C(0x01230045), 4); /* X = 45h, Y = 123h */
    assert_int_equal(board.x, 0x45);
    assert_int_equal(board.y, 0x123);
    pc98_port_write(&ports, 0x00D8, 0xAA, 1);
    assert_int_equal(pc98_port_read(&ports, 0x00D8, 1), 0xAA);
    assert_int_equal(pc98_port_read(&ports, 0x00DA, 1), 0);
    assert_int_equal(board_violations(&board), 0);
}

/* A wait is so many reads of the status with nothing in between, and no key to come. */
static void a_wait_for_a_key_is_seen(void **state) {
    (void)state;
    struct pc98_ports ports = {.bus = new_board(), .polls = PC98_POLLS_OF_A_WAIT};
    assert_false(pc98_ports_wait_in_vain(&ports));
    (void)pc98_port_read(&ports, 0x43, 1);
    assert_true(pc98_ports_wait_in_vain(&ports));
    ports.escape_after = 1;
    assert_false(pc98_ports_wait_in_vain(&ports));
    (void)pc98_port_read(&ports, 0x41, 1);
    assert_true(pc98_ports_wait_in_vain(&ports));
    pc98_port_write(&ports, 0xD8, 0, 1);
    assert_false(pc98_ports_wait_in_vain(&ports));
    ports.polls = PC98_POLLS_OF_A_WAIT + 1;
    (void)pc98_port_read(&ports, 0xD8, 1);
    assert_false(pc98_ports_wait_in_vain(&ports));
}

/* The machine's own ports end here: a trace, and a hash, has those of the board alone. */
static void own_ports_do_not_reach_the_bus(void **state) {
    (void)state;
    static const uint16_t own[] = {0xF0, 0xF2, 0xF6, 0x68, 0x6A, 0xA0, 0xA2,
                                   0xA4, 0xA6, 0xA8, 0xAA, 0xAC, 0xAE};
    struct pc98_ports ports = {.bus = new_board()};
    for (size_t i = 0; i < sizeof own / sizeof own[0]; i++) {
        pc98_port_write(&ports, own[i], 0, 1);
    }
    assert_int_equal(pc98_port_read(&ports, 0xF2, 1), 0xFE);
    assert_int_equal(board.accesses, 0);
    assert_true(ports.is_reset);
    pc98_port_write(&ports, 0x5F, 0, 1);
    assert_int_equal(board.accesses, 1);
}

static void line_20_is_switched(void **state) {
    (void)state;
    struct pc98_ports ports = {.is_line_20_on = false};
    assert_int_equal(pc98_port_read(&ports, 0xF2, 1), 0xFF);
    pc98_port_write(&ports, 0xF6, 2, 1);
    assert_true(ports.is_line_20_on);
    pc98_port_write(&ports, 0xF6, 1, 1);
    assert_true(ports.is_line_20_on);
    pc98_port_write(&ports, 0xF6, 3, 1);
    assert_false(ports.is_line_20_on);
    pc98_port_write(&ports, 0xF2, 0, 1);
    assert_int_equal(pc98_port_read(&ports, 0xF2, 1), 0xFE);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(escape_is_pressed_once),
        cmocka_unit_test(other_ports_are_the_boards),
        cmocka_unit_test(a_wait_for_a_key_is_seen),
        cmocka_unit_test(own_ports_do_not_reach_the_bus),
        cmocka_unit_test(line_20_is_switched),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
