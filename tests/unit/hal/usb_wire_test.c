/* SPDX-License-Identifier: MIT */
/* Frames, replies and reports: what is packed comes out again, and nothing else passes. */
#include "board_fixture.h"

#include "usb_wire.h"

static uint8_t frame[USB_FRAME_MOST], payload[USB_PAYLOAD_MOST];

static struct usb_header random_header(uint64_t *random) {
    const struct usb_header header = {USB_VERSION,
                                      (uint8_t)next_random(random),
                                      next_random(random),
                                      next_random(random),
                                      next_random(random),
                                      (uint16_t)(next_random(random) % (USB_PAYLOAD_MOST + 1)),
                                      (uint8_t)next_random(random),
                                      (uint8_t)next_random(random)};
    return header;
}

static void the_crc_is_the_one_of_ieee_802_3(void **state) {
    static const uint8_t digits[] = "123456789";
    (void)state;
    assert_int_equal(usb_crc(0, digits, 9), 0xCBF43926); /* the check value of its definition */
    assert_int_equal(usb_crc(usb_crc(0, digits, 4), digits + 4, 5), 0xCBF43926);
}

static void a_frame_has_the_bytes_that_the_protocol_says(void **state) {
    static const uint8_t expected[] = {'S',  'F',  1,    2,    0x44, 0x33, 0x22, 0x11, 0x88, 0x77,
                                       0x66, 0x55, 0xCC, 0xBB, 0xAA, 0x99, 2,    0,    7,    8};
    static const uint8_t ops[2] = {0x0E, 0x01};
    const struct usb_header header = {1, 2, 0x11223344, 0x55667788, 0x99AABBCC, 2, 7, 8};
    (void)state;
    assert_int_equal(usb_frame_pack(frame, &header, ops), 28);
    assert_memory_equal(frame, expected, sizeof expected);
    assert_int_equal(usb_get16(frame + 20), usb_crc(0, frame, 20) & 0xFFFF);
    assert_memory_equal(frame + 22, ops, 2);
    assert_int_equal(usb_get32(frame + 24), usb_crc(0, frame, 24));
}

static void what_is_packed_comes_out_again(void **state) {
    uint64_t random = 17;
    (void)state;
    for (unsigned i = 0; i < 500; i++) {
        const struct usb_header header = random_header(&random);
        struct usb_header found;
        size_t length = 0;
        for (size_t j = 0; j < header.length; j++) {
            payload[j] = (uint8_t)next_random(&random);
        }
        size_t packed = usb_frame_pack(frame, &header, payload);
        assert_int_equal(packed, USB_OVERHEAD + header.length);
        assert_int_equal(usb_frame_scan(frame, packed, &found, &length), USB_SCAN_FRAME);
        assert_int_equal(length, packed);
        assert_int_equal(found.session, header.session);
        assert_int_equal(found.sequence, header.sequence);
        assert_int_equal(found.last, header.last);
        assert_int_equal(found.length, header.length);
        assert_int_equal(found.kind, header.kind);
        assert_int_equal(found.status, header.status);
        assert_int_equal(found.credits, header.credits);
        assert_memory_equal(frame + USB_HEADER_BYTES, payload, header.length);
        size_t cut = next_random(&random) % packed;
        assert_int_equal(usb_frame_scan(frame, cut, &found, &length), USB_SCAN_MORE);
    }
}

static void no_frame_with_a_flipped_bit_passes(void **state) {
    const struct usb_header header = {USB_VERSION, USB_KIND_RUN, 1, 2, 3, 40, 0, 0};
    (void)state;
    memset(payload, 0x53, sizeof payload);
    size_t packed = usb_frame_pack(frame, &header, payload);
    for (size_t bit = 0; bit < 8 * packed; bit++) {
        struct usb_header found;
        size_t length = 0;
        frame[bit / 8] ^= (uint8_t)(1U << bit % 8);
        enum usb_scan scan = usb_frame_scan(frame, packed, &found, &length);
        assert_true(scan == USB_SCAN_NOISE || scan == USB_SCAN_DAMAGED);
        assert_in_range(length, 1, packed);
        frame[bit / 8] ^= (uint8_t)(1U << bit % 8);
    }
}

