/* SPDX-License-Identifier: MIT */
/* The USB/IP server's side of one client, byte by byte: the list, attaching, transfers, and what
 * ends the visit. */
#include "board_fixture.h"

#include "adapter/usbip.h"

enum { HEADER = 48, SEEN_SIZE = 4096 };

static struct usb_device device;
static struct usbip_client client;
static uint8_t seen[SEEN_SIZE]; /* what the client was sent */
static size_t seen_count;

static void see(void *context, const uint8_t *bytes, size_t count) {
    assert_ptr_equal(context, &seen);
    assert_true(seen_count + count <= sizeof seen);
    memcpy(seen + seen_count, bytes, count);
    seen_count += count;
}

static uint32_t number_at(size_t place) {
    assert_true(place + 4 <= seen_count);
    return (uint32_t)seen[place] << 24 | (uint32_t)seen[place + 1] << 16 |
           (uint32_t)seen[place + 2] << 8 | seen[place + 3];
}

static void put_number(uint8_t *bytes, uint32_t value) {
    for (unsigned i = 0; i < 4; i++) {
        bytes[i] = (uint8_t)(value >> (24 - 8 * i));
    }
}

static void arrive(bool is_busy, bool is_high_speed) {
    power_on(BOARD_1987);
    usb_device_init(&device, &board_bus.bus, 0x00D0, "GUEST", is_high_speed);
    usbip_client_init(&client, &device, is_busy, see, &seen);
    seen_count = 0;
}

/* Asks for a device of this name. */
static void import(const char *name) {
    uint8_t request[40] = {0x01, 0x11, 0x80, 0x03};
    strcpy((char *)request + 8, name);
    usbip_client_take(&client, request, sizeof request);
}

/* Fills the stack below its caller: what a function leaves as it found it there shows. */
static void poison_stack(void) {
    volatile uint8_t bytes[4096];
    for (size_t i = 0; i < sizeof bytes; i++) {
        bytes[i] = 0xA5;
    }
}

/* A command with its data; of what is sent, only what comes after counts. */
static void command(const uint32_t fields[8], const uint8_t *setup, const uint8_t *data,
                    size_t count) {
    uint8_t bytes[HEADER] = {0};
    for (unsigned i = 0; i < 8; i++) {
        put_number(bytes + 4 * i, fields[i]);
    }
    put_number(bytes + 32, 0);
    if (setup != NULL) {
        memcpy(bytes + 40, setup, 8);
    }
    seen_count = 0;
    poison_stack();
    usbip_client_take(&client, bytes, sizeof bytes);
    usbip_client_take(&client, data, count);
}

/* A transfer with a number; is_in: from the device. */
static void submit(uint32_t number, unsigned endpoint, bool is_in, uint32_t length,
                   const uint8_t *setup, const uint8_t *data) {
    const uint32_t fields[8] = {1, number, 0x10001, is_in, endpoint, 0, length, 0};
    command(fields, setup, data, is_in ? 0 : length);
}

/* Checks every byte of an answer's header: the rest of it is 0. */
static void assert_answer(uint32_t code, uint32_t number, int32_t status, uint32_t length) {
    uint8_t expected[HEADER] = {0};
    put_number(expected, code);
    put_number(expected + 4, number);
    put_number(expected + 20, (uint32_t)status);
    put_number(expected + 24, length);
    assert_true(seen_count >= HEADER);
    assert_memory_equal(seen, expected, HEADER);
}

static void attach(void) {
    static const uint8_t set_configuration[8] = {0, 9, 1};
    arrive(false, true);
    import("1-1");
    assert_true(client.is_attached && !client.is_over);
    submit(1, 0, false, 0, set_configuration, NULL);
    assert_answer(3, 1, 0, 0);
    assert_int_equal(device.configuration, 1);
}

