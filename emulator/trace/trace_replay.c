/* SPDX-License-Identifier: MIT */
/* Plays a trace into a bus. */
#include "trace_replay.h"

#include <inttypes.h>

static void play(struct bus *bus, const struct trace_access *access, struct trace_replay *replay) {
    replay->accesses++;
    if (!access->is_read) {
        bus_write(bus, access->port, access->value, access->width);
        return;
    }
    uint16_t answer = bus_read(bus, access->port, access->width);
    replay->reads++;
    if (answer != access->value && replay->different_reads++ == 0) {
        replay->first_different = replay->accesses;
        replay->first_access = *access;
        replay->first_answer = answer;
    }
}

enum trace_status trace_replay(struct trace_reader *reader, struct bus *bus, uint64_t stop_after,
                               struct trace_replay *replay) {
    struct trace_access access;
    while (stop_after == 0 || replay->accesses < stop_after) {
        enum trace_status status = trace_reader_next(reader, &access);
        if (status != TRACE_OK) {
            return status;
        }
        play(bus, &access, replay);
        if (bus->status != BUS_OK) {
            reader->error.status = TRACE_BUS_FAILED;
            reader->error.line = reader->line;
            reader->error.offset = reader->offset;
            snprintf(reader->error.message, sizeof reader->error.message,
                     "at access %" PRIu64 ": %s", replay->accesses, bus_status_text(bus->status));
            return TRACE_BUS_FAILED;
        }
    }
    return TRACE_OK;
}
