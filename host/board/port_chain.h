/* SPDX-License-Identifier: MIT */
/* The buses behind the ports, put together. A hash of the writes comes first, then what is asked
 * for besides, and at the end the board or a device. */
#ifndef SUPERFRAME_PORT_CHAIN_H
#define SUPERFRAME_PORT_CHAIN_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

#include "board.h"
#include "board/first_write.h"
#include "board/trace_limit.h"
#include "bus.h"
#include "cost_bus.h"
#include "fault_bus.h"
#include "native_screen.h"
#include "picture.h"
#include "trace_hash.h"
#include "trace_recorder.h"

/* About a megabyte: make it with port_chain_new(). */
struct port_chain {
    struct trace_hash hash; /* outermost */
    bool is_recording;
    struct trace_recorder recorder;
    struct trace_limit limit;
    bool is_counting;
    struct cost_bus cost;
    struct fault_bus faults;
    struct first_write first; /* has_happened: of an observed chain */
    bool has_board;
    struct board_bus board_bus;
    struct bus null_bus; /* in the board's place where there is none */
    struct board board;
    bool has_native;
    struct native_screen native; /* the PC's own screen, black unless has_native */
    uint8_t rgb[PICTURE_BYTES];  /* what the CRT shows: port_chain_picture() draws it */
    enum picture_state picture_state;
};

/* Makes a chain without a recorder. has_board: the chain ends at a board of that desc, otherwise at
 * an empty slot. NULL if memory is out or the desc is invalid. */
struct port_chain *port_chain_new(const struct board_desc *desc, bool has_board);

/* The following five put something into the chain, before any access. What is put in later sees an
 * access earlier. The order is: a device, faults, the count, the recorder, its limit. */

/* Puts a device in the place of the empty slot, for a chain without a board. The device stays the
 * caller's. */
void port_chain_end_at(struct port_chain *chain, struct bus *device);

/* Puts faults between what is recorded and the board. */
void port_chain_spoil(struct port_chain *chain, const struct fault_plan *plan);

/* Puts in a count of the accesses, for what accesses cost: chain->cost. */
void port_chain_count(struct port_chain *chain);

/* Puts in a recorder. The file stays the caller's. */
void port_chain_record(struct port_chain *chain, FILE *file, enum trace_format format);

/* Lets the recorder, which is there, record at most so many accesses, at least 1. The name of its
 * file must outlive the chain. */
void port_chain_limit(struct port_chain *chain, const char *name, uint64_t accesses_most);

/* Returns the bus to bind, after all of the above. Observed: chain->hash hashes and counts the
 * writes, and chain->first notes when the first write comes. Otherwise only what was put into the
 * chain knows of the accesses, and accesses take less time. */
struct bus *port_chain_bus(struct port_chain *chain, bool is_observed);

/* Ends the recording, if there is one, and returns the status of the whole chain. No access may
 * follow. */
enum bus_status port_chain_finish(struct port_chain *chain);

/* Draws what the CRT shows into chain->rgb. */
void port_chain_picture(struct port_chain *chain);

/* Counts the port accesses so far, of an observed chain. Without a board, a recorder and a count
 * the reads are given as 0. */
uint64_t port_chain_writes(const struct port_chain *chain);
uint64_t port_chain_reads(const struct port_chain *chain);

/* Tells whether a strict check holds: no violation and, with a grade, nothing relied on that is no
 * better known. What breaks the check is printed to standard error. */
bool port_chain_holds(const struct port_chain *chain, bool has_grade, enum board_grade grade);

/* Frees the chain, and unbinds the chain if it is bound. Harmless on NULL. */
void port_chain_free(struct port_chain *chain);

#endif
