/* SPDX-License-Identifier: MIT */
/* The machine's own I/O ports on Linux (x86), by ioperm(): for a board in a real slot. */
#ifndef SUPERFRAME_HAL_PORTS_LINUX_H
#define SUPERFRAME_HAL_PORTS_LINUX_H

#include "board_ports.h"
#include "bus.h"

#include <stdbool.h>
#include <stddef.h>

enum { PORTS_LINUX_MESSAGE_SIZE = 240 };

/* How the kernel and the ports are reached. Value and port stand in Linux's order, which is the
 * reverse of outp()'s. A test puts its own functions here. */
struct ports_linux_system {
    /* As ioperm(): 0, or -1 with errno set. */
    int (*allow)(unsigned long first, unsigned long count, int is_allowed);
    void (*write_byte)(unsigned char value, unsigned short port);
    void (*write_word)(unsigned short value, unsigned short port);
    unsigned char (*read_byte)(unsigned short port);
    unsigned short (*read_word)(unsigned short port);
    /* Gives up the privileges that the program has beyond its user's; 0, or -1 with errno set. */
    int (*drop)(void);
    const char *owners; /* the list of who owns which ports: /proc/ioports */
};

/* Linux itself. On other systems and processors allow() fails with ENOSYS. */
extern const struct ports_linux_system ports_linux_system;

/* The ports as a bus. */
struct ports_linux {
    struct bus bus; /* the first member */
    const struct ports_linux_system *system;
    uint16_t base;
};

/* What ports_linux_open() came to. */
enum ports_linux_result {
    PORTS_LINUX_OPEN,
    PORTS_LINUX_OWNED,  /* another owner is known, or who the owner is can't be found out */
    PORTS_LINUX_REFUSED /* the kernel or the rights don't allow it */
};

/* Opens the sixteen ports from base on, for the calling thread and the threads that it starts
 * later. Then drops the program's privileges for good, so the call comes before anything else is
 * opened. Refuses without touching a port where system->owners names an owner other than a bus
 * bridge. On anything but PORTS_LINUX_OPEN, message (PORTS_LINUX_MESSAGE_SIZE bytes) says why and
 * what helps.
 *
 * An access outside the sixteen ports fails the bus with BUS_REFUSED; it never reaches a port. */
enum ports_linux_result ports_linux_open(struct ports_linux *ports, uint16_t base,
                                         const struct ports_linux_system *system, char *message);

#endif
