/* SPDX-License-Identifier: MIT */
/* The hash of a run: which bytes it takes, and what it leaves alone. */
#include "board_fixture.h"

#include "trace_hash.h"

#include <stdlib.h>
#include <xxhash.h>

static struct trace_hash hash;

static void it_is_xxh3_over_five_bytes_a_write(void **state) {
    static const uint8_t bytes[] = {0xD4, 0x00, 2, 0x23, 0x01, 0xD8, 0x00, 1, 0xFF, 0x00,
                                    0xD8, 0x0C, 1, 0x00, 0x00, 0xFF, 0xFF, 2, 0xEF, 0xBE};
    (void)state;
    assert_true(trace_hash_init(&hash, NULL));
    bus_bind(&hash.bus);
    assert_int_equal(trace_hash_value(&hash), XXH3_64bits("", 0));
    outpw(0x00D4, 0x0123);
    outp(0x00D8, 0xFF);
    assert_int_equal(trace_hash_value(&hash), XXH3_64bits(bytes, 10));
    outp(0x0CD8, 0x00);
    outpw(0xFFFF, 0xBEEF);
    assert_int_equal(trace_hash_value(&hash), XXH3_64bits(bytes, 20));
    assert_int_equal(hash.writes, 4);
    trace_hash_free(&hash);
    trace_hash_free(&hash);
}

static void writes_of_a_file_hash_as_those_on_a_bus(void **state) {
    struct trace_hash other;
    (void)state;
    power_on(BOARD_1987);
    assert_true(trace_hash_init(&hash, NULL) && trace_hash_init(&other, &board_bus.bus));
    for (unsigned i = 0; i < 2000; i++) { /* more than the buffer holds */
        bus_write(&hash.bus, 0x00D8, (uint16_t)(i & 0xFF), BUS_BYTE);
        trace_hash_add(&other, 0x00D8, (uint16_t)(i & 0xFF), BUS_BYTE);
    }
    assert_true(trace_hash_value(&hash) == trace_hash_value(&other));
    assert_int_equal(other.writes, 2000);
    assert_int_equal(board.accesses, 0); /* nothing is passed on */
    trace_hash_free(&hash);
    trace_hash_free(&other);
}

/* The published XXH3-64 of no input, as a check of the library that we link. */
static void the_hash_of_nothing_is_the_published_one(void **state) {
    (void)state;
    assert_true(trace_hash_init(&hash, NULL));
    assert_true(trace_hash_value(&hash) == 0x2D06800538D394C2U);
    trace_hash_free(&hash);
}

static void reads_do_not_count_and_are_answered_by_the_board(void **state) {
    (void)state;
    power_on(BOARD_1987);
    assert_true(trace_hash_init(&hash, &board_bus.bus));
    bus_bind(&hash.bus);
    put_pixel(1, 2, 0x112233);
    uint64_t before = trace_hash_value(&hash);
    assert_int_equal(get_here(), 0x112233);
    assert_int_equal(inpw(0x00D8), 0xFF11);
    assert_true(trace_hash_value(&hash) == before);
    assert_int_equal(board.accesses, 9);
    trace_hash_free(&hash);
    assert_true(trace_hash_init(&hash, NULL));
    bus_bind(&hash.bus);
    assert_int_equal(inp(0x00D8), 0xFF);
    assert_int_equal(inpw(0x00D8), 0xFFFF);
    trace_hash_free(&hash);
}

static void a_long_run_hashes_as_one_piece(void **state) {
    enum { WRITES = 10007 };
    uint8_t *bytes = malloc(WRITES * 5);
    uint64_t random = 17;
    (void)state;
    assert_non_null(bytes);
    assert_true(trace_hash_init(&hash, NULL));
    for (unsigned i = 0; i < WRITES; i++) {
        uint32_t draw = next_random(&random);
        unsigned width = (draw & 1) + 1;
        uint16_t value = (uint16_t)(width == 1 ? draw >> 8 & 0xFF : draw >> 8);
        uint16_t port = (uint16_t)next_random(&random);
        bytes[i * 5] = (uint8_t)port;
        bytes[i * 5 + 1] = (uint8_t)(port >> 8);
        bytes[i * 5 + 2] = (uint8_t)width;
        bytes[i * 5 + 3] = (uint8_t)value;
        bytes[i * 5 + 4] = (uint8_t)(value >> 8);
        bus_write(&hash.bus, port, value, width);
        if (i % 1777 == 0) { /* asking in between changes nothing */
            assert_true(trace_hash_value(&hash) == XXH3_64bits(bytes, (i + 1) * 5));
        }
    }
    assert_true(trace_hash_value(&hash) == XXH3_64bits(bytes, WRITES * 5));
    trace_hash_free(&hash);
    free(bytes);
}

static void a_failure_behind_it_comes_through(void **state) {
    (void)state;
    power_on(BOARD_1987);
    assert_true(trace_hash_init(&hash, &board_bus.bus));
    assert_int_equal(bus_flush(&hash.bus), BUS_OK);
    bus_fail(&board_bus.bus, BUS_LOST);
    assert_int_equal(bus_flush(&hash.bus), BUS_LOST);
    trace_hash_free(&hash);
    assert_true(trace_hash_init(&hash, &board_bus.bus));
    assert_int_equal(hash.bus.status, BUS_LOST);
    trace_hash_free(&hash);
    assert_true(trace_hash_init(&hash, NULL));
    assert_int_equal(bus_flush(&hash.bus), BUS_OK);
    trace_hash_free(&hash);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(it_is_xxh3_over_five_bytes_a_write),
        cmocka_unit_test(the_hash_of_nothing_is_the_published_one),
        cmocka_unit_test(reads_do_not_count_and_are_answered_by_the_board),
        cmocka_unit_test(a_long_run_hashes_as_one_piece),
        cmocka_unit_test(a_failure_behind_it_comes_through),
        cmocka_unit_test(writes_of_a_file_hash_as_those_on_a_bus),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