static void the_list_names_the_device(void **state) {
    static const uint8_t request[8] = {0x01, 0x11, 0x80, 0x05};
    (void)state;
    for (int is_high = 0; is_high < 2; is_high++) {
        arrive(true, is_high); /* also to who comes while another has the device */
        usbip_client_take(&client, request, sizeof request);
        assert_int_equal(seen_count, 8 + 4 + 312 + 8);
        assert_int_equal(number_at(0), 0x01110005);
        assert_int_equal(number_at(4), 0);
        assert_int_equal(number_at(8), 1);
        assert_string_equal((const char *)seen + 12 + 256, "1-1");
        assert_int_equal(number_at(12 + 296), is_high ? 3 : 2);
        assert_int_equal(number_at(12 + 300), 0x12099801);
        assert_true(client.is_over);
    }
}

/* Reads one of the device's own descriptors. */
static int describe(uint8_t type, uint8_t descriptor[USB_CONTROL_MOST]) {
    const uint8_t get[8] = {0x80, 6, 0, type, 0, 0, 255, 0};
    return usb_device_control(&device, get, NULL, descriptor);
}

/* Checks all 312 bytes of a record against struct usbip_usb_device of the kernel, filled from the
 * device's own descriptor. */
static void assert_record(const uint8_t *record, unsigned speed) {
    uint8_t descriptor[USB_CONTROL_MOST], expected[312] = {0};
    assert_int_equal(describe(1, descriptor), 18);
    strcpy((char *)expected, "/sys/devices/superframe/1-1");
    strcpy((char *)expected + 256, "1-1");
    put_number(expected + 288, 1);
    put_number(expected + 292, 1);
    put_number(expected + 296, speed);
    for (unsigned i = 0; i < 6; i += 2) { /* vendor, product, release: high byte first there */
        expected[300 + i] = descriptor[8 + i + 1];
        expected[300 + i + 1] = descriptor[8 + i];
    }
    memcpy(expected + 306, descriptor + 4, 3); /* class, subclass, protocol */
    expected[309] = device.configuration;
    expected[310] = descriptor[17];
    expected[311] = 2;
    assert_memory_equal(record, expected, sizeof expected);
}

/* Checks class, subclass and protocol of each interface against the configuration's. */
static void assert_interfaces(const uint8_t *interfaces) {
    uint8_t descriptor[USB_CONTROL_MOST];
    unsigned found = 0;
    int count = describe(2, descriptor);
    for (int at = 0; at < count; at += descriptor[at]) {
        if (descriptor[at + 1] == 4) {
            assert_memory_equal(interfaces + 4 * (size_t)found, descriptor + at + 5, 3);
            assert_int_equal(interfaces[4 * found + 3], 0);
            found++;
        }
    }
    assert_int_equal(found, 2);
}

static void every_byte_of_the_records_is_set(void **state) {
    static const uint8_t set_configuration[8] = {0, 9, 1}, request[8] = {0x01, 0x11, 0x80, 0x05};
    uint8_t in[USB_CONTROL_MOST];
    (void)state;
    for (unsigned i = 0; i < 8; i++) {
        bool is_high = i % 2 != 0, is_import = i / 4 != 0;
        arrive(false, is_high);
        if (i / 2 % 2 != 0) {
            assert_int_equal(usb_device_control(&device, set_configuration, NULL, in), 0);
        }
        struct usb_device before = device;
        poison_stack();
        if (is_import) {
            import("1-1");
        } else {
            usbip_client_take(&client, request, sizeof request);
        }
        device = before; /* attaching resets it */
        assert_record(seen + (is_import ? 8 : 12), is_high ? 3 : 2);
        assert_int_equal(seen_count, is_import ? 8 + 312 : 12 + 312 + 8);
        if (!is_import) {
            assert_interfaces(seen + 12 + 312);
        }
    }
}

static void only_a_free_device_of_that_name_is_given(void **state) {
    (void)state;
    arrive(false, true);
    import("1-2");
    assert_int_equal(number_at(0), 0x01110003);
    assert_int_equal(number_at(4), 1);
    assert_true(client.is_over && !client.is_attached);
    arrive(true, true);
    import("1-1");
    assert_int_equal(number_at(4), 2);
    assert_string_equal(client.reason, "another client has the device");
    arrive(false, true);
    import("1-1");
    assert_int_equal(number_at(4), 0);
    assert_int_equal(seen_count, 8 + 312);
}

