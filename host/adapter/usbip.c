/* SPDX-License-Identifier: MIT */
/* The USB/IP protocol, as far as a device with control, bulk and interrupt endpoints needs it. */
#include "adapter/usbip.h"

#include <stddef.h>
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
    IMPORT_BYTES = 40,
    DEVICE_BYTES = 312,
    INTERFACE_BYTES = 4,
    COMMAND_SUBMIT = 1,
    COMMAND_UNLINK = 2,
    ANSWER_SUBMIT = 3,
    ANSWER_UNLINK = 4,
    SETUP_PLACE = 40,
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

void usbip_client_end(struct usbip_client *client, const char *reason) {
    if (!client->is_over) {
        client->reason = reason;
    }
    client->is_over = true;
    client->wants_device = false;
}

/* Initialises all but the buffers: memory that a client never uses is never touched. */
void usbip_client_init(struct usbip_client *client, struct usb_device *device) {
    memset(client, 0, offsetof(struct usbip_client, answers));
    client->device = device;
    client->reason = "";
}

/* Tells whether the longest answer still has room. */
static bool has_room(const struct usbip_client *client) {
    return sizeof client->answers - client->answer_count >= USBIP_HEADER_BYTES + USBIP_IN_MOST;
}

static void put_answer(struct usbip_client *client, const void *bytes, size_t count) {
    memcpy(client->answers + client->answer_count, bytes, count);
    client->answer_count += count;
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

static void answer_op(struct usbip_client *client, unsigned code, uint32_t status) {
    uint8_t bytes[OP_BYTES];
    put16(bytes, VERSION);
    put16(bytes + 2, code);
    put32(bytes + 4, status);
    put_answer(client, bytes, sizeof bytes);
}

static void answer_list(struct usbip_client *client) {
    /* Class, subclass, protocol: as the configuration has them. */
    static const uint8_t interfaces[USB_INTERFACES][INTERFACE_BYTES] = {{0xFF, 0, USB_VERSION},
                                                                        {3}};
    uint8_t bytes[4 + DEVICE_BYTES];
    put32(bytes, 1); /* device */
    describe_device(client->device, bytes + 4);
    answer_op(client, REPLY_LIST, 0);
    put_answer(client, bytes, sizeof bytes);
    put_answer(client, interfaces, sizeof interfaces);
    usbip_client_end(client, "it has seen the list");
}

static void take_import(struct usbip_client *client, const uint8_t *bus_id) {
    client->wants_device = memcmp(bus_id, USBIP_BUS_ID, sizeof USBIP_BUS_ID) == 0;
    if (!client->wants_device) {
        answer_op(client, REPLY_IMPORT, STATUS_NOT_AVAILABLE);
        usbip_client_end(client, "it asked for another device");
    }
}

/* Takes one request of this phase. Returns its length, or 0 where more bytes are needed or the
 * visit is over. */
static size_t take_op(struct usbip_client *client, const uint8_t *bytes, size_t count) {
    if (count < OP_BYTES) {
        return 0;
    }
    unsigned version = (unsigned)bytes[0] << 8 | bytes[1];
    unsigned code = (unsigned)bytes[2] << 8 | bytes[3];
    if (version != VERSION) {
        usbip_client_end(client, "it speaks another version of USB/IP; allowed is 1.1.1");
        return 0;
    }
    if (code == REQUEST_LIST) {
        answer_list(client);
        return OP_BYTES;
    }
    if (code != REQUEST_IMPORT) {
        usbip_client_end(client, "it asks for what is neither the list nor a device");
        return 0;
    }
    if (count < IMPORT_BYTES) {
        return 0;
    }
    take_import(client, bytes + OP_BYTES);
    return IMPORT_BYTES;
}

/* ---- Transfers ------------------------------------------------------------------------------- */

static void answer(struct usbip_client *client, uint32_t code, uint32_t number, int32_t status,
                   uint32_t length) {
    uint8_t bytes[USBIP_HEADER_BYTES];
    memset(bytes, 0, sizeof bytes);
    put32(bytes, code);
    put32(bytes + 4, number);
    put32(bytes + 20, (uint32_t)status);
    put32(bytes + 24, length);
    put_answer(client, bytes, sizeof bytes);
}

/* Answers a transfer from the device, for which has_room() holds. Returns false if there is nothing
 * yet. */
static bool answer_in(struct usbip_client *client, uint32_t number, uint8_t endpoint,
                      uint32_t room) {
    uint8_t bytes[USBIP_IN_MOST];
    int count =
        usb_device_in(client->device, endpoint, bytes, room < USBIP_IN_MOST ? room : USBIP_IN_MOST);
    if (count == USB_NOTHING_YET) {
        return false;
    }
    answer(client, ANSWER_SUBMIT, number, count < 0 ? ERROR_PIPE : 0,
           count < 0 ? 0 : (uint32_t)count);
    if (count > 0) {
        put_answer(client, bytes, (size_t)count);
    }
    return true;
}

static void unpark(struct usbip_client *client, unsigned place) {
    client->parked_count--;
    for (unsigned i = place; i < client->parked_count; i++) {
        client->parked[i] = client->parked[i + 1];
    }
}

/* Answers in their order the transfers that the device can answer by now, while there is room. */
static void serve_parked(struct usbip_client *client) {
    for (unsigned i = 0; i < client->parked_count && has_room(client);) {
        const struct usbip_parked parked = client->parked[i];
        if (answer_in(client, parked.number, parked.endpoint, parked.room)) {
            unpark(client, i);
        } else {
            i++;
        }
    }
}

static void submit_control(struct usbip_client *client, uint32_t number, const uint8_t *header,
                           uint32_t length, bool is_in) {
    uint8_t in[USB_CONTROL_MOST], setup[8];
    memcpy(setup, header + SETUP_PLACE, sizeof setup);
    /* The direction and length that setup gives must be those of what follows. */
    bool is_consistent = ((setup[0] & 0x80) != 0) == (is_in || length == 0) ||
                         (length == 0 && usb_get16(setup + 6) == 0);
    uint32_t wanted = usb_get16(setup + 6);
    if (!is_consistent || (!is_in && wanted != length)) {
        answer(client, ANSWER_SUBMIT, number, ERROR_PIPE, 0);
        return;
    }
    int count = usb_device_control(client->device, setup, header + USBIP_HEADER_BYTES, in);
    if (count > 0 && (uint32_t)count > length) {
        count = (int)length;
    }
    answer(client, ANSWER_SUBMIT, number, count < 0 ? ERROR_PIPE : 0,
           count < 0 ? 0 : (is_in ? (uint32_t)count : length));
    if (count > 0 && is_in) {
        put_answer(client, in, (size_t)count);
    }
}

static void submit(struct usbip_client *client, const uint8_t *header, uint32_t length) {
    uint32_t number = get32(header + 4), endpoint = get32(header + 16);
    bool is_in = get32(header + 12) == DIRECTION_IN;
    if (endpoint == 0) {
        submit_control(client, number, header, length, is_in);
    } else if (is_in) {
        const struct usbip_parked parked = {number, length, (uint8_t)(0x80 | endpoint)};
        if (client->parked_count == USBIP_PARKED_MOST) {
            usbip_client_end(client, "too many of its transfers wait");
            return;
        }
        client->parked[client->parked_count++] = parked;
    } else {
        bool is_taken =
            usb_device_out(client->device, (uint8_t)endpoint, header + USBIP_HEADER_BYTES, length);
        answer(client, ANSWER_SUBMIT, number, is_taken ? 0 : ERROR_PIPE, is_taken ? length : 0);
    }
    serve_parked(client);
}

static void unlink_transfer(struct usbip_client *client, const uint8_t *header) {
    uint32_t number = get32(header + 20);
    int32_t status = 0; /* it was answered already */
    for (unsigned i = 0; i < client->parked_count; i++) {
        if (client->parked[i].number == number) {
            unpark(client, i);
            status = ERROR_RESET;
            break;
        }
    }
    answer(client, ANSWER_UNLINK, get32(header + 4), status, 0);
}

/* Takes one command of this phase. Returns its length, or 0 where more bytes are needed or the
 * visit is over. */
static size_t take_command(struct usbip_client *client, const uint8_t *bytes, size_t count) {
    if (count < USBIP_HEADER_BYTES) {
        return 0;
    }
    uint32_t code = get32(bytes);
    if (code == COMMAND_UNLINK) {
        unlink_transfer(client, bytes);
        return USBIP_HEADER_BYTES;
    }
    uint32_t direction = get32(bytes + 12), length = get32(bytes + 24);
    uint32_t packets = get32(bytes + 32);
    if (code != COMMAND_SUBMIT || direction > DIRECTION_IN || get32(bytes + 16) > ENDPOINT_MOST) {
        usbip_client_end(client, "a command that USB/IP does not have");
        return 0;
    }
    if (packets != 0 && packets != UINT32_MAX) {
        usbip_client_end(client, "an isochronous transfer, and the device has no such endpoint");
        return 0;
    }
    size_t data = direction == DIRECTION_IN ? 0 : length;
    if (data > USBIP_TRANSFER_MOST) {
        usbip_client_end(client, "a transfer of more than 65536 bytes");
        return 0;
    }
    if (count < USBIP_HEADER_BYTES + data) {
        return 0;
    }
    submit(client, bytes, length);
    return USBIP_HEADER_BYTES + data;
}

/* Works off the whole requests or commands that are there, while there is room for answers; the
 * rest stays. */
static void work_off(struct usbip_client *client) {
    size_t begin = 0;
    while (!client->is_over && !client->wants_device && has_room(client)) {
        const uint8_t *bytes = client->input + begin;
        size_t count = client->input_count - begin;
        size_t taken = client->is_attached ? take_command(client, bytes, count)
                                           : take_op(client, bytes, count);
        if (taken == 0) {
            break;
        }
        begin += taken;
    }
    client->input_count -= begin;
    memmove(client->input, client->input + begin, client->input_count);
}

size_t usbip_client_room(const struct usbip_client *client) {
    if (client->is_over || client->wants_device || !has_room(client)) {
        return 0;
    }
    return (client->is_attached ? sizeof client->input : IMPORT_BYTES) - client->input_count;
}

size_t usbip_client_take(struct usbip_client *client, const uint8_t *bytes, size_t count) {
    size_t done = 0, room = 0;
    while (done < count && (room = usbip_client_room(client)) > 0) {
        size_t taken = count - done < room ? count - done : room;
        memcpy(client->input + client->input_count, bytes + done, taken);
        client->input_count += taken;
        done += taken;
        work_off(client);
    }
    return done;
}

void usbip_client_give(struct usbip_client *client, bool is_given) {
    uint8_t bytes[DEVICE_BYTES];
    client->wants_device = false;
    client->is_attached = is_given;
    answer_op(client, REPLY_IMPORT, is_given ? 0 : STATUS_BUSY);
    if (!is_given) {
        usbip_client_end(client, "another client has the device");
        return;
    }
    describe_device(client->device, bytes);
    put_answer(client, bytes, sizeof bytes);
    usb_device_reset(client->device);
}

void usbip_client_sent(struct usbip_client *client, size_t count) {
    client->answer_count -= count;
    memmove(client->answers, client->answers + count, client->answer_count);
    if (client->is_attached) {
        serve_parked(client);
        work_off(client);
    }
}

void usbip_client_leave(struct usbip_client *client) {
    if (client->is_attached) {
        usb_device_reset(client->device);
    }
    client->is_attached = false;
}
