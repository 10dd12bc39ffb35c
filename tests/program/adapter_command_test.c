/* SPDX-License-Identifier: MIT */
/* The virtual adapter as a program of its own: a client over TCP draws on it by bulk and by HID,
 * and the picture that it writes is the emulator's. */
#include "adapter_process.h"
#include "usb_fixture.h"
#include "usbip_client.h"

#include "picture.h"
#include "png_file.h"
#include "trace_replay.h"

enum { LINES = 40 };

static struct usbip_client client;
static struct adapter_process server;

static int start_server(void **state) {
    const char *const words[] = {"--once", "-o", server.picture, NULL};
    (void)state;
    adapter_start(&server, words);
    return 0;
}

static int stop_server(void **state) {
    (void)state;
    adapter_stop(&server);
    return 0;
}

static void draw(struct bus *bus) {
    static const uint16_t pairs[15][2] = {{0x00, 0x6B}, {0x01, 0x50}, {0x02, 0x5B}, {0x03, 0x0E},
                                          {0x04, 0x1A}, {0x05, 0x02}, {0x06, 0x19}, {0x07, 0x19},
                                          {0x08, 0x80}, {0x09, 0x0F}, {0x0C, 0xFF}, {0x0D, 0xFF},
                                          {0x1B, 0x01}, {0x1E, 0x8C}, {0x1F, 0x00}};
    for (unsigned i = 0; i < 15; i++) {
        bus_write(bus, 0x00D0, pairs[i][0], BUS_BYTE);
        bus_write(bus, 0x00D2, pairs[i][1], BUS_BYTE);
    }
    bus_write(bus, 0x00DE, 0x01, BUS_BYTE);
    for (unsigned y = 0; y < LINES; y++) {
        bus_write(bus, 0x00D6, (uint16_t)y, BUS_WORD);
        for (unsigned x = 0; x < BOARD_WIDTH; x++) {
            bus_write(bus, 0x00D4, (uint16_t)x, BUS_WORD);
            bus_write(bus, 0x00D8, (x * y) & 0xFF, BUS_BYTE);
            bus_write(bus, 0x00DA, (x ^ y) & 0xFF, BUS_BYTE);
            bus_write(bus, 0x00DC, (uint16_t)(x / 64), BUS_BYTE);
        }
    }
}

static void compare_with_emulator(void) {
    static uint8_t expected[PICTURE_BYTES];
    struct png_error error;
    struct png_image written;
    power_on(BOARD_1987);
    draw(&board_bus.bus);
    assert_int_equal(picture_draw(&board, NULL, expected), PICTURE_OK);
    FILE *file = fopen(server.picture, "rb");
    assert_non_null(file);
    assert_int_equal(read_png(file, &written, &error), PNG_OK);
    (void)fclose(file);
    assert_int_equal(written.width, PICTURE_WIDTH);
    assert_int_equal(written.height, PICTURE_HEIGHT);
    assert_memory_equal(written.rgb, expected, PICTURE_BYTES);
    free_png(&written);
}

static void draw_over(bool is_hid) {
    struct usb_limits limits = quick_limits(7);
    limits.reply_ms = 5000;
    client_init(&client, connect_to(server.port), is_hid);
    client_attach(&client);
    struct usb_bus *usb_bus = usb_bus_new(&client.link, 0x00D0, &limits);
    assert_non_null(usb_bus);
    draw(&usb_bus->bus);
    assert_int_equal(bus_flush(&usb_bus->bus), BUS_OK);
    assert_int_equal(bus_read(&usb_bus->bus, 0x00D8, BUS_BYTE), 639 * 39 & 0xFF);
    usb_bus_free(usb_bus);
    (void)close(client.socket);
    assert_int_equal(adapter_wait(&server), 0);
    compare_with_emulator();
}

static void a_client_draws_by_bulk(void **state) {
    (void)state;
    draw_over(false);
}

static void a_client_draws_by_hid(void **state) {
    (void)state;
    draw_over(true);
}

/* A scene's port accesses, as the firmware made them, played to the adapter: the picture behind it
 * is that of the emulated board in the program itself. */
