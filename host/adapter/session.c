/* SPDX-License-Identifier: MIT */
/* A session with an adapter: sends frames with credits, takes replies, and sends what was lost
 * again. After the cable was pulled, the session is taken up or begun anew. */
#include "adapter/bus_internal.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/stopwatch.h"
#include "splitmix64.h"

enum { REOPEN_SLICE_MS = 200, JOURNAL_MOST = 256 << 20 };

void usb_bus_give_up(struct usb_bus *usb_bus, enum bus_status status, const char *format, ...) {
    if (usb_bus->bus.status == BUS_OK) {
        va_list arguments;
        va_start(arguments, format);
        (void)vsnprintf(usb_bus->reason, sizeof usb_bus->reason, format, arguments);
        va_end(arguments);
    }
    bus_fail(&usb_bus->bus, status);
}

static bool has_failed(const struct usb_bus *usb_bus) {
    return usb_bus->bus.status != BUS_OK;
}

/* Notes that something went on: patience begins anew. */
static void note_progress(struct usb_bus *usb_bus) {
    usb_bus->failures = 0;
    usb_bus->waiting_since = stopwatch_start();
}

/* ---- The journal --------------------------------------------------------------------------- */

static bool grow(void **memory, size_t *size, size_t wanted, size_t item) {
    if (wanted <= *size) {
        return true;
    }
    size_t grown = wanted + wanted / 2 + 64;
    void *moved = realloc(*memory, grown * item);
    if (moved == NULL) {
        return false;
    }
    *memory = moved;
    *size = grown;
    return true;
}

static bool remember(struct usb_bus *usb_bus, const uint8_t *payload, size_t count) {
    struct usb_journal *journal = &usb_bus->journal;
    void *bytes = journal->bytes, *ends = journal->ends;
    bool has_room = journal->used + count <= JOURNAL_MOST &&
                    grow(&bytes, &journal->size, journal->used + count, 1);
    has_room = has_room &&
               grow(&ends, &journal->ends_size, (size_t)usb_bus->sealed + 1, sizeof *journal->ends);
    journal->bytes = bytes;
    journal->ends = ends;
    if (!has_room) {
        usb_bus_give_up(usb_bus, BUS_IO_ERROR, "no memory for what may have to be sent again");
        return false;
    }
    memcpy(journal->bytes + journal->used, payload, count);
    journal->used += count;
    journal->ends[usb_bus->sealed++] = journal->used;
    return true;
}

/* ---- Sending ------------------------------------------------------------------------------- */

/* Does what is needed after a call of the link. Returns true if the call went well and the bus did
 * not fail. */
static bool recover(struct usb_bus *usb_bus, enum usb_link_status status);

static enum usb_link_status send_one(struct usb_bus *usb_bus, uint32_t sequence) {
    uint8_t frame[USB_FRAME_MOST];
    const struct usb_journal *journal = &usb_bus->journal;
    size_t begin = sequence == 1 ? 0 : journal->ends[sequence - 2];
    size_t count = journal->ends[sequence - 1] - begin;
    const struct usb_header header = {
        USB_VERSION, USB_KIND_RUN, usb_bus->session, sequence, 0, (uint16_t)count, 0, 0};
    size_t length = usb_frame_pack(frame, &header, journal->bytes + begin);
    usb_bus->counts.sent_bytes += length;
    if (sequence <= usb_bus->highest_sent) {
        usb_bus->counts.resent++;
    } else {
        usb_bus->highest_sent = sequence;
    }
    return usb_bus->link->operations->send(usb_bus->link, frame, length);
}

static void go_back(struct usb_bus *usb_bus) {
    usb_bus->sent = usb_bus->acked;
}

/* Sends what the credits allow. Returns false if something got in between: what is in flight is
 * then unknown. */
static bool fill_window(struct usb_bus *usb_bus) {
    while (!has_failed(usb_bus) && usb_bus->sent < usb_bus->sealed &&
           usb_bus->sent - usb_bus->acked < usb_bus->credits) {
        usb_bus->sent++;
        if (!recover(usb_bus, send_one(usb_bus, usb_bus->sent))) {
            return false;
        }
    }
    return !has_failed(usb_bus);
}

/* ---- Replies ------------------------------------------------------------------------------- */

