/* SPDX-License-Identifier: MIT */
/* Our back ends with the real libusb, hidapi and libudev, against an emulated kernel: a picture
 * arrives by either way, whatever happens on it. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <cmocka.h>

#include "adapter/bus.h"
#include "adapter/drivers.h"
#include "mock_adapter.h"
#include "picture.h"

enum { LINES = 8 };

extern const struct usb_backend usb_backend_bulk, usb_backend_hid;

const struct usb_backend *const usb_backends_built[] = {&usb_backend_bulk, &usb_backend_hid, NULL};
static struct usb_link *link_of_test;

static uint8_t colour(unsigned x, unsigned y, unsigned i) {
    return (uint8_t)((x * 2654435761U ^ y * 40503U) >> (8 + 8 * i));
}

static void draw(struct bus *bus) {
    for (unsigned y = 0; y < LINES; y++) {
        bus_write(bus, 0x00D6, (uint16_t)y, BUS_WORD);
        for (unsigned x = 0; x < BOARD_WIDTH; x++) {
            bus_write(bus, 0x00D4, (uint16_t)x, BUS_WORD);
            for (unsigned i = 0; i < 3; i++) {
                bus_write(bus, (uint16_t)(0x00D8 + 2 * i), colour(x, y, i), BUS_BYTE);
            }
        }
    }
}

static void assert_picture(void) {
    for (unsigned y = 0; y < LINES; y++) {
        for (unsigned x = 0; x < BOARD_WIDTH; x++) {
            for (unsigned i = 0; i < 3; i++) {
                assert_int_equal(mock_board()->memory[(y * BOARD_WIDTH + x) * 3 + i],
                                 colour(x, y, i));
            }
        }
    }
}

static struct usb_limits limits_of_test(void) {
    struct usb_limits limits = usb_default_limits();
    limits.reply_ms = 300;
    limits.reopen_ms = 5000;
    limits.seed = 12345;
    return limits;
}

static struct usb_bus *start(const struct usb_backend *way) {
    struct usb_limits limits = limits_of_test();
    char reason[USB_LINK_REASON_SIZE] = "";
    enum usb_open_status status = way->open(NULL, &link_of_test, reason);
    if (status != USB_OPEN_OK) {
        print_message("%s: %s\n", way->name, reason);
    }
    assert_int_equal(status, USB_OPEN_OK);
    struct usb_bus *usb_bus = usb_bus_new(link_of_test, 0x00D0, &limits);
    assert_non_null(usb_bus);
    return usb_bus;
}

static void stop(struct usb_bus *usb_bus) {
    usb_bus_free(usb_bus);
    link_of_test->operations->close(link_of_test);
    mock_remove();
}

/* Draws over both ways with the same faults; sums up what it took. */
static void draw_despite(const struct mock_faults *faults, struct usb_counts *sum) {
    static const struct mock_faults none;
    memset(sum, 0, sizeof *sum);
    for (unsigned i = 0; i < 2; i++) {
        mock_plug(&none);
        struct usb_bus *usb_bus = start(usb_backends_built[i]);
        assert_int_equal(usb_bus->bus.status, BUS_OK);
        mock_set_faults(faults);
        draw(&usb_bus->bus);
        enum bus_status status = bus_flush(&usb_bus->bus);
        if (status != BUS_OK) {
            print_message("%s: %s\n", usb_backends_built[i]->name, usb_bus->reason);
        }
        assert_int_equal(status, BUS_OK);
        assert_picture();
        sum->timeouts += usb_bus->counts.timeouts;
        sum->stalls += usb_bus->counts.stalls;
        sum->reconnects += usb_bus->counts.reconnects;
        sum->restarts += usb_bus->counts.restarts;
        sum->resent += usb_bus->counts.resent;
        stop(usb_bus);
    }
}

static void the_adapter_is_listed_by_both_ways(void **state) {
    const struct mock_faults none = {0};
    struct usb_found found[4];
    char reason[USB_LINK_REASON_SIZE];
    (void)state;
    mock_plug(&none);
    for (unsigned i = 0; i < 2; i++) {
        assert_int_equal(usb_backends_built[i]->list(found, 4, reason), 1);
        assert_string_equal(reason, "");
        assert_string_equal(found[0].serial, "MOCK");
        assert_true(found[0].is_accessible);
        assert_int_equal(usb_backends_built[i]->open("OTHER", &link_of_test, reason),
                         USB_OPEN_ABSENT);
        assert_non_null(strstr(reason, "OTHER"));
    }
    mock_remove();
}

static void a_picture_arrives_and_is_read_back(void **state) {
    const struct mock_faults none = {0};
    (void)state;
    for (unsigned i = 0; i < 2; i++) {
        struct usb_verification verification;
        mock_plug(&none);
        struct usb_bus *usb_bus = start(usb_backends_built[i]);
        draw(&usb_bus->bus);
        assert_int_equal(bus_read(&usb_bus->bus, 0x00DA, BUS_BYTE), colour(639, LINES - 1, 1));
        assert_int_equal(bus_flush(&usb_bus->bus), BUS_OK);
        assert_picture();
        assert_int_equal(mock_state().duplicates + mock_state().damaged, 0);
        assert_true(usb_bus_verify(usb_bus, 100, 1, &verification));
        assert_int_equal(verification.pixels, LINES * BOARD_WIDTH);
        assert_int_equal(verification.repaired + verification.wrong_lines, 0);
        stop(usb_bus);
    }
}

