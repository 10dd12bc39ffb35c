/* SPDX-License-Identifier: MIT */
/* The cost of the port accesses on machines of the time, for the statistics. */
#include "stats/port_cost.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

#include "stats/cost_model.h"

const char *const cost_shown_machines[COST_SHOWN + 1] = {"VM2", "VX2", "RA2", NULL};

/* The names of cost_shown_machines in the cost model, in the same order. */
static const char *const targets[COST_SHOWN] = {"v30", "286", "386"};

static const struct cost_target *find_target(const char *name) {
    const struct cost_target *target = cost_targets;
    while (target->name != NULL && strcmp(target->name, name) != 0) {
        target++;
    }
    return target->name != NULL ? target : NULL;
}

void stats_predict_frames(const struct compiled_scene *scene, const struct render_totals *totals,
                          const char *arithmetic, uint64_t port_writes,
                          double seconds[COST_SHOWN]) {
    const struct cost_work work = {
        {totals->rays, totals->shadow_rays, totals->nodes, totals->solid_tests},
        cost_mix_of(scene),
        port_writes};
    for (int i = 0; i < COST_SHOWN; i++) {
        const struct cost_target *target = find_target(targets[i]);
        seconds[i] = target != NULL ? cost_seconds(target, arithmetic, &work) : (double)NAN;
    }
}

void stats_write_cost(struct json *json, const struct cost_bus *cost,
                      const struct board_options *options, const double frames[COST_SHOWN]) {
    json_rounded(json, "bus_wait_ns", options->bus_wait, 6);
    json_begin_object(json, "port_cost");
    for (int i = 0; i < COST_SHOWN; i++) {
        const struct cost_machine *machine = cost_machine_by_name(cost_shown_machines[i]);
        double seconds = cost_bus_seconds(cost, machine, options->bus_wait);
        double frame = options->frame_seconds > 0 ? options->frame_seconds
                       : frames != NULL           ? frames[i]
                                                  : 0;
        frame = frame > 0 ? frame : (double)NAN;
        json_begin_object(json, machine->name);
        json_rounded(json, "seconds", seconds, 9);
        json_rounded(json, "frame_seconds", frame, 6);
        json_rounded(json, "frame_share", seconds / frame, 9);
        json_end_object(json);
    }
    json_end_object(json);
}
