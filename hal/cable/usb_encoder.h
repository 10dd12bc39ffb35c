/* SPDX-License-Identifier: MIT */
/* From port accesses to the fewest bytes of ops: the host's end. */
#ifndef SUPERFRAME_HAL_USB_ENCODER_H
#define SUPERFRAME_HAL_USB_ENCODER_H

#include "usb_ops.h"

enum {
    USB_WAY_SAME,
    USB_WAY_COPY,
    USB_WAY_PIXELS,                     /* and mask - 1 */
    USB_WAY_PAIRS = USB_WAY_PIXELS + 7, /* and mask - 1 */
    USB_WAY_PLANES = USB_WAY_PAIRS + 7,
    USB_WAYS
};

/* The best way of each run of pixels: shortest paths over the ways of sending them. */
struct usb_plan {
    uint32_t cost[BOARD_WIDTH + 1][USB_WAYS];  /* eighths of a byte */
    uint8_t before[BOARD_WIDTH + 1][USB_WAYS]; /* the way that led there */
    uint8_t best[BOARD_WIDTH + 1];
    uint8_t way[BOARD_WIDTH]; /* of each pixel */
};

/* Turns a stream of accesses into payloads. Running the payloads in their order makes the same
 * accesses in the same order. About 64 KB. */
struct usb_encoder {
    struct usb_memory memory; /* the adapter's, once it has run everything up to payload's end */
    size_t payload_most;
    size_t used;
    uint8_t payload[USB_PAYLOAD_MOST];

    /* Takes payload[0..used); called when the next op has no room. The encoder goes on with an
     * empty payload. */
    void (*full)(void *context);
    void *context;

    unsigned stage;              /* accesses of a pixel seen: 0, X, X R, X R G */
    uint16_t x;                  /* of that pixel */
    uint8_t colour[3];           /* so far */
    uint16_t first_x;            /* of the run */
    unsigned count;              /* pixels in the run */
    uint8_t run[BOARD_WIDTH][3]; /* pixels side by side that wait to be encoded */
    struct usb_plan plan;
};

/* Begins a session: memory is empty at both ends. payload_most:
 * USB_PAYLOAD_LEAST..USB_PAYLOAD_MOST. full gets context; full must not be NULL. */
void usb_encoder_init(struct usb_encoder *encoder, size_t payload_most, void (*full)(void *context),
                      void *context);

/* Encodes one write. offset is 0..15 from the board's base. A word at 15 leaves the board: nothing
 * is encoded, and false is returned. */
bool usb_encoder_write(struct usb_encoder *encoder, unsigned offset, uint16_t value,
                       unsigned width);

/* Encodes one read, whose answer comes as 1 or 2 bytes. Nothing waits any more afterwards. Returns
 * false as usb_encoder_write() does. */
bool usb_encoder_read(struct usb_encoder *encoder, unsigned offset, unsigned width);

/* Encodes a read of count pixels (1..170) of the current line from x on, three bytes each. */
void usb_encoder_read_pixels(struct usb_encoder *encoder, uint16_t x, unsigned count);

/* Puts into the payload what still waits. */
void usb_encoder_flush(struct usb_encoder *encoder);

#endif
