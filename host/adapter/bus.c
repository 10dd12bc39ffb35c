/* SPDX-License-Identifier: MIT */
/* The ports at the end of a cable: accesses in, frames out, and what is known of the picture. */
#include "adapter/bus_internal.h"

#include <stdlib.h>
#include <string.h>

static const uint32_t being_written = UINT32_MAX;

struct usb_limits usb_default_limits(void) {
    const struct usb_limits limits = {1000, 5, 5000, 8, 1, NULL};
    return limits;
}

/* Seals the encoder's payload, which is full. */
static void seal(void *context) {
    usb_session_seal(context);
}

/* Notes that what was written to the line so far is, at the latest, in the frame that is being
 * filled. */
static void close_line(struct usb_bus *usb_bus) {
    if (usb_bus->y < BOARD_HEIGHT && usb_bus->line_frame[usb_bus->y] == being_written) {
        usb_bus->line_frame[usb_bus->y] = usb_bus->sealed + 1;
    }
}

/* Follows the picture: words to X and Y, and bytes to the primaries. */
static void follow(struct usb_bus *usb_bus, unsigned offset, uint16_t value, unsigned width) {
    if (width == BUS_WORD && offset == BOARD_X) {
        usb_bus->x = value;
    } else if (width == BUS_WORD && offset == BOARD_Y) {
        close_line(usb_bus);
        usb_bus->y = value;
    } else if (width == BUS_BYTE && offset >= BOARD_RED && offset <= BOARD_BLUE &&
               offset % 2 == 0 && usb_bus->x < BOARD_WIDTH && usb_bus->y < BOARD_HEIGHT) {
        usb_bus->pixels[usb_bus->y][usb_bus->x][(offset - BOARD_RED) / 2] = (uint8_t)value;
        usb_bus->drawn[usb_bus->y][usb_bus->x] |= (uint8_t)(1U << (offset - BOARD_RED) / 2);
        usb_bus->line_frame[usb_bus->y] = being_written;
    }
}

static void refuse(struct usb_bus *usb_bus, uint16_t port) {
    usb_bus_give_up(usb_bus, BUS_REFUSED,
                    "port %04X is none of the adapter's; allowed are %04X-%04X", port,
                    usb_bus->base, usb_bus->base + BOARD_PORTS - 1);
}

static void write_port(struct bus *bus, uint16_t port, uint16_t value, unsigned width) {
    struct usb_bus *usb_bus = (struct usb_bus *)bus;
    unsigned offset = (uint16_t)(port - usb_bus->base);
    if (!usb_encoder_write(&usb_bus->encoder, offset, value, width)) {
        refuse(usb_bus, port);
        return;
    }
    follow(usb_bus, offset, value, width);
}

/* Returns what was read. If the bus fails meanwhile, bus_read() does not take the value. */
static uint16_t read_port(struct bus *bus, uint16_t port, unsigned width) {
    struct usb_bus *usb_bus = (struct usb_bus *)bus;
    if (usb_encoder_read(&usb_bus->encoder, (uint16_t)(port - usb_bus->base), width)) {
        close_line(usb_bus);
        (void)usb_session_ask(usb_bus, width);
    } else {
        refuse(usb_bus, port);
    }
    return width == BUS_BYTE ? usb_bus->data[0] : usb_get16(usb_bus->data);
}

static void flush(struct bus *bus) {
    struct usb_bus *usb_bus = (struct usb_bus *)bus;
    usb_encoder_flush(&usb_bus->encoder);
    close_line(usb_bus);
    usb_session_seal(usb_bus);
    usb_bus->encoder.used = 0;
    (void)usb_session_finish(usb_bus);
}

static const struct bus_operations operations = {write_port, read_port, flush};

struct usb_bus *usb_bus_new(struct usb_link *link, uint16_t base, const struct usb_limits *limits) {
    struct usb_bus *usb_bus = calloc(1, sizeof *usb_bus);
    if (usb_bus == NULL) {
        return NULL;
    }
    usb_bus->bus.operations = &operations;
    usb_bus->link = link;
    usb_bus->base = base;
    usb_bus->limits = *limits;
    if (usb_session_begin(usb_bus)) {
        usb_encoder_init(&usb_bus->encoder, usb_bus->greeting.payload_most, seal, usb_bus);
    }
    return usb_bus;
}

bool usb_bus_line_is_there(const struct usb_bus *usb_bus, unsigned line) {
    uint32_t frame = usb_bus->line_frame[line];
    return frame != 0 && frame != being_written && frame <= usb_bus->acked;
}

void usb_bus_free(struct usb_bus *usb_bus) {
    if (usb_bus != NULL) {
        free(usb_bus->journal.bytes);
        free(usb_bus->journal.ends);
        free(usb_bus);
    }
}