static void take_run_reply(struct usb_bus *usb_bus, const struct usb_header *header,
                           const uint8_t *payload) {
    if (header->last > usb_bus->highest_sent) {
        usb_bus_give_up(usb_bus, BUS_PROTOCOL,
                        "the adapter says that it ran frame %lu, but only %lu were sent",
                        (unsigned long)header->last, (unsigned long)usb_bus->highest_sent);
        return;
    }
    if (header->last > usb_bus->acked) {
        usb_bus->acked = header->last;
        note_progress(usb_bus);
        usb_bus->is_gap_known = false;
        if (usb_bus->sent < usb_bus->acked) {
            usb_bus->sent = usb_bus->acked;
        }
    }
    bool is_run = header->status == USB_STATUS_OK || header->status == USB_STATUS_DUPLICATE;
    if (is_run && header->sequence == usb_bus->awaited &&
        header->length == usb_bus->awaited_count) {
        memcpy(usb_bus->data, payload, header->length);
        usb_bus->has_data = true;
    } else if (header->status == USB_STATUS_BAD_CHECK || header->status == USB_STATUS_GAP) {
        /* Each frame behind a lost one is answered by a gap: going back once is enough. Should the
         * frame be lost again, no reply comes, and the timeout does the rest. */
        if (!usb_bus->is_gap_known) {
            usb_bus->is_gap_known = true;
            go_back(usb_bus);
        }
    } else if (!is_run) {
        usb_bus_give_up(usb_bus, BUS_PROTOCOL, "the adapter refused a frame: %s",
                        usb_status_text(header->status));
    }
}

static void take_reply(struct usb_bus *usb_bus, const struct usb_header *header,
                       const uint8_t *payload) {
    if (header->kind != USB_KIND_REPLY) {
        return;
    }
    if (header->version != USB_VERSION || header->status == USB_STATUS_BAD_VERSION) {
        usb_bus_give_up(usb_bus, BUS_PROTOCOL,
                        "the adapter speaks version %u of the protocol; allowed is %u",
                        header->version, (unsigned)USB_VERSION);
        return;
    }
    if (header->sequence == 0) {
        if (header->status == USB_STATUS_OK && header->session != usb_bus->session) {
            return; /* the reply to a hello from long ago */
        }
        usb_bus->is_greeted = usb_hello_reply_unpack(payload, header->length, &usb_bus->greeting);
        usb_bus->greeting_status = header->status;
        usb_bus->greeting_last = header->last;
    } else if (header->session == usb_bus->session) {
        take_run_reply(usb_bus, header, payload);
    } else if (header->status == USB_STATUS_UNKNOWN_SESSION) {
        usb_bus->must_ask = true; /* or a reply from long ago: the hello will tell */
    }
}

static void take_input(struct usb_bus *usb_bus) {
    size_t begin = 0;
    for (;;) {
        struct usb_header header;
        size_t length = 0;
        const uint8_t *bytes = usb_bus->input + begin;
        enum usb_scan scan = usb_frame_scan(bytes, usb_bus->input_count - begin, &header, &length);
        if (scan == USB_SCAN_MORE) {
            break;
        }
        if (scan == USB_SCAN_FRAME) {
            take_reply(usb_bus, &header, bytes + USB_HEADER_BYTES);
        }
        begin += length;
    }
    usb_bus->input_count -= begin;
    memmove(usb_bus->input, usb_bus->input + begin, usb_bus->input_count);
}

/* ---- Waiting ------------------------------------------------------------------------------- */

/* Waits for one answer of the link, at most timeout_ms, and takes the answer. */
static enum usb_link_status listen(struct usb_bus *usb_bus, unsigned timeout_ms) {
    size_t count = 0;
    enum usb_link_status status = usb_bus->link->operations->receive(
        usb_bus->link, usb_bus->input + usb_bus->input_count,
        sizeof usb_bus->input - usb_bus->input_count, timeout_ms, &count);
    if (status == USB_LINK_OK) {
        usb_bus->counts.received_bytes += count;
        usb_bus->input_count += count;
        take_input(usb_bus);
        /* An adapter that never falls silent would never be found to give no answer. */
        if (stopwatch_seconds(&usb_bus->waiting_since) * 1000 >
            (double)usb_bus->limits.reply_ms * (usb_bus->limits.retries + 1)) {
            usb_bus_give_up(usb_bus, BUS_TIMEOUT, "the adapter talks, but does not answer");
        }
    }
    return status;
}

/* Counts a failure. Returns false, with the bus failed, when there are too many in a row. */
static bool may_try_again(struct usb_bus *usb_bus, enum bus_status status, const char *what) {
    usb_bus->failures++;
    if (usb_bus->failures > usb_bus->limits.retries) {
        usb_bus_give_up(usb_bus, status, "%s, %u times in a row", what, usb_bus->limits.retries);
        return false;
    }
    return true;
}

/* Sends a hello and waits for its reply. Returns the link's status. OK with is_greeted false means
 * that the bus failed. */
