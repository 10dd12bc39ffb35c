/* SPDX-License-Identifier: MIT */
/* What goes over the cable: frames with a checked header, a payload and a CRC, packed and unpacked
 * by both ends. Every byte is in docs/usb-protocol.md. */
#ifndef SUPERFRAME_HAL_USB_WIRE_H
#define SUPERFRAME_HAL_USB_WIRE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum {
    USB_VERSION = 1,
    USB_HEADER_BYTES = 22,
    USB_CHECK_BYTES = 4,
    USB_OVERHEAD = USB_HEADER_BYTES + USB_CHECK_BYTES, /* of a frame, beside its payload */
    USB_PAYLOAD_MOST = 4096,                           /* bytes of ops in one frame */
    USB_FRAME_MOST = USB_OVERHEAD + USB_PAYLOAD_MOST,
    USB_READ_MOST = 510, /* bytes that the reads of one frame may give: 170 pixels */
    USB_REPLY_MOST = USB_OVERHEAD + USB_READ_MOST,
    USB_PAYLOAD_LEAST = 1024,    /* an adapter must take at least so much: the longest op fits */
    USB_CREDITS_MOST = 8,        /* frames that may wait for their replies */
    USB_HELLO_BYTES = 2,         /* payload of a hello */
    USB_HELLO_REPLY_BYTES = 8,   /* payload of its reply */
    USB_REPORT_BYTES = 64,       /* of a HID report */
    USB_REPORT_STREAM_BYTES = 63 /* of these, all but the length */
};

/* What a frame is. */
enum usb_kind {
    USB_KIND_HELLO = 1, /* to the adapter: begin or take up a session */
    USB_KIND_RUN = 2,   /* to the adapter: ops */
    USB_KIND_REPLY = 3  /* from the adapter: exactly one for each of the others */
};

/* Flags of a hello, in the place of the status. */
enum usb_hello_flag { USB_HELLO_START = 1 /* begin this session if it is not the current one */ };

/* What a reply says. */
enum usb_status {
    USB_STATUS_OK = 0,
    USB_STATUS_DUPLICATE,       /* run before: not run again; the reads' data once more */
    USB_STATUS_BAD_CHECK,       /* the CRC does not fit: nothing was run */
    USB_STATUS_BAD_OP,          /* an op that is none, or not whole: nothing was run */
    USB_STATUS_GAP,             /* a frame before it is missing: nothing was run */
    USB_STATUS_UNKNOWN_SESSION, /* the adapter was switched off since: begin anew */
    USB_STATUS_BAD_VERSION,     /* the version is in the reply's header */
    USB_STATUS_BAD_BASE,        /* a base address that the board does not have */
    USB_STATUS_BAD_KIND,
    USB_STATUSES
};

/* What the adapter can do, in the reply to a hello. */
enum usb_capability { USB_CAN_BURST = 1, USB_CAN_COPY = 2, USB_CAN_READ = 4 };

/* A frame's header. */
struct usb_header {
    uint8_t version;   /* USB_VERSION */
    uint8_t kind;      /* enum usb_kind */
    uint32_t session;  /* chosen by the host; 0: none */
    uint32_t sequence; /* of a RUN from 1, and of what the reply answers; 0: a hello's */
    uint32_t last;     /* replies: the last RUN of the session that was run; 0: none */
    uint16_t length;   /* bytes of payload, 0..USB_PAYLOAD_MOST */
    uint8_t status;    /* replies: enum usb_status; hellos: flags */
    uint8_t credits;   /* replies: frames that may be on their way, 1..USB_CREDITS_MOST */
};

/* What an adapter says of itself. */
struct usb_hello_reply {
    uint16_t payload_most; /* bytes of ops that it takes, USB_PAYLOAD_LEAST..USB_PAYLOAD_MOST */
    uint16_t read_most;    /* bytes that it gives in one reply, 3..USB_READ_MOST */
    uint16_t base;         /* of the board's ports */
    uint8_t credits;
    uint8_t capabilities; /* of enum usb_capability */
};

/* Returns the CRC-32 (IEEE 802.3), begun with crc = 0 and continued with what was returned
 * before. */
uint32_t usb_crc(uint32_t crc, const uint8_t *bytes, size_t count);

/* Gets or puts a number as it lies in a frame: the low byte first, 2 or 4 bytes at any address. */
uint16_t usb_get16(const uint8_t *bytes);
uint32_t usb_get32(const uint8_t *bytes);
void usb_put16(uint8_t *bytes, uint16_t value);
void usb_put32(uint8_t *bytes, uint32_t value);

/* Packs a frame: header, payload (header->length bytes, which may lie at frame + USB_HEADER_BYTES
 * already) and CRC. Returns the frame's length. frame has room for USB_OVERHEAD + header->length
 * bytes. */
size_t usb_frame_pack(uint8_t *frame, const struct usb_header *header, const uint8_t *payload);

/* How much of a frame a stream of bytes begins with. */
enum usb_scan {
    USB_SCAN_MORE,    /* the beginning of a frame: more bytes are needed */
    USB_SCAN_FRAME,   /* a whole frame whose CRC fits */
    USB_SCAN_DAMAGED, /* a whole frame whose CRC does not fit */
    USB_SCAN_NOISE    /* no frame begins here */
};

/* Looks at the first bytes of a stream. *header is filled for FRAME and DAMAGED. *length is filled
 * for FRAME, DAMAGED and NOISE: how many bytes to leave out to get on. For DAMAGED these are the
 * bytes before the next place where a frame may begin. So what follows a corrupt frame is not lost
 * with it. */
enum usb_scan usb_frame_scan(const uint8_t *bytes, size_t count, struct usb_header *header,
                             size_t *length);

/* Packs and unpacks the payload of the reply to a hello. Unpacking returns false if there are fewer
 * bytes or a value is out of range. */
void usb_hello_reply_pack(uint8_t bytes[USB_HELLO_REPLY_BYTES],
                          const struct usb_hello_reply *hello);
bool usb_hello_reply_unpack(const uint8_t *bytes, size_t count, struct usb_hello_reply *hello);

/* Packs up to 63 bytes of the same stream into a HID report. Returns how many of count were
 * taken. */
size_t usb_report_pack(uint8_t report[USB_REPORT_BYTES], const uint8_t *bytes, size_t count);

/* Returns how many bytes of the stream follow at report + 1: 0..63, and fewer than size. An invalid
 * length counts as 0. */
size_t usb_report_length(const uint8_t *report, size_t size);

/* Returns one English phrase for a reply's status. */
const char *usb_status_text(uint8_t status);

#endif
