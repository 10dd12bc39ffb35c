/* SPDX-License-Identifier: MIT */
/* The adapter's end: each frame is run once, in order and whole, and the device describes itself
 * as the USB specifications say. */
#include "usb_fixture.h"

static struct usb_device device;
static uint8_t reply_bytes[USB_OUTPUT_BYTES];
static const uint8_t *reply_payload;

static int plug_in(void **state) {
    static const uint8_t set_configuration[8] = {0, 9, 1};
    uint8_t in[USB_CONTROL_MOST];
    (void)state;
    power_on(BOARD_1987);
    usb_device_init(&device, &board_bus.bus, 0, "ABC-123", false);
    assert_int_equal(usb_device_control(&device, set_configuration, NULL, in), 0);
    return 0;
}

static bool deliver(uint8_t kind, uint32_t session, uint32_t sequence, uint8_t flags,
                    const uint8_t *payload, size_t count) {
    uint8_t frame[USB_FRAME_MOST];
    const struct usb_header header = {USB_VERSION,     kind,  session, sequence, 0,
                                      (uint16_t)count, flags, 0};
    size_t length = usb_frame_pack(frame, &header, payload);
    return usb_device_out(&device, USB_BULK_OUT, frame, length);
}

/* The next reply; false if there is none. */
static bool fetch(struct usb_header *header) {
    int count = usb_device_in(&device, USB_BULK_IN, reply_bytes, USB_HEADER_BYTES);
    size_t length = 0;
    if (count == USB_NOTHING_YET) {
        return false;
    }
    assert_int_equal(count, USB_HEADER_BYTES);
    int rest = usb_get16(reply_bytes + 16) + USB_CHECK_BYTES;
    assert_int_equal(
        usb_device_in(&device, USB_BULK_IN, reply_bytes + USB_HEADER_BYTES, (size_t)rest), rest);
    assert_int_equal(usb_frame_scan(reply_bytes, (size_t)(count + rest), header, &length),
                     USB_SCAN_FRAME);
    reply_payload = reply_bytes + USB_HEADER_BYTES;
    return true;
}

static uint8_t ask(uint8_t kind, uint32_t session, uint32_t sequence, uint8_t flags,
                   const uint8_t *payload, size_t count, struct usb_header *header) {
    assert_true(deliver(kind, session, sequence, flags, payload, count));
    assert_true(fetch(header));
    assert_int_equal(header->kind, USB_KIND_REPLY);
    assert_int_equal(header->sequence, sequence);
    assert_int_equal(header->credits, USB_CREDITS_MOST);
    return header->status;
}

static const uint8_t base[2] = {0xD0, 0x00};

static void greet(uint32_t session) {
    struct usb_header header;
    assert_int_equal(ask(USB_KIND_HELLO, session, 0, USB_HELLO_START, base, 2, &header),
                     USB_STATUS_OK);
    assert_int_equal(header.session, session);
}

static void a_frame_is_run_once_whatever_comes_twice(void **state) {
    static const uint8_t red_twice[] = {0x14, 5, 0, 0x16, 6, 0, 0x08, 0x11, 0x28, 0x08, 0x22};
    struct usb_header header;
    (void)state;
    greet(77);
    assert_int_equal(ask(USB_KIND_RUN, 77, 1, 0, red_twice, sizeof red_twice, &header),
                     USB_STATUS_OK);
    assert_int_equal(header.last, 1);
    assert_int_equal(header.length, 1);
    assert_int_equal(reply_payload[0], 0x11);
    uint64_t accesses = board.accesses;
    assert_int_equal(accesses, 5);
    assert_int_equal(ask(USB_KIND_RUN, 77, 1, 0, red_twice, sizeof red_twice, &header),
                     USB_STATUS_DUPLICATE);
    assert_int_equal(header.length, 1);
    assert_int_equal(reply_payload[0], 0x11); /* what it read then, though red is 22h by now */
    greet(77); /* a hello that comes twice does not begin anew either */
    assert_int_equal(ask(USB_KIND_RUN, 77, 1, 0, red_twice, sizeof red_twice, &header),
                     USB_STATUS_DUPLICATE);
    assert_int_equal(board.accesses, accesses);
}

