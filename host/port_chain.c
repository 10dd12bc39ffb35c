/* SPDX-License-Identifier: MIT */
/* The buses behind the ports, put together: a hash of the writes, a recorder, the board. */
#include "port_chain.h"

#include <inttypes.h>
#include <stdlib.h>

#include "command.h"
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

void port_chain_record(struct port_chain *chain, FILE *file, enum trace_format format) {
    const struct trace_header header = {chain->board.desc.profile, chain->board.desc.base};
    trace_recorder_init(&chain->recorder, chain->hash.inner, file, format, &header);
    chain->hash.inner = &chain->recorder.bus;
    chain->is_recording = true;
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
    chain->picture_state = picture_draw(&chain->board, NULL, chain->rgb);
}

uint64_t port_chain_writes(const struct port_chain *chain) {
    return chain->hash.writes;
}

uint64_t port_chain_reads(const struct port_chain *chain) {
    uint64_t accesses = chain->has_board ? chain->board.accesses
                                         : (chain->is_recording ? chain->recorder.accesses : 0);
    return accesses > chain->hash.writes ? accesses - chain->hash.writes : 0;
}

bool port_chain_holds(const struct port_chain *chain, bool has_grade, enum board_grade grade) {
    const struct board *board = &chain->board;
    enum board_profile profile = board->desc.profile;
    bool holds = true;
    for (int i = 0; i < BOARD_BEHAVIOURS; i++) {
        enum board_behaviour behaviour = (enum board_behaviour)i;
        enum board_grade own = board_behaviour_grade(behaviour, profile);
        bool is_violation = board_behaviour_is_violation(behaviour, profile);
        if (board->notes[i].count == 0 || !(is_violation || (has_grade && own >= grade))) {
            continue;
        }
        complain("%s: %s (grade %s): %" PRIu64 " times, first at access %" PRIu64,
                 is_violation ? "violation" : "relied on", board_behaviour_text(behaviour),
                 board_grade_letter(own), board->notes[i].count, board->notes[i].first);
        holds = false;
    }
    return holds;
}

void port_chain_free(struct port_chain *chain) {
    if (chain == NULL) {
        return;
    }
    struct bus *bound = bus_bind(NULL);
    if (bound != &chain->hash.bus) {
        (void)bus_bind(bound);
    }
    trace_hash_free(&chain->hash);
    free(chain);
}
