/* SPDX-License-Identifier: MIT */
/* A picture over a cable that loses, damages and repeats what it carries: it arrives exactly, or
 * the error says which lines did. */
#include "usb_picture.h"

#include "trace_hash.h"

enum { RUNS = 200 };

static void a_good_cable_carries_every_access_once_and_in_order(void **state) {
    (void)state;
    for (int is_hid = 0; is_hid < 2; is_hid++) {
        const struct cable_faults none = {.is_hid = is_hid != 0};
        struct trace_hash near, far;
        struct usb_counts counts;
        plug_in(&none, 5);
        assert_true(trace_hash_init(&far, &far_board_bus.bus));
        cable.device.adapter.bus = &far.bus;
        assert_true(run_once(5, &counts));
        assert_true(trace_hash_init(&near, NULL));
        draw(&near.bus);
        assert_int_equal(near.writes, LINES * (1 + 4 * BOARD_WIDTH));
        assert_int_equal(far.writes, near.writes);
        assert_true(trace_hash_value(&far) == trace_hash_value(&near));
        assert_int_equal(counts.resent + counts.timeouts + counts.restarts, 0);
        assert_int_equal(cable.device.adapter.duplicates, 0);
        trace_hash_free(&near);
        trace_hash_free(&far);
    }
}

/* Everything at random: which faults, how often, bulk or HID. */
static struct cable_faults random_faults(uint64_t seed) {
    uint64_t random = seed * 2 + 1;
    struct cable_faults faults;
    uint32_t *const rates[] = {
        &faults.lose,          &faults.corrupt, &faults.duplicate,       &faults.lose_reply,
        &faults.corrupt_reply, &faults.stall,   &faults.duplicate_reply, &faults.unplug};
    memset(&faults, 0, sizeof faults);
    for (unsigned i = 0; i < sizeof rates / sizeof rates[0]; i++) {
        uint32_t rate = 4 + next_random(&random) % 30;
        *rates[i] = next_random(&random) % 3 == 0 || i == seed % 8 ? rate : 0;
    }
    faults.is_hid = next_random(&random) % 2 == 0;
    if (faults.is_hid) {
        faults.lose *= 4; /* a frame is up to 66 reports */
        faults.corrupt *= 4;
        faults.duplicate *= 4;
    }
    faults.restart = next_random(&random) % 4 == 0 ? 200 + next_random(&random) % 800 : 0;
    faults.power_cycle = next_random(&random) % 4;
    faults.is_board_cleared = next_random(&random) % 2 == 0;
    faults.unplugs_most = next_random(&random) % 4 == 0 ? 0 : 1000;
    return faults;
}

static void two_hundred_bad_cables_never_give_a_wrong_picture(void **state) {
    unsigned done = 0, refused = 0, struck = 0;
    struct usb_counts counts, sum;
    (void)state;
    memset(&sum, 0, sizeof sum);
    for (uint64_t seed = 1; seed <= RUNS; seed++) {
        const struct cable_faults faults = random_faults(seed);
        plug_in(&faults, seed);
        bool is_done = run_once(seed, &counts);
        done += is_done;
        refused += !is_done;
        struck += cable.struck > 0;
        sum.resent += counts.resent;
        sum.timeouts += counts.timeouts;
        sum.stalls += counts.stalls;
        sum.reconnects += counts.reconnects;
        sum.restarts += counts.restarts;
    }
    print_message("%u exact, %u refused; %lu resent, %lu timeouts, %lu stalls, %lu reconnects, "
                  "%lu restarts\n",
                  done, refused, (unsigned long)sum.resent, (unsigned long)sum.timeouts,
                  (unsigned long)sum.stalls, (unsigned long)sum.reconnects,
                  (unsigned long)sum.restarts);
    /* The test is none unless most runs were disturbed, and both ends were seen. */
    assert_true(struck > RUNS * 3 / 4);
    assert_true(done > RUNS / 2 && refused > 0);
    assert_true(sum.resent > 0 && sum.timeouts > 0 && sum.stalls > 0);
    assert_true(sum.reconnects > 0 && sum.restarts > 0);
}

