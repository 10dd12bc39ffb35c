/* SPDX-License-Identifier: MIT */
/* The output of `superframe trace` for a whole trace. */
#include "trace/print.h"

#include <inttypes.h>
#include <math.h>

#include "base/json.h"
#include "stats/port_cost.h"
#include "trace/words.h"

static void print_registers(FILE *out, const struct board *board) {
    uint64_t own = 0;
    (void)fprintf(out, "%-16s %12s %12s %12s %12s\n", "register", "bytes out", "words out",
                  "bytes in", "words in");
    for (unsigned offset = 0; offset < BOARD_PORTS; offset++) {
        const uint64_t *writes = board->writes[offset];
        const uint64_t *reads = board->reads[offset];
        uint64_t sum = writes[0] + writes[1] + reads[0] + reads[1];
        own += sum;
        if (sum > 0 || (offset & 1) == 0) {
            char name[32];
            (void)snprintf(name, sizeof name, "%04X %s%s", board->desc.base + offset,
                           trace_register_name(offset), (offset & 1) != 0 ? ", odd" : "");
            (void)fprintf(out, "%-16s %12" PRIu64 " %12" PRIu64 " %12" PRIu64 " %12" PRIu64 "\n",
                          name, writes[0], writes[1], reads[0], reads[1]);
        }
    }
    (void)fprintf(out, "%-16s %12" PRIu64 " of %" PRIu64 " accesses\n", "elsewhere",
                  board->accesses - own, board->accesses);
}

static void print_cost(FILE *out, const struct cost_bus *cost,
                       const struct board_options *options) {
    (void)fprintf(out, "\n%-8s %-6s %5s %12s  %s\n", "machine", "CPU", "MHz", "seconds",
                  "share of the frame");
    for (int i = 0; cost_shown_machines[i] != NULL; i++) {
        const struct cost_machine *machine = cost_machine_by_name(cost_shown_machines[i]);
        double seconds = cost_bus_seconds(cost, machine, options->bus_wait);
        (void)fprintf(out, "%-8s %-6s %5.1f %12.6f  ", machine->name, cost_cpu_text(machine->cpu),
                      machine->megahertz, seconds);
        if (options->frame_seconds > 0) {
            (void)fprintf(out, "%.4f %%\n", 100 * seconds / options->frame_seconds);
        } else {
            (void)fprintf(out, "not known: --frame-seconds says what a frame takes\n");
        }
    }
    (void)fprintf(out, "(clocks of IN and OUT alone, and %g ns of the bus for each access)\n",
                  options->bus_wait);
}

void trace_print_statistics(FILE *out, const struct trace_statistics *statistics,
                            const struct cost_bus *cost, const struct board_options *options) {
    struct trace_pixels pixels = trace_statistics_pixels(statistics);
    print_registers(out, &statistics->board);
    (void)fprintf(out, "\n%-28s %12" PRIu64 "\n", "writes", statistics->writes);
    (void)fprintf(out, "%-28s %12" PRIu64 "\n", "redundant writes", statistics->redundant_writes);
    (void)fprintf(out, "%-28s %12" PRIu64 "\n", "reads", statistics->reads);
    (void)fprintf(out, "%-28s %12" PRIu32 "\n", "pixels touched once", pixels.once);
    (void)fprintf(out, "%-28s %12" PRIu32 "\n", "pixels touched twice or more", pixels.again);
    (void)fprintf(out, "%-28s %12" PRIu32 "\n", "pixels never touched", pixels.never);
    (void)fprintf(out, "%-28s %12" PRIu64 "\n", "violations", board_violations(&statistics->board));
    print_cost(out, cost, options);
}

static void write_registers(struct json *json, const struct board *board) {
    json_begin_list(json, "registers");
    for (unsigned offset = 0; offset < BOARD_PORTS; offset++) {
        json_begin_object(json, NULL);
        json_count(json, "port", board->desc.base + offset);
        json_text(json, "name", trace_register_name(offset));
        json_count(json, "bytes_out", board->writes[offset][0]);
        json_count(json, "words_out", board->writes[offset][1]);
        json_count(json, "bytes_in", board->reads[offset][0]);
        json_count(json, "words_in", board->reads[offset][1]);
        json_end_object(json);
    }
    json_end_list(json);
}

static void write_cost(struct json *json, const struct cost_bus *cost,
                       const struct board_options *options) {
    json_real(json, "bus_wait_ns", options->bus_wait);
    json_begin_object(json, "port_cost");
    for (int i = 0; cost_shown_machines[i] != NULL; i++) {
        const struct cost_machine *machine = cost_machine_by_name(cost_shown_machines[i]);
        double seconds = cost_bus_seconds(cost, machine, options->bus_wait);
        bool is_known = options->frame_seconds > 0;
        json_begin_object(json, machine->name);
        json_real(json, "seconds", seconds);
        json_real(json, "frame_seconds", is_known ? options->frame_seconds : (double)NAN);
        json_real(json, "frame_share", is_known ? seconds / options->frame_seconds : (double)NAN);
        json_end_object(json);
    }
    json_end_object(json);
}

void trace_write_statistics(FILE *out, const struct trace_statistics *statistics,
                            const struct cost_bus *cost, const struct board_options *options) {
    const struct trace_pixels pixels = trace_statistics_pixels(statistics);
    struct json json = {.out = out};
    json_begin_object(&json, NULL);
    json_count(&json, "accesses", statistics->board.accesses);
    json_count(&json, "writes", statistics->writes);
    json_count(&json, "redundant_writes", statistics->redundant_writes);
    json_count(&json, "reads", statistics->reads);
    json_count(&json, "pixels_touched_once", pixels.once);
    json_count(&json, "pixels_touched_again", pixels.again);
    json_count(&json, "pixels_never_touched", pixels.never);
    json_count(&json, "violations", board_violations(&statistics->board));
    write_registers(&json, &statistics->board);
    write_cost(&json, cost, options);
    json_end_object(&json);
}

static void print_access(FILE *out, char mark, uint64_t number, const struct trace_access *access) {
    char text[TRACE_TEXT_SIZE];
    (void)trace_text_format(text, access);
    (void)fprintf(out, "%c %8" PRIu64 "  %s\n", mark, number, text);
}

void trace_print_difference(FILE *out, const struct trace_difference *difference,
                            const char *const names[2]) {
    static const char marks[2] = {'-', '+'};
    (void)fprintf(out, "the traces differ first at access %" PRIu64 "\n--- %s\n+++ %s\n",
                  difference->access, names[0], names[1]);
    for (unsigned i = 0; i < difference->before_count; i++) {
        print_access(out, ' ', difference->access - difference->before_count + i,
                     &difference->before[i]);
    }
    for (int which = 0; which < 2; which++) {
        for (unsigned i = 0; i < difference->after_count[which]; i++) {
            print_access(out, marks[which], difference->access + i, &difference->after[which][i]);
        }
        if (difference->after_count[which] == 0) {
            (void)fprintf(out, "%c           (the trace ends here)\n", marks[which]);
        }
    }
}
