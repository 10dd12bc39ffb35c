/* SPDX-License-Identifier: MIT */
/* Accesses to ops and back: the same accesses in the same order, for few bytes. */
#include "board_fixture.h"

#include "usb_encoder.h"

enum { LOG_MOST = 40000 };

/* A bus that remembers, and whose reads give what their number says. */
struct log_bus {
    struct bus bus;
    unsigned count;
    struct {
        uint16_t port, value;
        uint8_t width;
        bool is_read;
    } entries[LOG_MOST];
};

static struct log_bus direct, decoded;
static struct usb_encoder encoder;
static struct usb_memory memory;
static uint8_t data[USB_READ_MOST];
static size_t payload_bytes, data_count;

static void log_access(struct bus *bus, uint16_t port, uint16_t value, unsigned width,
                       bool is_read) {
    struct log_bus *log = (struct log_bus *)bus;
    assert_true(log->count < LOG_MOST);
    assert_in_range(port, 0x00D0, 0x00DF - (width - 1));
    log->entries[log->count].port = port;
    log->entries[log->count].value = value;
    log->entries[log->count].width = (uint8_t)width;
    log->entries[log->count].is_read = is_read;
    log->count++;
}

static void log_write(struct bus *bus, uint16_t port, uint16_t value, unsigned width) {
    log_access(bus, port, value, width, false);
}

static uint16_t log_read(struct bus *bus, uint16_t port, unsigned width) {
    uint16_t value = (uint16_t)(((struct log_bus *)bus)->count * 40503U);
    value = width == BUS_BYTE ? (uint16_t)(value & 0xFF) : value;
    log_access(bus, port, value, width, true);
    return value;
}

/* What the adapter would do with a payload. */
static void run_payload(void *context) {
    size_t reads = 0;
    (void)context;
    assert_true(usb_ops_check(&memory, encoder.payload, encoder.used, &reads));
    data_count = usb_ops_run(&memory, &decoded.bus, 0x00D0, encoder.payload, encoder.used, data);
    assert_int_equal(data_count, reads);
    payload_bytes += encoder.used;
}

static void start(void) {
    static const struct bus_operations log_operations = {log_write, log_read, NULL};
    memset(&direct, 0, sizeof direct);
    memset(&decoded, 0, sizeof decoded);
    direct.bus.operations = decoded.bus.operations = &log_operations;
    memset(&memory, 0, sizeof memory);
    payload_bytes = data_count = 0;
    usb_encoder_init(&encoder, USB_PAYLOAD_LEAST, run_payload, NULL);
}

static void finish(void) {
    usb_encoder_flush(&encoder);
    run_payload(NULL);
    encoder.used = 0;
    assert_int_equal(decoded.count, direct.count);
    assert_memory_equal(decoded.entries, direct.entries, direct.count * sizeof direct.entries[0]);
    assert_memory_equal(&memory, &encoder.memory, sizeof memory);
}

static void write_both(unsigned offset, unsigned value, unsigned width) {
    bus_write(&direct.bus, (uint16_t)(0x00D0 + offset), (uint16_t)value, width);
    assert_true(usb_encoder_write(&encoder, offset, (uint16_t)value, width));
}

static void read_both(unsigned offset, unsigned width) {
    uint16_t expected = bus_read(&direct.bus, (uint16_t)(0x00D0 + offset), width);
    assert_true(usb_encoder_read(&encoder, offset, width));
    run_payload(NULL);
    encoder.used = 0;
    assert_int_equal(data_count, width);
    assert_int_equal(width == BUS_BYTE ? data[0] : usb_get16(data), expected);
}

static void pixel_both(unsigned x, const uint8_t rgb[3]) {
    write_both(BOARD_X, x, BUS_WORD);
    for (unsigned i = 0; i < 3; i++) {
        write_both(BOARD_RED + 2 * i, rgb[i], BUS_BYTE);
    }
}

static void any_accesses_come_out_as_they_went_in(void **state) {
    (void)state;
    for (uint64_t seed = 1; seed <= 60; seed++) {
        uint64_t random = seed;
        uint8_t rgb[3] = {0, 0, 0};
        unsigned x = 0;
        start();
        for (unsigned i = 0; i < 1500; i++) {
            uint32_t kind = next_random(&random) % 16, noise = next_random(&random);
            if (kind == 0) {
                unsigned width = 1 + noise % 2;
                write_both(noise >> 1 & (width == 2 ? 7U : 15U),
                           noise >> 8 & 0xFFFF >> (16 - 8 * width), width);
            } else if (kind == 1) {
                read_both(noise % 15, 1 + (noise >> 8) % 2);
            } else if (kind == 2) { /* a pixel that breaks off */
                write_both(BOARD_X, noise & 0x3FF, BUS_WORD);
                write_both(BOARD_RED, noise >> 16 & 0xFF, BUS_BYTE);
            } else if (kind == 3) {
                x = noise % 700;
            } else if (kind == 4) {
                write_both(BOARD_Y, memory.y + noise % 3, BUS_WORD);
            } else {
                rgb[noise % 3] = (uint8_t)(kind < 8 ? noise >> 8 : 0xFF * (noise >> 8 & 1));
                pixel_both(x++, rgb);
                if (kind > 12) {
                    pixel_both(x++, rgb);
                }
            }
        }
        finish();
    }
}

