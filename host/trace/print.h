/* SPDX-License-Identifier: MIT */
/* What `superframe trace` prints of a whole trace: its statistics, and where two part. */
#ifndef SUPERFRAME_TRACE_PRINT_H
#define SUPERFRAME_TRACE_PRINT_H

#include <stdio.h>

#include "board/options.h"
#include "cost_bus.h"
#include "trace_compare.h"
#include "trace_statistics.h"

/* Accesses by register, redundant writes, pixels by how often they were touched, and the seconds
 * that the accesses take on machines of the time. */
void trace_print_statistics(FILE *out, const struct trace_statistics *statistics,
                            const struct cost_bus *cost, const struct board_options *options);

/* The first difference, found before, as a diff: what both have, then - of the one named first and
 * + of the other. */
void trace_print_difference(FILE *out, const struct trace_difference *difference,
                            const char *const names[2]);

#endif
