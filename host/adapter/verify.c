/* SPDX-License-Identifier: MIT */
/* Reading the picture back over the cable, and repairing what differs. */
#include "adapter/bus_internal.h"

#include <string.h>

#include "splitmix64.h"

enum { ALL_PRIMARIES = 7, PERCENT = 100 };

static bool is_drawn(const struct usb_bus *usb_bus, unsigned line) {
    for (unsigned x = 0; x < BOARD_WIDTH; x++) {
        if (usb_bus->drawn[line][x] == ALL_PRIMARIES) {
            return true;
        }
    }
    return false;
}

static void port_write(struct usb_bus *usb_bus, unsigned offset, unsigned value, unsigned width) {
    bus_write(&usb_bus->bus, (uint16_t)(usb_bus->base + offset), (uint16_t)value, width);
}

/* Notes in differs which pixels of a line are not as drawn. Returns how many, and adds to *compared
 * how many were compared. */
static unsigned compare_line(struct usb_bus *usb_bus, unsigned line, uint8_t *differs,
                             uint64_t *compared) {
    unsigned most = usb_bus->read_most / 3, different = 0;
    memset(differs, 0, BOARD_WIDTH);
    port_write(usb_bus, BOARD_Y, line, BUS_WORD);
    for (unsigned x = 0; x < BOARD_WIDTH; x += most) {
        unsigned count = BOARD_WIDTH - x < most ? BOARD_WIDTH - x : most;
        usb_encoder_read_pixels(&usb_bus->encoder, (uint16_t)x, count);
        if (!usb_session_ask(usb_bus, 3 * (size_t)count)) {
            return 0;
        }
        for (unsigned i = 0; i < count; i++) {
            if (usb_bus->drawn[line][x + i] == ALL_PRIMARIES) {
                ++*compared;
                differs[x + i] =
                    memcmp(usb_bus->pixels[line][x + i], usb_bus->data + 3 * (size_t)i, 3) != 0;
                different += differs[x + i];
            }
        }
    }
    return different;
}

static void repair_line(struct usb_bus *usb_bus, unsigned line, const uint8_t *differs) {
    port_write(usb_bus, BOARD_Y, line, BUS_WORD);
    for (unsigned x = 0; x < BOARD_WIDTH; x++) {
        if (differs[x] != 0) {
            port_write(usb_bus, BOARD_X, x, BUS_WORD);
            for (unsigned primary = 0; primary < 3; primary++) {
                port_write(usb_bus, BOARD_RED + 2 * primary, usb_bus->pixels[line][x][primary],
                           BUS_BYTE);
            }
        }
    }
}

static void verify_line(struct usb_bus *usb_bus, unsigned line,
                        struct usb_verification *verification) {
    uint8_t differs[BOARD_WIDTH];
    uint64_t again = 0;
    unsigned first = compare_line(usb_bus, line, differs, &verification->pixels);
    unsigned left = first;
    for (unsigned i = 0; i < USB_REPAIRS_MOST && left > 0 && usb_bus->bus.status == BUS_OK; i++) {
        repair_line(usb_bus, line, differs);
        left = compare_line(usb_bus, line, differs, &again);
    }
    verification->repaired += first - (left < first ? left : first);
    if (left > 0) {
        if (verification->wrong_lines == 0) {
            verification->first_wrong = line;
        }
        verification->wrong_lines++;
    }
}

bool usb_bus_verify(struct usb_bus *usb_bus, unsigned percent, uint64_t seed,
                    struct usb_verification *verification) {
    memset(verification, 0, sizeof *verification);
    (void)bus_flush(&usb_bus->bus);
    for (unsigned line = 0; line < BOARD_HEIGHT && usb_bus->bus.status == BUS_OK; line++) {
        if (is_drawn(usb_bus, line) && splitmix64(&seed) % PERCENT < percent) {
            verify_line(usb_bus, line, verification);
        }
    }
    return bus_flush(&usb_bus->bus) == BUS_OK;
}