static void reads_come_back_over_a_bad_cable(void **state) {
    const struct cable_faults faults = {.lose_reply = 5, .corrupt_reply = 5, .lose = 10};
    (void)state;
    plug_in(&faults, 3);
    struct usb_bus *usb_bus = start(3);
    usb_bus->limits.retries = 50;
    for (unsigned i = 0; i < 200; i++) {
        bus_write(&usb_bus->bus, 0x00D4, (uint16_t)i, BUS_WORD);
        bus_write(&usb_bus->bus, 0x00D6, 7, BUS_WORD);
        bus_write(&usb_bus->bus, 0x00DA, (uint16_t)(i ^ 0x5A), BUS_BYTE);
        assert_int_equal(bus_read(&usb_bus->bus, 0x00DA, BUS_BYTE), (i ^ 0x5A) & 0xFF);
        assert_int_equal(bus_read(&usb_bus->bus, 0x00DA, BUS_WORD), 0xFF00 | (i ^ 0x5A));
    }
    assert_int_equal(bus_flush(&usb_bus->bus), BUS_OK);
    assert_true(usb_bus->counts.timeouts > 0);
    usb_bus_free(usb_bus);
}

static void verifying_finds_and_repairs_what_differs(void **state) {
    struct usb_verification verification;
    (void)state;
    struct usb_bus *usb_bus = draw_over_a_good_cable(11);
    far_board.memory[(3 * BOARD_WIDTH + 100) * 3] ^= 0x10;
    far_board.memory[(3 * BOARD_WIDTH + 639) * 3 + 2] ^= 0x01;
    far_board.memory[(LINES - 1) * BOARD_WIDTH * 3 + 1] ^= 0x80;
    assert_true(usb_bus_verify(usb_bus, 100, 1, &verification));
    assert_int_equal(verification.pixels, LINES * BOARD_WIDTH);
    assert_int_equal(verification.repaired, 3);
    assert_int_equal(verification.wrong_lines, 0);
    for (unsigned y = 0; y < LINES; y++) {
        assert_true(is_line_right(y));
    }
    assert_true(usb_bus_verify(usb_bus, 50, 1, &verification));
    assert_true(verification.pixels > 0 && verification.pixels < LINES * BOARD_WIDTH);
    assert_int_equal(verification.pixels % BOARD_WIDTH, 0);
    usb_bus_free(usb_bus);
}

/* A line of which every third pixel was drawn, whole or in part; where it differs it is repaired,
 * and the rest is not the bus's to write. */
static void verifying_leaves_alone_what_was_not_drawn(void **state) {
    const struct cable_faults none = {0};
    struct usb_verification verification;
    uint8_t before[BOARD_WIDTH * 3];
    (void)state;
    plug_in(&none, 12);
    struct usb_bus *usb_bus = start(12);
    bus_write(&usb_bus->bus, 0x00D6, 5, BUS_WORD);
    for (unsigned x = 0; x < BOARD_WIDTH; x += 3) {
        bus_write(&usb_bus->bus, 0x00D4, (uint16_t)x, BUS_WORD);
        for (unsigned i = 0; i < (x % 2 == 0 ? 3U : 2U); i++) {
            bus_write(&usb_bus->bus, (uint16_t)(0x00D8 + 2 * i), (uint16_t)(x & 0xFF), BUS_BYTE);
        }
    }
    assert_int_equal(bus_flush(&usb_bus->bus), BUS_OK);
    memcpy(before, far_board.memory + 5 * sizeof before, sizeof before);
    far_board.memory[5 * sizeof before + 60 * 3] ^= 1;
    assert_true(usb_bus_verify(usb_bus, 100, 1, &verification));
    assert_int_equal(verification.pixels, (BOARD_WIDTH + 5) / 6);
    assert_int_equal(verification.repaired, 1);
    assert_memory_equal(far_board.memory + 5 * sizeof before, before, sizeof before);
    usb_bus_free(usb_bus);
}

/* A board whose red has a bit that sticks. */
static void sticky_write(struct bus *bus, uint16_t port, uint16_t value, unsigned width) {
    (void)bus;
    bus_write(&far_board_bus.bus, port, port == 0x00D8 ? value | 1U : value, width);
}

static uint16_t sticky_read(struct bus *bus, uint16_t port, unsigned width) {
    (void)bus;
    return bus_read(&far_board_bus.bus, port, width);
}

