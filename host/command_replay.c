/* SPDX-License-Identifier: MIT */
/* superframe replay: port traces, binary or plain text, on the emulated board. */
#include <errno.h>
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

#include "command.h"
#include "output.h"
#include "port_chain.h"
#include "screen_output.h"
#include "stats.h"
#include "stopwatch.h"
#include "trace_replay.h"

/* One run of the command. */
struct replay_run {
    const struct options *options;
    struct timespec began;
    struct port_chain *chain;
    struct trace_reader *reader; /* 66 KB: not on the stack */
    struct output picture, stats;
};

static int complain_about_trace(const char *path, const struct trace_error *error) {
    char text[512];
    (void)trace_error_format(text, sizeof text, path, error);
    return bad_input("%s", text);
}

/* Plays one file on the chain: what it wrote is written, what it read is read and compared. */
static int play(struct replay_run *run, const char *path, FILE *file) {
    const struct trace_header board = {run->options->profile, run->options->base};
    struct trace_replay replay;
    enum trace_status status = trace_reader_open(run->reader, file);
    memset(&replay, 0, sizeof replay);
    if (status == TRACE_OK) {
        status = trace_reader_require(run->reader, &board);
    }
    if (status == TRACE_OK) {
        status = trace_replay(run->reader, &run->chain->hash.bus, 0, &replay);
    }
    if (replay.different_reads > 0) {
        complain("%s: %" PRIu64 " reads were answered otherwise than recorded, the first at access "
                 "%" PRIu64,
                 path, replay.different_reads, replay.first_different);
    }
    return status == TRACE_END ? STATUS_DONE : complain_about_trace(path, &run->reader->error);
}

static int play_all(struct replay_run *run) {
    int status = STATUS_DONE;
    for (int i = 0; i < run->options->operand_count && status == STATUS_DONE; i++) {
        const char *path = run->options->operands[i];
        bool is_stdin = strcmp(path, "-") == 0;
        FILE *file = is_stdin ? stdin : fopen(path, "rb");
        if (file == NULL) {
            return bad_input("%s: cannot be read: %s", path, strerror(errno));
        }
        status = play(run, path, file);
        if (!is_stdin) {
            (void)fclose(file);
        }
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
    if ((options->output != NULL && !output_open(&run->picture, options->output)) ||
        (options->stats != NULL && !output_open(&run->stats, options->stats))) {
        return STATUS_FAILED;
    }
    return STATUS_DONE;
}

static int write_results(struct replay_run *run) {
    if (run->picture.file != NULL && !screen_write(&run->picture, run->chain)) {
        return STATUS_FAILED;
    }
    if (run->stats.file != NULL) {
        const struct run_stats stats = {.chain = run->chain,
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