static void nothing_of_a_refused_frame_is_run(void **state) {
    static const uint8_t good[] = {0x08, 0x11};
    static const uint8_t half[] = {0x08, 0x11, 0x08};          /* the second op is cut off */
    static const uint8_t unknown[] = {0x08, 0x11, 0x7F};       /* and here it is none */
    static const uint8_t outside[] = {0x08, 0x11, 0x1F, 0, 0}; /* a word at the last port */
    uint8_t many_reads[171 * 2];
    struct usb_header header;
    (void)state;
    assert_int_equal(ask(USB_KIND_RUN, 5, 1, 0, good, 2, &header), USB_STATUS_UNKNOWN_SESSION);
    greet(5);
    assert_int_equal(ask(USB_KIND_RUN, 6, 1, 0, good, 2, &header), USB_STATUS_UNKNOWN_SESSION);
    assert_int_equal(ask(USB_KIND_RUN, 5, 2, 0, good, 2, &header), USB_STATUS_GAP);
    assert_int_equal(ask(USB_KIND_RUN, 5, 1, 0, half, sizeof half, &header), USB_STATUS_BAD_OP);
    assert_int_equal(ask(USB_KIND_RUN, 5, 1, 0, unknown, sizeof unknown, &header),
                     USB_STATUS_BAD_OP);
    assert_int_equal(ask(USB_KIND_RUN, 5, 1, 0, outside, sizeof outside, &header),
                     USB_STATUS_BAD_OP);
    for (unsigned i = 0; i < sizeof many_reads; i += 2) {
        many_reads[i] = USB_OP_READ_PIXELS;
        many_reads[i + 1] = 0;
    }
    assert_int_equal(ask(USB_KIND_RUN, 5, 1, 0, many_reads, sizeof many_reads, &header),
                     USB_STATUS_BAD_OP);
    assert_int_equal(ask(9, 5, 1, 0, good, 2, &header), USB_STATUS_BAD_KIND);
    assert_int_equal(header.last, 0);
    assert_int_equal(board.accesses, 0);
    assert_int_equal(ask(USB_KIND_RUN, 5, 1, 0, many_reads, 170 * 2, &header), USB_STATUS_OK);
    assert_int_equal(header.length, 510);
    assert_int_equal(ask(USB_KIND_RUN, 5, 2, 0, good, 2, &header), USB_STATUS_OK);
    assert_int_equal(board.accesses, 170 * 4 + 1);
}

static void a_damaged_frame_is_told_and_the_next_one_is_run(void **state) {
    static const uint8_t good[] = {0x08, 0x11};
    uint8_t frames[2 * (USB_OVERHEAD + 2)];
    const struct usb_header run = {USB_VERSION, USB_KIND_RUN, 5, 1, 0, 2, 0, 0};
    struct usb_header header;
    (void)state;
    greet(5);
    size_t length = usb_frame_pack(frames, &run, good);
    (void)usb_frame_pack(frames + length, &run, good);
    frames[USB_HEADER_BYTES] ^= 1;
    assert_true(usb_device_out(&device, USB_BULK_OUT, frames, 2 * length));
    assert_true(fetch(&header));
    assert_int_equal(header.status, USB_STATUS_BAD_CHECK);
    assert_true(fetch(&header));
    assert_int_equal(header.status, USB_STATUS_OK);
    assert_int_equal(header.last, 1);
    assert_int_equal(device.adapter.damaged, 1);
}

static void a_session_outlives_the_cable_but_not_the_power(void **state) {
    static const uint8_t good[] = {0x08, 0x11};
    struct usb_header header;
    (void)state;
    greet(5);
    assert_int_equal(ask(USB_KIND_RUN, 5, 1, 0, good, 2, &header), USB_STATUS_OK);
    usb_device_reset(&device);
    assert_false(deliver(USB_KIND_HELLO, 5, 0, 0, base, 2)); /* not configured yet */
    device.configuration = 1;
    assert_int_equal(ask(USB_KIND_HELLO, 5, 0, 0, base, 2, &header), USB_STATUS_OK);
    assert_int_equal(header.last, 1);
    plug_in(NULL);
    assert_int_equal(ask(USB_KIND_HELLO, 5, 0, 0, base, 2, &header), USB_STATUS_UNKNOWN_SESSION);
    assert_int_equal(header.session, 0);
}

