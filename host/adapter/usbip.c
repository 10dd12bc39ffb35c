/* SPDX-License-Identifier: MIT */
/* The USB/IP protocol, as far as a device with control, bulk and interrupt endpoints needs it. */
#include "adapter/usbip.h"

#include <string.h>

enum {
    VERSION = 0x0111,
    REQUEST_LIST = 0x8005,
    REPLY_LIST = 0x0005,
    REQUEST_IMPORT = 0x8003,
    REPLY_IMPORT = 0x0003,
    STATUS_NOT_AVAILABLE = 1,
    STATUS_BUSY = 2,
    OP_BYTES = 8,
    BUS_ID_BYTES = 32,
    DEVICE_BYTES = 312,
    INTERFACE_BYTES = 4,
    COMMAND_SUBMIT = 1,
    COMMAND_UNLINK = 2,
    ANSWER_SUBMIT = 3,
    ANSWER_UNLINK = 4,
    HEADER_BYTES = 48,
    SETUP_PLACE = 40,
    IN_MOST = 16384, /* bytes of one answer from the device */
    ERROR_PIPE = -32,
    ERROR_RESET = -104,
    SPEED_FULL = 2,
    SPEED_HIGH = 3,
    DIRECTION_IN = 1,
    ENDPOINT_MOST = 15
};

static uint32_t get32(const uint8_t *bytes) {
    return (uint32_t)bytes[0] << 24 | (uint32_t)bytes[1] << 16 | (uint32_t)bytes[2] << 8 | bytes[3];
}

static void put32(uint8_t *bytes, uint32_t value) {
    bytes[0] = (uint8_t)(value >> 24);
    bytes[1] = (uint8_t)(value >> 16);
    bytes[2] = (uint8_t)(value >> 8);
    bytes[3] = (uint8_t)value;
}

static void put16(uint8_t *bytes, unsigned value) {
    bytes[0] = (uint8_t)(value >> 8);
    bytes[1] = (uint8_t)value;
}

static void end(struct usbip_guest *guest, const char *reason) {
    if (!guest->is_over) {
        guest->reason = reason;
    }
    guest->is_over = true;
}

void usbip_guest_init(struct usbip_guest *guest, struct usb_device *device, bool is_busy,
                      void (*send)(void *context, const uint8_t *bytes, size_t count),
                      void *context) {
    memset(guest, 0, sizeof *guest);
    guest->device = device;
    guest->is_busy = is_busy;
    guest->send = send;
    guest->context = context;
    guest->reason = "";
}

/* ---- Before the device is attached ----------------------------------------------------------- */

static void describe_device(const struct usb_device *device, uint8_t bytes[DEVICE_BYTES]) {
    memset(bytes, 0, DEVICE_BYTES);
    (void)strcpy((char *)bytes, "/sys/devices/superframe/" USBIP_BUS_ID);
    (void)strcpy((char *)bytes + 256, USBIP_BUS_ID);
    put32(bytes + 288, 1); /* bus */
    put32(bytes + 292, 1); /* device */
    put32(bytes + 296, device->is_high_speed ? SPEED_HIGH : SPEED_FULL);
    put16(bytes + 300, USB_VENDOR_ID);
    put16(bytes + 302, USB_PRODUCT_ID);
    put16(bytes + 304, 0x0100);
    bytes[309] = device->configuration;
    bytes[310] = 1; /* configurations */
    bytes[311] = USB_INTERFACES;
}

static void send_op(const struct usbip_guest *guest, unsigned code, uint32_t status) {
    uint8_t bytes[OP_BYTES];
    put16(bytes, VERSION);
    put16(bytes + 2, code);
    put32(bytes + 4, status);
    guest->send(guest->context, bytes, sizeof bytes);
}

static void answer_list(struct usbip_guest *guest) {
    /* Class, subclass, protocol: as the configuration has them. */
    static const uint8_t interfaces[USB_INTERFACES][INTERFACE_BYTES] = {{0xFF, 0, USB_VERSION},
                                                                        {3}};
    uint8_t bytes[4 + DEVICE_BYTES];
    put32(bytes, 1); /* device */
    describe_device(guest->device, bytes + 4);
    send_op(guest, REPLY_LIST, 0);
    guest->send(guest->context, bytes, sizeof bytes);
    guest->send(guest->context, interfaces[0], sizeof interfaces);
    end(guest, "it has seen the list");
}

