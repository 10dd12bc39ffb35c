/* SPDX-License-Identifier: MIT */
/* The ports at the end of a cable: a bus that sends its accesses to an adapter, each exactly once,
 * in order. The bus knows which lines of the picture have arrived. */
#ifndef SUPERFRAME_USB_BUS_H
#define SUPERFRAME_USB_BUS_H

#include <signal.h>
#include <time.h>

#include "adapter/link.h"
#include "board.h"
#include "bus.h"
#include "usb_encoder.h"

/* How patient the bus is. All waits are bounded: the bus ends with an error, never in an endless
 * wait. */
struct usb_limits {
    unsigned reply_ms;  /* for a reply, before the frame is sent again; 1.. */
    unsigned retries;   /* sendings without any progress before it is given up; 1.. */
    unsigned reopen_ms; /* for the adapter to come back after it was lost; 0: not at all */
    unsigned restarts;  /* of the whole session, for an adapter that was switched off; 0: none */
    uint64_t seed;      /* of the session's number: different in each run */
    const volatile sig_atomic_t
        *stop; /* not zero: no more waiting for a lost adapter. NULL: none */
};

/* What sending and receiving took. */
struct usb_counts {
    uint64_t frames;        /* made of the accesses */
    uint64_t payload_bytes; /* in them */
    uint64_t sent_bytes;    /* with headers and CRCs, each sending counted */
    uint64_t received_bytes;
    uint64_t resent; /* frames sent more than once, each sending after the first */
    uint64_t timeouts, stalls, reconnects, restarts;
};

enum { USB_REASON_SIZE = 384 };

/* Frames that were made, so that they can be sent again. */
struct usb_journal {
    uint8_t *bytes;
    size_t used, size;
    size_t *ends; /* of frame i in bytes */
    size_t ends_size;
};

/* About a megabyte and a half: make it with usb_bus_new(). Fields are for reading. */
struct usb_bus {
    struct bus bus; /* the first member */
    struct usb_link *link;
    struct usb_limits limits;
    struct usb_counts counts;
    uint16_t base;
    char reason[USB_REASON_SIZE]; /* why the bus failed; "" if it did not */

    uint64_t random;
    uint32_t session;
    uint32_t sealed;       /* frames made; they are numbered from 1 */
    uint32_t sent, acked;  /* the last one sent, the last one known to have been run */
    uint32_t highest_sent; /* in this session */
    unsigned credits, failures;
    struct timespec waiting_since; /* for something that brings the session on */
    unsigned read_most;
    bool is_gap_known; /* a gap after acked has been seen: its further replies say nothing new */
    bool must_ask;     /* a reply did not know the session */
    struct usb_journal journal;

    uint32_t awaited; /* the frame whose data is waited for; 0: none */
    size_t awaited_count;
    bool has_data;
    uint8_t data[USB_READ_MOST];

    bool is_greeted; /* the reply to a hello has come */
    uint8_t greeting_status;
    uint32_t greeting_last;
    struct usb_hello_reply greeting;

    size_t input_count;
    uint8_t input[USB_FRAME_MOST + USB_REPLY_MOST];

    /* What was drawn, as far as it is known from the writes alone. */
    uint16_t x, y;
    uint32_t line_frame[BOARD_HEIGHT]; /* the last frame with something of the line; 0: none */
    uint8_t drawn[BOARD_HEIGHT][BOARD_WIDTH];
    uint8_t pixels[BOARD_HEIGHT][BOARD_WIDTH][3];

    struct usb_encoder encoder;
};

/* Returns the patience for people: a second for a reply, five seconds for a replug. */
struct usb_limits usb_default_limits(void);

/* Greets the adapter behind the link and begins a session. The link stays the caller's. Returns
 * NULL if memory is out. Anything else that goes wrong is in bus.status and reason. */
struct usb_bus *usb_bus_new(struct usb_link *link, uint16_t base, const struct usb_limits *limits);

/* Tells whether everything that was written to a line (0..399) is known to have been run. False
 * also where nothing was written. */
bool usb_bus_line_is_there(const struct usb_bus *usb_bus, unsigned line);

/* Frees the bus; harmless on NULL. */
void usb_bus_free(struct usb_bus *usb_bus);

/* What reading back came to. */
struct usb_verification {
    uint64_t pixels;      /* compared */
    uint64_t repaired;    /* differed, were written again, and are correct now */
    unsigned wrong_lines; /* still differ after USB_REPAIRS_MOST repairs */
    unsigned first_wrong; /* the first of these */
};

enum { USB_REPAIRS_MOST = 3 };

/* Reads back the pixels that were drawn and repairs those that differ. percent: 1..100 of the lines
 * that have any, chosen by the seed; 100: all. Moves the X and Y registers. Returns false if the
 * bus failed. */
bool usb_bus_verify(struct usb_bus *usb_bus, unsigned percent, uint64_t seed,
                    struct usb_verification *verification);

#endif
