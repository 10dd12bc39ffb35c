/* SPDX-License-Identifier: MIT */
/* A payload's operations, what both ends remember of the pixels, and how a payload is checked and
 * run on a bus. */
#ifndef SUPERFRAME_HAL_USB_OPS_H
#define SUPERFRAME_HAL_USB_OPS_H

#include "board_ports.h"
#include "bus.h"
#include "usb_wire.h"

/* "A pixel" here is always the same four accesses: X as a word, then R, G and B as bytes. A count
 * is a number of pixels, 1..BOARD_WIDTH; next_x, colour and line are struct usb_memory's. */
enum usb_op {
    USB_OP_WRITE_BYTE = 0x00,  /* | offset; value */
    USB_OP_WRITE_WORD = 0x10,  /* | offset; low, high */
    USB_OP_READ_BYTE = 0x20,   /* | offset; one byte in the reply */
    USB_OP_READ_WORD = 0x30,   /* | offset; two bytes in the reply */
    USB_OP_SEEK = 0x40,        /* low, high: next_x, without an access */
    USB_OP_NEXT_LINE = 0x41,   /* Y := the last Y + 1, next_x := 0 */
    USB_OP_SAME = 0x42,        /* count low, high: pixels of the last colour */
    USB_OP_COPY = 0x43,        /* count low, high: pixels as last drawn at the same X */
    USB_OP_READ_PIXELS = 0x44, /* count - 1: X written, R, G, B read; three bytes each */
    USB_OP_PLANES = 0x45,      /* count low, high; for each 8 pixels three bytes: red, green, blue.
                                  A bit a pixel, bit 0 first; 1: FFh, 0: 00h */
    USB_OP_SAME_FEW = 0x50,    /* | count - 1 */
    USB_OP_COPY_FEW = 0x60,    /* | count - 1 */
    USB_OP_PIXELS = 0x80, /* | mask (1 red, 2 green, 4 blue); count - 1; each pixel's primaries in
                             the mask. The others are as in the pixel before */
    USB_OP_PAIRS = 0x88   /* | mask; count - 1; as USB_OP_PIXELS, and each pixel twice */
};

enum { USB_FEW_MOST = 16, USB_PIXELS_MOST = 256 /* of one USB_OP_PIXELS */ };

/* What both ends remember of a session. All zero at its beginning. A word written to Y, by an op
 * or plainly, sets next_x to 0. */
struct usb_memory {
    uint16_t next_x;              /* where the next pixel goes */
    uint16_t y;                   /* the last word written to Y */
    uint8_t colour[3];            /* of the last pixel: R, G, B */
    uint8_t line[BOARD_WIDTH][3]; /* the last pixel drawn at each X */
};

/* Forgets everything: a session begins. */
void usb_memory_clear(struct usb_memory *memory);

/* Notes a pixel at next_x. */
void usb_memory_pixel(struct usb_memory *memory, const uint8_t colour[3]);

/* Notes a plain write. offset: 0..15 from the board's base; width: 1 or 2 bytes. */
void usb_memory_write(struct usb_memory *memory, unsigned offset, uint16_t value, unsigned width);

/* Checks that a payload holds nothing but whole, known ops, with counts in range, and that its
 * reads fit into a reply. *reads gets the bytes that the reads will give. next_x is memory's. */
bool usb_ops_check(const struct usb_memory *memory, const uint8_t *ops, size_t count,
                   size_t *reads);

/* Runs a payload that usb_ops_check() has passed with the same memory. data gets what was read
 * (room for USB_READ_MOST bytes). Returns how many bytes were read. No port outside base..base + 15
 * is touched. */
size_t usb_ops_run(struct usb_memory *memory, struct bus *bus, uint16_t base, const uint8_t *ops,
                   size_t count, uint8_t *data);

#endif