static void short_reads_are_put_together(void **state) {
    const struct mock_faults faults = {.is_short = true};
    struct usb_counts counts;
    (void)state;
    draw_despite(&faults, &counts);
    assert_int_equal(counts.resent, 0);
}

static void a_stalled_endpoint_is_cleared(void **state) {
    const struct mock_faults none = {0}, faults = {.stalls = 1};
    (void)state;
    mock_plug(&none);
    struct usb_bus *usb_bus = start(&usb_backend_bulk);
    mock_set_faults(&faults);
    draw(&usb_bus->bus);
    assert_int_equal(bus_flush(&usb_bus->bus), BUS_OK);
    assert_picture();
    assert_true(usb_bus->counts.stalls >= 1);
    stop(usb_bus);
}

static void lost_replies_cost_a_timeout(void **state) {
    const struct mock_faults faults = {.lost_replies = 8};
    struct usb_counts counts;
    (void)state;
    draw_despite(&faults, &counts);
    assert_true(counts.timeouts >= 1);
}

static void corrupt_and_double_replies_do_no_harm(void **state) {
    const struct mock_faults faults = {.corrupt_replies = 2, .double_replies = 3};
    struct usb_counts counts;
    (void)state;
    draw_despite(&faults, &counts);
}

static void an_unplugged_adapter_goes_on_where_it_was(void **state) {
    const struct mock_faults faults = {.unplug_after = 3};
    struct usb_counts counts;
    (void)state;
    draw_despite(&faults, &counts);
    assert_int_equal(counts.reconnects, 2);
    assert_int_equal(counts.restarts, 0);
}

static void one_that_was_switched_off_gets_everything_again(void **state) {
    const struct mock_faults faults = {.unplug_after = 3, .forgets = true};
    struct usb_counts counts;
    (void)state;
    draw_despite(&faults, &counts);
    assert_int_equal(counts.restarts, 2);
}

static void one_that_stays_away_or_silent_is_an_error_in_time(void **state) {
    static const struct mock_faults none,
        faults[2] = {{.unplug_after = 3, .is_lost_for_good = true}, {.is_mute = true}};
    (void)state;
    for (unsigned i = 0; i < 4; i++) {
        mock_plug(&none);
        struct usb_bus *usb_bus = start(usb_backends_built[i / 2]);
        usb_bus->limits.reopen_ms = 800;
        mock_set_faults(&faults[i % 2]);
        draw(&usb_bus->bus);
        assert_int_equal(bus_flush(&usb_bus->bus), i % 2 == 0 ? BUS_LOST : BUS_TIMEOUT);
        assert_true(usb_bus->reason[0] != '\0');
        assert_false(usb_bus_line_is_there(usb_bus, LINES - 1));
        stop(usb_bus);
    }
}

/* Runs a command line; what it prints, on both streams, is in output. */
static int run(const char *line, char *output, size_t size) {
    FILE *pipe = popen(line, "r");
    assert_non_null(pipe);
    output[fread(output, 1, size - 1, pipe)] = '\0';
    return pclose(pipe);
}

static void the_program_draws_a_scene_and_verifies_it(void **state) {
    static const char *const buses[2] = {"usb --verify", "hid --verify=10"};
    static const struct mock_faults none;
    static uint8_t rgb[PICTURE_BYTES];
    char line[512], output[4096], emulated[9], crc[9];
    const char *program = getenv("SUPERFRAME");
    (void)state;
    assert_non_null(program);
    (void)snprintf(line, sizeof line,
                   "'%s' render fig3 --size 64x40 --quiet -o /dev/null --stats -", program);
    assert_int_equal(run(line, output, sizeof output), 0);
    const char *place = strstr(output, "\"frame_crc\": \"");
    assert_non_null(place);
    assert_int_equal(sscanf(place, "\"frame_crc\": \"%8[0-9a-f]", emulated), 1);
    for (unsigned i = 0; i < 2; i++) {
        mock_plug(&none);
        (void)snprintf(line, sizeof line,
                       "'%s' render fig3 --size 64x40 --quiet --stats - --bus %s 2>&1", program,
                       buses[i]);
        int status = run(line, output, sizeof output);
        if (status != 0 || strstr(output, "pixels read back, 0 differed") == NULL) {
            print_message("%s", output);
        }
        assert_int_equal(status, 0);
        assert_non_null(strstr(output, "pixels read back, 0 differed"));
        assert_non_null(strstr(output, "\"repaired_pixels\": 0\n"));
        (void)picture_draw(mock_board(), NULL, rgb);
        (void)snprintf(crc, sizeof crc, "%08lx", (unsigned long)picture_crc(rgb));
        assert_string_equal(crc, emulated);
        mock_remove();
    }
}

int main(int argc, char **argv) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_adapter_is_listed_by_both_ways),
        cmocka_unit_test(a_picture_arrives_and_is_read_back),
        cmocka_unit_test(short_reads_are_put_together),
        cmocka_unit_test(a_stalled_endpoint_is_cleared),
        cmocka_unit_test(lost_replies_cost_a_timeout),
        cmocka_unit_test(corrupt_and_double_replies_do_no_harm),
        cmocka_unit_test(an_unplugged_adapter_goes_on_where_it_was),
        cmocka_unit_test(one_that_was_switched_off_gets_everything_again),
        cmocka_unit_test(one_that_stays_away_or_silent_is_an_error_in_time),
        cmocka_unit_test(the_program_draws_a_scene_and_verifies_it),
    };
    (void)argc;
    (void)mock_enter(argv);
    (void)alarm(300); /* a wait without end is a failure */
    return cmocka_run_group_tests(tests, NULL, NULL);
}
