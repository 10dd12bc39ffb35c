/* SPDX-License-Identifier: MIT */
/* What both back ends share: which adapter is meant, and why an adapter can't be had. */
#include "adapter/drivers.h"

#include <stdio.h>
#include <string.h>

#include "usb_device.h"

/* The library that a transport takes, by usb_backend_names, and the package of its headers. */
static const char *const libraries[][2] = {{"libusb-1.0", "libusb-1.0-0-dev"},
                                           {"hidapi", "libhidapi-dev"}};

const char *const usb_backend_names[] = {"usb", "hid", NULL};

const struct usb_backend *usb_backend_find(const char *name, char *reason) {
    for (size_t i = 0; usb_backends_built[i] != NULL; i++) {
        if (strcmp(usb_backends_built[i]->name, name) == 0) {
            return usb_backends_built[i];
        }
    }
    size_t known = strcmp(name, usb_backend_names[0]) == 0 ? 0 : 1;
    (void)snprintf(reason, USB_LINK_REASON_SIZE,
                   "built without %s; install its headers (%s) and build again",
                   libraries[known][0], libraries[known][1]);
    return NULL;
}

static void refuse_several(const struct usb_found *found, unsigned count, char *reason) {
    int used = snprintf(reason, USB_LINK_REASON_SIZE,
                        "%u adapters are plugged in; name one by its serial number:", count);
    for (unsigned i = 0; i < count && used > 0 && used < USB_LINK_REASON_SIZE; i++) {
        used += snprintf(reason + used, (size_t)(USB_LINK_REASON_SIZE - used), " %s",
                         found[i].serial[0] != '\0' ? found[i].serial : "(unreadable)");
    }
}

enum usb_open_status usb_choose(const struct usb_found *found, unsigned count, const char *serial,
                                unsigned *index, char *reason) {
    unsigned matching = 0;
    for (unsigned i = 0; i < count; i++) {
        if (serial == NULL || strcmp(found[i].serial, serial) == 0) {
            *index = i;
            matching++;
        }
    }
    if (matching == 1) {
        return USB_OPEN_OK;
    }
    if (matching > 1) {
        refuse_several(found, count, reason);
        return USB_OPEN_REFUSED;
    }
    if (serial != NULL && count > 0) {
        for (unsigned i = 0; i < count; i++) {
            if (!found[i].is_accessible) {
                usb_explain_access(reason, found[i].path);
                return USB_OPEN_DENIED;
            }
        }
        (void)snprintf(reason, USB_LINK_REASON_SIZE,
                       "no adapter \"%.60s\" is plugged in; superframe devices lists those that "
                       "are",
                       serial);
    } else {
        (void)snprintf(reason, USB_LINK_REASON_SIZE,
                       "no adapter (%04x:%04x) is plugged in; --wait waits for one",
                       (unsigned)USB_VENDOR_ID, (unsigned)USB_PRODUCT_ID);
    }
    return USB_OPEN_ABSENT;
}

void usb_explain_access(char *reason, const char *path) {
    (void)snprintf(reason, USB_LINK_REASON_SIZE,
                   "%.60s: this user may not open it; the udev rule 70-superframe.rules is missing "
                   "(make install puts it there) or came after the adapter, or this user does "
                   "not sit at the machine",
                   path);
}