static enum usb_link_status greet(struct usb_bus *usb_bus, bool is_start) {
    uint8_t frame[USB_OVERHEAD + USB_HELLO_BYTES], payload[USB_HELLO_BYTES];
    const struct usb_header header = {USB_VERSION,
                                      USB_KIND_HELLO,
                                      usb_bus->session,
                                      0,
                                      0,
                                      USB_HELLO_BYTES,
                                      is_start ? USB_HELLO_START : 0,
                                      0};
    usb_put16(payload, usb_bus->base);
    size_t length = usb_frame_pack(frame, &header, payload);
    usb_bus->is_greeted = false;
    usb_bus->waiting_since = stopwatch_start();
    while (!has_failed(usb_bus)) {
        usb_bus->counts.sent_bytes += length;
        enum usb_link_status status = usb_bus->link->operations->send(usb_bus->link, frame, length);
        while (status == USB_LINK_OK && !usb_bus->is_greeted && !has_failed(usb_bus)) {
            status = listen(usb_bus, usb_bus->limits.reply_ms);
        }
        if (usb_bus->is_greeted || status == USB_LINK_LOST) {
            return status;
        }
        usb_bus->counts.timeouts += status == USB_LINK_TIMEOUT;
        usb_bus->counts.stalls += status == USB_LINK_STALLED;
        if (!has_failed(usb_bus) &&
            !may_try_again(usb_bus, BUS_TIMEOUT, "the adapter does not answer a hello")) {
            break;
        }
    }
    return USB_LINK_OK;
}

/* Makes a session that the adapter has never heard of: everything is sent again from the
 * beginning. */
static void new_session(struct usb_bus *usb_bus) {
    do {
        usb_bus->session = (uint32_t)splitmix64(&usb_bus->random);
    } while (usb_bus->session == 0);
    usb_bus->acked = usb_bus->sent = usb_bus->highest_sent = 0;
}

/* Tells whether the greeting lets the session go on where it is. Otherwise the bus failed, or
 * *must_restart is set. */
static bool can_go_on(struct usb_bus *usb_bus, bool *must_restart) {
    const struct usb_hello_reply *greeting = &usb_bus->greeting;
    *must_restart = false;
    if (usb_bus->greeting_status == USB_STATUS_UNKNOWN_SESSION) {
        *must_restart = true;
        return false;
    }
    if (usb_bus->greeting_status != USB_STATUS_OK) {
        usb_bus_give_up(usb_bus, BUS_PROTOCOL, "%s: it has %04X, asked for was %04X",
                        usb_status_text(usb_bus->greeting_status), greeting->base, usb_bus->base);
        return false;
    }
    /* The reply to an earlier hello, or an adapter that lost or made up frames. */
    if (usb_bus->greeting_last < usb_bus->acked || usb_bus->greeting_last > usb_bus->highest_sent) {
        *must_restart = true;
        return false;
    }
    usb_bus->acked = usb_bus->sent = usb_bus->greeting_last;
    usb_bus->credits = greeting->credits;
    usb_bus->read_most = greeting->read_most;
    if (usb_bus->encoder.payload_most > greeting->payload_most) {
        usb_bus_give_up(usb_bus, BUS_PROTOCOL,
                        "the adapter came back with smaller buffers: %u bytes; allowed is %u",
                        greeting->payload_most, (unsigned)usb_bus->encoder.payload_most);
        return false;
    }
    return true;
}

/* Asks the adapter where the session stands, and begins anew if the adapter does not know. Returns
 * the link's status. */
static enum usb_link_status take_up(struct usb_bus *usb_bus) {
    bool is_start = false, must_restart;
    for (;;) {
        usb_bus->must_ask = false;
        usb_bus->is_gap_known = false;
        enum usb_link_status status = greet(usb_bus, is_start);
        if (status != USB_LINK_OK || has_failed(usb_bus)) {
            return status;
        }
        if (can_go_on(usb_bus, &must_restart) || !must_restart) {
            return USB_LINK_OK;
        }
        if (usb_bus->counts.restarts >= usb_bus->limits.restarts) {
            usb_bus_give_up(usb_bus, BUS_LOST,
                            "the adapter was switched off in between; after %u new beginnings it "
                            "is given up",
                            usb_bus->limits.restarts);
            return USB_LINK_OK;
        }
        usb_bus->counts.restarts++;
        new_session(usb_bus);
        is_start = true;
    }
}

/* Waits for the adapter to be plugged in again. Returns false, with the bus failed, if it was
 * not. */
