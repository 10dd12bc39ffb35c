/* SPDX-License-Identifier: MIT */
/* One client of a USB/IP server: the bytes that the client sends, taken apart and done on a device.
 *
 * No sockets: bytes go in by usbip_client_take() and come out by a function of the caller's. The
 * protocol is the Linux kernel's, version 1.1.1 (Documentation/usb/usbip_protocol.rst). */
#ifndef SUPERFRAME_EMULATOR_USBIP_H
#define SUPERFRAME_EMULATOR_USBIP_H

#include "usb_device.h"

enum {
    USBIP_PORT = 3240, /* the registered one */
    USBIP_TRANSFER_MOST =
        65536,             /* bytes of a transfer to the device; more ends the client's visit */
    USBIP_PARKED_MOST = 32 /* transfers from the device that may wait for data */
};

#define USBIP_BUS_ID "1-1" /* what `usbip attach -b` names the device by */

/* A transfer that waits for the device to have something to say. */
struct usbip_parked {
    uint32_t number;
    uint32_t room; /* bytes */
    uint8_t endpoint;
};

/* A client. About 66 KB. */
struct usbip_client {
    struct usb_device *device;
    void (*send)(void *context, const uint8_t *bytes, size_t count);
    void *context;
    bool is_busy;     /* another client has the device: this one may look, but not have it */
    bool is_attached; /* has the device */
    bool is_over;     /* close the connection; reason says why */
    const char *reason;
    unsigned parked_count;
    struct usbip_parked parked[USBIP_PARKED_MOST];
    size_t input_count;
    uint8_t input[48 + USBIP_TRANSFER_MOST];
};

/* Initialises the connection of a client that has just connected. is_busy says that another client
 * has the device. */
void usbip_client_init(struct usbip_client *client, struct usb_device *device, bool is_busy,
                       void (*send)(void *context, const uint8_t *bytes, size_t count),
                       void *context);

/* Takes bytes and does what they ask for. Once is_over, nothing more is taken. */
void usbip_client_take(struct usbip_client *client, const uint8_t *bytes, size_t count);

/* Ends a client's visit: to the device, the cable was pulled. */
void usbip_client_leave(struct usbip_client *client);

#endif
