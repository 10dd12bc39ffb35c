/* SPDX-License-Identifier: MIT */
/* The adapter as a USB device: descriptors, requests, a bulk pair and a HID pair. A vendor's or
 * TinyUSB's driver of the USB block hands packets in and takes packets out. */
#ifndef SUPERFRAME_HAL_USB_DEVICE_H
#define SUPERFRAME_HAL_USB_DEVICE_H

#include "usb_adapter.h"

/* To be registered with pid.codes before hardware ships. No enum, because an int of 16 bits does
 * not hold the number. */
#define USB_PRODUCT_ID UINT16_C(0x9801)

enum {
    USB_VENDOR_ID = 0x1209,
    USB_BULK_OUT = 0x01,
    USB_BULK_IN = 0x81,
    USB_HID_OUT = 0x02,
    USB_HID_IN = 0x82,
    USB_BULK_INTERFACE = 0,
    USB_HID_INTERFACE = 1,
    USB_INTERFACES = 2,
    USB_SERIAL_MOST = 31,   /* letters, ASCII */
    USB_FEATURE_BYTES = 32, /* of the HID feature report: the adapter's counters */
    USB_CONTROL_MOST = 256, /* bytes that a control transfer may give */
    USB_NOTHING_YET = -1,   /* no answer now: NAK */
    USB_STALL = -2
};

/* The device. */
struct usb_device {
    struct usb_adapter adapter;
    char serial[USB_SERIAL_MOST + 1];

    bool is_high_speed;
    uint8_t configuration; /* 0: not configured */
    uint8_t halted;        /* bit 0: bulk out, 1: bulk in, 2: HID out, 3: HID in */
    bool is_by_hid;        /* where the last frames came from: replies go there */
};

/* Plugs the device in. serial: 1..31 letters, copied. bus: where the board is; base_served as for
 * usb_adapter_init(). */
void usb_device_init(struct usb_device *device, struct bus *bus, uint16_t base_served,
                     const char *serial, bool is_high_speed);

/* Makes the device not configured, as the USB reset does. The session of the protocol stays. */
void usb_device_reset(struct usb_device *device);

/* Does one control transfer. data is what the host sent (setup's wLength bytes) if the transfer
 * goes out; in has room for USB_CONTROL_MOST bytes. Returns how many bytes of in are the answer (0
 * for a transfer that goes out), or USB_STALL. */
int usb_device_control(struct usb_device *device, const uint8_t setup[8], const uint8_t *data,
                       uint8_t *in);

/* Takes what came in over an OUT endpoint. Returns false if the bytes are lost and the endpoint
 * stalls. The reason is that the device has no such endpoint, is not configured, or has halted the
 * endpoint. An endpoint is halted, until CLEAR_FEATURE, once more replies wait than credits
 * allow. */
bool usb_device_out(struct usb_device *device, uint8_t endpoint, const uint8_t *bytes,
                    size_t count);

/* Gives what to send over an IN endpoint: at most room bytes (a HID report needs 64). Returns the
 * number of bytes, or USB_NOTHING_YET or USB_STALL. A bulk answer ends with a packet that is not
 * full: after a full last packet the driver adds an empty one. */
int usb_device_in(struct usb_device *device, uint8_t endpoint, uint8_t *bytes, size_t room);

#endif
