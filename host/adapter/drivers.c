/* SPDX-License-Identifier: MIT */
/* What both back ends share: which adapter is meant, and why an adapter can't be had. */
#include "adapter/drivers.h"

#include <stdio.h>
#include <string.h>

#include "usb_device.h"

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
                   "%.60s: this user may not open it; the udev rule 70-superframe.rules is lacking "
                   "(make install puts it there) or came after the adapter, or this user does "
                   "not sit at the machine",
                   path);
}
