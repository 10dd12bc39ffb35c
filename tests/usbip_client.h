/* SPDX-License-Identifier: MIT */
/* The other end of USB/IP, as a kernel would be: attaches, configures, and carries a link's bytes
 * in bulk transfers or HID reports over a socket. */
#ifndef SUPERFRAME_TESTS_USBIP_CLIENT_H
#define SUPERFRAME_TESTS_USBIP_CLIENT_H

#include <poll.h>
#include <setjmp.h>
#include <stdarg.h>
#include <string.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cmocka.h>

#include "adapter/link.h"
#include "usb_device.h"

enum { CLIENT_IN_BYTES = 4096, CLIENT_HEADER = 48 };

struct usbip_client {
    struct usb_link link; /* the first member */
    int socket;
    bool is_hid;
    uint32_t number;      /* of the last transfer */
    uint32_t in_number;   /* of the transfer from the device that waits; 0: none */
    uint32_t pending_out; /* transfers to the device that are not answered yet */
    size_t count;         /* bytes for receive() */
    uint8_t bytes[65536];
};

static inline void client_put32(uint8_t *bytes, uint32_t value) {
    for (unsigned i = 0; i < 4; i++) {
        bytes[i] = (uint8_t)(value >> (24 - 8 * i));
    }
}

static inline uint32_t client_get32(const uint8_t *bytes) {
    return (uint32_t)bytes[0] << 24 | (uint32_t)bytes[1] << 16 | (uint32_t)bytes[2] << 8 | bytes[3];
}

static inline bool client_write(int socket, const void *bytes, size_t count) {
    return send(socket, bytes, count, MSG_NOSIGNAL) == (ssize_t)count;
}

static inline bool client_read(int socket, uint8_t *bytes, size_t count) {
    for (size_t got = 0; got < count;) {
        struct pollfd watched = {socket, POLLIN, 0};
        ssize_t more =
            poll(&watched, 1, 10000) == 1 ? recv(socket, bytes + got, count - got, 0) : -1;
        if (more <= 0) {
            return false;
        }
        got += (size_t)more;
    }
    return true;
}

/* Sends one command; setup may be NULL. Returns its number, 0: the connection is lost. */
static inline uint32_t client_submit(struct usbip_client *client, unsigned endpoint, bool is_in,
                                     const uint8_t *setup, const uint8_t *data, uint32_t length) {
    uint8_t header[CLIENT_HEADER] = {0};
    client_put32(header, 1);
    client_put32(header + 4, ++client->number);
    client_put32(header + 8, 1 << 16 | 1);
    client_put32(header + 12, is_in);
    client_put32(header + 16, endpoint);
    client_put32(header + 24, length);
    if (setup != NULL) {
        memcpy(header + 40, setup, 8);
    }
    bool is_sent = client_write(client->socket, header, sizeof header) &&
                   (is_in || length == 0 || client_write(client->socket, data, length));
    return is_sent ? client->number : 0;
}

/* One control transfer; returns the answer's length, or -1 for a stall. */
static inline int client_control(struct usbip_client *client, const uint8_t setup[8],
                                 uint8_t *answer) {
    uint8_t header[CLIENT_HEADER];
    bool is_in = (setup[0] & 0x80) != 0;
    uint32_t length = usb_get16(setup + 6);
    uint32_t number = client_submit(client, 0, is_in, setup, answer, length);
    assert_true(number != 0 && client_read(client->socket, header, sizeof header));
    assert_int_equal(client_get32(header), 3);
    assert_int_equal(client_get32(header + 4), number);
    uint32_t count = client_get32(header + 24);
    assert_true(count <= length);
    if (is_in && count > 0) {
        assert_true(client_read(client->socket, answer, count));
    }
    return client_get32(header + 20) == 0 ? (int)count : -1;
}

