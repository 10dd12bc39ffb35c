/* SPDX-License-Identifier: MIT */
/* What the USB bus counts, how it bears an adapter that starts anew, and a link that is lost in the
 * midst of a read. */
#include "usb_picture.h"

enum { STALLS, TIMEOUTS, RECONNECTS, RESTARTS, COUNTS };

/* Each kind of fault alone, so often that the session's greeting meets it too. A replug or a
 * restart takes replies along with it, and an adapter that was pulled before it was greeted knows
 * of no session. */
static void each_kind_of_fault_moves_its_own_count_alone(void **state) {
    static const struct {
        struct cable_faults faults;
        bool moves[COUNTS], is_told_each;
    } kinds[COUNTS] = {
        {{.stall = 3}, {true, false, false, false}, true},
        {{.lose = 9}, {false, true, false, false}, false},
        {{.unplug = 5, .unplugs_most = 1000}, {false, false, true, true}, true},
        {{.restart = 15}, {false, true, false, true}, false},
    };
    (void)state;
    for (unsigned i = 0; i < COUNTS; i++) {
        uint64_t moved = 0;
        for (uint64_t seed = 1; seed <= 10; seed++) {
            struct usb_counts counts;
            plug_in(&kinds[i].faults, seed);
            (void)run_once(seed, &counts);
            const uint64_t found[COUNTS] = {counts.stalls, counts.timeouts, counts.reconnects,
                                            counts.restarts};
            for (unsigned j = 0; j < COUNTS; j++) {
                assert_true(kinds[i].moves[j] || found[j] == 0);
            }
            assert_true(!kinds[i].is_told_each || found[i] == cable.struck);
            moved += found[i];
        }
        assert_in_range(moved, 5, 1000);
    }
}

/* Draws again and again; the adapter starts anew while the end of each picture is on its way. */
static struct usb_bus *draw_through_restarts(bool is_hid, unsigned restarts) {
    const struct cable_faults faults = {.is_hid = is_hid, .is_board_cleared = true};
    plug_in(&faults, restarts);
    paint(restarts);
    struct usb_bus *usb_bus = start(restarts);
    for (unsigned i = 0; i < restarts; i++) {
        draw(&usb_bus->bus);
        cable_restart(&cable);
        (void)bus_flush(&usb_bus->bus);
    }
    draw(&usb_bus->bus);
    (void)bus_flush(&usb_bus->bus);
    return usb_bus;
}

static void an_adapter_that_starts_anew_in_its_place_gets_everything_again(void **state) {
    const unsigned most = usb_default_limits().restarts;
    const unsigned cases[] = {0, 1, 2, most, most + 1};
    (void)state;
    for (unsigned i = 0; i < 2 * sizeof cases / sizeof cases[0]; i++) {
        unsigned restarts = cases[i / 2];
        struct usb_bus *usb_bus = draw_through_restarts(i % 2 != 0, restarts);
        bool is_borne = restarts <= most;
        assert_int_equal(usb_bus->bus.status, is_borne ? BUS_OK : BUS_LOST);
        assert_int_equal(usb_bus->counts.restarts, is_borne ? restarts : most);
        assert_int_equal(usb_bus->counts.reconnects, 0);
        assert_counts(usb_bus);
        for (unsigned y = 0; y < LINES && is_borne; y++) {
            assert_true(usb_bus_line_is_there(usb_bus, y));
            assert_true(is_line_right(y));
        }
        if (!is_borne) {
            assert_non_null(strstr(usb_bus->reason, "switched off in between"));
        }
        usb_bus_free(usb_bus);
    }
}

static unsigned frames_until_loss;

static enum usb_link_status send_but_one(struct usb_link *link, const uint8_t *bytes,
                                         size_t count) {
    if (frames_until_loss-- != 0) {
        return cable_send(link, bytes, count);
    }
    cable_note_frame(&cable.tally, bytes, count);
    return USB_LINK_OK;
}

/* Replies that take a while: a glance finds none, so that a window fills before the first is seen.
 */
static enum usb_link_status receive_late(struct usb_link *link, uint8_t *bytes, size_t room,
                                         unsigned timeout_ms, size_t *count) {
    return timeout_ms == 0 ? USB_LINK_TIMEOUT : cable_receive(link, bytes, room, timeout_ms, count);
}

