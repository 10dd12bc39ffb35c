/* SPDX-License-Identifier: MIT */
/* Packing and unpacking of frames, replies and reports. */
#include "usb_wire.h"

enum { MAGIC_0 = 'S', MAGIC_1 = 'F', HEADER_CHECKED = 20 };

uint32_t usb_crc(uint32_t crc, const uint8_t *bytes, size_t count) {
    /* The reflected polynomial EDB88320h by half bytes: sixteen words suit a small adapter. */
    static const uint32_t table[16] = {0x00000000U, 0x1DB71064U, 0x3B6E20C8U, 0x26D930ACU,
                                       0x76DC4190U, 0x6B6B51F4U, 0x4DB26158U, 0x5005713CU,
                                       0xEDB88320U, 0xF00F9344U, 0xD6D6A3E8U, 0xCB61B38CU,
                                       0x9B64C2B0U, 0x86D3D2D4U, 0xA00AE278U, 0xBDBDF21CU};
    crc = ~crc;
    for (size_t i = 0; i < count; i++) {
        crc ^= bytes[i];
        crc = crc >> 4 ^ table[crc & 15];
        crc = crc >> 4 ^ table[crc & 15];
    }
    return ~crc;
}

uint16_t usb_get16(const uint8_t *bytes) {
    return (uint16_t)(bytes[0] | (unsigned)bytes[1] << 8);
}

uint32_t usb_get32(const uint8_t *bytes) {
    return usb_get16(bytes) | (uint32_t)usb_get16(bytes + 2) << 16;
}

void usb_put16(uint8_t *bytes, uint16_t value) {
    bytes[0] = (uint8_t)value;
    bytes[1] = (uint8_t)(value >> 8);
}

void usb_put32(uint8_t *bytes, uint32_t value) {
    usb_put16(bytes, (uint16_t)value);
    usb_put16(bytes + 2, (uint16_t)(value >> 16));
}

size_t usb_frame_pack(uint8_t *frame, const struct usb_header *header, const uint8_t *payload) {
    size_t end = USB_HEADER_BYTES + (size_t)header->length;
    frame[0] = MAGIC_0;
    frame[1] = MAGIC_1;
    frame[2] = header->version;
    frame[3] = header->kind;
    usb_put32(frame + 4, header->session);
    usb_put32(frame + 8, header->sequence);
    usb_put32(frame + 12, header->last);
    usb_put16(frame + 16, header->length);
    frame[18] = header->status;
    frame[19] = header->credits;
    usb_put16(frame + HEADER_CHECKED, (uint16_t)usb_crc(0, frame, HEADER_CHECKED));
    if (payload != frame + USB_HEADER_BYTES) {
        for (size_t i = 0; i < header->length; i++) {
            frame[USB_HEADER_BYTES + i] = payload[i];
        }
    }
    usb_put32(frame + end, usb_crc(0, frame, end));
    return end + USB_CHECK_BYTES;
}

/* Counts the bytes before the next place, from 1 on, where a frame may begin. */
static size_t skip_to_magic(const uint8_t *bytes, size_t count) {
    size_t place = 1;
    while (place < count &&
           !(bytes[place] == MAGIC_0 && (place + 1 == count || bytes[place + 1] == MAGIC_1))) {
        place++;
    }
    return place;
}

enum usb_scan usb_frame_scan(const uint8_t *bytes, size_t count, struct usb_header *header,
                             size_t *length) {
    if (count == 0) {
        return USB_SCAN_MORE;
    }
    if (bytes[0] != MAGIC_0 || (count > 1 && bytes[1] != MAGIC_1)) {
        *length = skip_to_magic(bytes, count);
        return USB_SCAN_NOISE;
    }
    if (count < USB_HEADER_BYTES) {
        return USB_SCAN_MORE;
    }
    uint16_t payload = usb_get16(bytes + 16);
    if (usb_get16(bytes + HEADER_CHECKED) != (uint16_t)usb_crc(0, bytes, HEADER_CHECKED) ||
        payload > USB_PAYLOAD_MOST) {
        *length = skip_to_magic(bytes, count);
        return USB_SCAN_NOISE;
    }
    size_t end = USB_HEADER_BYTES + (size_t)payload;
    if (count < end + USB_CHECK_BYTES) {
        return USB_SCAN_MORE;
    }
    header->version = bytes[2];
    header->kind = bytes[3];
    header->session = usb_get32(bytes + 4);
    header->sequence = usb_get32(bytes + 8);
    header->last = usb_get32(bytes + 12);
    header->length = payload;
    header->status = bytes[18];
    header->credits = bytes[19];
    if (usb_get32(bytes + end) != usb_crc(0, bytes, end)) {
        *length = skip_to_magic(bytes, count);
        return USB_SCAN_DAMAGED;
    }
    *length = end + USB_CHECK_BYTES;
    return USB_SCAN_FRAME;
}

void usb_hello_reply_pack(uint8_t bytes[USB_HELLO_REPLY_BYTES],
                          const struct usb_hello_reply *hello) {
    usb_put16(bytes, hello->payload_most);
    usb_put16(bytes + 2, hello->read_most);
    usb_put16(bytes + 4, hello->base);
    bytes[6] = hello->credits;
    bytes[7] = hello->capabilities;
}

bool usb_hello_reply_unpack(const uint8_t *bytes, size_t count, struct usb_hello_reply *hello) {
    if (count < USB_HELLO_REPLY_BYTES) {
        return false;
    }
    hello->payload_most = usb_get16(bytes);
    hello->read_most = usb_get16(bytes + 2);
    hello->base = usb_get16(bytes + 4);
    hello->credits = bytes[6];
    hello->capabilities = bytes[7];
    return hello->payload_most >= USB_PAYLOAD_LEAST && hello->payload_most <= USB_PAYLOAD_MOST &&
           hello->read_most >= 3 && hello->read_most <= USB_READ_MOST && hello->credits >= 1 &&
           hello->credits <= USB_CREDITS_MOST;
}

size_t usb_report_pack(uint8_t report[USB_REPORT_BYTES], const uint8_t *bytes, size_t count) {
    size_t taken = count < USB_REPORT_STREAM_BYTES ? count : USB_REPORT_STREAM_BYTES;
    report[0] = (uint8_t)taken;
    for (size_t i = 0; i < USB_REPORT_STREAM_BYTES; i++) {
        report[1 + i] = i < taken ? bytes[i] : 0;
    }
    return taken;
}

size_t usb_report_length(const uint8_t *report, size_t size) {
    return size > 0 && report[0] <= USB_REPORT_STREAM_BYTES && report[0] < size ? report[0] : 0;
}

const char *usb_status_text(uint8_t status) {
    static const char *const texts[USB_STATUSES] = {
        [USB_STATUS_OK] = "run",
        [USB_STATUS_DUPLICATE] = "run before",
        [USB_STATUS_BAD_CHECK] = "damaged on the way",
        [USB_STATUS_BAD_OP] = "an operation that the adapter does not know",
        [USB_STATUS_GAP] = "a frame before it is missing",
        [USB_STATUS_UNKNOWN_SESSION] = "the adapter does not know the session",
        [USB_STATUS_BAD_VERSION] = "the adapter speaks another version of the protocol",
        [USB_STATUS_BAD_BASE] = "the adapter does not serve that base address",
        [USB_STATUS_BAD_KIND] = "a kind of frame that the adapter does not know"};
    return status < USB_STATUSES ? texts[status] : "a status that the protocol does not have";
}