/* Bytes for one line of pixels, after a line that is all grey. */
static size_t cost_of_line(void (*colour)(unsigned x, uint8_t rgb[3])) {
    static const uint8_t grey[3] = {0x80, 0x80, 0x80};
    start();
    write_both(BOARD_Y, 0, BUS_WORD);
    for (unsigned x = 0; x < 640; x++) {
        pixel_both(x, grey);
    }
    write_both(BOARD_Y, 1, BUS_WORD);
    usb_encoder_flush(&encoder);
    run_payload(NULL);
    encoder.used = 0;
    payload_bytes = 0;
    for (unsigned x = 0; x < 640; x++) {
        uint8_t rgb[3];
        colour(x, rgb);
        pixel_both(x, rgb);
    }
    finish();
    return payload_bytes;
}

static void noisy(unsigned x, uint8_t rgb[3]) {
    uint64_t random = x + 1;
    for (unsigned i = 0; i < 3; i++) {
        rgb[i] = (uint8_t)(next_random(&random) | 2U); /* never an extreme 00h */
    }
}

static void flat(unsigned x, uint8_t rgb[3]) {
    (void)x;
    rgb[0] = 1, rgb[1] = 2, rgb[2] = 3;
}

static void as_above(unsigned x, uint8_t rgb[3]) {
    (void)x;
    rgb[0] = rgb[1] = rgb[2] = 0x80;
}

static void red_ramp(unsigned x, uint8_t rgb[3]) {
    rgb[0] = (uint8_t)x, rgb[1] = 2, rgb[2] = 3;
}

static void doubled(unsigned x, uint8_t rgb[3]) {
    noisy(x / 2, rgb);
}

static void eight_colours(unsigned x, uint8_t rgb[3]) {
    uint64_t random = x + 1;
    for (unsigned i = 0; i < 3; i++) {
        rgb[i] = (next_random(&random) & 1) != 0 ? 0xFF : 0x00;
    }
}

static void repeats_and_what_is_unchanged_cost_less(void **state) {
    (void)state;
    assert_in_range(cost_of_line(noisy), 3 * 640, 3 * 640 + 3 * 2);
    assert_in_range(cost_of_line(flat), 1, 8);
    assert_in_range(cost_of_line(as_above), 1, 3);
    assert_in_range(cost_of_line(red_ramp), 640, 640 + 12);
    assert_in_range(cost_of_line(doubled), 3 * 320, 3 * 320 + 2 * 2);
    assert_in_range(cost_of_line(eight_colours), 240, 240 + 3);
}

static void a_word_that_leaves_the_board_is_refused(void **state) {
    (void)state;
    start();
    assert_false(usb_encoder_write(&encoder, 15, 0, BUS_WORD));
    assert_false(usb_encoder_read(&encoder, 15, BUS_WORD));
    assert_false(usb_encoder_write(&encoder, 16, 0, BUS_BYTE));
    assert_false(usb_encoder_write(&encoder, 0xFFFF, 0, BUS_WORD));
    assert_int_equal(encoder.used, 0);
    assert_true(usb_encoder_write(&encoder, 15, 0, BUS_BYTE));
}

/* log_access() holds the port to the sixteen; the sanitizers hold the reads to the payload. */
static void no_payload_reaches_beyond_the_board(void **state) {
    uint64_t random = 99;
    unsigned passed = 0;
    (void)state;
    for (unsigned i = 0; i < 200000; i++) {
        uint8_t ops[12];
        size_t count = 1 + next_random(&random) % sizeof ops, reads = 0;
        for (size_t j = 0; j < count; j++) {
            ops[j] = (uint8_t)next_random(&random);
        }
        uint8_t *exact = test_malloc(count);
        memcpy(exact, ops, count);
        start();
        memory.next_x = (uint16_t)(next_random(&random) % 700);
        if (usb_ops_check(&memory, exact, count, &reads)) {
            assert_true(reads <= USB_READ_MOST);
            assert_int_equal(usb_ops_run(&memory, &decoded.bus, 0x00D0, exact, count, data), reads);
            passed++;
        }
        test_free(exact);
    }
    assert_true(passed > 1000);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(any_accesses_come_out_as_they_went_in),
        cmocka_unit_test(repeats_and_what_is_unchanged_cost_less),
        cmocka_unit_test(a_word_that_leaves_the_board_is_refused),
        cmocka_unit_test(no_payload_reaches_beyond_the_board),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