/* Each frame behind a lost one is answered by a gap: only the first of these is acted on. */
static void a_lost_frame_takes_those_behind_it_along_once(void **state) {
    static const struct usb_link_operations lossy = {send_but_one, receive_late, cable_reopen,
                                                     cable_close};
    const struct cable_faults none = {0};
    unsigned gaps = 0;
    (void)state;
    for (unsigned i = 0; i < 12; i++) {
        plug_in(&none, 3);
        paint(3);
        struct usb_bus *usb_bus = start(3);
        cable.link.operations = &lossy;
        frames_until_loss = i;
        while (usb_bus->counts.frames < i + 2 * USB_CREDITS_MOST) {
            draw(&usb_bus->bus);
        }
        assert_int_equal(bus_flush(&usb_bus->bus), BUS_OK);
        assert_in_range(usb_bus->counts.resent, 1, USB_CREDITS_MOST);
        assert_true(usb_bus->counts.timeouts <= 1);
        gaps += usb_bus->counts.timeouts == 0;
        for (unsigned y = 0; y < LINES; y++) {
            assert_true(is_line_right(y));
        }
        usb_bus_free(usb_bus);
    }
    assert_true(gaps > 6);
}

static uint32_t lost_sequence;
static unsigned losses_left;

static enum usb_link_status send_but_one_sequence(struct usb_link *link, const uint8_t *bytes,
                                                  size_t count) {
    struct usb_header header;
    size_t length;
    assert_int_equal(usb_frame_scan(bytes, count, &header, &length), USB_SCAN_FRAME);
    if (header.sequence != lost_sequence || losses_left == 0) {
        return cable_send(link, bytes, count);
    }
    losses_left--;
    cable_note_frame(&cable.tally, bytes, count);
    return USB_LINK_OK;
}

/* A gap calls for the frame once; its next loss takes a timeout, and then a gap calls again. */
static void a_frame_that_is_lost_repeatedly_takes_a_timeout_every_other_time(void **state) {
    static const struct usb_link_operations lossy = {send_but_one_sequence, receive_late,
                                                     cable_reopen, cable_close};
    const struct cable_faults none = {0};
    (void)state;
    for (unsigned losses = 1; losses <= 7; losses++) {
        plug_in(&none, 5);
        paint(5);
        struct usb_bus *usb_bus = start(5);
        cable.link.operations = &lossy;
        lost_sequence = 3;
        losses_left = losses;
        while (usb_bus->counts.frames < 3 * USB_CREDITS_MOST) {
            draw(&usb_bus->bus);
        }
        assert_int_equal(bus_flush(&usb_bus->bus), BUS_OK);
        assert_int_equal(losses_left, 0);
        assert_int_equal(usb_bus->counts.timeouts, losses / 2);
        assert_counts(usb_bus);
        for (unsigned y = 0; y < LINES; y++) {
            assert_true(is_line_right(y));
        }
        usb_bus_free(usb_bus);
    }
}

/* Neither an idle flush nor what comes after a failure makes a frame. */
static void nothing_is_sent_where_there_is_nothing_to_send(void **state) {
    struct usb_verification verification;
    (void)state;
    struct usb_bus *usb_bus = draw_over_a_good_cable(7);
    const struct usb_counts before = usb_bus->counts;
    assert_int_equal(bus_flush(&usb_bus->bus), BUS_OK);
    assert_memory_equal(&usb_bus->counts, &before, sizeof before);
    bus_write(&usb_bus->bus, 0x00D4, 1, BUS_WORD);
    bus_write(&usb_bus->bus, 0x00CF, 1, BUS_BYTE); /* none of the adapter's ports */
    bus_write(&usb_bus->bus, 0x00D4, 2, BUS_WORD);
    assert_int_equal(bus_flush(&usb_bus->bus), BUS_REFUSED);
    assert_false(usb_bus_verify(usb_bus, 100, 1, &verification));
    assert_memory_equal(&usb_bus->counts, &before, sizeof before);
    usb_bus_free(usb_bus);
}

/* The link's calls that go well before it is lost for good. */
static unsigned good_calls;

