/* SPDX-License-Identifier: MIT */
/* One client of a USB/IP server: the bytes that the client sends, taken apart and done on a device.
 *
 * No sockets: bytes go in by usbip_client_take(), and what the client is to be sent waits in
 * `answers`. The protocol is the Linux kernel's, version 1.1.1
 * (Documentation/usb/usbip_protocol.rst). */
#ifndef SUPERFRAME_USBIP_H
#define SUPERFRAME_USBIP_H

#include "usb_device.h"

enum {
    USBIP_PORT = 3240, /* the registered one */
    USBIP_HEADER_BYTES = 48,
    USBIP_TRANSFER_MOST = 65536, /* bytes of one transfer to the device; more ends the visit */
    USBIP_IN_MOST = 16384,       /* bytes of one transfer from the device */
    USBIP_PARKED_MOST = 32,      /* transfers from the device that may wait for data */
    USBIP_ANSWERS_MOST = 2 * (USBIP_HEADER_BYTES + USBIP_IN_MOST) /* bytes that may wait */
};

#define USBIP_BUS_ID "1-1" /* what `usbip attach -b` names the device by */

/* A transfer that waits for the device to have something to say. */
struct usbip_parked {
    uint32_t number;
    uint32_t room; /* bytes */
    uint8_t endpoint;
};

/* A client. About 99 KB, of which a client without the device touches less than one. */
struct usbip_client {
    struct usb_device *device;
    bool wants_device; /* asks for the device: usbip_client_give() answers, and nothing before */
    bool is_attached;  /* has the device */
    bool is_over;      /* close the connection once the answers are sent; reason says why */
    const char *reason;
    unsigned parked_count;
    struct usbip_parked parked[USBIP_PARKED_MOST];
    size_t answer_count, input_count;
    uint8_t answers[USBIP_ANSWERS_MOST];
    uint8_t input[USBIP_HEADER_BYTES + USBIP_TRANSFER_MOST];
};

/* Initialises the connection of a client that has just connected. */
void usbip_client_init(struct usbip_client *client, struct usb_device *device);

/* Returns how many bytes the client may hand in now. 0: none before usbip_client_give() or
 * usbip_client_sent(), or never again where the visit is over. */
size_t usbip_client_room(const struct usbip_client *client);

/* Takes bytes as long as there is room, and does what the bytes ask for. Returns how many it
 * took. */
size_t usbip_client_take(struct usbip_client *client, const uint8_t *bytes, size_t count);

/* Answers the client that wants the device: the client has it now, or another client has it. */
void usbip_client_give(struct usbip_client *client, bool is_given);

/* Removes the first `count` bytes of the answers, which the client was sent. Goes on with what had
 * to wait for their room. */
void usbip_client_sent(struct usbip_client *client, size_t count);

/* Ends a client's visit for a reason, a string that stays. The first reason counts. */
void usbip_client_end(struct usbip_client *client, const char *reason);

/* Takes the device from a client, if the client has it: to the device, the cable was pulled. */
void usbip_client_leave(struct usbip_client *client);

#endif
