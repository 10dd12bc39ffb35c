/* SPDX-License-Identifier: MIT */
/* superframe devices: the adapters that are plugged in. */
#include <stdio.h>

#include "adapter/drivers.h"
#include "command/command.h"

/* Prints a line for each adapter: the backend's name, the serial number, the path, with tabs
 * between. Returns false, with the reason printed, where adapters can't be listed. */
static bool list_backend(const struct usb_backend *backend) {
    struct usb_found found[USB_FOUND_MOST];
    char reason[USB_LINK_REASON_SIZE];
    unsigned count = backend->list(found, USB_FOUND_MOST, reason);
    if (reason[0] != '\0') {
        complain("%s: %s", backend->name, reason);
        return false;
    }
    for (unsigned i = 0; i < count; i++) {
        (void)printf("%s\t%s\t%s%s\n", backend->name,
                     found[i].serial[0] != '\0' ? found[i].serial : "-", found[i].path,
                     found[i].is_accessible ? ""
                                            : "\tno permission: 70-superframe.rules is lacking");
    }
    return true;
}

int run_devices(const struct options *options) {
    (void)options;
    bool has_bulk = list_backend(&usb_backend_bulk);
    bool has_hid = list_backend(&usb_backend_hid);
    return has_bulk || has_hid ? STATUS_DONE : STATUS_FAILED;
}
