/* SPDX-License-Identifier: MIT */
/* Stands in for driver_hid.c where hidapi is missing. */
#include <stdio.h>

#include "adapter/drivers.h"

static void say_so(char *reason) {
    (void)snprintf(reason, USB_LINK_REASON_SIZE,
                   "built without hidapi; install its headers (libhidapi-dev) and build again");
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

const struct usb_backend usb_backend_hid = {"hid", "built without hidapi", list, open_none};
