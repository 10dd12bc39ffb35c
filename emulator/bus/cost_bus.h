/* SPDX-License-Identifier: MIT */
/* What port accesses cost on machines of the time: a bus that counts clocks by CPU. */
#ifndef SUPERFRAME_HAL_COST_BUS_H
#define SUPERFRAME_HAL_COST_BUS_H

#include "bus.h"

#include <stdbool.h>

enum cost_cpu { COST_8086, COST_V30, COST_80286, COST_80386, COST_CPUS };

/* A machine to predict for. */
struct cost_machine {
    const char *name;
    enum cost_cpu cpu;
    double megahertz;
};

/* Returns the machines that are known. *count gets how many; count must not be NULL. Source: MAME's
 * pc9801 header. */
const struct cost_machine *cost_machines(unsigned *count);

/* Finds a machine by its name, case included: "VM2", "VX2", "RA2", ..., "8086-5". Returns NULL if
 * no machine has the name. */
const struct cost_machine *cost_machine_by_name(const char *name);

/* Returns the clocks of one OUT DX or IN DX of a width (bytes), without wait states. The 80386 is
 * in real mode. Source: the CPU manuals' tables (OUT 8, 8, 3, 11; IN 8, 8, 5, 13). A word at an odd
 * port takes a second bus cycle. The cycle costs 4 clocks more on 8086 and V30 by the manuals, 2 on
 * the others (assumed). */
unsigned cost_clocks(enum cost_cpu cpu, uint16_t port, unsigned width, bool is_read);

/* Returns the name of a CPU: "8086", "V30", "80286" or "80386". */
const char *cost_cpu_text(enum cost_cpu cpu);

/* Counts the accesses on their way to inner. */
struct cost_bus {
    struct bus bus; /* the first member */
    struct bus *inner;
    uint64_t reads[2];  /* by width - 1 */
    uint64_t writes[2]; /* by width - 1 */
    uint64_t odd_words; /* words at odd ports, of all reads and writes */
};

/* Sets up *cost_bus in front of inner. If inner is NULL, the accesses are only counted. */
void cost_bus_init(struct cost_bus *cost_bus, struct bus *inner);

/* Returns the number of bus accesses so far. A word at an odd port is two. */
uint64_t cost_bus_cycles(const struct cost_bus *cost_bus);

/* Returns the clocks of all accesses so far, each as cost_clocks() counts them. */
uint64_t cost_bus_clocks(const struct cost_bus *cost_bus, enum cost_cpu cpu);

/* Returns the seconds that a machine spends in the IN and OUT instructions alone. bus_wait_ns, 0 or
 * more, is added for each bus access; 0 is the bare CPU. About 400 is what an emulator's model adds
 * up to on a 9.83 MHz machine (NP2kai). No measured figure is known. */
double cost_bus_seconds(const struct cost_bus *cost_bus, const struct cost_machine *machine,
                        double bus_wait_ns);

#endif
