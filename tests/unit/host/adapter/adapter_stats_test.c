/* SPDX-License-Identifier: MIT */
/* What the statistics say of the cable is what went over it. */
#include <stdlib.h>
#include <unistd.h>

#include "usb_fixture.h"

#include "adapter/open.h"

static struct cable cable;
static struct adapter_bus adapter;

/* A link that counts by itself what it hands on to the cable, each call as one transfer. */
static struct {
    struct usb_link link; /* the first member */
    size_t sent, received, calls;
} meter;

static enum usb_link_status meter_send(struct usb_link *link, const uint8_t *bytes, size_t count) {
    meter.sent += count;
    meter.calls++;
    link->transfers++;
    return cable.link.operations->send(&cable.link, bytes, count);
}

static enum usb_link_status meter_receive(struct usb_link *link, uint8_t *bytes, size_t room,
                                          unsigned timeout_ms, size_t *count) {
    enum usb_link_status status =
        cable.link.operations->receive(&cable.link, bytes, room, timeout_ms, count);
    meter.received += status == USB_LINK_OK ? *count : 0;
    meter.calls += status == USB_LINK_OK;
    link->transfers += status == USB_LINK_OK;
    return status;
}

static enum usb_link_status meter_reopen(struct usb_link *link, unsigned timeout_ms) {
    (void)link;
    return cable.link.operations->reopen(&cable.link, timeout_ms);
}

static void meter_close(struct usb_link *link) {
    (void)link;
}

static void plug_in(const struct cable_faults *faults) {
    static const struct usb_link_operations operations = {meter_send, meter_receive, meter_reopen,
                                                          meter_close};
    struct usb_limits limits = quick_limits(3);
    power_on(BOARD_1987);
    cable_plug(&cable, faults, 3, &board_bus.bus, &board);
    memset(&meter, 0, sizeof meter);
    memset(&adapter, 0, sizeof adapter);
    meter.link.operations = &operations;
    limits.retries = 50;
    adapter.name = "usb";
    adapter.link = &meter.link;
    adapter.usb = usb_bus_new(&meter.link, 0x00D0, &limits);
    assert_non_null(adapter.usb);
}

static void draw(void) {
    for (unsigned y = 0; y < 40; y++) {
        (void)bus_read(&adapter.usb->bus, 0x00DE, BUS_BYTE); /* waits for its reply */
        bus_write(&adapter.usb->bus, 0x00D6, (uint16_t)y, BUS_WORD);
        for (unsigned x = 0; x < BOARD_WIDTH; x++) {
            bus_write(&adapter.usb->bus, 0x00D4, (uint16_t)x, BUS_WORD);
            for (unsigned i = 0; i < 3; i++) {
                bus_write(&adapter.usb->bus, (uint16_t)(0x00D8 + 2 * i),
                          (uint16_t)((x * (y + 3 * i + 1)) & 0xFF), BUS_BYTE);
            }
        }
    }
    assert_int_equal(bus_flush(&adapter.usb->bus), BUS_OK);
}

static const char *written(void) {
    static char text[1024];
    FILE *file = tmpfile();
    assert_non_null(file);
    struct json json = {.out = file};
    json_begin_object(&json, NULL);
    adapter_bus_write_stats(&adapter, &json);
    json_end_object(&json);
    rewind(file);
    text[fread(text, 1, sizeof text - 1, file)] = '\0';
    (void)fclose(file);
    return text;
}

static unsigned long count_of(const char *key) {
    char quoted[64];
    (void)snprintf(quoted, sizeof quoted, "\"%s\": ", key);
    const char *place = strstr(written(), quoted);
    assert_non_null(place);
    return strtoul(place + strlen(quoted), NULL, 10);
}

