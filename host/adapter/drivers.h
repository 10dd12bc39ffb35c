/* SPDX-License-Identifier: MIT */
/* The two transports to an adapter, bulk transfers and HID reports. */
#ifndef SUPERFRAME_USB_BACKENDS_H
#define SUPERFRAME_USB_BACKENDS_H

#include "adapter/link.h"

enum { USB_FOUND_MOST = 32, USB_NAME_SIZE = 64, USB_PATH_SIZE = 128 };

/* An adapter that is plugged in. */
struct usb_found {
    char serial[USB_NAME_SIZE]; /* "" if it can't be read */
    char path[USB_PATH_SIZE];   /* where it is plugged in, in the library's words */
    bool is_accessible;         /* false: this user may not open it */
    void *device;               /* the back end's own */
};

/* What opening came to. */
enum usb_open_status {
    USB_OPEN_OK,
    USB_OPEN_ABSENT, /* no such adapter: it may yet be plugged in */
    USB_OPEN_DENIED, /* this user may not open it: udev takes a moment with one that has just come
                      */
    USB_OPEN_REFUSED /* it is there, but can't be had: waiting does not help */
};

/* One transport. */
struct usb_backend {
    const char *name; /* "usb" or "hid", as --bus calls it */

    /* Lists the adapters, at most most; returns how many. reason (USB_LINK_REASON_SIZE bytes) is
     * "" or says why the list can't be had. */
    unsigned (*list)(struct usb_found *found, unsigned most, char *reason);

    /* Opens the adapter with a serial number; NULL: the only one. Anything but OK fills reason. */
    enum usb_open_status (*open)(const char *serial, struct usb_link **link, char *reason);
};

/* The transports of this build, in a list that make writes; NULL ends the list. */
extern const struct usb_backend *const usb_backends_built[];

/* The names of all transports, whether this build has them or not; NULL ends the list. */
extern const char *const usb_backend_names[];

/* Finds a transport by its name. NULL with `reason` filled (USB_LINK_REASON_SIZE bytes) where its
 * library was missing when the program was built. */
const struct usb_backend *usb_backend_find(const char *name, char *reason);

/* Finds the adapter that is meant among those found. With USB_OPEN_OK, *index is its place. */
enum usb_open_status usb_choose(const struct usb_found *found, unsigned count, const char *serial,
                                unsigned *index, char *reason);

/* Says that this user may not open the device, and what would help. */
void usb_explain_access(char *reason, const char *path);

#endif
