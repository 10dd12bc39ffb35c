/* SPDX-License-Identifier: MIT */
/* superframe devices: the adapters that are plugged in. */
#include <stdio.h>

#include "adapter/drivers.h"
#include "base/json.h"
#include "command/command.h"

/* What is printed, and how far it has come. */
struct listing {
    struct json json;
    bool is_json, is_any_listed; /* is_any_listed: some library could be asked */
    unsigned adapters;
};

/* Prints an adapter: the transport's name, the serial number, the path, with tabs between. */
static void print_adapter(struct listing *listing, const char *name,
                          const struct usb_found *found) {
    struct json *json = &listing->json;
    listing->adapters++;
    if (!listing->is_json) {
        (void)printf("%s\t%s\t%s%s\n", name, found->serial[0] != '\0' ? found->serial : "-",
                     found->path,
                     found->is_accessible ? "" : "\tno permission: 70-superframe.rules is missing");
        return;
    }
    json_begin_object(json, NULL);
    json_text(json, "bus", name);
    json_text(json, "serial", found->serial[0] != '\0' ? found->serial : NULL);
    json_text(json, "path", found->path);
    json_flag(json, "accessible", found->is_accessible);
    json_end_object(json);
}

/* Prints the adapters of a transport, or why they can't be listed. */
static void list_adapters(struct listing *listing, const char *name) {
    struct usb_found found[USB_FOUND_MOST];
    char reason[USB_LINK_REASON_SIZE] = "";
    const struct usb_backend *backend = usb_backend_find(name, reason);
    unsigned count = backend != NULL ? backend->list(found, USB_FOUND_MOST, reason) : 0;
    if (reason[0] != '\0') {
        complain("%s: %s", name, reason);
        return;
    }
    listing->is_any_listed = true;
    for (unsigned i = 0; i < count; i++) {
        print_adapter(listing, name, &found[i]);
    }
}

static int run_devices(const struct options *options) {
    struct listing listing = {.json = {.out = stdout}, .is_json = options->json};
    if (listing.is_json) {
        json_begin_list(&listing.json, NULL);
    }
    for (size_t i = 0; usb_backend_names[i] != NULL; i++) {
        list_adapters(&listing, usb_backend_names[i]);
    }
    if (listing.is_json) {
        json_end_list(&listing.json);
    } else if (listing.is_any_listed && listing.adapters == 0) {
        complain("devices: no adapter is plugged in");
    }
    return listing.is_any_listed ? STATUS_DONE : STATUS_FAILED;
}

const struct command command_devices = {.name = "devices",
                                        .operands = "",
                                        .summary = "List the adapters that are plugged in.",
                                        .groups = OPTION_GROUPS(&group_json),
                                        .examples =
                                            COMMAND_EXAMPLES("devices", "devices | grep ^usb"),
                                        .run = run_devices};
