/* SPDX-License-Identifier: MIT */
/* A server of USB/IP that keeps its peace among clients who do not keep theirs.
 *
 * One thread, one poll(), and no call that waits for a client. Whoever connects is a visitor at
 * first: a visitor may see the list or ask for the device, within a bounded time. One client at a
 * time has the device, until it leaves or is lost. */
#ifndef SUPERFRAME_USBIP_SERVER_H
#define SUPERFRAME_USBIP_SERVER_H

#include <signal.h>
#include <stdbool.h>
#include <stddef.h>

#include "adapter/address.h"
#include "usb_device.h"

/* How patient the server is, to a tenth of a second. */
struct usbip_limits {
    unsigned visit_ms; /* for all that a client without the device does; 1.. */
    unsigned busy_ms;  /* for a former client's end, before the device is told to be busy; 0.. */
    unsigned lost_s;   /* for a client with the device that answers or reads nothing; 1.. */
    unsigned keep_ms;  /* at least from one keep() to the next; 0.. */
};

/* What is served, where and to whom. */
struct usbip_server {
    int listener; /* listens; stays the caller's, and becomes non-blocking */
    struct usb_device *device;
    const struct address_range *allowed; /* who may come; 0 of them: anybody */
    size_t allowed_count;
    struct usbip_limits limits;
    bool is_quiet; /* nothing is told of who comes and leaves */
    bool is_once;  /* the server ends when the first client that had the device has left */

    /* Keeps what a client drew that has left the device. One descriptor is free for it. What is
     * drawn by the server's end is the caller's to keep. */
    void (*keep)(void *context);
    void *context;
};

/* Returns the patience for people: 5 seconds for a visit, half a second before the device is told
 * to be busy. A lost client has 30 seconds, and a second lies between two calls of keep(). */
struct usbip_limits usbip_default_limits(void);

/* Serves until *stop is not 0 or, is_once, the first client has left; *stop is looked at every
 * 100 ms. Who comes, gets the device, leaves and why is told on standard error. A line of these
 * that would have to wait for its reader is left out. Returns false if memory is out. */
bool usbip_serve(const struct usbip_server *server, const volatile sig_atomic_t *stop);

#endif
