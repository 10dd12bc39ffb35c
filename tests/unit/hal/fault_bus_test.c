/* SPDX-License-Identifier: MIT */
/* Injected faults: each kind does what it says, as often as it says, the same with the same seed.
 */
#include "board_fixture.h"

#include "fault_bus.h"
#include "splitmix64.h"

static struct fault_bus faulty;

static void power_on_with(const struct fault_plan *plan) {
    power_on(BOARD_1987);
    fault_bus_init(&faulty, &board_bus.bus, plan);
    bus_bind(&faulty.bus);
}

static void without_a_plan_nothing_is_changed(void **state) {
    const struct fault_plan none = {0};
    (void)state;
    power_on_with(&none);
    put_pixel(600, 300, 0x123456);
    assert_int_equal(get_here(), 0x123456);
    assert_int_equal(inpw(0x00D8), 0xFF12);
    assert_int_equal(faulty.accesses, 9);
    assert_int_equal(board.accesses, 9);
    assert_int_equal(faulty.lost_writes + faulty.flipped_writes + faulty.flipped_reads, 0);
    assert_int_equal(bus_flush(&faulty.bus), BUS_OK);
}

static void writes_are_lost_as_often_as_asked(void **state) {
    static const uint32_t one_in[] = {1, 2, 10, 100};
    (void)state;
    for (unsigned i = 0; i < 4; i++) {
        const struct fault_plan plan = {.seed = 3, .lose_one_in = one_in[i]};
        power_on_with(&plan);
        for (unsigned j = 0; j < 100000; j++) {
            outp(0x00D8, (uint8_t)j);
        }
        uint64_t mean = 100000 / one_in[i]; /* four standard deviations are under 4 sqrt(mean) */
        assert_in_range(faulty.lost_writes, i == 0 ? 100000 : mean * 85 / 100, mean * 115 / 100);
        assert_int_equal(board.writes[0x8][0], 100000 - faulty.lost_writes);
    }
}

static void exactly_one_bit_of_the_width_flips(void **state) {
    const struct fault_plan plan = {.seed = 9, .flip_write_one_in = 1};
    bool is_seen[16] = {false};
    (void)state;
    power_on_with(&plan);
    for (unsigned i = 0; i < 1000; i++) {
        outp(0x00D8, 0x5A);
        unsigned difference = inp(0x00D8) ^ 0x5AU;
        assert_true(difference != 0 && (difference & (difference - 1)) == 0);
        outpw(0x00D4, 0x0000);
        for (unsigned bit = 0; bit < 10; bit++) {
            is_seen[bit] = is_seen[bit] || board.x == 1U << bit;
        }
    }
    for (unsigned bit = 0; bit < 10; bit++) {
        assert_true(is_seen[bit]);
    }
    assert_int_equal(faulty.flipped_writes, 2000);
}

static void a_flipped_read_leaves_the_board_as_it_is(void **state) {
    const struct fault_plan plan = {.seed = 9, .flip_read_one_in = 1};
    (void)state;
    power_on_with(&plan);
    outp(0x00D8, 0x5A);
    for (unsigned i = 0; i < 100; i++) {
        unsigned difference = inp(0x00D8) ^ 0x5AU;
        assert_true(difference != 0 && (difference & (difference - 1)) == 0);
    }
    assert_int_equal(board_read(&board, 0x00D8, 1), 0x5A);
    assert_int_equal(faulty.flipped_reads, 100);
}

static void a_dead_channel_takes_nothing_and_gives_ff(void **state) {
    const struct fault_plan plan = {.has_dead_port = true, .dead_port = 0x00DA};
    (void)state;
    power_on_with(&plan);
    put_pixel(1, 1, 0x112233);
    assert_int_equal(get_here(), 0x11FF33);
    assert_int_equal(inp(0x00DB), 0xFF);
    assert_int_equal(inpw(0x00DA), 0xFFFF);
    assert_int_equal(board_read(&board, 0x00DA, 1), 0x00);
    assert_int_equal(faulty.lost_writes, 1);
    assert_int_equal(faulty.dead_reads, 3);
    assert_int_equal(bus_bound_status(), BUS_OK);
}

