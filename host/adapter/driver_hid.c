/* SPDX-License-Identifier: MIT */
/* The transport to an adapter by HID reports, with hidapi. */
#include <errno.h>
#include <hidapi.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "adapter/drivers.h"
#include "base/stopwatch.h"
#include "usb_device.h"

enum { POLL_MS = 20 };

struct hid_link {
    struct usb_link link; /* the first member */
    hid_device *device;   /* NULL: lost */
    char serial[USB_NAME_SIZE];
};

/* Converts a serial number to bytes. Serial numbers of adapters are ASCII; anything else becomes
 * '?'. */
static void narrow(char *text, const wchar_t *wide) {
    size_t i = 0;
    for (; wide != NULL && wide[i] != L'\0' && i < USB_NAME_SIZE - 1; i++) {
        text[i] = wide[i] > 0x20 && wide[i] < 0x7F ? (char)wide[i] : '?';
    }
    text[i] = '\0';
}

static bool is_accessible(const char *path) {
    hid_device *device = hid_open_path(path);
    if (device == NULL) {
        return false;
    }
    hid_close(device);
    return true;
}

/* Lists the adapters by the number of the HID interface: not all of hidapi's back ends know the
 * usage page. An adapter that was pulled meanwhile may be listed without a path. */
static unsigned enumerate(struct usb_found *found, unsigned most, char *reason, bool must_try) {
    unsigned count = 0;
    reason[0] = '\0';
    if (hid_init() != 0) {
        (void)snprintf(reason, USB_LINK_REASON_SIZE, "hidapi can't be set up");
        return 0;
    }
    struct hid_device_info *all = hid_enumerate(USB_VENDOR_ID, USB_PRODUCT_ID);
    for (struct hid_device_info *info = all; info != NULL && count < most; info = info->next) {
        if (info->interface_number == USB_HID_INTERFACE && info->path != NULL) {
            narrow(found[count].serial, info->serial_number);
            (void)snprintf(found[count].path, USB_PATH_SIZE, "%s", info->path);
            found[count].is_accessible = !must_try || is_accessible(info->path);
            found[count].device = NULL;
            count++;
        }
    }
    hid_free_enumeration(all);
    return count;
}

static unsigned list(struct usb_found *found, unsigned most, char *reason) {
    unsigned count = enumerate(found, most, reason, true);
    (void)hid_exit();
    return count;
}

static void let_go(struct hid_link *hid) {
    if (hid->device != NULL) {
        hid_close(hid->device);
        hid->device = NULL;
    }
}

static enum usb_link_status lose(struct hid_link *hid) {
    (void)snprintf(hid->link.reason, sizeof hid->link.reason, "HID: %ls",
                   hid->device != NULL ? hid_error(hid->device) : L"not open");
    let_go(hid);
    return USB_LINK_LOST;
}

static enum usb_link_status hid_link_send(struct usb_link *link, const uint8_t *bytes,
                                          size_t count) {
    struct hid_link *hid = (struct hid_link *)link;
    for (size_t place = 0; place < count;) {
        uint8_t report[1 + USB_REPORT_BYTES];
        report[0] = 0; /* the reports have no numbers */
        if (hid->device == NULL) {
            return USB_LINK_LOST;
        }
        place += usb_report_pack(report + 1, bytes + place, count - place);
        if (hid_write(hid->device, report, sizeof report) < 0) {
            return lose(hid);
        }
        hid->link.transfers++;
    }
    return USB_LINK_OK;
}

static enum usb_link_status hid_link_receive(struct usb_link *link, uint8_t *bytes, size_t room,
                                             unsigned timeout_ms, size_t *count) {
    struct hid_link *hid = (struct hid_link *)link;
    struct timespec began = stopwatch_start();
    for (;;) {
        uint8_t report[USB_REPORT_BYTES];
        int left = (int)timeout_ms - (int)(stopwatch_seconds(&began) * 1000);
        if (hid->device == NULL) {
            return USB_LINK_LOST;
        }
        int got = hid_read_timeout(hid->device, report, sizeof report, left > 0 ? left : 0);
        if (got < 0) {
            return lose(hid);
        }
        hid->link.transfers += got > 0;
        size_t length = usb_report_length(report, (size_t)got);
        if (length > 0 && length <= room) {
            memcpy(bytes, report + 1, length);
            *count = length;
            return USB_LINK_OK;
        }
        if (left <= 0) {
            return USB_LINK_TIMEOUT; /* also if empty reports come without end */
        }
    }
}

static enum usb_open_status open_device(struct hid_link *hid, const char *serial, char *reason) {
    struct usb_found found[USB_FOUND_MOST];
    unsigned index = 0, count = enumerate(found, USB_FOUND_MOST, reason, false);
    if (reason[0] != '\0') {
        return USB_OPEN_REFUSED;
    }
    enum usb_open_status status = usb_choose(found, count, serial, &index, reason);
    if (status != USB_OPEN_OK) {
        return status;
    }
    errno = 0;
    hid->device = hid_open_path(found[index].path);
    if (hid->device == NULL) {
        if (errno == EACCES || errno == EPERM) {
            usb_explain_access(reason, found[index].path);
            return USB_OPEN_DENIED;
        }
        (void)snprintf(reason, USB_LINK_REASON_SIZE, "%.100s: can't be opened: %s",
                       found[index].path, errno != 0 ? strerror(errno) : "hidapi does not say why");
        return USB_OPEN_ABSENT; /* a node that is being made or torn down: another try may help */
    }
    (void)snprintf(hid->serial, sizeof hid->serial, "%s", found[index].serial);
    return USB_OPEN_OK;
}

static enum usb_link_status hid_link_reopen(struct usb_link *link, unsigned timeout_ms) {
    struct hid_link *hid = (struct hid_link *)link;
    struct timespec began = stopwatch_start();
    const struct timespec pause = {0, POLL_MS * 1000000L};
    char reason[USB_LINK_REASON_SIZE];
    let_go(hid);
    for (;;) {
        if (open_device(hid, hid->serial, reason) == USB_OPEN_OK) {
            return USB_LINK_OK;
        }
        if (stopwatch_seconds(&began) * 1000 >= timeout_ms) {
            return USB_LINK_TIMEOUT;
        }
        (void)nanosleep(&pause, NULL);
    }
}

static void hid_link_close(struct usb_link *link) {
    struct hid_link *hid = (struct hid_link *)link;
    let_go(hid);
    (void)hid_exit();
    free(hid);
}

static enum usb_open_status open_link(const char *serial, struct usb_link **link, char *reason) {
    static const struct usb_link_operations operations = {hid_link_send, hid_link_receive,
                                                          hid_link_reopen, hid_link_close};
    struct hid_link *hid = calloc(1, sizeof *hid);
    *link = NULL;
    if (hid == NULL) {
        (void)snprintf(reason, USB_LINK_REASON_SIZE, "out of memory");
        return USB_OPEN_REFUSED;
    }
    hid->link.operations = &operations;
    enum usb_open_status status = open_device(hid, serial, reason);
    if (status != USB_OPEN_OK) {
        (void)hid_exit(); /* or it would go on with the devices that it knows now */
        free(hid);
        return status;
    }
    *link = &hid->link;
    return USB_OPEN_OK;
}

extern const struct usb_backend usb_backend_hid;

const struct usb_backend usb_backend_hid = {"hid", list, open_link};