static void verifying_tells_what_cannot_be_repaired(void **state) {
    static const struct bus_operations sticky_operations = {sticky_write, sticky_read, NULL};
    struct bus sticky = {&sticky_operations, BUS_OK};
    const struct cable_faults none = {0};
    struct usb_verification verification;
    (void)state;
    plug_in(&none, 11);
    cable.device.adapter.bus = &sticky;
    memset(picture, 0x41, sizeof picture);
    picture[6][20][0] = 0x40;
    struct usb_bus *usb_bus = start(11);
    draw(&usb_bus->bus);
    assert_true(usb_bus_verify(usb_bus, 100, 1, &verification));
    assert_int_equal(verification.wrong_lines, 1);
    assert_int_equal(verification.first_wrong, 6);
    usb_bus_free(usb_bus);
}

static void an_adapter_that_stays_away_is_given_up_with_what_is_there(void **state) {
    const struct cable_faults none = {0};
    (void)state;
    plug_in(&none, 2);
    paint(2);
    struct usb_bus *usb_bus = start(2);
    draw(&usb_bus->bus);
    cable.is_gone = true;
    cable.unplugs = 1;
    assert_int_equal(bus_flush(&usb_bus->bus), BUS_LOST);
    assert_non_null(strstr(usb_bus->reason, "went away"));
    assert_true(usb_bus_line_is_there(usb_bus, 0));
    assert_false(usb_bus_line_is_there(usb_bus, LINES - 1));
    assert_int_equal(bus_read(&usb_bus->bus, 0x00D8, BUS_BYTE), 0xFF);
    usb_bus_free(usb_bus);
}

static void an_adapter_that_says_nothing_is_given_up(void **state) {
    const struct cable_faults deaf = {.lose = 1};
    (void)state;
    plug_in(&deaf, 2);
    struct usb_bus *usb_bus = start(2);
    assert_int_equal(usb_bus->bus.status, BUS_TIMEOUT);
    assert_non_null(strstr(usb_bus->reason, "does not answer"));
    usb_bus_free(usb_bus);
}

static void garbage_for_an_answer_is_given_up(void **state) {
    const struct cable_faults garbled = {.corrupt_reply = 1};
    (void)state;
    plug_in(&garbled, 2);
    struct usb_bus *usb_bus = start(2);
    assert_int_equal(usb_bus->bus.status, BUS_TIMEOUT);
    usb_bus_free(usb_bus);
}

/* Noise, without end. */
static enum usb_link_status babble(struct usb_link *link, uint8_t *bytes, size_t room,
                                   unsigned timeout_ms, size_t *count) {
    static uint64_t random = 1;
    (void)link;
    (void)timeout_ms;
    *count = room < 64 ? room : 64;
    for (size_t i = 0; i < *count; i++) {
        bytes[i] = (uint8_t)next_random(&random);
    }
    return USB_LINK_OK;
}

/* The adapter behind the cable answers the hello, and falls to babbling then. */
static enum usb_link_status greet_and_babble(struct usb_link *link, uint8_t *bytes, size_t room,
                                             unsigned timeout_ms, size_t *count) {
    enum usb_link_status status = cable_receive(&cable.link, bytes, room, timeout_ms, count);
    return status == USB_LINK_OK && cable.device.adapter.last == 0
               ? status
               : babble(link, bytes, room, timeout_ms, count);
}

static enum usb_link_status send_by_cable(struct usb_link *link, const uint8_t *bytes,
                                          size_t count) {
    (void)link;
    return cable_send(&cable.link, bytes, count);
}

static void noise_without_end_is_given_up(void **state) {
    static const struct usb_link_operations babblers[2] = {
        {send_by_cable, babble, NULL, NULL}, {send_by_cable, greet_and_babble, NULL, NULL}};
    const struct cable_faults none = {0};
    struct usb_limits limits = quick_limits(1);
    (void)state;
    limits.reply_ms = 20;
    for (unsigned i = 0; i < 2; i++) {
        struct usb_link link = {.operations = &babblers[i]};
        plug_in(&none, 2);
        struct usb_bus *usb_bus = usb_bus_new(&link, 0x00D0, &limits);
        assert_non_null(usb_bus);
        assert_int_equal(usb_bus->bus.status, i == 0 ? BUS_TIMEOUT : BUS_OK);
        paint(2);
        draw(&usb_bus->bus);
        assert_int_equal(bus_flush(&usb_bus->bus), BUS_TIMEOUT);
        assert_non_null(strstr(usb_bus->reason, "talks, but does not answer"));
        usb_bus_free(usb_bus);
    }
}

static enum usb_link_status take_anything(struct usb_link *link, const uint8_t *bytes,
                                          size_t count) {
    (void)link;
    (void)bytes;
    (void)count;
    return USB_LINK_OK;
}

