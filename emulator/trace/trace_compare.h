/* SPDX-License-Identifier: MIT */
/* The first difference of two traces, with what stands around it. */
#ifndef SUPERFRAME_EMULATOR_TRACE_COMPARE_H
#define SUPERFRAME_EMULATOR_TRACE_COMPARE_H

#include "trace_reader.h"

enum { TRACE_CONTEXT = 5 }; /* accesses shown before and after the difference */

/* What a comparison found. */
struct trace_difference {
    bool is_found;
    uint64_t access; /* number of the first access that differs, from 1; if the traces are equal,
                        the number of accesses that they have */
    unsigned before_count;                           /* valid entries, 0..TRACE_CONTEXT */
    struct trace_access before[TRACE_CONTEXT];       /* what both have before it, oldest first */
    unsigned after_count[2];                         /* 0: that trace ends here */
    struct trace_access after[2][TRACE_CONTEXT + 1]; /* of each trace, the different one first */
    int failed; /* which trace can't be read: 0 or 1; -1: neither */
};

/* Reads two traces until they differ in any field of an access, or one is longer. Returns TRACE_OK
 * when they could be compared; else what is wrong, with the details in readers[failed]->error. */
enum trace_status trace_compare(struct trace_reader *const readers[2],
                                struct trace_difference *difference);

#endif