static bool is_lost_now(void) {
    cable.is_gone = cable.is_gone || good_calls == 0;
    cable.unplugs = cable.is_gone ? 1 : 0;
    good_calls -= good_calls > 0;
    return cable.is_gone;
}

static enum usb_link_status send_for_a_while(struct usb_link *link, const uint8_t *bytes,
                                             size_t count) {
    return is_lost_now() ? USB_LINK_LOST : cable_send(link, bytes, count);
}

static enum usb_link_status receive_for_a_while(struct usb_link *link, uint8_t *bytes, size_t room,
                                                unsigned timeout_ms, size_t *count) {
    return is_lost_now() ? USB_LINK_LOST : cable_receive(link, bytes, room, timeout_ms, count);
}

/* The read before gave a value: were it left over, it would be seen. */
static void a_link_that_is_lost_during_a_read_leaves_an_open_bus(void **state) {
    static const struct usb_link_operations fragile = {send_for_a_while, receive_for_a_while,
                                                       cable_reopen, cable_close};
    const struct cable_faults none = {0};
    unsigned lost = 0, read = 0;
    (void)state;
    for (unsigned i = 0; i < 16; i++) {
        unsigned width = i % 2 == 0 ? BUS_BYTE : BUS_WORD;
        plug_in(&none, 4);
        struct usb_bus *usb_bus = start(4);
        bus_write(&usb_bus->bus, 0x00D4, 0x0123, BUS_WORD);
        bus_write(&usb_bus->bus, 0x00D6, 0x0012, BUS_WORD);
        bus_write(&usb_bus->bus, 0x00D8, 0x45, BUS_BYTE);
        unsigned expected = width == BUS_BYTE ? 0x45 : 0xFF45;
        assert_int_equal(bus_read(&usb_bus->bus, 0x00D8, width), expected);
        bus_write(&usb_bus->bus, 0x00D8, 0x46, BUS_BYTE);
        cable.link.operations = &fragile;
        good_calls = i / 2;
        unsigned value = bus_read(&usb_bus->bus, 0x00D8, width);
        bool is_lost = usb_bus->bus.status != BUS_OK;
        lost += is_lost;
        read += !is_lost;
        assert_int_equal(usb_bus->bus.status, is_lost ? BUS_LOST : BUS_OK);
        assert_int_equal(value, !is_lost ? expected + 1 : width == BUS_BYTE ? 0xFF : 0xFFFF);
        assert_int_equal(usb_bus->reason[0] != '\0', is_lost);
        usb_bus_free(usb_bus);
    }
    assert_true(lost >= 4 && read >= 2);
}

/* Wherever the cable breaks, verifying ends, and does not say that all is well. */
static void verifying_over_a_link_that_is_lost_is_no_success(void **state) {
    static const struct usb_link_operations fragile = {send_for_a_while, receive_for_a_while,
                                                       cable_reopen, cable_close};
    struct usb_verification verification;
    unsigned done = 0, lost = 0;
    (void)state;
    for (unsigned i = 0; done == 0; i += 13) {
        struct usb_bus *usb_bus = draw_over_a_good_cable(11);
        far_board.memory[(3 * BOARD_WIDTH + 100) * 3] ^= 0x10;
        cable.link.operations = &fragile;
        good_calls = i;
        bool is_verified = usb_bus_verify(usb_bus, 100, 1, &verification);
        assert_int_equal(is_verified, usb_bus->bus.status == BUS_OK);
        assert_true(verification.pixels <= LINES * BOARD_WIDTH);
        done += is_verified;
        lost += !is_verified;
        usb_bus_free(usb_bus);
    }
    assert_int_equal(verification.pixels, LINES * BOARD_WIDTH);
    assert_true(lost > 10);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_kind_of_fault_moves_its_own_count_alone),
        cmocka_unit_test(an_adapter_that_starts_anew_in_its_place_gets_everything_again),
        cmocka_unit_test(a_lost_frame_takes_those_behind_it_along_once),
        cmocka_unit_test(a_frame_that_is_lost_repeatedly_takes_a_timeout_every_other_time),
        cmocka_unit_test(nothing_is_sent_where_there_is_nothing_to_send),
        cmocka_unit_test(a_link_that_is_lost_during_a_read_leaves_an_open_bus),
        cmocka_unit_test(verifying_over_a_link_that_is_lost_is_no_success),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
