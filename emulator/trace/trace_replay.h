/* SPDX-License-Identifier: MIT */
/* Plays a trace into a bus and compares the answers. */
#ifndef SUPERFRAME_EMULATOR_TRACE_REPLAY_H
#define SUPERFRAME_EMULATOR_TRACE_REPLAY_H

#include "bus.h"
#include "trace_reader.h"

/* What a replay has met so far. Start with all zeros. */
struct trace_replay {
    uint64_t accesses; /* played, reads included */
    uint64_t reads;
    uint64_t different_reads;         /* reads that the bus answered otherwise than recorded */
    uint64_t first_different;         /* the number of the first one, from 1; 0: none */
    struct trace_access first_access; /* as recorded; valid if first_different is not 0 */
    uint16_t first_answer;            /* what the bus answered instead */
};

/* Plays the accesses up to number stop_after (0: all) into bus. The next call goes on from there. A
 * read that is answered differently is counted and does not stop the replay. Returns TRACE_OK if
 * the replay stopped at stop_after, TRACE_END after the last access, else what is wrong with the
 * trace. Returns TRACE_BUS_FAILED if the bus failed; reader->error says at which access. */
enum trace_status trace_replay(struct trace_reader *reader, struct bus *bus, uint64_t stop_after,
                               struct trace_replay *replay);

#endif
