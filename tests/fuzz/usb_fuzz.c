/* SPDX-License-Identifier: MIT */
/* Fuzzes whatever takes bytes from a cable or a socket: the adapter, the USB/IP server, the host's
 * reading of replies. The first byte says which; no access may leave the sixteen ports. */
#include <stdlib.h>
#include <string.h>

#include "adapter/bus.h"
#include "adapter/usbip.h"
#include "fuzz.h"

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
static struct usbip_client client;

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

/* Plays a client that reads nothing until the server stops to listen: the queue keeps its bounds.
 */
static void be_client(const uint8_t *bytes, size_t count) {
    usbip_client_init(&client, &device);
    for (size_t taken = 1; count > 0 && taken > 0;) {
        taken = usbip_client_take(&client, bytes, count);
        bytes += taken;
        count -= taken;
        if (client.answer_count > sizeof client.answers) {
            abort();
        }
        if (client.wants_device) {
            usbip_client_give(&client, true);
            taken = 1;
        }
        if (taken == 0 && client.answer_count > 0) {
            usbip_client_sent(&client, client.answer_count / 2 + 1);
            taken = 1;
        }
    }
    usbip_client_leave(&client);
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

/* An adapter that says what the fuzzer wants it to say: a step is a byte of what to do, one of how
 * many bytes follow, and these. */
struct liar {
    struct usb_link link; /* the first member */
    const uint8_t *bytes;
    size_t count;
    uint32_t session, sequence;    /* of the frame that was sent last */
    const struct usb_bus *usb_bus; /* NULL until it has greeted */
};

static enum usb_link_status liar_send(struct usb_link *link, const uint8_t *bytes, size_t count) {
    struct liar *liar = (struct liar *)link;
    struct usb_header header;
    size_t length;
    if (usb_frame_scan(bytes, count, &header, &length) != USB_SCAN_FRAME || length != count) {
        abort(); /* what the host sends is well-formed, whatever it is told */
    }
    liar->session = header.session;
    liar->sequence = header.sequence;
    return liar->count > 0 && liar->bytes[0] == 0xFF ? USB_LINK_STALLED : USB_LINK_OK;
}

/* A reply whose CRC is right and whose fields are the fuzzer's, near to what would be right. Its
 * payload is the fuzzer's too or, is_data, as long as what the host waits for. */
static size_t make_reply(const struct liar *liar, const uint8_t *data, size_t count, bool is_data,
                         uint8_t *bytes) {
    uint8_t fields[4] = {0, 0, 0, 1}, payload[USB_READ_MOST];
    size_t head = count < sizeof fields ? count : sizeof fields;
    memcpy(fields, data, head);
    size_t length = count - head;
    memcpy(payload, data + head, length);
    if (is_data && liar->usb_bus != NULL) {
        memset(payload + length, fields[1], sizeof payload - length);
        length = liar->usb_bus->awaited_count;
    }
    const struct usb_header reply = {USB_VERSION,
                                     USB_KIND_REPLY,
                                     liar->session + (fields[0] >> 6),
                                     liar->sequence + (fields[0] & 3U) * 0x40000000U,
                                     liar->sequence - (fields[1] & 15U),
                                     (uint16_t)length,
                                     fields[2] % 10,
                                     fields[3]};
    return usb_frame_pack(bytes, &reply, payload);
}

static enum usb_link_status liar_receive(struct usb_link *link, uint8_t *bytes, size_t room,
                                         unsigned timeout_ms, size_t *count) {
    struct liar *liar = (struct liar *)link;
    uint8_t said[USB_REPLY_MOST];
    (void)timeout_ms;
    if (liar->count < 2) {
        return USB_LINK_TIMEOUT;
    }
    unsigned what = liar->bytes[0];
    size_t length = liar->bytes[1] < liar->count - 2 ? liar->bytes[1] : liar->count - 2;
    const uint8_t *data = liar->bytes + 2;
    liar->bytes += 2 + length;
    liar->count -= 2 + length;
    if (what >= 0xFC) {
        return (enum usb_link_status)(what - 0xFC);
    }
    if (what % 2 == 0) {
        memcpy(said, data, length);
    } else {
        length = make_reply(liar, data, length, what % 4 == 3, said);
    }
    *count = length < room ? length : room;
    memcpy(bytes, said, *count);
    return *count > 0 ? USB_LINK_OK : USB_LINK_TIMEOUT;
}

static enum usb_link_status liar_reopen(struct usb_link *link, unsigned timeout_ms) {
    const struct liar *liar = (const struct liar *)link;
    (void)timeout_ms;
    return liar->count > 0 ? USB_LINK_OK : USB_LINK_TIMEOUT;
}

static void be_host(const uint8_t *bytes, size_t count) {
    static const struct usb_link_operations lies = {liar_send, liar_receive, liar_reopen, NULL};
    struct liar liar = {{&lies, 0, ""}, bytes, count, 0, 0, NULL};
    const struct usb_limits limits = {1000, 2, 1, 2, 1, NULL};
    struct usb_verification found;
    struct usb_bus *usb_bus = usb_bus_new(&liar.link, 0x00D0, &limits);
    if (usb_bus == NULL) {
        abort();
    }
    liar.usb_bus = usb_bus;
    for (unsigned y = 0; y < 2; y++) {
        bus_write(&usb_bus->bus, 0x00D6, (uint16_t)y, BUS_WORD);
        for (unsigned x = 0; x < 400; x++) {
            bus_write(&usb_bus->bus, 0x00D4, (uint16_t)x, BUS_WORD);
            for (unsigned i = 0; i < 3; i++) {
                bus_write(&usb_bus->bus, (uint16_t)(0x00D8 + 2 * i), (x * (y + i)) & 0xFF,
                          BUS_BYTE);
            }
        }
    }
    (void)bus_read(&usb_bus->bus, 0x00DA, BUS_BYTE);
    (void)usb_bus_verify(usb_bus, 100, 1, &found);
    if (usb_bus->bus.status == BUS_OK && usb_bus->acked != usb_bus->sealed) {
        abort(); /* it said that all is there */
    }
    usb_bus_free(usb_bus);
}

int LLVMFuzzerTestOneInput(const uint8_t *bytes, size_t count) {
    if (count == 0) {
        return 0;
    }
    plug_in();
    switch (bytes[0] % 6) {
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
        be_client(bytes + 1, count - 1);
        break;
    case 4:
        take_replies(bytes + 1, count - 1);
        break;
    default:
        be_host(bytes + 1, count - 1);
        break;
    }
    return 0;
}
