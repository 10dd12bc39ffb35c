/* SPDX-License-Identifier: MIT */
/* Where a target without a slot sends its port accesses. */
#ifndef SUPERFRAME_TARGETS_SINK_H
#define SUPERFRAME_TARGETS_SINK_H

#include <stdint.h>

/* Opens the sink. Called once, before anything else. */
void sink_open(void);

/* Hands on bytes. All bytes arrive in this order, or the sink ends the run as failed. */
void sink_write(const uint8_t *bytes, uint16_t count);

/* Ends the run; 0: all is well. */
void sink_exit(int status);

#endif
