/* SPDX-License-Identifier: MIT */
/* What a run did with the ports: counts by register, redundant writes, pixels touched. */
#ifndef SUPERFRAME_EMULATOR_TRACE_STATISTICS_H
#define SUPERFRAME_EMULATOR_TRACE_STATISTICS_H

#include "board.h"
#include "trace.h"

/* The statistics; 1.1 MB, most of it the board that follows the accesses. */
struct trace_statistics {
    struct board board; /* its writes[] and reads[] are the counts by register */
    uint64_t writes;
    uint64_t reads;
    uint64_t redundant_writes;  /* the register or pixel had been written, and had that value */
    uint16_t written_registers; /* bit n: the register at offset 2n has been written */
    uint8_t touched[BOARD_WIDTH * BOARD_MEMORY_HEIGHT]; /* bits 0-2: R, G, B written; 3-5: again */
};

/* How often the 640 x 400 pixels that are shown were written. */
struct trace_pixels {
    uint32_t never;
    uint32_t once;  /* at least one primary, and none twice */
    uint32_t again; /* at least one primary more than once */
};

/* Starts from a board as desc describes it. Returns false if board_init() refuses the desc. */
bool trace_statistics_init(struct trace_statistics *statistics, const struct board_desc *desc);

/* Takes the next access into account. Returns what the board answers a read, whatever the trace
 * says; 0 after a write. */
uint16_t trace_statistics_add(struct trace_statistics *statistics,
                              const struct trace_access *access);

/* Counts the shown pixels by how often they were written. */
struct trace_pixels trace_statistics_pixels(const struct trace_statistics *statistics);

#endif
