/* SPDX-License-Identifier: MIT */
/* Port traces: what one access is, what the header says, what can be wrong with a file. The bytes
 * are in docs/trace-format.md. */
#ifndef SUPERFRAME_EMULATOR_TRACE_H
#define SUPERFRAME_EMULATOR_TRACE_H

#include "board.h"

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* One access, as the program made it. */
struct trace_access {
    uint16_t port;
    uint16_t value; /* written, or what the read gave */
    uint8_t width;  /* bytes: 1 or 2 */
    bool is_read;
};

/* How a trace lies in its file. */
enum trace_format {
    TRACE_BINARY, /* compact, with checksums */
    TRACE_TEXT    /* one access a line, no header */
};

/* For which board a trace was recorded. */
struct trace_header {
    enum board_profile profile;
    uint16_t base; /* port of control 1 */
};

/* What reading, replaying or comparing came to. */
enum trace_status {
    TRACE_OK = 0,
    TRACE_END,           /* no more accesses; the count and the checksum were right */
    TRACE_IO_ERROR,      /* the file could not be read */
    TRACE_NOT_TRACE,     /* empty, or another kind of file */
    TRACE_LATER_VERSION, /* written by a later version of the format */
    TRACE_WRONG_PROFILE, /* recorded for another profile than asked for */
    TRACE_WRONG_BASE,    /* recorded at another base than asked for */
    TRACE_TRUNCATED,     /* the file ends before the trace does */
    TRACE_CORRUPT,       /* a checksum or a count is wrong, or bytes follow the end */
    TRACE_BAD_LINE,      /* a line of the text form can't be read */
    TRACE_BUS_FAILED     /* the bus that a trace is replayed into failed: see its status */
};

enum { TRACE_MESSAGE_SIZE = 160 };

/* What is wrong, where, and what is allowed. */
struct trace_error {
    enum trace_status status;
    uint64_t line;   /* of the text form, from 1; 0: the place is an offset */
    uint64_t offset; /* bytes from the start of the file */
    char message[TRACE_MESSAGE_SIZE];
};

/* Writes "NAME:LINE: message" or "NAME: byte OFFSET: message" as snprintf() does, and returns what
 * snprintf() returns. */
int trace_error_format(char *text, size_t size, const char *name, const struct trace_error *error);

/* Tells whether two accesses are the same in every field. */
bool trace_access_equal(const struct trace_access *a, const struct trace_access *b);

/* ---- The plain-text form -------------------------------------------------------------------- */

enum { TRACE_TEXT_SIZE = 16 }; /* room for "out16 00D4 0123" and the 0 after it */

/* Writes an access as one line without its end; returns its length, at most 15. */
unsigned trace_text_format(char text[TRACE_TEXT_SIZE], const struct trace_access *access);

/* What a line of the text form holds. */
enum trace_line { TRACE_LINE_ACCESS, TRACE_LINE_EMPTY, TRACE_LINE_BAD };

/* Reads one line (ended by 0, without its newline). Case and the amount of white space don't
 * matter; # begins a comment. On TRACE_LINE_BAD, message (TRACE_MESSAGE_SIZE bytes) says why and
 * what is allowed. */
enum trace_line trace_text_parse(const char *line, struct trace_access *access, char *message);

#endif
