/* SPDX-License-Identifier: MIT */
/* XXH3-64 over the port writes. */
#include "trace_hash.h"

#include <stddef.h>
#include <xxhash.h>

static void hash_buffer(struct trace_hash *hash) {
    XXH3_64bits_update(hash->state, hash->buffer, hash->used);
    hash->used = 0;
}

static inline void keep(struct trace_hash *hash, uint16_t port, uint16_t value, unsigned width) {
    uint8_t *bytes = hash->buffer + hash->used;
    /* Four bytes taken off one number: the compiler makes one store of them. */
    uint32_t head = port | (uint32_t)width << 16 | (uint32_t)value << 24;
    bytes[0] = (uint8_t)head;
    bytes[1] = (uint8_t)(head >> 8);
    bytes[2] = (uint8_t)(head >> 16);
    bytes[3] = (uint8_t)(head >> 24);
    bytes[4] = width == BUS_BYTE ? 0 : (uint8_t)(value >> 8);
    hash->used += 5;
    hash->writes++;
}

static inline void hash_if_full(struct trace_hash *hash) {
    if (hash->used == TRACE_HASH_BUFFER) {
        hash_buffer(hash);
    }
}

void trace_hash_add(struct trace_hash *hash, uint16_t port, uint16_t value, unsigned width) {
    keep(hash, port, value, width);
    hash_if_full(hash);
}

/* Passes a write on. A full buffer is hashed last: before that the write itself would have to be
 * saved over the call. */
static void hash_write(struct bus *bus, uint16_t port, uint16_t value, unsigned width) {
    struct trace_hash *hash = (struct trace_hash *)bus;
    keep(hash, port, value, width);
    if (hash->inner != NULL) {
        bus_pass_on(bus, hash->inner, port, value, width);
    }
    hash_if_full(hash);
}

static uint16_t hash_read(struct bus *bus, uint16_t port, unsigned width) {
    struct trace_hash *hash = (struct trace_hash *)bus;
    uint16_t value = 0xFFFF;
    if (hash->inner != NULL) {
        value = bus_read(hash->inner, port, width);
        bus_fail(bus, hash->inner->status);
    }
    return value;
}

static void hash_flush(struct bus *bus) {
    struct trace_hash *hash = (struct trace_hash *)bus;
    if (hash->inner != NULL) {
        bus_fail(bus, bus_flush(hash->inner));
    }
}

static const struct bus_operations hash_operations = {hash_write, hash_read, hash_flush};

bool trace_hash_init(struct trace_hash *hash, struct bus *inner) {
    hash->bus.operations = &hash_operations;
    hash->bus.status = inner == NULL ? BUS_OK : inner->status;
    hash->inner = inner;
    hash->writes = 0;
    hash->used = 0;
    hash->state = XXH3_createState();
    return hash->state != NULL && XXH3_64bits_reset(hash->state) == XXH_OK;
}

uint64_t trace_hash_value(struct trace_hash *hash) {
    hash_buffer(hash);
    return XXH3_64bits_digest(hash->state);
}

void trace_hash_free(struct trace_hash *hash) {
    XXH3_freeState(hash->state);
    hash->state = NULL;
}