static void an_absent_board_reads_ff_and_nobody_is_told(void **state) {
    const struct fault_plan plan = {.is_absent = true};
    (void)state;
    power_on_with(&plan);
    put_pixel(0, 0, 0xAAAAAA);
    assert_int_equal(get_here(), 0xFFFFFF);
    assert_int_equal(inpw(0x00D0), 0xFFFF);
    assert_int_equal(board.accesses, 0);
    assert_int_equal(bus_bound_status(), BUS_OK);
}

static void a_board_vanishes_after_k_accesses(void **state) {
    (void)state;
    for (int lost = 0; lost < 2; lost++) {
        const struct fault_plan plan = {.vanish_after = 3,
                                        .vanish_status = lost ? BUS_LOST : BUS_OK};
        power_on_with(&plan);
        outp(0x00D8, 0x11);
        outp(0x00DA, 0x22);
        assert_int_equal(inp(0x00D8), 0x11);
        assert_int_equal(bus_bound_status(), BUS_OK);
        outp(0x00D8, 0x99);
        assert_int_equal(inp(0x00D8), 0xFF);
        assert_int_equal(inpw(0x00D8), 0xFFFF);
        assert_int_equal(board.accesses, 3);
        assert_int_equal(bus_bound_status(), lost ? BUS_LOST : BUS_OK);
    }
}

static void the_same_seed_gives_the_same_faults_and_another_seed_others(void **state) {
    static struct board first;
    (void)state;
    for (int run = 0; run < 3; run++) {
        const struct fault_plan plan = {.seed = run < 2 ? 5 : 6,
                                        .lose_one_in = 7,
                                        .flip_write_one_in = 5,
                                        .flip_read_one_in = 3};
        power_on_with(&plan);
        for (unsigned i = 0; i < 3000; i++) {
            put_pixel(i % 640, i % 400, i * 999);
            inp(0x00D8);
        }
        if (run == 0) {
            first = board;
        } else if (run == 1) {
            assert_memory_equal(board.memory, first.memory, sizeof first.memory);
        } else {
            assert_memory_not_equal(board.memory, first.memory, sizeof first.memory);
        }
    }
}

static void a_failure_behind_it_comes_through(void **state) {
    const struct fault_plan none = {0};
    (void)state;
    power_on_with(&none);
    bus_fail(&board_bus.bus, BUS_TIMEOUT);
    outp(0x00D8, 1);
    assert_int_equal(bus_bound_status(), BUS_TIMEOUT);
}

/* Of the reference implementation: prng.di.unimi.it/splitmix64.c, from the state 1234567. */
static void random_numbers_are_the_published_ones(void **state) {
    static const uint64_t published[] = {6457827717110365317U, 3203168211198807973U,
                                         9817491932198370423U, 4593380528125082431U,
                                         16408922859458223821U};
    uint64_t random = 1234567;
    (void)state;
    for (unsigned i = 0; i < 5; i++) {
        assert_true(splitmix64(&random) == published[i]);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(without_a_plan_nothing_is_changed),
        cmocka_unit_test(writes_are_lost_as_often_as_asked),
        cmocka_unit_test(exactly_one_bit_of_the_width_flips),
        cmocka_unit_test(a_flipped_read_leaves_the_board_as_it_is),
        cmocka_unit_test(a_dead_channel_takes_nothing_and_gives_ff),
        cmocka_unit_test(an_absent_board_reads_ff_and_nobody_is_told),
        cmocka_unit_test(a_board_vanishes_after_k_accesses),
        cmocka_unit_test(the_same_seed_gives_the_same_faults_and_another_seed_others),
        cmocka_unit_test(a_failure_behind_it_comes_through),
        cmocka_unit_test(random_numbers_are_the_published_ones),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
