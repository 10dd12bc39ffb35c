/* SPDX-License-Identifier: MIT */
/* The ports of a target without a slot: each write becomes a record for the host. */
#ifndef SUPERFRAME_TARGETS_PORT_RECORDS_H
#define SUPERFRAME_TARGETS_PORT_RECORDS_H

/* A record is what the trace hash takes of a write: port (16 bits), width in bytes (8), value (16),
 * little-endian. tests/targets/records.sh makes a trace of the records. */

/* Hands on what is buffered. */
void port_records_flush(void);

#endif