static void another_version_and_another_base_are_refused(void **state) {
    static const uint8_t odd_base[2] = {0xD1, 0x00};
    uint8_t frame[USB_OVERHEAD + 2];
    const struct usb_header later = {2, USB_KIND_HELLO, 5, 0, 0, 2, USB_HELLO_START, 0};
    struct usb_header header;
    (void)state;
    assert_true(usb_device_out(&device, USB_BULK_OUT, frame, usb_frame_pack(frame, &later, base)));
    assert_true(fetch(&header));
    assert_int_equal(header.status, USB_STATUS_BAD_VERSION);
    assert_int_equal(header.version, USB_VERSION);
    assert_int_equal(ask(USB_KIND_HELLO, 5, 0, USB_HELLO_START, odd_base, 2, &header),
                     USB_STATUS_BAD_BASE);
    assert_int_equal(ask(USB_KIND_HELLO, 5, 0, USB_HELLO_START, base, 1, &header),
                     USB_STATUS_BAD_BASE);
    assert_int_equal(device.adapter.session, 0);
}

static void too_many_unfetched_replies_stall_the_endpoint(void **state) {
    static const uint8_t clear[8] = {2, 1, 0, 0, USB_BULK_OUT};
    uint8_t in[USB_CONTROL_MOST];
    unsigned sent = 0;
    (void)state;
    while (sent < 1000 && deliver(USB_KIND_HELLO, 5, 0, USB_HELLO_START, base, 2)) {
        sent++;
    }
    assert_in_range(sent, USB_CREDITS_MOST + 1, 999);
    assert_false(deliver(USB_KIND_HELLO, 5, 0, USB_HELLO_START, base, 2));
    while (usb_device_in(&device, USB_BULK_IN, reply_bytes, sizeof reply_bytes) > 0) {
    }
    assert_int_equal(usb_device_control(&device, clear, NULL, in), 0);
    assert_true(deliver(USB_KIND_HELLO, 5, 0, USB_HELLO_START, base, 2));
}

/* A whole window of the largest frames there are, with the largest replies there are. */
static void all_runs_that_credits_allow_are_run_before_a_reply_is_fetched(void **state) {
    static uint8_t payload[USB_PAYLOAD_MOST];
    struct usb_header header;
    (void)state;
    memset(payload, USB_OP_READ_BYTE | BOARD_RED, USB_READ_MOST);
    for (unsigned i = USB_READ_MOST; i < sizeof payload; i += 2) {
        payload[i] = USB_OP_WRITE_BYTE | BOARD_RED;
    }
    greet(5);
    for (unsigned i = 1; i <= USB_CREDITS_MOST; i++) {
        payload[sizeof payload - 1] = (uint8_t)i;
        assert_true(deliver(USB_KIND_RUN, 5, i, 0, payload, sizeof payload));
        assert_int_equal(device.adapter.last, i);
    }
    /* One frame more is kept, and run as soon as there is room for its reply. */
    assert_true(deliver(USB_KIND_RUN, 5, USB_CREDITS_MOST + 1, 0, payload, sizeof payload));
    assert_int_equal(device.adapter.last, USB_CREDITS_MOST);
    for (unsigned i = 1; i <= USB_CREDITS_MOST + 1; i++) {
        assert_true(fetch(&header));
        assert_int_equal(header.sequence, i);
        assert_int_equal(header.status, USB_STATUS_OK);
        assert_int_equal(header.length, USB_READ_MOST);
        assert_int_equal(reply_payload[0], i - 1); /* what the run before wrote */
    }
    assert_false(fetch(&header));
}

static void a_report_without_bytes_changes_nothing(void **state) {
    static const uint8_t set_report[8] = {0x21, 9, 0, 2, 1, 0, 0, 0};
    uint8_t in[USB_CONTROL_MOST];
    (void)state;
    assert_int_equal(usb_device_control(&device, set_report, NULL, in), 0);
    assert_true(usb_device_out(&device, USB_HID_OUT, NULL, 0));
    assert_true(usb_device_out(&device, USB_BULK_OUT, NULL, 0));
    assert_false(device.is_by_hid);
}

static void an_answer_is_no_longer_than_asked_for(void **state) {
    static const uint16_t lengths[] = {0, 1, 17, 18, 19, 0x7FFF, 0x8000, 0xFFFF};
    uint8_t in[USB_CONTROL_MOST];
    (void)state;
    for (size_t i = 0; i < sizeof lengths / sizeof lengths[0]; i++) {
        uint8_t setup[8] = {0x80, 6, 0, 1};
        usb_put16(setup + 6, lengths[i]);
        assert_int_equal(usb_device_control(&device, setup, NULL, in),
                         lengths[i] < 18 ? lengths[i] : 18);
    }
}

