/* SPDX-License-Identifier: MIT */
/* The seam: which bus outp() reaches, the sticky status, and the empty slot. */
#include "board_fixture.h"

#include "null_bus.h"

/* A bus that remembers the last access and can be told to fail. */
struct spy {
    struct bus bus;
    uint16_t port, value;
    unsigned width, calls, flushes;
    enum bus_status fail_with;
    uint16_t answer;
};

static void spy_write(struct bus *bus, uint16_t port, uint16_t value, unsigned width) {
    struct spy *spy = (struct spy *)bus;
    spy->port = port;
    spy->value = value;
    spy->width = width;
    spy->calls++;
    bus_fail(bus, spy->fail_with);
}

static uint16_t spy_read(struct bus *bus, uint16_t port, unsigned width) {
    spy_write(bus, port, 0, width);
    return ((struct spy *)bus)->answer;
}

static void spy_flush(struct bus *bus) {
    struct spy *spy = (struct spy *)bus;
    spy->flushes++;
    bus_fail(bus, spy->fail_with);
}

static const struct bus_operations spy_operations = {spy_write, spy_read, spy_flush};

static void spy_init(struct spy *spy) {
    const struct spy fresh = {.bus = {&spy_operations, BUS_OK}, .answer = 0x1234};
    *spy = fresh;
}

static void with_no_bus_bound_writes_vanish_and_reads_give_ff(void **state) {
    (void)state;
    bus_bind(NULL);
    outp(0x00D8, 1);
    outpw(0x00D4, 1);
    assert_int_equal(inp(0x00D8), 0xFF);
    assert_int_equal(inpw(0x00D8), 0xFFFF);
    assert_int_equal(bus_bound_status(), BUS_UNBOUND);
}

static void binding_returns_the_bus_that_was_bound_before(void **state) {
    (void)state;
    struct spy a, b;
    spy_init(&a);
    spy_init(&b);
    bus_bind(NULL);
    assert_null(bus_bind(&a.bus));
    assert_ptr_equal(bus_bind(&b.bus), &a.bus);
    assert_ptr_equal(bus_bind(NULL), &b.bus);
}

static void each_access_reaches_the_bound_bus_with_port_value_and_width(void **state) {
    (void)state;
    struct spy spy;
    spy_init(&spy);
    bus_bind(&spy.bus);
    outp(0x00D8, 0xA5);
    assert_true(spy.port == 0x00D8 && spy.value == 0xA5 && spy.width == 1);
    outpw(0xFFFE, 0xBEEF);
    assert_true(spy.port == 0xFFFE && spy.value == 0xBEEF && spy.width == 2);
    assert_int_equal(inp(0x00DA), 0x34); /* a byte is the low byte, whatever the back end gives */
    assert_true(spy.port == 0x00DA && spy.width == 1);
    assert_int_equal(inpw(0x0001), 0x1234);
    assert_true(spy.port == 0x0001 && spy.width == 2);
    assert_int_equal(spy.calls, 4);
    assert_int_equal(bus_bound_status(), BUS_OK);
}

static void the_first_failure_stays_and_nothing_reaches_the_bus_after_it(void **state) {
    (void)state;
    struct spy spy;
    spy_init(&spy);
    bus_bind(&spy.bus);
    spy.fail_with = BUS_LOST;
    outp(0x00D8, 1);
    spy.fail_with = BUS_TIMEOUT;
    outp(0x00D8, 2);
    outpw(0x00D8, 2);
    bus_write(&spy.bus, 0x00D8, 2, 1);
    assert_int_equal(inp(0x00D8), 0xFF);
    assert_int_equal(inpw(0x00D8), 0xFFFF);
    assert_int_equal(bus_flush(&spy.bus), BUS_LOST);
    bus_fail(&spy.bus, BUS_PROTOCOL);
    assert_int_equal(bus_bound_status(), BUS_LOST);
    assert_int_equal(spy.calls, 1);
    assert_int_equal(spy.flushes, 0);
}

static void a_read_that_breaks_the_bus_gives_ff(void **state) {
    (void)state;
    struct spy spy;
    spy_init(&spy);
    spy.fail_with = BUS_TIMEOUT;
    assert_int_equal(bus_read(&spy.bus, 0x00D8, 2), 0xFFFF);
    assert_int_equal(spy.bus.status, BUS_TIMEOUT);
}

static void flush_reaches_a_bus_that_buffers_and_skips_one_that_does_not(void **state) {
    (void)state;
    struct spy spy;
    struct bus empty;
    spy_init(&spy);
    assert_int_equal(bus_flush(&spy.bus), BUS_OK);
    assert_int_equal(spy.flushes, 1);
    spy.fail_with = BUS_IO_ERROR;
    assert_int_equal(bus_flush(&spy.bus), BUS_IO_ERROR);
    null_bus_init(&empty);
    assert_int_equal(bus_flush(&empty), BUS_OK);
}

static void an_empty_slot_swallows_writes_and_reads_ff_without_failing(void **state) {
    (void)state;
    struct bus empty;
    null_bus_init(&empty);
    bus_write(&empty, 0x00D8, 1, 1);
    assert_int_equal(bus_read(&empty, 0x00D8, 1), 0x00FF);
    assert_int_equal(bus_read(&empty, 0x00D8, 2), 0xFFFF);
    assert_int_equal(empty.status, BUS_OK);
}

static void every_status_has_a_text_of_its_own(void **state) {
    (void)state;
    for (int a = BUS_OK; a <= BUS_REFUSED; a++) {
        assert_true(strlen(bus_status_text((enum bus_status)a)) > 0);
        for (int b = BUS_OK; b < a; b++) {
            assert_string_not_equal(bus_status_text((enum bus_status)a),
                                    bus_status_text((enum bus_status)b));
        }
    }
    assert_string_equal(bus_status_text((enum bus_status)99), "unknown bus status");
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(with_no_bus_bound_writes_vanish_and_reads_give_ff),
        cmocka_unit_test(binding_returns_the_bus_that_was_bound_before),
        cmocka_unit_test(each_access_reaches_the_bound_bus_with_port_value_and_width),
        cmocka_unit_test(the_first_failure_stays_and_nothing_reaches_the_bus_after_it),
        cmocka_unit_test(a_read_that_breaks_the_bus_gives_ff),
        cmocka_unit_test(flush_reaches_a_bus_that_buffers_and_skips_one_that_does_not),
        cmocka_unit_test(an_empty_slot_swallows_writes_and_reads_ff_without_failing),
        cmocka_unit_test(every_status_has_a_text_of_its_own),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
