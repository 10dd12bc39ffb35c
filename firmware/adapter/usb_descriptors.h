/* SPDX-License-Identifier: MIT */
/* The tables that the device describes itself with. */
#ifndef SUPERFRAME_HAL_USB_DESCRIPTORS_H
#define SUPERFRAME_HAL_USB_DESCRIPTORS_H

#include "usb_device.h"

enum { USB_MICROSOFT_REQUEST = 0x4D }; /* bRequest by which Windows asks for the MS OS 2.0 set */

/* Copies the descriptor that GET_DESCRIPTOR asks for (value: type in the high byte, index in the
 * low one). Returns the descriptor's length, 0 if there is no such descriptor. bytes has room for
 * USB_CONTROL_MOST. */
size_t usb_descriptor(const struct usb_device *device, uint16_t value, uint8_t *bytes);

/* Copies the MS OS 2.0 descriptor set, by which Windows binds WinUSB to the bulk interface. Returns
 * the set's length, 178. bytes has room for USB_CONTROL_MOST. */
size_t usb_microsoft_descriptor(uint8_t *bytes);

#endif