static void answer_import(struct usbip_guest *guest, const uint8_t *bus_id) {
    uint8_t bytes[DEVICE_BYTES];
    bool is_ours = memcmp(bus_id, USBIP_BUS_ID, sizeof USBIP_BUS_ID) == 0;
    if (!is_ours || guest->is_busy) {
        send_op(guest, REPLY_IMPORT, is_ours ? STATUS_BUSY : STATUS_NOT_AVAILABLE);
        end(guest, is_ours ? "another guest has the device" : "it asked for another device");
        return;
    }
    describe_device(guest->device, bytes);
    send_op(guest, REPLY_IMPORT, 0);
    guest->send(guest->context, bytes, sizeof bytes);
    guest->is_attached = true;
    usb_device_reset(guest->device);
}

/* Takes one request of this phase. Returns its length, or 0 where more bytes are needed or the
 * visit is over. */
static size_t take_op(struct usbip_guest *guest, const uint8_t *bytes, size_t count) {
    if (count < OP_BYTES) {
        return 0;
    }
    unsigned version = (unsigned)bytes[0] << 8 | bytes[1];
    unsigned code = (unsigned)bytes[2] << 8 | bytes[3];
    if (version != VERSION) {
        end(guest, "it speaks another version of USB/IP; allowed is 1.1.1");
        return 0;
    }
    if (code == REQUEST_LIST) {
        answer_list(guest);
        return OP_BYTES;
    }
    if (code != REQUEST_IMPORT) {
        end(guest, "it asks for what is neither the list nor a device");
        return 0;
    }
    if (count < OP_BYTES + BUS_ID_BYTES) {
        return 0;
    }
    answer_import(guest, bytes + OP_BYTES);
    return OP_BYTES + BUS_ID_BYTES;
}

/* ---- Transfers ------------------------------------------------------------------------------- */

static void answer(const struct usbip_guest *guest, uint32_t code, uint32_t number, int32_t status,
                   uint32_t length) {
    uint8_t bytes[HEADER_BYTES];
    memset(bytes, 0, sizeof bytes);
    put32(bytes, code);
    put32(bytes + 4, number);
    put32(bytes + 20, (uint32_t)status);
    put32(bytes + 24, length);
    guest->send(guest->context, bytes, sizeof bytes);
}

/* Answers a transfer from the device. Returns false if there is nothing yet. */
static bool answer_in(struct usbip_guest *guest, uint32_t number, uint8_t endpoint, uint32_t room) {
    uint8_t bytes[IN_MOST];
    int count = usb_device_in(guest->device, endpoint, bytes, room < IN_MOST ? room : IN_MOST);
    if (count == USB_NOTHING_YET) {
        return false;
    }
    answer(guest, ANSWER_SUBMIT, number, count < 0 ? ERROR_PIPE : 0,
           count < 0 ? 0 : (uint32_t)count);
    if (count > 0) {
        guest->send(guest->context, bytes, (size_t)count);
    }
    return true;
}

static void unpark(struct usbip_guest *guest, unsigned place) {
    guest->parked_count--;
    for (unsigned i = place; i < guest->parked_count; i++) {
        guest->parked[i] = guest->parked[i + 1];
    }
}

/* Answers in their order the transfers that the device can answer by now. */
static void serve_parked(struct usbip_guest *guest) {
    for (unsigned i = 0; i < guest->parked_count;) {
        const struct usbip_parked parked = guest->parked[i];
        if (answer_in(guest, parked.number, parked.endpoint, parked.room)) {
            unpark(guest, i);
        } else {
            i++;
        }
    }
}

static void submit_control(struct usbip_guest *guest, uint32_t number, const uint8_t *header,
                           uint32_t length, bool is_in) {
    uint8_t in[USB_CONTROL_MOST], setup[8];
    memcpy(setup, header + SETUP_PLACE, sizeof setup);
    /* The direction and length that setup gives must be those of what follows. */
    bool is_consistent = ((setup[0] & 0x80) != 0) == (is_in || length == 0) ||
                         (length == 0 && usb_get16(setup + 6) == 0);
    uint32_t wanted = usb_get16(setup + 6);
    if (!is_consistent || (!is_in && wanted != length)) {
        answer(guest, ANSWER_SUBMIT, number, ERROR_PIPE, 0);
        return;
    }
    int count = usb_device_control(guest->device, setup, header + HEADER_BYTES, in);
    if (count > 0 && (uint32_t)count > length) {
        count = (int)length;
    }
    answer(guest, ANSWER_SUBMIT, number, count < 0 ? ERROR_PIPE : 0,
           count < 0 ? 0 : (is_in ? (uint32_t)count : length));
    if (count > 0 && is_in) {
        guest->send(guest->context, in, (size_t)count);
    }
}

