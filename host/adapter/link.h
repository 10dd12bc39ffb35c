/* SPDX-License-Identifier: MIT */
/* A stream of bytes to an adapter and back, whatever carries the bytes: bulk transfers, HID
 * reports, or a test's own. */
#ifndef SUPERFRAME_USB_LINK_H
#define SUPERFRAME_USB_LINK_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* What became of a call. */
enum usb_link_status {
    USB_LINK_OK = 0,
    USB_LINK_TIMEOUT, /* nothing came, or nothing was taken, in time */
    USB_LINK_STALLED, /* the endpoint refused and was cleared; what was in flight is lost */
    USB_LINK_LOST     /* the device is gone: reopen() may bring it back */
};

enum { USB_LINK_REASON_SIZE = 256 };

struct usb_link;

/* What a back end implements. */
struct usb_link_operations {
    /* Hands a whole frame on. The frame may still be in flight when send() returns; several can
     * be. */
    enum usb_link_status (*send)(struct usb_link *link, const uint8_t *bytes, size_t count);

    /* Waits for bytes, at most timeout_ms (0: only looks). OK: *count is 1..room. */
    enum usb_link_status (*receive)(struct usb_link *link, uint8_t *bytes, size_t room,
                                    unsigned timeout_ms, size_t *count);

    /* Waits for the same adapter to come back, at most timeout_ms, and opens it. TIMEOUT: the
     * adapter did not come back. What was in flight before is lost. */
    enum usb_link_status (*reopen)(struct usb_link *link, unsigned timeout_ms);

    /* Lets go of the device and of the link itself. */
    void (*close)(struct usb_link *link);
};

/* The first member of a back end's own struct. */
struct usb_link {
    const struct usb_link_operations *operations;
    uint64_t transfers; /* handed over, and come, so far: bulk transfers or reports */
    char reason[USB_LINK_REASON_SIZE]; /* of the last LOST, in words; "" if there is none */
};

#endif