static void bytes_may_come_one_by_one(void **state) {
    uint8_t request[40] = {0x01, 0x11, 0x80, 0x03, 0, 0, 0, 0, '1', '-', '1'};
    (void)state;
    arrive(false, true);
    for (size_t i = 0; i < sizeof request; i++) {
        assert_int_equal(seen_count, 0);
        usbip_client_take(&client, request + i, 1);
    }
    assert_true(client.is_attached);
}

static void strangers_are_sent_away(void **state) {
    static const struct {
        uint8_t request[8];
        const char *reason;
    } cases[] = {{{0x01, 0x10, 0x80, 0x03}, "another version of USB/IP"},
                 {{0x01, 0x11, 0x80, 0x07}, "neither the list nor a device"}};
    (void)state;
    for (size_t i = 0; i < 2; i++) {
        arrive(false, true);
        usbip_client_take(&client, cases[i].request, 8);
        assert_true(client.is_over);
        assert_non_null(strstr(client.reason, cases[i].reason));
        usbip_client_take(&client, cases[i].request, 8); /* nothing more is taken */
        assert_int_equal(seen_count, 0);
    }
}

static void control_transfers(void **state) {
    static const uint8_t device_descriptor[8] = {0x80, 6, 0, 1, 0, 0, 18, 0};
    static const uint8_t unknown[8] = {0x80, 0x55, 0, 0, 0, 0, 18, 0};
    static const uint8_t out_of_step[8] = {0x00, 9, 1, 0, 0, 0, 5, 0};
    (void)state;
    attach();
    submit(2, 0, true, 18, device_descriptor, NULL);
    assert_answer(3, 2, 0, 18);
    assert_int_equal(seen_count, HEADER + 18);
    assert_int_equal(seen[HEADER], 18);
    submit(3, 0, true, 8, device_descriptor, NULL); /* less room than it has */
    assert_answer(3, 3, 0, 8);
    assert_int_equal(seen_count, HEADER + 8);
    submit(4, 0, true, 18, unknown, NULL);
    assert_answer(3, 4, -32, 0);
    submit(5, 0, true, 18, out_of_step, NULL); /* setup says out, the transfer in */
    assert_answer(3, 5, -32, 0);
    submit(6, 0, false, 0, out_of_step, NULL); /* setup promises five bytes */
    assert_answer(3, 6, -32, 0);
    submit(7, 0, false, 0, device_descriptor, NULL); /* setup says in, and 18 bytes */
    assert_answer(3, 7, -32, 0);
    assert_false(client.is_over);
}

static void transfers_wait_and_may_be_taken_back(void **state) {
    const uint32_t unlink[8] = {2, 20, 0x10001, 0, 0, 11, 0, 0};
    const uint32_t again[8] = {2, 21, 0x10001, 0, 0, 11, 0, 0};
    (void)state;
    attach();
    submit(10, 1, true, 512, NULL, NULL);
    submit(11, 1, true, 512, NULL, NULL);
    submit(12, 1, true, 512, NULL, NULL);
    assert_int_equal(seen_count, 0);
    assert_int_equal(client.parked_count, 3);
    command(unlink, NULL, NULL, 0);
    assert_answer(4, 20, -104, 0);
    assert_int_equal(client.parked_count, 2);
    command(again, NULL, NULL, 0);
    assert_answer(4, 21, 0, 0); /* it is not there any more */
    assert_int_equal(client.parked[1].number, 12);
}

