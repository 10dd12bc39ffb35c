/* SPDX-License-Identifier: MIT */
/* The bus behind outp() on the host: three functions, a sticky status, and which bus is bound. */
#ifndef SUPERFRAME_HAL_BUS_H
#define SUPERFRAME_HAL_BUS_H

#include <stdint.h>

/* What a bus can say of itself. 0 is the only good value. */
enum bus_status {
    BUS_OK = 0,
    BUS_UNBOUND,  /* no bus was bound when a port was accessed */
    BUS_IO_ERROR, /* an operating-system call failed (disk full, pipe closed) */
    BUS_LOST,     /* the device went away */
    BUS_TIMEOUT,  /* the device did not answer in time */
    BUS_PROTOCOL, /* the device answered what it may not answer */
    BUS_REFUSED   /* the access is not allowed here */
};

/* Width of an access in bytes. */
enum bus_width { BUS_BYTE = 1, BUS_WORD = 2 };

struct bus;

/* What a back end implements. Each function gets the bus it was called on; width is 1 or 2.
 * Of a byte only bits 7-0 count, of the value that is written and of what read returns. A failure
 * is reported by bus_fail(), which makes it sticky. */
struct bus_operations {
    void (*write)(struct bus *bus, uint16_t port, uint16_t value, unsigned width);
    uint16_t (*read)(struct bus *bus, uint16_t port, unsigned width);
    void (*flush)(struct bus *bus); /* may be NULL: nothing is buffered */
};

/* A bus is embedded as the first member of the back end's own struct. */
struct bus {
    const struct bus_operations *operations;
    enum bus_status status; /* sticky: the first failure stays until the bus is set up again */
};

/* Writes through the bus: of a byte, bits 7-0 of value. The write is dropped once the bus has
 * failed. */
void bus_write(struct bus *bus, uint16_t port, uint16_t value, unsigned width);

/* Hands a write to inner and takes over inner's status, for a decorator that has not failed.
 * Inline, because a frame has a million writes, each through every bus of the chain. */
static inline void bus_pass_on(struct bus *bus, struct bus *inner, uint16_t port, uint16_t value,
                               unsigned width) {
    if (inner->status == BUS_OK) {
        inner->operations->write(inner, port, value, width);
    }
    bus->status = inner->status;
}

/* Reads through the bus: 0..FFh (width 1) or 0..FFFFh (width 2). Returns FFh or FFFFh once the bus
 * has failed. */
uint16_t bus_read(struct bus *bus, uint16_t port, unsigned width);

/* Sends whatever the bus has buffered and returns its status. */
enum bus_status bus_flush(struct bus *bus);

/* Records a failure; the first one wins, and BUS_OK changes nothing. */
void bus_fail(struct bus *bus, enum bus_status status);

/* Makes bus the one that outp() and its siblings reach; NULL unbinds. Returns the bus that was
 * bound before, or NULL. Not to be called while another thread is accessing ports. */
struct bus *bus_bind(struct bus *bus);

/* Returns the status of the bound bus, BUS_UNBOUND if none is bound. */
enum bus_status bus_bound_status(void);

/* Returns one English phrase for a status, for error messages. */
const char *bus_status_text(enum bus_status status);

#endif
