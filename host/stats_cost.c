/* SPDX-License-Identifier: MIT */
/* What the port accesses cost on machines of the time, for the statistics. */
#include "stats_cost.h"

#include <stddef.h>

const char *const cost_shown_machines[] = {"VM2", "VX2", "RA2", NULL};

void stats_write_cost(FILE *out, const struct cost_bus *cost, const struct board_options *options) {
    (void)fprintf(out, "  \"bus_wait_ns\": %g,\n  \"port_cost\": {", options->bus_wait);
    for (int i = 0; cost_shown_machines[i] != NULL; i++) {
        const struct cost_machine *machine = cost_machine_by_name(cost_shown_machines[i]);
        double seconds = cost_bus_seconds(cost, machine, options->bus_wait);
        (void)fprintf(out, "%s\"%s\": {\"seconds\": %.9g, \"frame_share\": ", i > 0 ? ", " : "",
                      machine->name, seconds);
        if (options->frame_seconds > 0) {
            (void)fprintf(out, "%.9g}", seconds / options->frame_seconds);
        } else {
            (void)fprintf(out, "null}");
        }
    }
    (void)fprintf(out, "},\n");
}
