/* SPDX-License-Identifier: MIT */
/* What a port trace costs on the cable: usb_bytes NAME TRACE prints a row of docs/usb-bytes.md. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "trace_replay.h"
#include "usb_encoder.h"

/* Bytes a second that a cable carries at most: full packets, nothing else on the bus (USB 2.0,
 * tables 5-9 and 5-10; a report a frame or microframe). */
enum {
    BULK_FULL_SPEED = 19 * 64 * 1000,
    BULK_HIGH_SPEED = 13 * 512 * 8000,
    HID_FULL_SPEED = USB_REPORT_STREAM_BYTES * 1000,
    HID_HIGH_SPEED = USB_REPORT_STREAM_BYTES * 8000
};

/* Counts frames instead of sending them. */
struct counter {
    struct bus bus; /* the first member */
    uint64_t pixels, frames, bytes;
    struct usb_encoder encoder;
};

static void count_frame(void *context) {
    struct counter *counter = context;
    counter->frames++;
    counter->bytes += USB_OVERHEAD + counter->encoder.used;
}

static void write_port(struct bus *bus, uint16_t port, uint16_t value, unsigned width) {
    struct counter *counter = (struct counter *)bus;
    unsigned offset = port & 15U;
    counter->pixels += offset == BOARD_BLUE;
    if (!usb_encoder_write(&counter->encoder, offset, value, width)) {
        bus_fail(bus, BUS_REFUSED);
    }
}

static uint16_t read_port(struct bus *bus, uint16_t port, unsigned width) {
    (void)port;
    (void)width;
    bus_fail(bus, BUS_REFUSED); /* what a read costs is a matter of time, not of bytes */
    return 0;
}

int main(int argc, char **argv) {
    static const struct bus_operations operations = {write_port, read_port, NULL};
    static struct trace_reader reader;
    static struct counter counter;
    struct trace_replay replay;
    FILE *file = argc == 3 ? fopen(argv[2], "rb") : NULL;
    if (file == NULL) {
        (void)fprintf(stderr, "usage: usb_bytes NAME TRACE\n");
        return 2;
    }
    memset(&replay, 0, sizeof replay);
    counter.bus.operations = &operations;
    usb_encoder_init(&counter.encoder, USB_PAYLOAD_MOST, count_frame, &counter);
    bool is_whole = trace_reader_open(&reader, file) == TRACE_OK &&
                    trace_replay(&reader, &counter.bus, 0, &replay) == TRACE_END;
    (void)fclose(file);
    if (!is_whole || counter.pixels == 0) {
        (void)fprintf(stderr, "usb_bytes: %s: no whole trace of a picture: %s\n", argv[2],
                      reader.error.message);
        return 1;
    }
    usb_encoder_flush(&counter.encoder);
    count_frame(&counter);
    double bytes = (double)counter.bytes;
    (void)printf("| %s | %llu | %.0f | %.3f | %.2f | %.3f | %.2f | %.2f |\n", argv[1],
                 (unsigned long long)counter.pixels, bytes, bytes / (double)counter.pixels,
                 bytes / BULK_FULL_SPEED, bytes / BULK_HIGH_SPEED, bytes / HID_FULL_SPEED,
                 bytes / HID_HIGH_SPEED);
    return 0;
}