static void submit(struct usbip_guest *guest, const uint8_t *header, uint32_t length) {
    uint32_t number = get32(header + 4), endpoint = get32(header + 16);
    bool is_in = get32(header + 12) == DIRECTION_IN;
    if (endpoint == 0) {
        submit_control(guest, number, header, length, is_in);
    } else if (is_in) {
        const struct usbip_parked parked = {number, length, (uint8_t)(0x80 | endpoint)};
        if (guest->parked_count == USBIP_PARKED_MOST) {
            end(guest, "too many of its transfers wait");
            return;
        }
        guest->parked[guest->parked_count++] = parked;
    } else {
        bool is_taken =
            usb_device_out(guest->device, (uint8_t)endpoint, header + HEADER_BYTES, length);
        answer(guest, ANSWER_SUBMIT, number, is_taken ? 0 : ERROR_PIPE, is_taken ? length : 0);
    }
    serve_parked(guest);
}

static void unlink_transfer(struct usbip_guest *guest, const uint8_t *header) {
    uint32_t number = get32(header + 20);
    int32_t status = 0; /* it was answered already */
    for (unsigned i = 0; i < guest->parked_count; i++) {
        if (guest->parked[i].number == number) {
            unpark(guest, i);
            status = ERROR_RESET;
            break;
        }
    }
    answer(guest, ANSWER_UNLINK, get32(header + 4), status, 0);
}

/* Takes one command of this phase. Returns its length, or 0 where more bytes are needed or the
 * visit is over. */
static size_t take_command(struct usbip_guest *guest, const uint8_t *bytes, size_t count) {
    if (count < HEADER_BYTES) {
        return 0;
    }
    uint32_t code = get32(bytes);
    if (code == COMMAND_UNLINK) {
        unlink_transfer(guest, bytes);
        return HEADER_BYTES;
    }
    uint32_t direction = get32(bytes + 12), length = get32(bytes + 24);
    uint32_t packets = get32(bytes + 32);
    if (code != COMMAND_SUBMIT || direction > DIRECTION_IN || get32(bytes + 16) > ENDPOINT_MOST) {
        end(guest, "a command that USB/IP does not have");
        return 0;
    }
    if (packets != 0 && packets != UINT32_MAX) {
        end(guest, "an isochronous transfer, and the device has no such endpoint");
        return 0;
    }
    size_t data = direction == DIRECTION_IN ? 0 : length;
    if (data > USBIP_TRANSFER_MOST) {
        end(guest, "a transfer of more than 65536 bytes");
        return 0;
    }
    if (count < HEADER_BYTES + data) {
        return 0;
    }
    submit(guest, bytes, length);
    return HEADER_BYTES + data;
}

/* Works off the whole requests or commands that are there; the rest stays. */
static void work_off(struct usbip_guest *guest) {
    size_t begin = 0;
    while (!guest->is_over) {
        const uint8_t *bytes = guest->input + begin;
        size_t count = guest->input_count - begin;
        size_t taken =
            guest->is_attached ? take_command(guest, bytes, count) : take_op(guest, bytes, count);
        if (taken == 0) {
            break;
        }
        begin += taken;
    }
    guest->input_count -= begin;
    memmove(guest->input, guest->input + begin, guest->input_count);
}

void usbip_guest_take(struct usbip_guest *guest, const uint8_t *bytes, size_t count) {
    while (count > 0 && !guest->is_over) {
        size_t room = sizeof guest->input - guest->input_count;
        size_t taken = count < room ? count : room;
        memcpy(guest->input + guest->input_count, bytes, taken);
        guest->input_count += taken;
        bytes += taken;
        count -= taken;
        work_off(guest);
    }
}

void usbip_guest_leave(struct usbip_guest *guest) {
    if (guest->is_attached) {
        usb_device_reset(guest->device);
    }
    guest->is_attached = false;
}
