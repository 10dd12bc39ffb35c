/* SPDX-License-Identifier: MIT */
/* A bus that lets a recorder see a number of accesses, and says when there are more. */
#ifndef SUPERFRAME_TRACE_LIMIT_H
#define SUPERFRAME_TRACE_LIMIT_H

#include "bus.h"
#include "trace_recorder.h"

#include <stdint.h>

struct trace_limit {
    struct bus bus;    /* the first member */
    struct bus *inner; /* the recorder while the limit lasts, then the bus behind it */
    struct trace_recorder *recorder;
    const char *name; /* of the trace's file, for the message */
    uint64_t left;    /* accesses that are still recorded */
};

/* Puts a limit before a recorder. Past accesses_most, which is at least 1, accesses go straight to
 * the bus behind the recorder. The first such access is told on standard error. */
void trace_limit_init(struct trace_limit *limit, struct trace_recorder *recorder, const char *name,
                      uint64_t accesses_most);

#endif
