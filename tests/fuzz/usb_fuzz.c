/* SPDX-License-Identifier: MIT */
/* Fuzzes whatever takes bytes from a cable or a socket: the adapter, the USB/IP server, the host's
 * reading of replies. The first byte says which; no access may leave the sixteen ports. */
#include <stdlib.h>
#include <string.h>

#include "usbip.h"

static void hold_to_board(uint16_t port, unsigned width) {
    if (port < 0x00D0 || port + width > 0x00E0) {
        abort();
    }
}

static void write_port(struct bus *bus, uint16_t port, uint16_t value, unsigned width) {
    (void)bus;
    (void)value;
    hold_to_board(port, width);
}

static uint16_t read_port(struct bus *bus, uint16_t port, unsigned width) {
    (void)bus;
    hold_to_board(port, width);
    return width == BUS_BYTE ? 0x5A : 0xA55A;
}

static const struct bus_operations operations = {write_port, read_port, NULL};
static struct bus board = {&operations, BUS_OK};
static struct usb_device device;
static struct usbip_guest guest;

static void plug_in(void) {
    static const uint8_t set_configuration[8] = {0, 9, 1};
    uint8_t in[USB_CONTROL_MOST];
    usb_device_init(&device, &board, 0x00D0, "FUZZ", true);
    (void)usb_device_control(&device, set_configuration, NULL, in);
}

/* The fuzzer can't guess CRCs: what it gives is the frame's fields and its ops. */
static void take_framed(const uint8_t *bytes, size_t count) {
    static uint8_t frame[USB_FRAME_MOST];
    static const uint8_t base[2] = {0xD0, 0x00};
    const struct usb_header hello = {USB_VERSION, USB_KIND_HELLO, 1, 0, 0, 2, USB_HELLO_START, 0};
    uint8_t out[64];
    uint32_t sequence = 0;
    (void)usb_device_out(&device, USB_BULK_OUT, frame, usb_frame_pack(frame, &hello, base));
    while (count >= 2) {
        size_t length = bytes[0] | (bytes[1] & 0x0FU) << 8;
        length = length < count - 2 ? length : count - 2;
        const struct usb_header run = {USB_VERSION, USB_KIND_RUN,     1, ++sequence,
                                       0,           (uint16_t)length, 0, 0};
        (void)usb_device_out(&device, USB_BULK_OUT, frame, usb_frame_pack(frame, &run, bytes + 2));
        sequence = device.adapter.last;
        while (usb_device_in(&device, USB_BULK_IN, out, sizeof out) > 0) {
        }
        bytes += 2 + length;
        count -= 2 + length;
    }
}

/* Raw packets, each behind its length. */
static void take_packets(uint8_t endpoint, const uint8_t *bytes, size_t count) {
    uint8_t out[64];
    while (count >= 1) {
        size_t length = bytes[0] < count - 1 ? bytes[0] : count - 1;
        uint8_t *exact = malloc(length + 1);
        if (exact == NULL) {
            return;
        }
        memcpy(exact, bytes + 1, length);
        (void)usb_device_out(&device, endpoint, exact, length);
        (void)usb_device_in(&device, endpoint | 0x80, out, sizeof out);
        device.halted = 0;
        free(exact);
        bytes += 1 + length;
        count -= 1 + length;
    }
}

static void drop(void *context, const uint8_t *bytes, size_t count) {
    (void)context;
    (void)bytes;
    (void)count;
}

static void take_replies(const uint8_t *bytes, size_t count) {
    while (count > 0) {
        struct usb_header header;
        struct usb_hello_reply hello;
        size_t length = 0;
        enum usb_scan scan = usb_frame_scan(bytes, count, &header, &length);
        if (scan == USB_SCAN_MORE) {
            return;
        }
        if (scan == USB_SCAN_FRAME) {
            (void)usb_hello_reply_unpack(bytes + USB_HEADER_BYTES, header.length, &hello);
        }
        if (length == 0 || length > count) {
            abort();
        }
        bytes += length;
        count -= length;
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t count);

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t count) {
    if (count == 0) {
        return 0;
    }
    plug_in();
    switch (bytes[0] % 5) {
    case 0:
        take_framed(bytes + 1, count - 1);
        break;
    case 1:
        take_packets(USB_BULK_OUT, bytes + 1, count - 1);
        break;
    case 2:
        take_packets(USB_HID_OUT, bytes + 1, count - 1);
        break;
    case 3:
        usbip_guest_init(&guest, &device, false, drop, NULL);
        usbip_guest_take(&guest, bytes + 1, count - 1);
        usbip_guest_leave(&guest);
        break;
    default:
        take_replies(bytes + 1, count - 1);
        break;
    }
    return 0;
}
