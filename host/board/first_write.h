/* SPDX-License-Identifier: MIT */
/* Times the first write to a port: a bus that reads the clocks once, then leaves the chain. */
#ifndef SUPERFRAME_FIRST_WRITE_H
#define SUPERFRAME_FIRST_WRITE_H

#include <stdbool.h>
#include <time.h>

#include "bus.h"

struct first_write {
    struct bus bus;     /* the first member */
    struct bus *inner;  /* where the accesses go */
    struct bus **link;  /* the outer bus's pointer to this one; the first write leads it past */
    bool has_happened;  /* the clocks below hold */
    struct timespec at; /* by the clock of stopwatch_start() */
    double cpu_seconds; /* that the process had taken by then, its loading included */
};

/* Puts the bus where *link leads. The chain has to be complete, since the bus takes itself out
 * again. */
void first_write_await(struct first_write *first, struct bus **link);

#endif
