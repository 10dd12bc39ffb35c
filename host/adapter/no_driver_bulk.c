/* SPDX-License-Identifier: MIT */
/* Stands in for driver_bulk.c where libusb-1.0 is missing. */
#include <stdio.h>

#include "adapter/drivers.h"

static void say_so(char *reason) {
    (void)snprintf(reason, USB_LINK_REASON_SIZE,
                   "built without libusb-1.0; install its headers (libusb-1.0-0-dev) and build "
                   "again");
}

static unsigned list(struct usb_found *found, unsigned most, char *reason) {
    (void)found;
    (void)most;
    say_so(reason);
    return 0;
}

static enum usb_open_status open_none(const char *serial, struct usb_link **link, char *reason) {
    (void)serial;
    *link = NULL;
    say_so(reason);
    return USB_OPEN_REFUSED;
}

const struct usb_backend usb_backend_bulk = {"usb", "built without libusb-1.0", list, open_none};
