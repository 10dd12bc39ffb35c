/* SPDX-License-Identifier: MIT */
/* A bus with nothing plugged in. */
#include "null_bus.h"

#include <stddef.h>

static void null_write(struct bus *bus, uint16_t port, uint16_t value, unsigned width) {
    (void)bus;
    (void)port;
    (void)value;
    (void)width;
}

static uint16_t null_read(struct bus *bus, uint16_t port, unsigned width) {
    (void)bus;
    (void)port;
    return width == BUS_BYTE ? 0x00FF : 0xFFFF;
}

static const struct bus_operations null_operations = {null_write, null_read, NULL};

void null_bus_init(struct bus *bus) {
    bus->operations = &null_operations;
    bus->status = BUS_OK;
}
