/* SPDX-License-Identifier: MIT */
/* Between the files of the USB bus: the session's machinery below the accesses. */
#ifndef SUPERFRAME_USB_BUS_INTERNAL_H
#define SUPERFRAME_USB_BUS_INTERNAL_H

#include "adapter/bus.h"

/* Fails the bus, and says why. The first reason stays. */
void usb_bus_give_up(struct usb_bus *usb_bus, enum bus_status status, const char *format, ...)
#if defined(__GNUC__)
    __attribute__((format(printf, 3, 4)))
#endif
    ;

/* Begins the first session. Returns false if the bus failed. */
bool usb_session_begin(struct usb_bus *usb_bus);

/* Makes a frame of the encoder's payload and sends it as soon as the credits allow. */
void usb_session_seal(struct usb_bus *usb_bus);

/* Waits until every frame is known to have been run. Returns false if the bus failed. */
bool usb_session_finish(struct usb_bus *usb_bus);

/* Seals a frame, and waits for what the frame reads: count bytes in data. Returns false if the bus
 * failed. */
bool usb_session_ask(struct usb_bus *usb_bus, size_t count);

#endif
