/* SPDX-License-Identifier: MIT */
/* The output of `superframe trace` for a whole trace: its statistics, and where two traces part. */
#ifndef SUPERFRAME_TRACE_PRINT_H
#define SUPERFRAME_TRACE_PRINT_H

#include <stdio.h>

#include "board/options.h"
#include "cost_bus.h"
#include "trace_compare.h"
#include "trace_statistics.h"

/* Prints the accesses by register, redundant writes, and pixels by how often they were touched.
 * Prints also the seconds that the accesses take on machines of the time. */
void trace_print_statistics(FILE *out, const struct trace_statistics *statistics,
                            const struct cost_bus *cost, const struct board_options *options);

/* Writes the same as a JSON object. Shares of a frame are null without --frame-seconds. */
void trace_write_statistics(FILE *out, const struct trace_statistics *statistics,
                            const struct cost_bus *cost, const struct board_options *options);

/* Prints the first difference, found before, as a diff. What both traces have comes first, then -
 * marks the one named first and + the other. */
void trace_print_difference(FILE *out, const struct trace_difference *difference,
                            const char *const names[2]);

#endif