static int get(unsigned type, unsigned index, unsigned length, uint8_t *in) {
    const uint8_t setup[8] = {0x80, 6, (uint8_t)index, (uint8_t)type, 0, 0, (uint8_t)length, 0};
    return usb_device_control(&device, setup, NULL, in);
}

/* Whatever is asked for in full length, the bytes behind the answer are the caller's own. */
static void nothing_is_written_behind_an_answer(void **state) {
    (void)state;
    for (unsigned type = 0x80; type < 256; type++) {
        for (unsigned request = 0; request < 256; request += request < 16 ? 1 : 9) {
            for (unsigned value = 0; value < 0x2400; value += value % 0x100 < 6 ? 1 : 0xFA) {
                uint8_t in[USB_CONTROL_MOST];
                const uint8_t setup[8] = {(uint8_t)type,
                                          (uint8_t)request,
                                          (uint8_t)value,
                                          (uint8_t)(value >> 8),
                                          0,
                                          0,
                                          0xFF,
                                          0xFF};
                memset(in, 0xA5, sizeof in);
                int length = usb_device_control(&device, setup, NULL, in);
                for (int i = length > 0 ? length : 0; i < USB_CONTROL_MOST; i++) {
                    if (in[i] != 0xA5) {
                        fail_msg("request %02X %02X %04X: %d bytes, and byte %d", type, request,
                                 value, length, i);
                    }
                }
            }
        }
    }
}

static void the_descriptors_are_whole(void **state) {
    uint8_t in[USB_CONTROL_MOST];
    unsigned interfaces = 0, endpoints = 0;
    (void)state;
    assert_int_equal(get(1, 0, 64, in), 18);
    assert_int_equal(in[0], 18);
    assert_true(usb_get16(in + 2) >= 0x0201); /* else nobody asks for the BOS descriptor */
    assert_int_equal(get(1, 0, 8, in), 8);
    assert_int_equal(get(2, 0, 255, in), 64);
    assert_int_equal(usb_get16(in + 2), 64);
    for (unsigned place = 0; place < 64; place += in[place]) {
        assert_in_range(in[place], 7, 64 - place);
        interfaces += in[place + 1] == 4;
        endpoints += in[place + 1] == 5;
        if (in[place + 1] == 0x21) {
            uint8_t report[USB_CONTROL_MOST];
            const uint8_t setup[8] = {0x81, 6, 0, 0x22, 1, 0, 255, 0};
            int length = usb_device_control(&device, setup, NULL, report);
            assert_int_equal(length, usb_get16(in + place + 7));
            assert_int_equal(report[length - 1], 0xC0); /* the end of the collection */
        }
    }
    assert_int_equal(interfaces, in[4]);
    assert_int_equal(endpoints, 4);
    assert_int_equal(get(3, 3, 255, in), 2 + 2 * 7);
    assert_int_equal(in[2], 'A');
    assert_int_equal(in[14], '3');
    assert_int_equal(get(3, 9, 255, in), USB_STALL);
    assert_int_equal(get(6, 0, 255, in), USB_STALL); /* at full speed there is no other speed */
    device.is_high_speed = true;
    assert_int_equal(get(6, 0, 255, in), 10);
    assert_int_equal(get(2, 0, 255, in), 64);
    assert_int_equal(usb_get16(in + 22), 512);
}

/* What a HID report descriptor has said so far (HID 1.11, section 6.2.2). */
struct report_items {
    long minimum, maximum, size, count, page, usage;
    long bits[3]; /* in, out, feature */
};

/* Takes an item, whose value has no sign here: maxima are given in two bytes. */
static void take_item(struct report_items *items, unsigned tag, long value) {
    long *const kept[] = {[0x04 >> 2] = &items->page,    [0x08 >> 2] = &items->usage,
                          [0x14 >> 2] = &items->minimum, [0x24 >> 2] = &items->maximum,
                          [0x74 >> 2] = &items->size,    [0x94 >> 2] = &items->count};
    const unsigned mains[] = {0x80, 0x90, 0xB0};
    if ((tag >> 2) < sizeof kept / sizeof kept[0] && kept[tag >> 2] != NULL) {
        *kept[tag >> 2] = value;
    }
    for (int i = 0; i < 3; i++) {
        if (tag == mains[i]) {
            assert_int_equal(value, 2); /* data, variable, absolute */
            assert_int_equal(items->minimum, 0);
            assert_int_equal(items->maximum, 255);
            assert_int_equal(items->size, 8);
            items->bits[i] += items->size * items->count;
        }
    }
}

