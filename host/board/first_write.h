/* SPDX-License-Identifier: MIT */
/* When the first port was written: a bus that looks at the clocks once, then leaves the chain. */
#ifndef SUPERFRAME_FIRST_WRITE_H
#define SUPERFRAME_FIRST_WRITE_H

#include <stdbool.h>
#include <time.h>

#include "bus.h"

struct first_write {
    struct bus bus;     /* the first member */
    struct bus *inner;  /* where the accesses go */
    struct bus **link;  /* the outer bus's way to this one; led past it by the first write */
    bool has_happened;  /* the clocks below hold */
    struct timespec at; /* by the clock of stopwatch_start() */
    double cpu_seconds; /* that the process had taken by then, its loading included */
};

/* Puts it where *link leads: into a chain that is complete, since it takes itself out again. */
void first_write_await(struct first_write *first, struct bus **link);

#endif
