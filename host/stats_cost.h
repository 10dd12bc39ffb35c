/* SPDX-License-Identifier: MIT */
/* What the port accesses cost on machines of the time, for the statistics. */
#ifndef SUPERFRAME_STATS_COST_H
#define SUPERFRAME_STATS_COST_H

#include <stdio.h>

#include "board_options.h"
#include "cost_bus.h"

/* The machines that stand for the CPUs of the time: VM2, VX2 and RA2; ended by NULL. */
extern const char *const cost_shown_machines[];

/* Writes the keys bus_wait_ns and port_cost of the statistics, each line ended by a comma. */
void stats_write_cost(FILE *out, const struct cost_bus *cost, const struct board_options *options);

#endif