static void a_frame_is_found_behind_anything(void **state) {
    static uint8_t stream[4 * USB_FRAME_MOST];
    uint64_t random = 23;
    (void)state;
    for (unsigned i = 0; i < 200; i++) {
        const struct usb_header header = {USB_VERSION, USB_KIND_RUN, 9, i + 1, 0, 100, 0, 0};
        size_t noise = next_random(&random) % 300, place = 0;
        struct usb_header found = {0};
        bool is_found = false;
        for (size_t j = 0; j < noise; j++) {
            stream[j] = (uint8_t)(next_random(&random) % 3 == 0 ? 'S' : 'F');
        }
        size_t packed = usb_frame_pack(frame, &header, payload);
        size_t cut = next_random(&random) % packed; /* and behind a part of itself */
        memcpy(stream + noise, frame, cut);
        memcpy(stream + noise + cut, frame, packed);
        size_t total = noise + cut + packed;
        while (place < total && !is_found) {
            size_t length = 0;
            enum usb_scan scan = usb_frame_scan(stream + place, total - place, &found, &length);
            if (scan == USB_SCAN_MORE) {
                break;
            }
            is_found = scan == USB_SCAN_FRAME;
            assert_true(length > 0);
            place += length;
        }
        assert_true(is_found);
        assert_int_equal(found.sequence, i + 1);
        assert_int_equal(place, total);
    }
}

/* The first byte of a frame may wait for more; two bytes that begin none may not. */
static void two_bytes_tell_whether_a_frame_begins(void **state) {
    (void)state;
    for (unsigned first = 0; first < 256; first++) {
        for (unsigned second = 0; second < 256; second++) {
            const uint8_t bytes[2] = {(uint8_t)first, (uint8_t)second};
            struct usb_header found;
            size_t length = 0;
            enum usb_scan scan = usb_frame_scan(bytes, 2, &found, &length);
            if (first == 'S' && second == 'F') {
                assert_int_equal(scan, USB_SCAN_MORE);
            } else {
                assert_int_equal(scan, USB_SCAN_NOISE);
                assert_int_equal(length, second == 'S' ? 1 : 2);
            }
        }
    }
}

static void reports_carry_the_stream_whole(void **state) {
    uint64_t random = 5;
    (void)state;
    for (size_t count = 0; count < 200; count++) {
        uint8_t sent[200], received[200];
        size_t place = 0, got = 0;
        for (size_t i = 0; i < count; i++) {
            sent[i] = (uint8_t)next_random(&random);
        }
        while (place < count) {
            uint8_t report[USB_REPORT_BYTES];
            place += usb_report_pack(report, sent + place, count - place);
            size_t length = usb_report_length(report, sizeof report);
            memcpy(received + got, report + 1, length);
            got += length;
        }
        assert_int_equal(got, count);
        assert_memory_equal(received, sent, count);
    }
}

static void a_report_never_claims_more_than_it_has(void **state) {
    uint8_t report[USB_REPORT_BYTES] = {0};
    (void)state;
    for (unsigned claimed = 0; claimed < 256; claimed++) {
        report[0] = (uint8_t)claimed;
        for (size_t size = 0; size <= sizeof report; size++) {
            size_t length = usb_report_length(report, size);
            assert_int_equal(length, claimed <= 63 && claimed < size ? claimed : 0);
        }
    }
}

static void a_hello_reply_out_of_range_is_refused(void **state) {
    static const struct usb_hello_reply good = {4096, 510, 0x00D0, 8, 7};
    uint8_t bytes[USB_HELLO_REPLY_BYTES];
    struct usb_hello_reply found;
    (void)state;
    usb_hello_reply_pack(bytes, &good);
    assert_true(usb_hello_reply_unpack(bytes, sizeof bytes, &found));
    assert_memory_equal(&found, &good, sizeof good);
    assert_false(usb_hello_reply_unpack(bytes, sizeof bytes - 1, &found));
    static const struct usb_hello_reply bad[] = {{1023, 510, 0xD0, 8, 7}, {4097, 510, 0xD0, 8, 7},
                                                 {4096, 2, 0xD0, 8, 7},   {4096, 511, 0xD0, 8, 7},
                                                 {4096, 510, 0xD0, 0, 7}, {4096, 510, 0xD0, 9, 7}};
    for (unsigned i = 0; i < sizeof bad / sizeof bad[0]; i++) {
        usb_hello_reply_pack(bytes, &bad[i]);
        assert_false(usb_hello_reply_unpack(bytes, sizeof bytes, &found));
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_crc_is_the_one_of_ieee_802_3),
        cmocka_unit_test(a_frame_has_the_bytes_that_the_protocol_says),
        cmocka_unit_test(what_is_packed_comes_out_again),
        cmocka_unit_test(no_frame_with_a_flipped_bit_passes),
        cmocka_unit_test(a_frame_is_found_behind_anything),
        cmocka_unit_test(two_bytes_tell_whether_a_frame_begins),
        cmocka_unit_test(reports_carry_the_stream_whole),
        cmocka_unit_test(a_report_never_claims_more_than_it_has),
        cmocka_unit_test(a_hello_reply_out_of_range_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
