/* SPDX-License-Identifier: MIT */
/* What accesses cost: the manuals' clocks, the machines, and the sums. */
#include "board_fixture.h"

#include "cost_bus.h"

static struct cost_bus cost;

static void each_cpu_has_the_clocks_of_its_manual(void **state) {
    static const struct {
        enum cost_cpu cpu;
        unsigned out, in, odd_word;
    } cases[] = {{COST_8086, 8, 8, 12},
                 {COST_V30, 8, 8, 12},
                 {COST_80286, 3, 5, 5},
                 {COST_80386, 11, 13, 13}};
    (void)state;
    for (unsigned i = 0; i < 4; i++) {
        assert_int_equal(cost_clocks(cases[i].cpu, 0x00D8, 1, false), cases[i].out);
        assert_int_equal(cost_clocks(cases[i].cpu, 0x00D9, 1, false), cases[i].out);
        assert_int_equal(cost_clocks(cases[i].cpu, 0x00D4, 2, false), cases[i].out);
        assert_int_equal(cost_clocks(cases[i].cpu, 0x00D5, 2, false), cases[i].odd_word);
        assert_int_equal(cost_clocks(cases[i].cpu, 0x00D8, 1, true), cases[i].in);
    }
    assert_string_equal(cost_cpu_text(COST_V30), "V30");
    assert_string_equal(cost_cpu_text(COST_80386), "80386");
}

static void the_machines_of_the_time_are_known_by_name(void **state) {
    unsigned count;
    const struct cost_machine *machines = cost_machines(&count);
    (void)state;
    for (unsigned i = 0; i < count; i++) {
        assert_ptr_equal(cost_machine_by_name(machines[i].name), &machines[i]);
    }
    assert_int_equal(cost_machine_by_name("VM2")->cpu, COST_V30);
    assert_int_equal(cost_machine_by_name("VX2")->cpu, COST_80286);
    assert_int_equal(cost_machine_by_name("RA2")->cpu, COST_80386);
    assert_null(cost_machine_by_name("PC-8001"));
}

/* One line of a picture: 1 Y, 640 X, 1920 primaries: 2561 writes. By hand: V30 at 10 MHz
 * 2561 x 8 / 10 MHz = 2.0488 ms; 286 at 8 MHz 2561 x 3 / 8 MHz = 0.960375 ms; 386 at 16 MHz
 * 2561 x 11 / 16 MHz = 1.7606875 ms. */
static void a_line_of_a_picture_takes_as_long_as_reckoned_by_hand(void **state) {
    static const struct {
        const char *machine;
        double microseconds;
    } cases[] = {{"VM2", 2048.8}, {"VX2", 960.375}, {"RA2", 1760.6875}};
    (void)state;
    power_on(BOARD_1987);
    cost_bus_init(&cost, &board_bus.bus);
    bus_bind(&cost.bus);
    outpw(0x00D6, 0);
    for (unsigned x = 0; x < 640; x++) {
        outpw(0x00D4, (uint16_t)x);
        outp(0x00D8, 1);
        outp(0x00DA, 1);
        outp(0x00DC, 1);
    }
    assert_int_equal(cost.writes[0], 1920);
    assert_int_equal(cost.writes[1], 641);
    assert_int_equal(cost_bus_cycles(&cost), 2561);
    assert_int_equal(board.accesses, 2561);
    for (unsigned i = 0; i < 3; i++) {
        const struct cost_machine *machine = cost_machine_by_name(cases[i].machine);
        double error = cost_bus_seconds(&cost, machine, 0) * 1e6 - cases[i].microseconds;
        assert_true(error < 1e-6 && error > -1e-6);
        error = cost_bus_seconds(&cost, machine, 400) * 1e6 - cases[i].microseconds - 1024.4;
        assert_true(error < 1e-6 && error > -1e-6); /* 2561 x 0.4 us */
    }
}

static void reads_and_words_at_odd_ports_are_counted_apart(void **state) {
    (void)state;
    cost_bus_init(&cost, NULL);
    bus_bind(&cost.bus);
    assert_int_equal(inp(0x00D8), 0xFF);
    assert_int_equal(inpw(0x00D8), 0xFFFF);
    assert_int_equal(inpw(0x00D9), 0xFFFF);
    outpw(0x00D5, 0);
    assert_int_equal(cost.reads[0], 1);
    assert_int_equal(cost.reads[1], 2);
    assert_int_equal(cost.odd_words, 2);
    assert_int_equal(cost_bus_cycles(&cost), 6);
    assert_int_equal(cost_bus_clocks(&cost, COST_8086), 8 + 8 + 12 + 12);
    assert_int_equal(cost_bus_clocks(&cost, COST_80286), 5 + 5 + 7 + 5);
    assert_int_equal(bus_flush(&cost.bus), BUS_OK);
}

static void answers_and_failures_come_through(void **state) {
    (void)state;
    power_on(BOARD_1987);
    cost_bus_init(&cost, &board_bus.bus);
    bus_bind(&cost.bus);
    outp(0x00D8, 0x77);
    assert_int_equal(inp(0x00D8), 0x77);
    assert_int_equal(bus_flush(&cost.bus), BUS_OK);
    bus_fail(&board_bus.bus, BUS_LOST);
    assert_int_equal(inp(0x00D8), 0xFF);
    assert_int_equal(bus_bound_status(), BUS_LOST);
}

static void a_write_to_a_device_that_has_failed_is_counted_and_goes_no_further(void **state) {
    (void)state;
    power_on(BOARD_1987);
    cost_bus_init(&cost, &board_bus.bus);
    bus_bind(&cost.bus);
    bus_fail(&board_bus.bus, BUS_TIMEOUT);
    outp(0x00D8, 0x77);
    assert_int_equal(bus_bound_status(), BUS_TIMEOUT);
    assert_int_equal(cost.writes[0], 1);
    assert_int_equal(board.accesses, 0);
    outp(0x00D8, 0x78);
    assert_int_equal(cost.writes[0], 1);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_cpu_has_the_clocks_of_its_manual),
        cmocka_unit_test(the_machines_of_the_time_are_known_by_name),
        cmocka_unit_test(a_line_of_a_picture_takes_as_long_as_reckoned_by_hand),
        cmocka_unit_test(reads_and_words_at_odd_ports_are_counted_apart),
        cmocka_unit_test(answers_and_failures_come_through),
        cmocka_unit_test(a_write_to_a_device_that_has_failed_is_counted_and_goes_no_further),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