static void the_report_descriptor_has_the_reports_of_the_pages(void **state) {
    uint8_t report[USB_CONTROL_MOST];
    const uint8_t setup[8] = {0x81, 6, 0, 0x22, 1, 0, 255, 0};
    struct report_items items = {0, 0, 0, 0, 0, 0, {0, 0, 0}};
    int depth = 0;
    (void)state;
    int length = usb_device_control(&device, setup, NULL, report);
    for (int i = 0; i < length;) {
        const unsigned tag = report[i] & 0xFCu, bytes = report[i] & 3u;
        long value = 0;
        assert_true(bytes <= 2 && i + 1 + (int)bytes <= length);
        for (unsigned j = 0; j < bytes; j++) {
            value |= (long)report[i + 1 + (int)j] << 8 * j;
        }
        depth += tag == 0xA0 ? 1 : tag == 0xC0 ? -1 : 0;
        assert_true(tag != 0xA0 || value == 1); /* an application's collection */
        take_item(&items, tag, value);
        i += 1 + (int)bytes;
    }
    assert_int_equal(depth, 0);
    assert_int_equal(items.page, 0xFF00); /* docs/usb-protocol.md */
    assert_int_equal(items.bits[0], 64 * 8);
    assert_int_equal(items.bits[1], 64 * 8);
    assert_int_equal(items.bits[2], 32 * 8);
}

/* The device has one descriptor of each of these; whoever asks for another gets a stall. */
static void there_is_one_of_each_descriptor(void **state) {
    uint8_t in[USB_CONTROL_MOST];
    (void)state;
    device.is_high_speed = true;
    for (unsigned index = 1; index < 256; index++) {
        assert_int_equal(get(2, index, 255, in), USB_STALL);
        assert_true(index < 16 ? get(3, index, 255, in) != 0 : get(3, index, 255, in) == USB_STALL);
    }
    for (unsigned type = 16; type < 256; type++) {
        if (type != 0x21 && type != 0x22) { /* of HID */
            assert_int_equal(get(type, 0, 255, in), USB_STALL);
        }
    }
}

static void windows_finds_its_driver(void **state) {
    uint8_t in[USB_CONTROL_MOST];
    (void)state;
    int length = get(15, 0, 255, in);
    assert_int_equal(length, usb_get16(in + 2));
    assert_int_equal(in[5 + 2], 5); /* a platform capability */
    unsigned total = usb_get16(in + 5 + 24);
    const uint8_t setup[8] = {0xC0, in[5 + 26], 0, 0, 7, 0, 255, 0};
    assert_int_equal(usb_device_control(&device, setup, NULL, in), total);
    assert_int_equal(usb_get16(in + 8), total);
    assert_int_equal(usb_get16(in + 10 + 6), total - 10);
    assert_int_equal(usb_get16(in + 18 + 6), total - 18);
    assert_string_equal(in + 30, "WINUSB");
    assert_int_equal(46 + usb_get16(in + 46), total);
    unsigned name = usb_get16(in + 46 + 6), value = usb_get16(in + 46 + 8 + name);
    assert_int_equal(46 + 8 + name + 2 + value, total);
    assert_int_equal(usb_get16(in + total - 2), 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup(a_frame_is_run_once_whatever_comes_twice, plug_in),
        cmocka_unit_test_setup(nothing_of_a_refused_frame_is_run, plug_in),
        cmocka_unit_test_setup(a_damaged_frame_is_told_and_the_next_one_is_run, plug_in),
        cmocka_unit_test_setup(a_session_outlives_the_cable_but_not_the_power, plug_in),
        cmocka_unit_test_setup(another_version_and_another_base_are_refused, plug_in),
        cmocka_unit_test_setup(too_many_unfetched_replies_stall_the_endpoint, plug_in),
        cmocka_unit_test_setup(all_runs_that_credits_allow_are_run_before_a_reply_is_fetched,
                               plug_in),
        cmocka_unit_test_setup(a_report_without_bytes_changes_nothing, plug_in),
        cmocka_unit_test_setup(an_answer_is_no_longer_than_asked_for, plug_in),
        cmocka_unit_test_setup(nothing_is_written_behind_an_answer, plug_in),
        cmocka_unit_test_setup(the_descriptors_are_whole, plug_in),
        cmocka_unit_test_setup(there_is_one_of_each_descriptor, plug_in),
        cmocka_unit_test_setup(the_report_descriptor_has_the_reports_of_the_pages, plug_in),
        cmocka_unit_test_setup(windows_finds_its_driver, plug_in),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
