/* SPDX-License-Identifier: MIT */
/* outp() and its siblings on the host: they reach whatever bus is bound. */
#include "bus.h"
#include "outp.h"

#include <stddef.h>

/* The one written global of the seam. NULL: no bus is bound. */
static struct bus *bound_bus = NULL;

void bus_write(struct bus *bus, uint16_t port, uint16_t value, unsigned width) {
    if (bus->status == BUS_OK) {
        bus->operations->write(bus, port, value, width);
    }
}

uint16_t bus_read(struct bus *bus, uint16_t port, unsigned width) {
    uint16_t value = 0xFFFF;
    if (bus->status == BUS_OK) {
        value = bus->operations->read(bus, port, width);
        /* A read that broke the bus has no value: its caller sees an open bus, as ever after. */
        if (bus->status != BUS_OK) {
            value = 0xFFFF;
        }
    }
    return width == BUS_BYTE ? (uint16_t)(value & 0x00FF) : value;
}

enum bus_status bus_flush(struct bus *bus) {
    if (bus->status == BUS_OK && bus->operations->flush != NULL) {
        bus->operations->flush(bus);
    }
    return bus->status;
}

void bus_fail(struct bus *bus, enum bus_status status) {
    if (bus->status == BUS_OK) {
        bus->status = status;
    }
}

struct bus *bus_bind(struct bus *bus) {
    struct bus *before = bound_bus;
    bound_bus = bus;
    return before;
}

enum bus_status bus_bound_status(void) {
    return bound_bus == NULL ? BUS_UNBOUND : bound_bus->status;
}

const char *bus_status_text(enum bus_status status) {
    switch (status) {
    case BUS_OK:
        return "the bus works";
    case BUS_UNBOUND:
        return "no bus is bound";
    case BUS_IO_ERROR:
        return "the operating system reported an input or output error";
    case BUS_LOST:
        return "the device went away";
    case BUS_TIMEOUT:
        return "the device did not answer in time";
    case BUS_PROTOCOL:
        return "the device gave an answer that the protocol does not allow";
    case BUS_REFUSED:
        return "the access is not allowed here";
    }
    return "unknown bus status";
}

void outp(uint16_t port, uint8_t value) {
    struct bus *bus = bound_bus;
    if (bus != NULL && bus->status == BUS_OK) {
        bus->operations->write(bus, port, value, BUS_BYTE);
    }
}

void outpw(uint16_t port, uint16_t value) {
    struct bus *bus = bound_bus;
    if (bus != NULL && bus->status == BUS_OK) {
        bus->operations->write(bus, port, value, BUS_WORD);
    }
}

uint8_t inp(uint16_t port) {
    return bound_bus == NULL ? 0xFF : (uint8_t)bus_read(bound_bus, port, BUS_BYTE);
}

uint16_t inpw(uint16_t port) {
    return bound_bus == NULL ? 0xFFFF : bus_read(bound_bus, port, BUS_WORD);
}