/* Attaches over a connected socket and sets the configuration. */
static inline void client_attach(struct usbip_client *client) {
    static const uint8_t set_configuration[8] = {0, 9, 1, 0, 0, 0, 0, 0};
    uint8_t request[40] = {0x01, 0x11, 0x80, 0x03}, reply[320];
    memcpy(request + 8, "1-1", 3);
    assert_true(client_write(client->socket, request, sizeof request));
    assert_true(client_read(client->socket, reply, 8));
    assert_int_equal(client_get32(reply), 0x01110003);
    assert_int_equal(client_get32(reply + 4), 0);
    assert_true(client_read(client->socket, reply, 312));
    assert_int_equal(client_control(client, set_configuration, NULL), 0);
}

/* Takes one answer of the server. False: nothing came in time. */
static inline bool client_take(struct usbip_client *client, int timeout_ms, bool *is_lost) {
    uint8_t header[CLIENT_HEADER], data[CLIENT_IN_BYTES];
    struct pollfd watched = {client->socket, POLLIN, 0};
    if (poll(&watched, 1, timeout_ms) != 1) {
        return false;
    }
    if (!client_read(client->socket, header, sizeof header)) {
        *is_lost = true;
        return false;
    }
    if (client_get32(header + 4) != client->in_number) {
        client->pending_out--;
        return true;
    }
    uint32_t count = client_get32(header + 24);
    client->in_number = 0;
    if (count > CLIENT_IN_BYTES || !client_read(client->socket, data, count)) {
        *is_lost = true;
        return false;
    }
    const uint8_t *stream = client->is_hid ? data + 1 : data;
    size_t length = client->is_hid ? usb_report_length(data, count) : count;
    assert_true(client->count + length <= sizeof client->bytes);
    memcpy(client->bytes + client->count, stream, length);
    client->count += length;
    return true;
}

static inline enum usb_link_status client_send(struct usb_link *link, const uint8_t *bytes,
                                               size_t count) {
    struct usbip_client *client = (struct usbip_client *)link;
    for (size_t place = 0; place < count;) {
        uint8_t report[USB_REPORT_BYTES];
        uint32_t number;
        if (client->is_hid) {
            place += usb_report_pack(report, bytes + place, count - place);
            number = client_submit(client, USB_HID_OUT, false, NULL, report, sizeof report);
        } else {
            number = client_submit(client, USB_BULK_OUT, false, NULL, bytes, (uint32_t)count);
            place = count;
        }
        if (number == 0) {
            return USB_LINK_LOST;
        }
        client->pending_out++;
    }
    return USB_LINK_OK;
}

static inline enum usb_link_status client_receive(struct usb_link *link, uint8_t *bytes,
                                                  size_t room, unsigned timeout_ms, size_t *count) {
    struct usbip_client *client = (struct usbip_client *)link;
    bool is_lost = false;
    while (client->count == 0) {
        if (client->in_number == 0) {
            client->in_number = client_submit(client, client->is_hid ? 2 : 1, true, NULL, NULL,
                                              client->is_hid ? USB_REPORT_BYTES : CLIENT_IN_BYTES);
        }
        if (!client_take(client, (int)timeout_ms, &is_lost)) {
            return is_lost ? USB_LINK_LOST : USB_LINK_TIMEOUT;
        }
    }
    *count = client->count < room ? client->count : room;
    memcpy(bytes, client->bytes, *count);
    client->count -= *count;
    memmove(client->bytes, client->bytes + *count, client->count);
    return USB_LINK_OK;
}

static inline enum usb_link_status client_reopen(struct usb_link *link, unsigned timeout_ms) {
    (void)link;
    (void)timeout_ms;
    return USB_LINK_TIMEOUT;
}

static inline void client_close(struct usb_link *link) {
    (void)link;
}

static inline void client_init(struct usbip_client *client, int socket, bool is_hid) {
    static const struct usb_link_operations client_operations = {client_send, client_receive,
                                                                 client_reopen, client_close};
    memset(client, 0, sizeof *client);
    client->link.operations = &client_operations;
    client->socket = socket;
    client->is_hid = is_hid;
}

#endif
