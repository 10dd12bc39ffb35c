/* SPDX-License-Identifier: MIT */
/* The cost of the port accesses on machines of the time, for the statistics. */
#ifndef SUPERFRAME_STATS_COST_H
#define SUPERFRAME_STATS_COST_H

#include "base/json.h"
#include "board/options.h"
#include "compiler/tables.h"
#include "cost_bus.h"
#include "render/render.h"

enum { COST_SHOWN = 3 };

/* The machines that represent the CPUs of the time: VM2, VX2 and RA2; ended by NULL. */
extern const char *const cost_shown_machines[COST_SHOWN + 1];

/* Predicts by the cost model the seconds of a whole rendering on each of cost_shown_machines, ports
 * included. NaN stands where the model has no figure for that arithmetic. */
void stats_predict_frames(const struct compiled_scene *scene, const struct render_totals *totals,
                          const char *arithmetic, uint64_t port_writes, double seconds[COST_SHOWN]);

/* Writes the keys bus_wait_ns and port_cost of the statistics. The frame's seconds, for the share,
 * come from --frame-seconds, else from `frames`. NULL or NaN there: not known, written as null. */
void stats_write_cost(struct json *json, const struct cost_bus *cost,
                      const struct board_options *options, const double frames[COST_SHOWN]);

#endif