/* What an adapter says to whatever it is told: its version, and whether it minds ours. */
static uint8_t version_told, status_told;

static enum usb_link_status tell_version(struct usb_link *link, uint8_t *bytes, size_t room,
                                         unsigned timeout_ms, size_t *count) {
    const struct usb_header header = {version_told, USB_KIND_REPLY, 0, 0, 0, 0, status_told, 1};
    (void)link;
    (void)timeout_ms;
    assert_true(room >= USB_OVERHEAD);
    *count = usb_frame_pack(bytes, &header, NULL);
    return USB_LINK_OK;
}

static void another_version_of_the_protocol_is_refused(void **state) {
    static const struct usb_link_operations of_another_version = {take_anything, tell_version, NULL,
                                                                  NULL};
    static const uint8_t told[][2] = {{2, USB_STATUS_BAD_VERSION},
                                      {2, USB_STATUS_UNKNOWN_SESSION},
                                      {USB_VERSION, USB_STATUS_BAD_VERSION}};
    struct usb_link link = {.operations = &of_another_version};
    struct usb_limits limits = quick_limits(1);
    (void)state;
    for (size_t i = 0; i < 3; i++) {
        version_told = told[i][0];
        status_told = told[i][1];
        struct usb_bus *usb_bus = usb_bus_new(&link, 0x00D0, &limits);
        assert_non_null(usb_bus);
        assert_int_equal(usb_bus->bus.status, BUS_PROTOCOL);
        assert_non_null(strstr(usb_bus->reason, "of the protocol; allowed is 1"));
        assert_int_equal(strstr(usb_bus->reason, "version 2") != NULL, version_told == 2);
        usb_bus_free(usb_bus);
    }
}

static void another_base_than_the_adapters_is_refused(void **state) {
    const struct cable_faults none = {0};
    struct usb_limits limits = quick_limits(1);
    (void)state;
    plug_in(&none, 2);
    cable.device.adapter.base_served = 0x02D0;
    struct usb_bus *usb_bus = usb_bus_new(&cable.link, 0x00D0, &limits);
    assert_int_equal(usb_bus->bus.status, BUS_PROTOCOL);
    assert_non_null(strstr(usb_bus->reason, "02D0"));
    usb_bus_free(usb_bus);
}

static void ports_of_others_are_refused(void **state) {
    static const uint16_t others[] = {0x00CF, 0x00E0, 0x00EE, 0x04D0};
    const struct cable_faults none = {0};
    (void)state;
    for (unsigned i = 0; i < sizeof others / sizeof others[0]; i++) {
        plug_in(&none, 2);
        struct usb_bus *usb_bus = start(2);
        bus_write(&usb_bus->bus, others[i], 0xC0, BUS_BYTE);
        assert_int_equal(bus_flush(&usb_bus->bus), BUS_REFUSED);
        assert_non_null(strstr(usb_bus->reason, "00D0-00DF"));
        usb_bus_free(usb_bus);
        usb_bus = start(2);
        assert_int_equal(bus_read(&usb_bus->bus, others[i], BUS_WORD), 0xFFFF);
        assert_int_equal(bus_flush(&usb_bus->bus), BUS_REFUSED);
        assert_non_null(strstr(usb_bus->reason, "00D0-00DF"));
        usb_bus_free(usb_bus);
    }
    assert_int_equal(far_board.accesses, 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_good_cable_carries_every_access_once_and_in_order),
        cmocka_unit_test(two_hundred_bad_cables_never_give_a_wrong_picture),
        cmocka_unit_test(reads_come_back_over_a_bad_cable),
        cmocka_unit_test(verifying_finds_and_repairs_what_differs),
        cmocka_unit_test(verifying_leaves_alone_what_was_not_drawn),
        cmocka_unit_test(verifying_tells_what_cannot_be_repaired),
        cmocka_unit_test(an_adapter_that_stays_away_is_given_up_with_what_is_there),
        cmocka_unit_test(an_adapter_that_says_nothing_is_given_up),
        cmocka_unit_test(garbage_for_an_answer_is_given_up),
        cmocka_unit_test(noise_without_end_is_given_up),
        cmocka_unit_test(another_version_of_the_protocol_is_refused),
        cmocka_unit_test(another_base_than_the_adapters_is_refused),
        cmocka_unit_test(ports_of_others_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
