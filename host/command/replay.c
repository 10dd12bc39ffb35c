/* SPDX-License-Identifier: MIT */
/* superframe replay: port traces, binary or plain text, on the emulated board. */
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

#include "base/stopwatch.h"
#include "board/session.h"
#include "command/command.h"
#include "stats/run.h"
#include "trace/file.h"
#include "trace_replay.h"

/* One run of the command. */
struct replay_run {
    const struct options *options;
    struct session session;
    struct trace_reader *reader; /* 66 KB: not on the stack */
    uint64_t played;             /* accesses, of all traces */
};

/* Plays one file on the board: its writes are written, its reads are read and compared. */
static int play(struct replay_run *run, struct bus *bus, const char *path) {
    const struct trace_header board = {run->options->board.profile, run->options->board.base};
    uint64_t stop = run->options->board.stop;
    struct trace_replay replay;
    enum trace_status status = trace_reader_require(run->reader, &board);
    memset(&replay, 0, sizeof replay);
    if (status == TRACE_OK) {
        status = trace_replay(run->reader, bus, stop == 0 ? 0 : stop - run->played, &replay);
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
    struct bus *bus = session_bus(&run->session);
    uint64_t stop = run->options->board.stop;
    int status = STATUS_DONE;
    for (int i = 0; i < run->options->operand_count && status == STATUS_DONE; i++) {
        FILE *file;
        if (stop != 0 && run->played == stop) {
            return STATUS_DONE;
        }
        status = trace_file_open(run->options->operands[i], &file, run->reader);
        if (status == STATUS_DONE) {
            status = play(run, bus, run->options->operands[i]);
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
    const struct session_files files = {.picture = options->output, .stats = options->stats};
    run->reader = malloc(sizeof *run->reader);
    if (run->reader == NULL) {
        return failure("out of memory");
    }
    int status = session_begin(&run->session, &options->board, NULL);
    return status == STATUS_DONE ? session_open(&run->session, &files) : status;
}

static int write_results(struct replay_run *run) {
    const struct run_stats stats = {.session = &run->session};
    return session_commit_picture(&run->session) && stats_commit(&stats) ? STATUS_DONE
                                                                         : STATUS_FAILED;
}

static int run_replay(const struct options *options) {
    struct replay_run run;
    memset(&run, 0, sizeof run);
    run.options = options;
    run.session.began = stopwatch_start();
    int status = prepare(&run);
    if (status == STATUS_DONE) {
        status = play_all(&run);
    }
    if (status == STATUS_DONE) {
        status = write_results(&run);
    }
    if (status == STATUS_DONE) {
        status = session_judge(&run.session);
    }
    session_free(&run.session);
    free(run.reader);
    return status;
}

static bool check_replay(const struct options *options, struct options_error *error) {
    return options->output != NULL || options->stats != NULL || options->board.strict ||
           options_refuse(error, "replay: -o FILE.png is missing (or --stats or --strict)");
}

const struct command command_replay = {
    .name = "replay",
    COMMAND_OPERANDS("TRACE...", 1, 1000, OPERANDS_FILES),
    .summary = "Play port traces on the emulated board.",
    .groups = OPTION_GROUPS(&group_picture, &group_statistics, &group_board, &group_screen,
                            &group_faults, &group_stop),
    .examples = COMMAND_EXAMPLES("replay my.trace -o screen.png",
                                 "replay my.trace --strict --stop 10000 --stats -"),
    .check = check_replay,
    .run = run_replay};