static void a_rendered_scene_is_the_same_behind_the_cable(void **state) {
    static struct trace_reader reader;
    struct trace_replay replay;
    struct usb_limits limits = quick_limits(9);
    char command[2048];
    (void)state;
    limits.reply_ms = 5000;
    (void)snprintf(command, sizeof command,
                   "'%s' render fig3 --size 64x40 --quiet -o '%s.own' --trace '%s.trace'",
                   getenv("SUPERFRAME"), server.picture, server.picture);
    assert_int_equal(system(command), 0);
    (void)snprintf(command, sizeof command, "%s.trace", server.picture);
    FILE *trace = fopen(command, "rb");
    assert_non_null(trace);
    client_init(&client, connect_to(server.port), false);
    client_attach(&client);
    struct usb_bus *usb_bus = usb_bus_new(&client.link, 0x00D0, &limits);
    assert_non_null(usb_bus);
    memset(&replay, 0, sizeof replay);
    assert_int_equal(trace_reader_open(&reader, trace), TRACE_OK);
    assert_int_equal(trace_replay(&reader, &usb_bus->bus, 0, &replay), TRACE_END);
    assert_int_equal(bus_flush(&usb_bus->bus), BUS_OK);
    (void)fclose(trace);
    usb_bus_free(usb_bus);
    (void)close(client.socket);
    assert_int_equal(adapter_wait(&server), 0);
    (void)snprintf(command, sizeof command, "cmp '%s' '%s.own' && rm '%s.own' '%s.trace'",
                   server.picture, server.picture, server.picture, server.picture);
    assert_int_equal(system(command), 0);
}

static void the_list_is_shown_and_a_second_client_is_refused(void **state) {
    (void)state;
    client_init(&client, connect_to(server.port), false);
    client_attach(&client);
    int second = connect_to(server.port);
    assert_true(client_list(second));
    (void)close(second);
    second = connect_to(server.port);
    assert_int_equal(client_import(second), 2); /* busy */
    (void)close(second);
    (void)close(client.socket);
}

static void an_interrupt_ends_it_with_its_picture(void **state) {
    (void)state;
    assert_int_equal(kill(server.pid, SIGINT), 0);
    assert_int_equal(adapter_wait(&server), 0);
    assert_int_equal(access(server.picture, R_OK), 0);
}

/* Returns the exit status of the program with these words; what it says is in said. */
static int run_adapter_with(const char *words, char *said, size_t size) {
    char command[1024];
    (void)snprintf(command, sizeof command, "timeout 20 '%s' adapter %s 2>&1", getenv("SUPERFRAME"),
                   words);
    FILE *pipe = popen(command, "r");
    assert_non_null(pipe);
    said[fread(said, 1, size - 1, pipe)] = '\0';
    int status = pclose(pipe);
    assert_true(WIFEXITED(status));
    return WEXITSTATUS(status);
}

static void what_cannot_be_served_is_refused_before_anybody_comes(void **state) {
#define FIVE "--allow ::1 --allow ::1 --allow ::1 --allow ::1 --allow ::1 "
    static const struct {
        const char *words;
        int status;
        const char *said;
    } cases[] = {{"--listen 127.0.0.1:0 -o /nonexistent/x.png", 1, "cannot be written"},
                 {"--listen 127.0.0.1:0 -o -", 2, "give each its own file"},
                 {"--listen 127.0.0.1:65536", 2, "with a port 0..65535"},
                 {"--listen somewhere", 2, "allowed are an address in numbers and a port"},
                 {"--listen [::1:5", 2, "[ADDRESS]:PORT"},
                 {"--listen 203.0.113.1:0", 1, "can't listen"},
                 {"--allow 127.0.0.1/33", 2, "--allow: \"127.0.0.1/33\" is invalid"},
                 {"--allow somebody", 2, "as in 192.0.2.7, 10.1.0.0/16"},
                 {FIVE FIVE FIVE "--allow ::1 --allow ::2", 2, "up to 16 times"}};
    char said[1024], busy[64];
    (void)state;
    for (unsigned i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        assert_int_equal(run_adapter_with(cases[i].words, said, sizeof said), cases[i].status);
        assert_non_null(strstr(said, cases[i].said));
        assert_null(strstr(said, "listening on"));
    }
    (void)snprintf(busy, sizeof busy, "--listen 127.0.0.1:%d", server.port);
    assert_int_equal(run_adapter_with(busy, said, sizeof said), 1);
    assert_non_null(strstr(said, "Address already in use"));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(a_client_draws_by_bulk, start_server, stop_server),
        cmocka_unit_test_setup_teardown(a_client_draws_by_hid, start_server, stop_server),
        cmocka_unit_test_setup_teardown(a_rendered_scene_is_the_same_behind_the_cable, start_server,
                                        stop_server),
        cmocka_unit_test_setup_teardown(the_list_is_shown_and_a_second_client_is_refused,
                                        start_server, stop_server),
        cmocka_unit_test_setup_teardown(what_cannot_be_served_is_refused_before_anybody_comes,
                                        start_server, stop_server),
        cmocka_unit_test_setup_teardown(an_interrupt_ends_it_with_its_picture, start_server,
                                        stop_server),
    };
    (void)alarm(120); /* a client that waits for ever is a failure */
    return cmocka_run_group_tests(tests, NULL, NULL);
}
