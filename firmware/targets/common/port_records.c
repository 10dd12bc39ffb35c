/* SPDX-License-Identifier: MIT */
/* outp() and its siblings as records of five bytes. */
#include "port_records.h"

#include "outp.h"
#include "sink.h"

enum { RECORD_BYTES = 5, RECORDS = 50 };

/* The only memory of a target that outlives a call, besides its stack. */
static uint8_t buffer[RECORD_BYTES * RECORDS];
static uint16_t used;

void port_records_flush(void) {
    sink_write(buffer, used);
    used = 0;
}

static void record(uint16_t port, uint8_t width, uint16_t value) {
    uint8_t *bytes = &buffer[used];
    bytes[0] = (uint8_t)port;
    bytes[1] = (uint8_t)(port >> 8);
    bytes[2] = width;
    bytes[3] = (uint8_t)value;
    bytes[4] = (uint8_t)(value >> 8);
    used += RECORD_BYTES;
    if (used == sizeof buffer) {
        port_records_flush();
    }
}

void outp(uint16_t port, uint8_t value) {
    record(port, 1, value);
}

void outpw(uint16_t port, uint16_t value) {
    record(port, 2, value);
}

/* Returns FFh, because nobody answers. */
uint8_t inp(uint16_t port) {
    (void)port;
    return 0xFF;
}

uint16_t inpw(uint16_t port) {
    (void)port;
    return 0xFFFF;
}
