/* SPDX-License-Identifier: MIT */
/* Clocks of port accesses by CPU, and the seconds that they make. */
#include "cost_bus.h"

#include <stddef.h>
#include <string.h>

/* Clocks of OUT DX,AL and IN AL,DX. A word at an even port costs the same. The 80386 is in real
 * mode. */
static const struct {
    const char *name;
    unsigned out, in, odd_word;
} cpus[COST_CPUS] = {
    [COST_8086] = {"8086", 8, 8, 4},
    [COST_V30] = {"V30", 8, 8, 4},
    [COST_80286] = {"80286", 3, 5, 2},
    [COST_80386] = {"80386", 11, 13, 2},
};

static const struct cost_machine machines[] = {
    {"8086-5", COST_8086, 5.0}, /* the first PC-9801, 1982 */
    {"VM2", COST_V30, 10.0},    /* 1985, the faster of its two clocks */
    {"VM2-8", COST_V30, 8.0},   /* the slower */
    {"VX2", COST_80286, 8.0},   /* 1986-11 */
    {"UX21", COST_80286, 10.0}, /* 1987-10 */
    {"XL2", COST_80386, 16.0},  /* 1987-10 */
    {"RA2", COST_80386, 16.0},  /* 1988-07 */
    {"RA21", COST_80386, 20.0}, /* 1989-11 */
};

const struct cost_machine *cost_machines(unsigned *count) {
    *count = sizeof machines / sizeof machines[0];
    return machines;
}

const struct cost_machine *cost_machine_by_name(const char *name) {
    for (size_t i = 0; i < sizeof machines / sizeof machines[0]; i++) {
        if (strcmp(name, machines[i].name) == 0) {
            return &machines[i];
        }
    }
    return NULL;
}

unsigned cost_clocks(enum cost_cpu cpu, uint16_t port, unsigned width, bool is_read) {
    unsigned clocks = is_read ? cpus[cpu].in : cpus[cpu].out;
    bool is_split = width == BUS_WORD && (port & 1) != 0;
    return clocks + (is_split ? cpus[cpu].odd_word : 0);
}

const char *cost_cpu_text(enum cost_cpu cpu) {
    return cpus[cpu].name;
}

static inline void count_odd(struct cost_bus *cost_bus, uint16_t port, unsigned width) {
    cost_bus->odd_words += width == BUS_WORD && (port & 1) != 0;
}

static void cost_write(struct bus *bus, uint16_t port, uint16_t value, unsigned width) {
    struct cost_bus *cost_bus = (struct cost_bus *)bus;
    cost_bus->writes[width - 1]++;
    count_odd(cost_bus, port, width);
    if (cost_bus->inner != NULL) {
        bus_pass_on(bus, cost_bus->inner, port, value, width);
    }
}

static uint16_t cost_read(struct bus *bus, uint16_t port, unsigned width) {
    struct cost_bus *cost_bus = (struct cost_bus *)bus;
    uint16_t value = 0xFFFF;
    cost_bus->reads[width - 1]++;
    count_odd(cost_bus, port, width);
    if (cost_bus->inner != NULL) {
        value = bus_read(cost_bus->inner, port, width);
        bus_fail(bus, cost_bus->inner->status);
    }
    return value;
}

static void cost_flush(struct bus *bus) {
    struct cost_bus *cost_bus = (struct cost_bus *)bus;
    if (cost_bus->inner != NULL) {
        bus_fail(bus, bus_flush(cost_bus->inner));
    }
}

static const struct bus_operations cost_operations = {cost_write, cost_read, cost_flush};

void cost_bus_init(struct cost_bus *cost_bus, struct bus *inner) {
    const struct cost_bus empty = {.inner = inner};
    *cost_bus = empty;
    cost_bus->bus.operations = &cost_operations;
    cost_bus->bus.status = inner == NULL ? BUS_OK : inner->status;
}

uint64_t cost_bus_cycles(const struct cost_bus *cost_bus) {
    return cost_bus->reads[0] + cost_bus->reads[1] + cost_bus->writes[0] + cost_bus->writes[1] +
           cost_bus->odd_words;
}

uint64_t cost_bus_clocks(const struct cost_bus *cost_bus, enum cost_cpu cpu) {
    return (cost_bus->writes[0] + cost_bus->writes[1]) * cpus[cpu].out +
           (cost_bus->reads[0] + cost_bus->reads[1]) * cpus[cpu].in +
           cost_bus->odd_words * cpus[cpu].odd_word;
}

double cost_bus_seconds(const struct cost_bus *cost_bus, const struct cost_machine *machine,
                        double bus_wait_ns) {
    return (double)cost_bus_clocks(cost_bus, machine->cpu) / (machine->megahertz * 1e6) +
           (double)cost_bus_cycles(cost_bus) * bus_wait_ns * 1e-9;
}