static void a_good_cable_is_counted_byte_by_byte(void **state) {
    const struct cable_faults none = {0};
    (void)state;
    plug_in(&none);
    draw();
    assert_int_equal(count_of("bytes_out"), meter.sent);
    assert_int_equal(count_of("bytes_in"), meter.received);
    assert_int_equal(count_of("transfers"), meter.calls);
    assert_int_equal(count_of("frames"), cable.device.adapter.last);
    assert_int_equal(count_of("resent") + count_of("timeouts") + count_of("stalls") +
                         count_of("reconnects") + count_of("restarts"),
                     0);
    assert_non_null(strstr(written(), "\"bus\": \"usb\""));
    assert_non_null(strstr(written(), "\"verified_pixels\": null,\n"));
    assert_non_null(strstr(written(), "\"repaired_pixels\": null\n"));
    adapter_bus_close(&adapter);
}

static void what_goes_wrong_shows_in_the_counts(void **state) {
    static const struct {
        const char *key;
        struct cable_faults faults;
    } cases[] = {{"resent", {.lose = 20}},
                 {"timeouts", {.lose_reply = 2}},
                 {"stalls", {.stall = 8}},
                 {"reconnects", {.unplug = 10, .unplugs_most = 1000}},
                 {"restarts", {.unplug = 20, .power_cycle = 1, .unplugs_most = 1000}}};
    (void)state;
    for (unsigned i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        plug_in(&cases[i].faults);
        draw();
        assert_true(count_of(cases[i].key) > 0);
        assert_int_equal(count_of("reconnects"), cable.unplugs);
        assert_int_equal(count_of("restarts"), cable.power_cycles);
        assert_int_equal(count_of("bytes_out"), meter.sent);
        assert_int_equal(count_of("bytes_in"), meter.received);
        adapter_bus_close(&adapter);
    }
}

static void verified_and_repaired_pixels_are_counted(void **state) {
    const struct cable_faults none = {0};
    (void)state;
    plug_in(&none);
    draw();
    board.memory[3 * 17] ^= 0x40;
    board.memory[3 * (BOARD_WIDTH + 5) + 2] ^= 0x01;
    assert_int_equal(adapter_bus_verify(&adapter, 100, 0), 0);
    assert_int_equal(count_of("verified_pixels"), 40 * BOARD_WIDTH);
    assert_int_equal(count_of("repaired_pixels"), 2);
    adapter_bus_close(&adapter);
}

/* Draws one dot of every second line from 100 on. */
static void draw_every_other_line(void) {
    for (unsigned y = 100; y < 300; y += 2) {
        bus_write(&adapter.usb->bus, 0x00D6, (uint16_t)y, BUS_WORD);
        bus_write(&adapter.usb->bus, 0x00D4, 1, BUS_WORD);
        bus_write(&adapter.usb->bus, 0x00D8, 1, BUS_BYTE);
    }
    assert_int_equal(bus_flush(&adapter.usb->bus), BUS_OK);
}

static void a_list_of_rows_that_is_too_long_ends_with_a_whole_number(void **state) {
    const struct cable_faults none = {0};
    char said[1024] = "";
    FILE *file = tmpfile();
    (void)state;
    plug_in(&none);
    draw_every_other_line();
    assert_non_null(file);
    (void)fflush(stderr);
    int stream = dup(STDERR_FILENO);
    assert_true(stream >= 0 && dup2(fileno(file), STDERR_FILENO) >= 0);
    adapter_bus_explain(&adapter, 100, 300, 1);
    (void)fflush(stderr);
    assert_true(dup2(stream, STDERR_FILENO) >= 0);
    (void)close(stream);
    rewind(file);
    said[fread(said, 1, sizeof said - 1, file)] = '\0';
    (void)fclose(file);
    assert_non_null(strstr(said, "of 200 rows 100 are known to be on the board: 100, 102, "));
    assert_non_null(strstr(said, ", 188, 190, and more; missing are 101, "));
    assert_non_null(strstr(said, ", 189, 191, and more\n"));
    adapter_bus_close(&adapter);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_good_cable_is_counted_byte_by_byte),
        cmocka_unit_test(what_goes_wrong_shows_in_the_counts),
        cmocka_unit_test(verified_and_repaired_pixels_are_counted),
        cmocka_unit_test(a_list_of_rows_that_is_too_long_ends_with_a_whole_number),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
