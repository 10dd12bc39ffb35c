/* SPDX-License-Identifier: MIT */
/* A bus with faults, seeded and reproducible, in front of another bus. */
#ifndef SUPERFRAME_HAL_FAULT_BUS_H
#define SUPERFRAME_HAL_FAULT_BUS_H

#include "bus.h"

#include <stdbool.h>

/* Which faults. All zeros: none. The same plan, seed and accesses give the same faults. */
struct fault_plan {
    uint64_t seed;              /* any value */
    uint32_t lose_one_in;       /* one write in so many is lost, on average; 0: none, 1: all */
    uint32_t flip_write_one_in; /* one write in so many has one bit flipped; 0: none */
    uint32_t flip_read_one_in;  /* one read in so many has one bit flipped; 0: none */
    bool has_dead_port;         /* dead_port and the port above it (a register) don't answer */
    uint16_t dead_port;
    bool is_absent;        /* nothing is plugged in: writes are lost, reads give FFh */
    uint64_t vanish_after; /* absent after so many accesses; 0: never */
    /* What the bus says once the device has vanished: BUS_OK as on a slot, where nobody notices;
     * BUS_LOST as on USB. */
    enum bus_status vanish_status;
};

/* The bus, and what it has done so far. */
struct fault_bus {
    struct bus bus; /* the first member */
    struct bus *inner;
    struct fault_plan plan;
    uint64_t random; /* state of the generator */
    uint64_t accesses;
    uint64_t lost_writes; /* by lose_one_in, dead_port, is_absent or vanish_after */
    uint64_t flipped_writes;
    uint64_t flipped_reads;
    uint64_t dead_reads; /* reads that got FFh instead of an answer */
};

/* Puts the plan's faults in front of inner, which must not be NULL. *plan is copied. */
void fault_bus_init(struct fault_bus *fault_bus, struct bus *inner, const struct fault_plan *plan);

#endif
