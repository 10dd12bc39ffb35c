/* SPDX-License-Identifier: MIT */
/* What the recorder and the reader of binary traces share: the layout and the prediction. */
#ifndef SUPERFRAME_EMULATOR_TRACE_MODEL_H
#define SUPERFRAME_EMULATOR_TRACE_MODEL_H

#include "trace.h"

#include <string.h>

enum {
    TRACE_MAGIC_SIZE = 8,
    TRACE_VERSION = 1,
    TRACE_HEADER_SIZE = 24,
    TRACE_BLOCK_HEADER_SIZE = 8,   /* payload length, accesses */
    TRACE_CHECKSUM_SIZE = 8,       /* after the payload */
    TRACE_PAYLOAD_LIMIT = 65536,   /* bytes */
    TRACE_LONGEST_ACCESS = 6,      /* bytes: control, flags, port, value */
    TRACE_END_SIZE = 16,           /* two zeros, the count; the checksum follows */
    TRACE_SLOTS = BOARD_PORTS * 4, /* kinds of access: offset, width, direction */

    /* The codes of an access, two bits each. */
    TRACE_CODE_EXPECTED = 0, /* kind and value as predicted */
    TRACE_CODE_VALUE = 1,    /* kind as predicted; the value follows */
    TRACE_CODE_KIND = 2,     /* the kind and the value follow */
    TRACE_CODE_FOREIGN = 3,  /* flags, port and value follow: outside the board's ports */

    TRACE_FLAG_READ = 1,
    TRACE_FLAG_WORD = 2
};

/* As in PNG: a byte that no text has, the name, and line ends that a text transfer would change. */
static const uint8_t trace_magic[TRACE_MAGIC_SIZE] = {0x89, 'S', 'F', 'T', 0x0D, 0x0A, 0x1A, 0x0A};

/* The access that is expected next. Its kind is the one that followed the last access the
 * last time. A byte is expected to have the same value as before, a word the same step as
 * before. */
struct trace_model {
    uint8_t previous;                /* slot */
    uint8_t next[TRACE_SLOTS];       /* by slot: the slot that followed it */
    uint16_t last[TRACE_SLOTS];      /* by slot: the value */
    uint16_t predicted[TRACE_SLOTS]; /* by slot: the next value */
};

static inline void trace_model_reset(struct trace_model *model) {
    memset(model, 0, sizeof *model);
}

static inline unsigned trace_slot(unsigned offset, unsigned width, bool is_read) {
    return offset * 4 + (width - 1) * 2 + (is_read ? 1U : 0U);
}

/* Learns from an access. */
static inline void trace_model_update(struct trace_model *model, unsigned slot, uint16_t value) {
    unsigned word_mask = 0U - (slot >> 1 & 1U);
    unsigned step = (unsigned)(value - model->last[slot]) & word_mask;
    model->predicted[slot] = (uint16_t)(value + step);
    model->last[slot] = value;
    model->next[model->previous] = (uint8_t)slot;
    model->previous = (uint8_t)slot;
}

/* ---- Little-endian numbers ------------------------------------------------------------------ */

static inline void trace_put(uint8_t *bytes, uint64_t value, unsigned size) {
    for (unsigned i = 0; i < size; i++) {
        bytes[i] = (uint8_t)(value >> (8 * i));
    }
}

static inline uint64_t trace_get(const uint8_t *bytes, unsigned size) {
    uint64_t value = 0;
    for (unsigned i = 0; i < size; i++) {
        value |= (uint64_t)bytes[i] << (8 * i);
    }
    return value;
}

#endif
