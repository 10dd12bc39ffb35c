/* SPDX-License-Identifier: MIT */
/* Records port accesses to a file on their way to another bus. */
#ifndef SUPERFRAME_EMULATOR_TRACE_RECORDER_H
#define SUPERFRAME_EMULATOR_TRACE_RECORDER_H

#include "bus.h"
#include "trace.h"
#include "trace_model.h"

#include <stdio.h>

enum { TRACE_BUFFER_SIZE = TRACE_BLOCK_HEADER_SIZE + TRACE_PAYLOAD_LIMIT + TRACE_CHECKSUM_SIZE };

/* The recorder; about 66 KB. */
struct trace_recorder {
    struct bus bus;    /* the first member */
    struct bus *inner; /* where the accesses go */
    FILE *file;
    uint16_t base;
    uint32_t used;           /* bytes of the buffer; in a binary block, its 8 of header included */
    uint32_t control;        /* where the current control byte is */
    uint32_t block_accesses; /* in the buffer */
    uint64_t accesses;       /* in all */
    uint64_t checksum;       /* of the block before: the seed of the next */
    int error_number;        /* errno of the write that failed; 0: none did */
    struct trace_model model;
    uint8_t buffer[TRACE_BUFFER_SIZE];
};

/* Begins a trace in file, which stays the caller's, and passes every access on to inner, which must
 * not be NULL. *header must be valid for the text form too: a comment in the first line holds the
 * header. The bus fails with BUS_IO_ERROR when the file can't be written, and as inner does when
 * inner fails. */
void trace_recorder_init(struct trace_recorder *recorder, struct bus *inner, FILE *file,
                         enum trace_format format, const struct trace_header *header);

/* Ends the trace: without its end the file counts as truncated. Flushes the file, not inner;
 * returns the status of the recording. No access may follow. */
enum bus_status trace_recorder_finish(struct trace_recorder *recorder);

#endif
