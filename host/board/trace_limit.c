/* SPDX-License-Identifier: MIT */
/* A bus that lets a recorder see a number of accesses, and says when there are more. */
#include "board/trace_limit.h"

#include <inttypes.h>

#include "base/complain.h"

/* Counts an access, and returns where the access goes. */
static struct bus *next_of(struct trace_limit *limit) {
    struct trace_recorder *recorder = limit->recorder;
    if (limit->left > 0) {
        limit->left--;
    } else if (limit->inner == &recorder->bus) {
        (void)bus_flush(&recorder->bus); /* also counts what is recorded */
        complain("%s: the trace ends after %" PRIu64 " port accesses; the run goes on", limit->name,
                 recorder->accesses);
        limit->inner = recorder->inner;
    }
    return limit->inner;
}

static void limited_write(struct bus *bus, uint16_t port, uint16_t value, unsigned width) {
    bus_pass_on(bus, next_of((struct trace_limit *)bus), port, value, width);
}

static uint16_t limited_read(struct bus *bus, uint16_t port, unsigned width) {
    struct bus *inner = next_of((struct trace_limit *)bus);
    uint16_t value = bus_read(inner, port, width);
    bus_fail(bus, inner->status);
    return value;
}

static void limited_flush(struct bus *bus) {
    bus_fail(bus, bus_flush(((struct trace_limit *)bus)->inner));
}

static const struct bus_operations limit_operations = {limited_write, limited_read, limited_flush};

void trace_limit_init(struct trace_limit *limit, struct trace_recorder *recorder, const char *name,
                      uint64_t accesses_most) {
    limit->bus.operations = &limit_operations;
    limit->bus.status = recorder->bus.status;
    limit->inner = &recorder->bus;
    limit->recorder = recorder;
    limit->name = name;
    limit->left = accesses_most;
}
