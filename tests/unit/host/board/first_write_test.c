/* SPDX-License-Identifier: MIT */
/* The bus that notes when the first port was written: once, and without a trace in the chain. */
#include "board_fixture.h"

#include <math.h>
#include <stdlib.h>

#include "base/stopwatch.h"
#include "board/first_write.h"
#include "trace_hash.h"

static struct first_write first;

static void reads_do_not_count_and_the_first_write_does(void **state) {
    (void)state;
    power_on(BOARD_1987);
    struct bus *link = &board_bus.bus;
    first_write_await(&first, &link);
    assert_ptr_equal(link, &first.bus);
    outp(0x00D8, 0x55);
    bus_bind(link);
    assert_int_equal(inp(0x00D8), 0x55);
    assert_int_equal(bus_flush(link), BUS_OK);
    assert_false(first.has_happened);
    assert_ptr_equal(link, &first.bus);
    outp(0x00D8, 0xAA);
    assert_true(first.has_happened);
    assert_ptr_equal(link, &board_bus.bus);
    assert_int_equal(inp(0x00D8), 0xAA);
}

static void the_clocks_are_those_of_the_first_write(void **state) {
    (void)state;
    power_on(BOARD_1987);
    struct bus *link = &board_bus.bus;
    first_write_await(&first, &link);
    bus_bind(link);
    struct timespec before = stopwatch_start();
    volatile double work = 1;
    while (stopwatch_seconds(&before) < 0.02) {
        work = sqrt(work + 1);
    }
    outp(0x00D8, 1);
    struct timespec after = stopwatch_start();
    struct timespec cpu = {0, 0};
    assert_int_equal(clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &cpu), 0);
    assert_true(stopwatch_between(&before, &first.at) >= 0.02);
    assert_true(stopwatch_between(&first.at, &after) >= 0);
    assert_true(first.cpu_seconds > 0);
    assert_true(first.cpu_seconds <= (double)cpu.tv_sec + (double)cpu.tv_nsec * 1e-9);
    struct timespec noted = first.at;
    outp(0x00D8, 2);
    assert_memory_equal(&noted, &first.at, sizeof noted);
}

static void what_is_hashed_and_drawn_stays_the_same(void **state) {
    uint64_t values[2];
    (void)state;
    for (int timed = 0; timed < 2; timed++) {
        struct trace_hash hash;
        power_on(BOARD_1987);
        assert_true(trace_hash_init(&hash, &board_bus.bus));
        if (timed) {
            first_write_await(&first, &hash.inner);
        }
        bus_bind(&hash.bus);
        put_pixel(3, 2, 0x112233);
        put_pixel(4, 2, 0x445566);
        assert_ptr_equal(hash.inner, &board_bus.bus);
        assert_int_equal(board.accesses, 10);
        values[timed] = trace_hash_value(&hash);
        trace_hash_free(&hash);
    }
    assert_int_equal(values[0], values[1]);
}

static void break_on_write(struct bus *bus, uint16_t port, uint16_t value, unsigned width) {
    (void)port;
    (void)value;
    (void)width;
    bus_fail(bus, BUS_LOST);
}

static void a_failure_of_the_first_write_comes_through(void **state) {
    const struct bus_operations operations = {break_on_write, NULL, NULL};
    struct bus broken = {&operations, BUS_OK};
    struct trace_hash hash;
    (void)state;
    assert_true(trace_hash_init(&hash, &broken));
    first_write_await(&first, &hash.inner);
    bus_bind(&hash.bus);
    assert_int_equal(bus_bound_status(), BUS_OK);
    outp(0x00D8, 1);
    assert_int_equal(bus_bound_status(), BUS_LOST);
    assert_int_equal(inp(0x00D8), 0xFF);
    bus_bind(NULL);
    trace_hash_free(&hash);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(reads_do_not_count_and_the_first_write_does),
        cmocka_unit_test(the_clocks_are_those_of_the_first_write),
        cmocka_unit_test(what_is_hashed_and_drawn_stays_the_same),
        cmocka_unit_test(a_failure_of_the_first_write_comes_through),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
