/* SPDX-License-Identifier: MIT */
/* The buses behind the ports, put together. */
#include "board/port_chain.h"

#include <stdlib.h>

#include "board/strict.h"
#include "null_bus.h"

struct port_chain *port_chain_new(const struct board_desc *desc, bool has_board) {
    struct port_chain *chain = calloc(1, sizeof *chain);
    if (chain == NULL) {
        return NULL;
    }
    null_bus_init(&chain->null_bus);
    chain->has_board = has_board;
    if (!board_init(&chain->board, desc)) {
        free(chain);
        return NULL;
    }
    board_bus_init(&chain->board_bus, &chain->board);
    if (!trace_hash_init(&chain->hash, has_board ? &chain->board_bus.bus : &chain->null_bus)) {
        free(chain);
        return NULL;
    }
    return chain;
}

void port_chain_end_at(struct port_chain *chain, struct bus *device) {
    chain->hash.inner = device;
}

void port_chain_spoil(struct port_chain *chain, const struct fault_plan *plan) {
    fault_bus_init(&chain->faults, chain->hash.inner, plan);
    chain->hash.inner = &chain->faults.bus;
}

void port_chain_count(struct port_chain *chain) {
    cost_bus_init(&chain->cost, chain->hash.inner);
    chain->hash.inner = &chain->cost.bus;
    chain->is_counting = true;
}

void port_chain_record(struct port_chain *chain, FILE *file, enum trace_format format) {
    const struct trace_header header = {chain->board.desc.profile, chain->board.desc.base};
    trace_recorder_init(&chain->recorder, chain->hash.inner, file, format, &header);
    chain->hash.inner = &chain->recorder.bus;
    chain->is_recording = true;
}

void port_chain_limit(struct port_chain *chain, const char *name, uint64_t accesses_most) {
    trace_limit_init(&chain->limit, &chain->recorder, name, accesses_most);
    chain->hash.inner = &chain->limit.bus;
}

struct bus *port_chain_bus(struct port_chain *chain, bool is_observed) {
    if (!is_observed) {
        return chain->hash.inner;
    }
    first_write_await(&chain->first, &chain->hash.inner);
    return &chain->hash.bus;
}

enum bus_status port_chain_finish(struct port_chain *chain) {
    enum bus_status status = bus_flush(&chain->hash.bus);
    if (chain->is_recording) {
        enum bus_status recorded = trace_recorder_finish(&chain->recorder);
        status = status != BUS_OK ? status : recorded;
    }
    return status;
}

void port_chain_picture(struct port_chain *chain) {
    chain->picture_state =
        picture_draw(&chain->board, chain->has_native ? &chain->native : NULL, chain->rgb);
}

uint64_t port_chain_writes(const struct port_chain *chain) {
    return chain->hash.writes;
}

uint64_t port_chain_reads(const struct port_chain *chain) {
    if (chain->is_counting) {
        return chain->cost.reads[0] + chain->cost.reads[1];
    }
    uint64_t accesses = chain->has_board ? chain->board.accesses
                                         : (chain->is_recording ? chain->recorder.accesses : 0);
    return accesses > chain->hash.writes ? accesses - chain->hash.writes : 0;
}

bool port_chain_holds(const struct port_chain *chain, bool has_grade, enum board_grade grade) {
    return strict_holds(&chain->board, has_grade, grade);
}

void port_chain_free(struct port_chain *chain) {
    if (chain == NULL) {
        return;
    }
    struct bus *bound = bus_bind(NULL);
    if (bound != &chain->hash.bus && bound != chain->hash.inner) {
        (void)bus_bind(bound);
    }
    trace_hash_free(&chain->hash);
    free(chain);
}
