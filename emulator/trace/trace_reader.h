/* SPDX-License-Identifier: MIT */
/* Reads a trace, binary or text, an access at a time. */
#ifndef SUPERFRAME_EMULATOR_TRACE_READER_H
#define SUPERFRAME_EMULATOR_TRACE_READER_H

#include "trace.h"
#include "trace_model.h"

#include <stdio.h>

/* The reader; about 66 KB. */
struct trace_reader {
    FILE *file;
    enum trace_format format;
    struct trace_header header; /* of the binary form; the text form has none */
    bool has_header;
    uint64_t accesses;        /* given out so far: the number of the last one */
    struct trace_error error; /* status TRACE_OK or TRACE_END: nothing is wrong */

    /* The rest is the reader's own. */
    uint64_t line;
    uint64_t offset; /* of the next byte of the file */
    uint64_t block_offset;
    uint64_t checksum;
    uint32_t used, size;                 /* of the payload */
    uint32_t block_accesses, block_done; /* accesses of the block; given out */
    uint8_t control;
    struct trace_model model;
    uint8_t block[TRACE_BLOCK_HEADER_SIZE + TRACE_PAYLOAD_LIMIT];
};

/* Begins to read file, which stays the caller's. The first byte tells the binary form from the text
 * form; the header of the binary form is checked. Returns TRACE_OK, or what error.status says. */
enum trace_status trace_reader_open(struct trace_reader *reader, FILE *file);

/* Refuses a binary trace that was recorded for another board. A text trace fits any. */
enum trace_status trace_reader_require(struct trace_reader *reader,
                                       const struct trace_header *header);

/* Gives the next access. Returns TRACE_OK, or TRACE_END after the last access, or what is wrong,
 * which also stays in reader->error. A block is given out only after its checksum was found
 * right. */
enum trace_status trace_reader_next(struct trace_reader *reader, struct trace_access *access);

#endif