/* A greeting over bulk is answered in the transfer that waits. */
static void what_waits_is_answered_when_there_is_something(void **state) {
    static const uint8_t base[2] = {0xD0, 0x00};
    const struct usb_header hello = {USB_VERSION, USB_KIND_HELLO, 1, 0, 0, 2, USB_HELLO_START, 0};
    static uint8_t frame[USB_FRAME_MOST];
    size_t length = usb_frame_pack(frame, &hello, base);
    (void)state;
    attach();
    submit(30, 1, true, 512, NULL, NULL);
    submit(31, 1, false, (uint32_t)length, NULL, frame);
    assert_answer(3, 31, 0, (uint32_t)length);
    assert_int_equal(number_at(HEADER + 4), 30);
    assert_int_equal(seen_count, 2 * HEADER + number_at(HEADER + 24));
    assert_true(number_at(HEADER + 24) > 0);
    assert_int_equal(client.parked_count, 0);
}

static void endpoints_that_are_none_stall(void **state) {
    static const uint8_t byte[1] = {0};
    (void)state;
    attach();
    submit(40, 9, false, 1, NULL, byte);
    assert_answer(3, 40, -32, 0);
    submit(41, 9, true, 64, NULL, NULL);
    assert_answer(3, 41, -32, 0);
}

static void what_ends_the_visit(void **state) {
    static const struct {
        uint32_t fields[8];
        uint32_t packets;
        const char *reason;
    } cases[] = {
        {{7, 1, 0, 0, 1, 0, 0, 0}, 0, "a command that USB/IP does not have"},
        {{1, 1, 0, 2, 1, 0, 0, 0}, 0, "a command that USB/IP does not have"},
        {{1, 1, 0, 0, 16, 0, 0, 0}, 0, "a command that USB/IP does not have"},
        {{1, 1, 0, 1, 1, 0, 0, 0}, 3, "an isochronous transfer"},
        {{1, 1, 0, 0, 1, 0, 65537, 0}, 0, "more than 65536 bytes"},
    };
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        uint8_t bytes[HEADER] = {0};
        attach();
        for (unsigned j = 0; j < 8; j++) {
            put_number(bytes + 4 * j, cases[i].fields[j]);
        }
        put_number(bytes + 32, cases[i].packets);
        usbip_client_take(&client, bytes, sizeof bytes);
        assert_true(client.is_over);
        assert_non_null(strstr(client.reason, cases[i].reason));
    }
    attach();
    for (uint32_t i = 0; i <= USBIP_PARKED_MOST; i++) {
        assert_false(client.is_over);
        submit(100 + i, 1, true, 64, NULL, NULL);
    }
    assert_string_equal(client.reason, "too many of its transfers wait");
}

static void packets_of_no_number_are_as_good_as_none(void **state) {
    uint8_t bytes[HEADER] = {0, 0, 0, 1, 0, 0, 0, 50, 0, 1, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
    (void)state;
    attach();
    put_number(bytes + 24, 64);
    put_number(bytes + 32, 0xFFFFFFFF);
    usbip_client_take(&client, bytes, sizeof bytes);
    assert_false(client.is_over);
    assert_int_equal(client.parked_count, 1);
}

static void leaving_resets_the_device(void **state) {
    (void)state;
    attach();
    usbip_client_leave(&client);
    assert_false(client.is_attached);
    assert_int_equal(device.configuration, 0);
    usbip_client_leave(&client); /* harmless when repeated */
    assert_false(client.is_attached);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_list_names_the_device),
        cmocka_unit_test(every_byte_of_the_records_is_set),
        cmocka_unit_test(only_a_free_device_of_that_name_is_given),
        cmocka_unit_test(bytes_may_come_one_by_one),
        cmocka_unit_test(strangers_are_sent_away),
        cmocka_unit_test(control_transfers),
        cmocka_unit_test(transfers_wait_and_may_be_taken_back),
        cmocka_unit_test(what_waits_is_answered_when_there_is_something),
        cmocka_unit_test(endpoints_that_are_none_stall),
        cmocka_unit_test(what_ends_the_visit),
        cmocka_unit_test(packets_of_no_number_are_as_good_as_none),
        cmocka_unit_test(leaving_resets_the_device),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
