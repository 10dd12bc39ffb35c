/* SPDX-License-Identifier: MIT */
/* The adapter's state machine: a stream of bytes in, port accesses and a stream of replies out. */
#ifndef SUPERFRAME_HAL_USB_ADAPTER_H
#define SUPERFRAME_HAL_USB_ADAPTER_H

#include "usb_ops.h"

/* Room for the replies that nobody has fetched yet: for all frames that the credits allow. */
enum { USB_OUTPUT_BYTES = USB_CREDITS_MOST * USB_REPLY_MOST };

/* An adapter. Copyable; no pointers into itself. About 11 KB. */
struct usb_adapter {
    struct bus *bus; /* where the board is */
    uint16_t
        base_served; /* the base address that the board's jumper sets; 0: any that is offered */

    uint32_t session; /* 0: none since power-on */
    uint32_t last;    /* sequence of the last RUN that was run; 0: none */
    uint16_t base;    /* of the session */
    struct usb_memory memory;
    uint16_t data_count; /* what the last RUN read, for its duplicates */
    uint8_t data[USB_READ_MOST];

    uint16_t input_count;
    uint8_t input[USB_FRAME_MOST];
    uint16_t output_count;
    uint8_t output[USB_OUTPUT_BYTES];

    uint32_t frames_run, duplicates, damaged; /* counters since power-on */
};

/* Powers the adapter on, without a session. base_served: 00D0h, 02D0h ... 0CD0h, or 0 for all of
 * them. */
void usb_adapter_init(struct usb_adapter *adapter, struct bus *bus, uint16_t base_served);

/* Drops partial input and unfetched replies: the cable was pulled, or the USB reset came. The
 * session stays. */
void usb_adapter_detach(struct usb_adapter *adapter);

/* Takes bytes of the stream and runs the frames that they complete. Up to USB_FRAME_MOST bytes wait
 * while there is no room for one more of the largest replies. Waiting bytes are worked off as
 * replies are fetched. Returns how many bytes were taken: fewer than count only while
 * USB_CREDITS_MOST replies or more are to be fetched. */
size_t usb_adapter_receive(struct usb_adapter *adapter, const uint8_t *bytes, size_t count);

/* Moves up to room bytes of replies to bytes; returns how many. */
size_t usb_adapter_fetch(struct usb_adapter *adapter, uint8_t *bytes, size_t room);

#endif
