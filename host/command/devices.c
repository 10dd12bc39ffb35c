/* SPDX-License-Identifier: MIT */
/* superframe devices: the adapters that are plugged in. */
#include <stdio.h>

#include "adapter/drivers.h"
#include "command/command.h"

/* Prints a line for each adapter: the backend's name, the serial number, the path, with tabs
 * between. Returns false, with the reason printed, where adapters can't be listed. */
static bool list_adapters(const char *name) {
    struct usb_found found[USB_FOUND_MOST];
    char reason[USB_LINK_REASON_SIZE] = "";
    const struct usb_backend *backend = usb_backend_find(name, reason);
    unsigned count = backend != NULL ? backend->list(found, USB_FOUND_MOST, reason) : 0;
    if (reason[0] != '\0') {
        complain("%s: %s", name, reason);
        return false;
    }
    for (unsigned i = 0; i < count; i++) {
        (void)printf("%s\t%s\t%s%s\n", name, found[i].serial[0] != '\0' ? found[i].serial : "-",
                     found[i].path,
                     found[i].is_accessible ? ""
                                            : "\tno permission: 70-superframe.rules is missing");
    }
    return true;
}

static int run_devices(const struct options *options) {
    (void)options;
    bool is_any_listed = false;
    for (size_t i = 0; usb_backend_names[i] != NULL; i++) {
        is_any_listed = list_adapters(usb_backend_names[i]) || is_any_listed;
    }
    return is_any_listed ? STATUS_DONE : STATUS_FAILED;
}

static const struct option_group *const groups[] = {NULL};
static const char *const examples[] = {"devices", "devices | grep ^usb", NULL};

const struct command command_devices = {.name = "devices",
                                        .operands = "",
                                        .summary = "List the adapters that are plugged in.",
                                        .least = 0,
                                        .most = 0,
                                        .kind = OPERANDS_NONE,
                                        .groups = groups,
                                        .examples = examples,
                                        .run = run_devices};
