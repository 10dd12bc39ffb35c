/* SPDX-License-Identifier: MIT */
/* superframe replay: port traces, binary or plain text, on the emulated board. */
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

#include "base/output.h"
#include "base/stopwatch.h"
#include "board/equip_chain.h"
#include "board/port_chain.h"
#include "board/screen_file.h"
#include "command/command.h"
#include "stats/run.h"
#include "trace/file.h"
#include "trace_replay.h"

/* One run of the command. */
struct replay_run {
    const struct options *options;
    struct timespec began;
    struct port_chain *chain;
    struct trace_reader *reader; /* 66 KB: not on the stack */
    uint64_t played;             /* accesses, of all traces */
    struct output picture, stats;
};

/* Plays one file on the chain: its writes are written, its reads are read and compared. */
static int play(struct replay_run *run, const char *path) {
    const struct trace_header board = {run->options->profile, run->options->base};
    uint64_t stop = run->options->board.stop;
    struct trace_replay replay;
    enum trace_status status = trace_reader_require(run->reader, &board);
    memset(&replay, 0, sizeof replay);
    if (status == TRACE_OK) {
        status = trace_replay(run->reader, &run->chain->hash.bus,
                              stop == 0 ? 0 : stop - run->played, &replay);
    }
    run->played += replay.accesses;
    if (replay.different_reads > 0) {
        complain("%s: %" PRIu64 " reads were answered otherwise than recorded, the first at access "
                 "%" PRIu64,
                 path, replay.different_reads, replay.first_different);
    }
    return status == TRACE_END || status == TRACE_OK
               ? STATUS_DONE
               : trace_file_complain(path, &run->reader->error);
}

static int play_all(struct replay_run *run) {
    uint64_t stop = run->options->board.stop;
    int status = STATUS_DONE;
    for (int i = 0; i < run->options->operand_count && status == STATUS_DONE; i++) {
        FILE *file;
        if (stop != 0 && run->played == stop) {
            return STATUS_DONE;
        }
        status = trace_file_open(run->options->operands[i], &file, run->reader);
        if (status == STATUS_DONE) {
            status = play(run, run->options->operands[i]);
        }
        trace_file_close(file);
    }
    if (status == STATUS_DONE && run->played < stop) {
        complain("the traces end after access %" PRIu64 ", before --stop %" PRIu64, run->played,
                 stop);
    }
    return status;
}

static int prepare(struct replay_run *run) {
    const struct options *options = run->options;
    struct board_desc desc = board_default_desc(options->profile);
    desc.base = options->base;
    run->chain = port_chain_new(&desc, true);
    run->reader = malloc(sizeof *run->reader);
    if (run->chain == NULL || run->reader == NULL) {
        complain("out of memory");
        return STATUS_FAILED;
    }
    int status = equip_chain(run->chain, &options->board, options->stats != NULL);
    if (status != STATUS_DONE) {
        return status;
    }
    if ((options->output != NULL && !output_open(&run->picture, options->output)) ||
        (options->stats != NULL && !output_open(&run->stats, options->stats))) {
        return STATUS_FAILED;
    }
    return STATUS_DONE;
}

static int write_results(struct replay_run *run) {
    const struct options *options = run->options;
    if (run->picture.file != NULL &&
        !board_picture_write(&run->picture, &run->chain->board,
                             run->chain->has_native ? &run->chain->native : NULL,
                             options->board.picture)) {
        return STATUS_FAILED;
    }
    if (run->stats.file != NULL) {
        const struct run_stats stats = {.chain = run->chain,
                                        .board = &options->board,
                                        .total_seconds = stopwatch_seconds(&run->began)};
        stats_write(run->stats.file, &stats);
        if (!output_commit(&run->stats)) {
            return STATUS_FAILED;
        }
    }
    return STATUS_DONE;
}

int run_replay(const struct options *options) {
    struct replay_run run;
    memset(&run, 0, sizeof run);
    run.options = options;
    run.began = stopwatch_start();
    int status = prepare(&run);
    if (status == STATUS_DONE) {
        status = play_all(&run);
    }
    if (status == STATUS_DONE) {
        status = write_results(&run);
    }
    if (status == STATUS_DONE && options->strict &&
        !port_chain_holds(run.chain, options->has_strict_grade, options->strict_grade)) {
        status = STATUS_NOT_HELD;
    }
    output_discard(&run.picture);
    output_discard(&run.stats);
    free(run.reader);
    port_chain_free(run.chain);
    return status;
}