static bool reopen(struct usb_bus *usb_bus) {
    unsigned waited = 0;
    while (waited < usb_bus->limits.reopen_ms &&
           !(usb_bus->limits.stop != NULL && *usb_bus->limits.stop != 0)) {
        unsigned left = usb_bus->limits.reopen_ms - waited;
        unsigned slice = left < REOPEN_SLICE_MS ? left : REOPEN_SLICE_MS;
        if (usb_bus->link->operations->reopen(usb_bus->link, slice) == USB_LINK_OK) {
            usb_bus->counts.reconnects++;
            usb_bus->input_count = 0;
            return true;
        }
        waited += slice;
    }
    usb_bus_give_up(usb_bus, BUS_LOST, "the adapter went away%s%s%s",
                    usb_bus->link->reason[0] != '\0' ? " (" : "", usb_bus->link->reason,
                    usb_bus->link->reason[0] != '\0' ? ")" : "");
    return false;
}

static bool recover(struct usb_bus *usb_bus, enum usb_link_status status) {
    if (status == USB_LINK_OK) {
        return !has_failed(usb_bus);
    }
    usb_bus->is_gap_known = false;
    if (status != USB_LINK_LOST) {
        usb_bus->counts.timeouts += status == USB_LINK_TIMEOUT;
        usb_bus->counts.stalls += status == USB_LINK_STALLED;
        go_back(usb_bus);
        (void)may_try_again(usb_bus, BUS_TIMEOUT, "the adapter does not answer");
        return false;
    }
    do {
        if (!may_try_again(usb_bus, BUS_LOST, "the adapter went away") || !reopen(usb_bus)) {
            return false;
        }
    } while (take_up(usb_bus) == USB_LINK_LOST && !has_failed(usb_bus));
    return false;
}

/* Goes one step on: sends what may be sent, waits for one answer. */
static void step(struct usb_bus *usb_bus) {
    if (!fill_window(usb_bus)) {
        return;
    }
    (void)recover(usb_bus, listen(usb_bus, usb_bus->limits.reply_ms));
    if (usb_bus->must_ask && !has_failed(usb_bus)) {
        (void)recover(usb_bus, take_up(usb_bus));
    }
}

bool usb_session_begin(struct usb_bus *usb_bus) {
    usb_bus->random = usb_bus->limits.seed;
    usb_bus->credits = 1;
    usb_bus->encoder.payload_most = USB_PAYLOAD_LEAST;
    new_session(usb_bus);
    enum usb_link_status status = greet(usb_bus, true);
    bool must_restart = false;
    if (status == USB_LINK_LOST) {
        (void)recover(usb_bus, status);
    } else if (!has_failed(usb_bus) && !can_go_on(usb_bus, &must_restart) && must_restart) {
        (void)recover(usb_bus, take_up(usb_bus));
    }
    return !has_failed(usb_bus);
}

void usb_session_seal(struct usb_bus *usb_bus) {
    const struct usb_encoder *encoder = &usb_bus->encoder;
    if (has_failed(usb_bus) || encoder->used == 0 ||
        !remember(usb_bus, encoder->payload, encoder->used)) {
        return;
    }
    usb_bus->waiting_since = stopwatch_start();
    usb_bus->counts.frames++;
    usb_bus->counts.payload_bytes += encoder->used;
    if (fill_window(usb_bus)) {
        /* Looks at what has come meanwhile, so that what is known to have arrived is up to date. */
        enum usb_link_status status = listen(usb_bus, 0);
        if (status != USB_LINK_TIMEOUT) {
            (void)recover(usb_bus, status);
        }
    }
    while (!has_failed(usb_bus) && usb_bus->sent < usb_bus->sealed) {
        step(usb_bus);
    }
}

bool usb_session_finish(struct usb_bus *usb_bus) {
    usb_bus->waiting_since = stopwatch_start();
    while (!has_failed(usb_bus) && usb_bus->acked < usb_bus->sealed) {
        step(usb_bus);
    }
    return !has_failed(usb_bus);
}

bool usb_session_ask(struct usb_bus *usb_bus, size_t count) {
    usb_bus->awaited = usb_bus->sealed + 1;
    usb_bus->awaited_count = count;
    usb_bus->has_data = false;
    usb_session_seal(usb_bus);
    usb_bus->encoder.used = 0;
    for (unsigned tries = 0; !has_failed(usb_bus) && !usb_bus->has_data;) {
        if (usb_bus->acked >= usb_bus->awaited) {
            if (tries++ > usb_bus->limits.retries) {
                usb_bus_give_up(usb_bus, BUS_PROTOCOL, "the adapter ran a read, but gives no data");
                break;
            }
            /* The frame was run, but its data got lost on the way: a duplicate brings the data once
             * more. */
            usb_bus->sent = usb_bus->awaited - 1;
            usb_bus->acked = usb_bus->awaited - 1;
        }
        step(usb_bus);
    }
    usb_bus->awaited = 0;
    return !has_failed(usb_bus);
}
