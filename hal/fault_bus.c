/* SPDX-License-Identifier: MIT */
/* Faults on their way to another bus: lost writes, flipped bits, a dead port, a missing device. */
#include "fault_bus.h"

#include "splitmix64.h"

/* Tells whether a fault strikes: once in `one_in` times on average. Draws only for faults that the
 * plan asks for. So a kind of fault that a plan does not have doesn't move the plan's others. */
static bool strikes(struct fault_bus *fault_bus, uint32_t one_in) {
    return one_in != 0 && splitmix64(&fault_bus->random) % one_in == 0;
}

static uint16_t flip_one_bit(struct fault_bus *fault_bus, uint16_t value, unsigned width) {
    unsigned bit = (unsigned)(splitmix64(&fault_bus->random) % (width * 8));
    return (uint16_t)(value ^ 1U << bit);
}

/* Counts the access. Returns false if no device answers the access. */
static bool device_answers(struct fault_bus *fault_bus, uint16_t port) {
    const struct fault_plan *plan = &fault_bus->plan;
    fault_bus->accesses++;
    if (plan->vanish_after != 0 && fault_bus->accesses > plan->vanish_after) {
        bus_fail(&fault_bus->bus, plan->vanish_status);
        return false;
    }
    bool is_dead = plan->has_dead_port && (uint16_t)(port - plan->dead_port) < 2;
    return !plan->is_absent && !is_dead;
}

static void fault_write(struct bus *bus, uint16_t port, uint16_t value, unsigned width) {
    struct fault_bus *fault_bus = (struct fault_bus *)bus;
    if (!device_answers(fault_bus, port) || strikes(fault_bus, fault_bus->plan.lose_one_in)) {
        fault_bus->lost_writes++;
        return;
    }
    if (strikes(fault_bus, fault_bus->plan.flip_write_one_in)) {
        value = flip_one_bit(fault_bus, value, width);
        fault_bus->flipped_writes++;
    }
    bus_write(fault_bus->inner, port, value, width);
    bus_fail(bus, fault_bus->inner->status);
}

static uint16_t fault_read(struct bus *bus, uint16_t port, unsigned width) {
    struct fault_bus *fault_bus = (struct fault_bus *)bus;
    if (!device_answers(fault_bus, port)) {
        fault_bus->dead_reads++;
        return 0xFFFF;
    }
    uint16_t value = bus_read(fault_bus->inner, port, width);
    bus_fail(bus, fault_bus->inner->status);
    if (strikes(fault_bus, fault_bus->plan.flip_read_one_in)) {
        value = flip_one_bit(fault_bus, value, width);
        fault_bus->flipped_reads++;
    }
    return value;
}

static void fault_flush(struct bus *bus) {
    bus_fail(bus, bus_flush(((struct fault_bus *)bus)->inner));
}

static const struct bus_operations fault_operations = {fault_write, fault_read, fault_flush};

void fault_bus_init(struct fault_bus *fault_bus, struct bus *inner, const struct fault_plan *plan) {
    const struct fault_bus empty = {.plan = *plan, .random = plan->seed, .inner = inner};
    *fault_bus = empty;
    fault_bus->bus.operations = &fault_operations;
    fault_bus->bus.status = inner->status;
}
