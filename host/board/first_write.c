/* SPDX-License-Identifier: MIT */
/* Times the first write to a port: a bus that reads the clocks once, then leaves the chain. */
#include "board/first_write.h"

#include <stddef.h>

#include "base/stopwatch.h"

static void write_first(struct bus *bus, uint16_t port, uint16_t value, unsigned width) {
    struct first_write *first = (struct first_write *)bus;
    struct timespec cpu = {0, 0};
    if (!first->has_happened) {
        (void)clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &cpu);
        first->cpu_seconds = (double)cpu.tv_sec + (double)cpu.tv_nsec * 1e-9;
        first->at = stopwatch_start();
        first->has_happened = true;
    }
    *first->link = first->inner;
    bus_pass_on(bus, first->inner, port, value, width);
}

static uint16_t read_before(struct bus *bus, uint16_t port, unsigned width) {
    struct first_write *first = (struct first_write *)bus;
    uint16_t value = bus_read(first->inner, port, width);
    bus_fail(bus, first->inner->status);
    return value;
}

static void flush_before(struct bus *bus) {
    bus_fail(bus, bus_flush(((struct first_write *)bus)->inner));
}

static const struct bus_operations first_write_operations = {write_first, read_before,
                                                             flush_before};

void first_write_await(struct first_write *first, struct bus **link) {
    const struct first_write empty = {.inner = *link, .link = link};
    *first = empty;
    first->bus.operations = &first_write_operations;
    first->bus.status = first->inner->status;
    *link = &first->bus;
}
