/* SPDX-License-Identifier: MIT */
/* The fingerprint of a run: a bus that hashes every write on its way to another bus. */
#ifndef SUPERFRAME_EMULATOR_TRACE_HASH_H
#define SUPERFRAME_EMULATOR_TRACE_HASH_H

#include "bus.h"

#include <stdbool.h>
#include <stdint.h>

enum { TRACE_HASH_BUFFER = 4000 }; /* bytes; a multiple of the five that a write takes */

/* The hash is XXH3-64 (seed 0) over the writes alone. Each write is five bytes: port (16 bits,
 * little-endian), width in bytes (8 bits), value (16 bits, little-endian). */
struct trace_hash {
    struct bus bus;    /* the first member */
    struct bus *inner; /* where the accesses go; NULL: nowhere, reads give FFh */
    void *state;       /* xxhash's */
    uint64_t writes;   /* hashed so far */
    unsigned used;     /* bytes waiting in the buffer */
    uint8_t buffer[TRACE_HASH_BUFFER];
};

/* Sets up *hash in front of inner. Returns false if out of memory; else trace_hash_free() is
 * due. */
bool trace_hash_init(struct trace_hash *hash, struct bus *inner);

/* Hashes one write without passing it on, for traces that are read from a file. */
void trace_hash_add(struct trace_hash *hash, uint16_t port, uint16_t value, unsigned width);

/* Returns the hash of the writes so far. More writes may follow. */
uint64_t trace_hash_value(struct trace_hash *hash);

/* Frees what trace_hash_init() took; harmless when repeated. */
void trace_hash_free(struct trace_hash *hash);

#endif
