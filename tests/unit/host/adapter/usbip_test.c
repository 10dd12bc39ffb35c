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
static const uint8_t import_request[40] = {0x01, 0x11, 0x80, 0x03, 0, 0, 0, 0, '1', '-', '1'};

/* Takes out the answers that wait. */
static void see(void) {
    size_t count = client.answer_count;
    assert_true(seen_count + count <= sizeof seen);
    memcpy(seen + seen_count, client.answers, count);
    seen_count += count;
    usbip_client_sent(&client, count);
}

/* Hands in bytes as there is room, and takes out what comes of each. */
static void hand_in(const uint8_t *bytes, size_t count) {
    size_t taken;
    do {
        taken = usbip_client_take(&client, bytes, count);
        bytes += taken;
        count -= taken;
        while (client.answer_count > 0) {
            see();
        }
    } while (count > 0 && taken > 0);
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

static void arrive(bool is_high_speed) {
    power_on(BOARD_1987);
    usb_device_init(&device, &board_bus.bus, 0x00D0, "GUEST", is_high_speed);
    usbip_client_init(&client, &device);
    seen_count = 0;
}

/* Asks for a device of this name; the server gives it or not. */
static void import(const char *name, bool is_given) {
    uint8_t request[40] = {0x01, 0x11, 0x80, 0x03};
    strcpy((char *)request + 8, name);
    hand_in(request, sizeof request);
    if (client.wants_device) {
        usbip_client_give(&client, is_given);
        see();
    }
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
    hand_in(bytes, sizeof bytes);
    hand_in(data, count);
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
    arrive(true);
    import("1-1", true);
    assert_true(client.is_attached && !client.is_over);
    submit(1, 0, false, 0, set_configuration, NULL);
    assert_answer(3, 1, 0, 0);
    assert_int_equal(device.configuration, 1);
}

static void the_list_names_the_device(void **state) {
    static const uint8_t request[8] = {0x01, 0x11, 0x80, 0x05};
    (void)state;
    for (int is_high = 0; is_high < 2; is_high++) {
        arrive(is_high);
        hand_in(request, sizeof request);
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
        arrive(is_high);
        if (i / 2 % 2 != 0) {
            assert_int_equal(usb_device_control(&device, set_configuration, NULL, in), 0);
        }
        struct usb_device before = device;
        poison_stack();
        if (is_import) {
            import("1-1", true);
        } else {
            hand_in(request, sizeof request);
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
    arrive(true);
    import("1-2", true);
    assert_int_equal(number_at(0), 0x01110003);
    assert_int_equal(number_at(4), 1);
    assert_true(client.is_over && !client.is_attached);
    arrive(true);
    import("1-1", false);
    assert_int_equal(number_at(4), 2);
    assert_int_equal(seen_count, 8);
    assert_true(client.is_over && !client.is_attached);
    assert_string_equal(client.reason, "another client has the device");
    arrive(true);
    import("1-1", true);
    assert_int_equal(number_at(4), 0);
    assert_int_equal(seen_count, 8 + 312);
}

static void bytes_may_come_one_by_one(void **state) {
    (void)state;
    arrive(true);
    for (size_t i = 0; i < sizeof import_request; i++) {
        assert_false(client.wants_device);
        hand_in(import_request + i, 1);
    }
    assert_true(client.wants_device);
}

/* Until the server has decided, nothing is answered and no byte of what follows is taken. */
static void who_wants_the_device_waits_for_the_answer(void **state) {
    static const uint8_t set_configuration[8] = {0, 9, 1};
    uint8_t request[40 + HEADER] = {0};
    (void)state;
    arrive(true);
    memcpy(request, import_request, sizeof import_request);
    put_number(request + 40, 1);
    put_number(request + 44, 70);
    memcpy(request + 40 + 40, set_configuration, 8);
    assert_int_equal(usbip_client_take(&client, request, sizeof request), 40);
    assert_int_equal(usbip_client_room(&client), 0);
    assert_int_equal(client.answer_count, 0);
    usbip_client_give(&client, true);
    see();
    assert_int_equal(seen_count, 8 + 312);
    seen_count = 0;
    hand_in(request + 40, HEADER);
    assert_answer(3, 70, 0, 0);
    assert_int_equal(device.configuration, 1);
}

/* A visit that ends first leaves nothing to be given. */
static void who_is_sent_away_wants_nothing(void **state) {
    (void)state;
    arrive(true);
    hand_in(import_request, sizeof import_request);
    usbip_client_end(&client, "the first reason");
    usbip_client_end(&client, "the second");
    assert_true(client.is_over && !client.wants_device);
    assert_string_equal(client.reason, "the first reason");
}

static void strangers_are_sent_away(void **state) {
    static const struct {
        uint8_t request[8];
        const char *reason;
    } cases[] = {{{0x01, 0x10, 0x80, 0x03}, "another version of USB/IP"},
                 {{0x01, 0x11, 0x80, 0x07}, "neither the list nor a device"}};
    (void)state;
    for (size_t i = 0; i < 2; i++) {
        arrive(true);
        hand_in(cases[i].request, 8);
        assert_true(client.is_over);
        assert_non_null(strstr(client.reason, cases[i].reason));
        assert_int_equal(usbip_client_take(&client, cases[i].request, 8), 0); /* nothing more */
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

/* Makes a command that asks for the configuration's descriptor. */
static void ask_for_descriptor(uint8_t request[HEADER], uint32_t number) {
    static const uint8_t get[8] = {0x80, 6, 0, 2, 0, 0, 255, 0};
    memset(request, 0, HEADER);
    put_number(request, 1);
    put_number(request + 4, number);
    put_number(request + 12, 1);
    put_number(request + 24, 255);
    memcpy(request + 40, get, 8);
}

/* Reads the answers to such commands, which were numbered from 1. Returns how many there are. */
static uint32_t read_descriptors(void) {
    uint8_t descriptor[USB_CONTROL_MOST];
    uint32_t count = 0, length = (uint32_t)describe(2, descriptor);
    while (client.answer_count > 0) {
        assert_true(client.answer_count <= sizeof client.answers);
        memcpy(seen, client.answers, HEADER);
        seen_count = HEADER;
        assert_answer(3, ++count, 0, length);
        usbip_client_sent(&client, HEADER + length);
    }
    return count;
}

/* Descriptors are asked for, and no answer is fetched: the queue stays within its bounds, the
 * client is not listened to, and later all answers come in their order. */
static void a_client_that_does_not_read_is_not_listened_to(void **state) {
    uint8_t request[HEADER];
    uint32_t asked = 0;
    (void)state;
    attach();
    do {
        ask_for_descriptor(request, ++asked);
        assert_true(asked < 10000);
    } while (usbip_client_take(&client, request, HEADER) == HEADER);
    asked--; /* the last was not taken */
    assert_int_equal(usbip_client_room(&client), 0);
    assert_true(client.answer_count <= sizeof client.answers && client.answer_count > 16384);
    assert_false(client.is_over);
    assert_int_equal(read_descriptors(), asked);
    assert_true(usbip_client_room(&client) > 0);
}

/* What one packet brought is worked off as room comes, without another packet. */
static void commands_that_had_to_wait_are_done_once_there_is_room(void **state) {
    enum { COMMANDS = 1200 };
    static uint8_t requests[COMMANDS * HEADER];
    (void)state;
    attach();
    for (size_t i = 0; i < COMMANDS; i++) {
        ask_for_descriptor(requests + i * HEADER, (uint32_t)i + 1);
    }
    assert_int_equal(usbip_client_take(&client, requests, sizeof requests), sizeof requests);
    assert_int_equal(read_descriptors(), COMMANDS);
    assert_int_equal(client.input_count, 0);
}

/* The kernel of a client takes an answer that is longer than its transfer for an attack. */
static void no_answer_is_longer_than_its_transfer(void **state) {
    uint8_t get[8] = {0x80, 6, 0, 2, 0, 0, 255, 0};
    (void)state;
    attach();
    for (uint32_t room = 0; room < 80; room++) {
        get[6] = 255;
        submit(200 + room, 0, true, room, get, NULL); /* setup asks for more */
        assert_true(number_at(24) <= room);
        assert_int_equal(seen_count, HEADER + number_at(24));
    }
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
        hand_in(bytes, sizeof bytes);
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
    hand_in(bytes, sizeof bytes);
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
        cmocka_unit_test(who_wants_the_device_waits_for_the_answer),
        cmocka_unit_test(who_is_sent_away_wants_nothing),
        cmocka_unit_test(strangers_are_sent_away),
        cmocka_unit_test(control_transfers),
        cmocka_unit_test(transfers_wait_and_may_be_taken_back),
        cmocka_unit_test(what_waits_is_answered_when_there_is_something),
        cmocka_unit_test(a_client_that_does_not_read_is_not_listened_to),
        cmocka_unit_test(commands_that_had_to_wait_are_done_once_there_is_room),
        cmocka_unit_test(no_answer_is_longer_than_its_transfer),
        cmocka_unit_test(endpoints_that_are_none_stall),
        cmocka_unit_test(what_ends_the_visit),
        cmocka_unit_test(packets_of_no_number_are_as_good_as_none),
        cmocka_unit_test(leaving_resets_the_device),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
