/* SPDX-License-Identifier: MIT */
/* A bus with nothing plugged in: writes go nowhere, reads give FFh. */
#ifndef SUPERFRAME_HAL_NULL_BUS_H
#define SUPERFRAME_HAL_NULL_BUS_H

#include "bus.h"

/* Sets up *bus as an empty slot. Cannot fail. Such a bus stands behind a recorder when nothing but
 * the trace is wanted. An undecoded read gives FFh (DOSBox-X, NP2kai; grade A). */
void null_bus_init(struct bus *bus);

#endif
