/* SPDX-License-Identifier: MIT */
/* Where the port accesses of a render go: the emulated board, a trace, real ports, a cable. */
#ifndef SUPERFRAME_OPTIONS_BUS_H
#define SUPERFRAME_OPTIONS_BUS_H

#include "options/options.h"

extern const struct option_group group_bus;

/* Checks that the bus can do what the options ask for, and that real ports are declared to be the
 * board's. Returns false with *error filled. */
bool bus_check(const struct options *options, struct options_error *error);

#endif
