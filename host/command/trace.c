/* SPDX-License-Identifier: MIT */
/* superframe trace: a port trace in words, as statistics, as violations, as a picture. */
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

#include "base/output.h"
#include "board/screen_file.h"
#include "board/strict.h"
#include "command/command.h"
#include "cost_bus.h"
#include "trace/convert.h"
#include "trace/file.h"
#include "trace/print.h"
#include "trace/words.h"
#include "trace_compare.h"
#include "trace_statistics.h"

/* Holds the options that `trace` alone takes. */
struct trace_options {
    struct options common;
    bool lists, counts, judges; /* --list, --statistics, --violations */
    const char *against;        /* --compare; NULL: not given */
    enum trace_format to;       /* --to */
};

/* One run of the command: 1.4 MB. */
struct trace_run {
    const struct options *options;
    const struct trace_options *tracing; /* the same */
    bool lists; /* every access is printed: --list is given, or nothing else is asked for */
    FILE *file;
    struct trace_reader reader;
    struct trace_statistics statistics; /* its board follows the accesses */
    struct cost_bus cost;
    struct native_screen native;
    uint64_t different_reads;
    struct picture_sink *picture; /* NULL: not asked for */
    uint8_t rgb[PICTURE_BYTES];
};

/* ---- One access ----------------------------------------------------------------------------- */

static void print_access(const struct trace_run *run, const struct trace_access *access) {
    char text[TRACE_TEXT_SIZE], words[TRACE_WORDS_SIZE];
    (void)trace_text_format(text, access);
    (void)printf("%9" PRIu64 "  %-15s  %s\n", run->reader.accesses, text,
                 trace_words(words, &run->statistics.board, access));
}

/* Prints a behaviour that the access relied on and that is asked about. */
static void print_behaviour(const struct trace_run *run, const struct trace_access *access,
                            enum board_behaviour behaviour) {
    const struct board *board = &run->statistics.board;
    enum board_profile profile = board->desc.profile;
    char text[TRACE_TEXT_SIZE], place[64] = "           ! ";
    if (!run->lists) {
        (void)trace_text_format(text, access);
        (void)snprintf(place, sizeof place, "access %" PRIu64 ": %s: ", run->reader.accesses, text);
    }
    (void)printf("%s%s: %s (grade %s)\n", place,
                 board_behaviour_is_violation(behaviour, profile) ? "violation" : "relied on",
                 board_behaviour_text(behaviour),
                 board_grade_letter(board_behaviour_grade(behaviour, profile)));
}

static void print_behaviours(const struct trace_run *run, const struct trace_access *access,
                             const struct board_note before[BOARD_BEHAVIOURS]) {
    const struct board *board = &run->statistics.board;
    const struct options *options = run->options;
    for (int i = 0; i < BOARD_BEHAVIOURS; i++) {
        enum board_behaviour behaviour = (enum board_behaviour)i;
        if (board->notes[i].count > before[i].count &&
            strict_minds(board, behaviour, options->board.has_strict_grade,
                         options->board.strict_grade)) {
            print_behaviour(run, access, behaviour);
        }
    }
}

static void note_answer(struct trace_run *run, const struct trace_access *access, uint16_t answer) {
    if (answer == access->value) {
        return;
    }
    run->different_reads++;
    if (run->lists || run->tracing->judges) {
        (void)printf("%s%" PRIu64 "%s the board answers %0*X\n",
                     run->lists ? "           ? access " : "access ", run->reader.accesses, ":",
                     access->width == BUS_WORD ? 4 : 2, answer);
    }
}

static void tell(struct trace_run *run, const struct trace_access *access) {
    struct board_note before[BOARD_BEHAVIOURS];
    memcpy(before, run->statistics.board.notes, sizeof before);
    if (run->lists) {
        print_access(run, access);
    }
    uint16_t answer = trace_statistics_add(&run->statistics, access);
    if (access->is_read) {
        (void)bus_read(&run->cost.bus, access->port, access->width);
        note_answer(run, access, answer);
    } else {
        bus_write(&run->cost.bus, access->port, access->value, access->width);
    }
    if (run->lists || run->tracing->judges) {
        print_behaviours(run, access, before);
    }
}

/* ---- The whole trace ------------------------------------------------------------------------ */

static int follow(struct trace_run *run) {
    uint64_t stop = run->options->board.stop;
    struct trace_access access;
    while (stop == 0 || run->reader.accesses < stop) {
        enum trace_status status = trace_reader_next(&run->reader, &access);
        if (status == TRACE_END) {
            break;
        }
        if (status != TRACE_OK) {
            return trace_file_complain(run->options->operands[0], &run->reader.error);
        }
        tell(run, &access);
        if (ferror(stdout)) {
            break; /* a closed pipe: main() says so */
        }
    }
    if (run->reader.accesses < stop) {
        complain("%s: the trace ends after access %" PRIu64 ", before --stop %" PRIu64,
                 run->options->operands[0], run->reader.accesses, stop);
    }
    return STATUS_DONE;
}

static int conclude(struct trace_run *run) {
    const struct options *options = run->options;
    const struct board *board = &run->statistics.board;
    if (run->different_reads > 0) {
        complain("%s: %" PRIu64 " reads were answered otherwise than recorded",
                 run->options->operands[0], run->different_reads);
    }
    if (run->tracing->judges) {
        (void)printf("%" PRIu64 " violations in %" PRIu64 " accesses, profile %s\n",
                     board_violations(board), board->accesses,
                     board_profile_text(board->desc.profile));
    }
    if (run->tracing->counts) {
        void (*const print)(FILE *, const struct trace_statistics *, const struct cost_bus *,
                            const struct board_options *) =
            options->json ? trace_write_statistics : trace_print_statistics;
        print(stdout, &run->statistics, &run->cost, &options->board);
    }
    if (run->picture != NULL &&
        !board_picture_finish(run->picture, board,
                              options->board.native != NULL ? &run->native : NULL,
                              options->board.picture, run->rgb)) {
        return STATUS_FAILED;
    }
    if (options->board.strict &&
        !strict_holds(board, options->board.has_strict_grade, options->board.strict_grade)) {
        return STATUS_NOT_HELD;
    }
    return STATUS_DONE;
}

static int prepare(struct trace_run *run) {
    const struct options *options = run->options;
    struct board_desc desc;
    int status = trace_file_open(run->options->operands[0], &run->file, &run->reader);
    if (status == STATUS_DONE) {
        status = trace_file_fit(run->options->operands[0], &run->reader, &options->board, &desc);
    }
    if (status != STATUS_DONE) {
        return status;
    }
    if (options->board.native != NULL && !native_read(&run->native, options->board.native)) {
        return STATUS_BAD_INPUT;
    }
    (void)trace_statistics_init(&run->statistics, &desc); /* the desc was looked at */
    cost_bus_init(&run->cost, NULL);
    run->picture = options->output != NULL ? png_sink_open(options->output) : NULL;
    return options->output == NULL || run->picture != NULL ? STATUS_DONE : STATUS_FAILED;
}

static int watch(const struct options *options) {
    static int (*const steps[])(struct trace_run *) = {prepare, follow, conclude};
    const struct trace_options *tracing = (const struct trace_options *)options;
    struct trace_run *run = calloc(1, sizeof *run);
    if (run == NULL) {
        return failure("out of memory");
    }
    run->options = options;
    run->tracing = tracing;
    run->lists = tracing->lists || !(tracing->counts || tracing->judges || options->board.strict ||
                                     options->output != NULL);
    int status = STATUS_DONE;
    for (size_t i = 0; i < sizeof steps / sizeof steps[0] && status == STATUS_DONE; i++) {
        status = steps[i](run);
    }
    picture_sink_close(run->picture);
    trace_file_close(run->file);
    free(run);
    return status;
}

/* ---- Two traces ----------------------------------------------------------------------------- */

/* Two traces: 132 KB. */
struct trace_pair {
    struct trace_reader readers[2];
    FILE *files[2];
    struct trace_difference difference;
};

static int compare_pair(struct trace_pair *pair, const char *const paths[2],
                        const struct board_options *board) {
    struct trace_reader *const readers[2] = {&pair->readers[0], &pair->readers[1]};
    struct trace_difference *difference = &pair->difference;
    struct board_desc desc;
    int status = STATUS_DONE;
    for (int i = 0; i < 2 && status == STATUS_DONE; i++) {
        status = trace_file_open(paths[i], &pair->files[i], readers[i]);
    }
    for (int i = 0; i < 2 && status == STATUS_DONE; i++) {
        status = trace_file_fit(paths[i], readers[i], board, &desc);
    }
    if (status != STATUS_DONE) {
        return status;
    }
    if (trace_compare(readers, difference) != TRACE_OK) {
        return trace_file_complain(paths[difference->failed], &readers[difference->failed]->error);
    }
    if (!difference->is_found) {
        (void)printf("the traces are equal: %" PRIu64 " accesses\n", difference->access);
        return STATUS_DONE;
    }
    trace_print_difference(stdout, difference, paths);
    return STATUS_NOT_HELD;
}

static int compare(const struct options *options, const char *against) {
    const char *const paths[2] = {options->operands[0], against};
    if (strcmp(paths[0], "-") == 0 && strcmp(paths[1], "-") == 0) {
        return bad_input("only one of the two traces can be standard input");
    }
    struct trace_pair *pair = calloc(1, sizeof *pair);
    if (pair == NULL) {
        return failure("out of memory");
    }
    int status = compare_pair(pair, paths, &options->board);
    trace_file_close(pair->files[0]);
    trace_file_close(pair->files[1]);
    free(pair);
    return status;
}

static int run_trace(const struct options *options) {
    const struct trace_options *tracing = (const struct trace_options *)options;
    if (tracing->against != NULL) {
        return compare(options, tracing->against);
    }
    if (!options->converts) {
        return watch(options);
    }
    const struct trace_conversion conversion = {.path = options->operands[0],
                                                .output =
                                                    options->output != NULL ? options->output : "-",
                                                .to = tracing->to,
                                                .stop = options->board.stop,
                                                .board = &options->board};
    return trace_convert(&conversion);
}

static const char *printed(const struct options *options) {
    const struct trace_options *tracing = (const struct trace_options *)options;
    return tracing->lists || tracing->counts || tracing->judges ? "what is told" : NULL;
}

/* Checks that no options of the command exclude each other. */
static bool check_trace(const struct options *options, struct options_error *error) {
    const struct trace_options *tracing = (const struct trace_options *)options;
    bool tells = printed(options) != NULL || options->board.strict;
    if (options->json && (!tracing->counts || tracing->lists || tracing->judges)) {
        return options_refuse(error, "--json goes with --statistics alone");
    }
    if (tracing->against != NULL && (options->converts || tells || options->output != NULL)) {
        return options_refuse(error, "--compare goes with --profile and --base only");
    }
    if (options->converts && tells) {
        return options_refuse(error, "--to goes with --profile, --base, --stop and -o only");
    }
    if (options->converts &&
        (options->board.native != NULL || options->board.picture != PICTURE_KIND_SCREEN)) {
        return options_refuse(error,
                              "--to makes a trace, no picture: not with --native or --picture");
    }
    return true;
}

static const char *const forms[] = {[TRACE_BINARY] = "binary", [TRACE_TEXT] = "text", NULL};
static const struct option_group group_own = {
    "Trace",
    OPTION_ENTRIES(
        {.name = "list",
         FLAG_IN(struct trace_options, lists),
         .help = "print every access in words"},
        {.name = "statistics",
         FLAG_IN(struct trace_options, counts),
         .help = "print what was written how often, pixels touched, and what it costs"},
        {.name = "violations",
         FLAG_IN(struct trace_options, judges),
         .help = "print each violation with the number of its access"},
        {.name = "compare",
         .value = "TRACE",
         TEXT_IN(struct trace_options, against),
         .role = ROLE_INPUT,
         .help = "print the first difference from another trace; none: exit status 0, else 3"},
        {.name = "to",
         .value = "FORM",
         WORD_IN(struct trace_options, to, forms),
         OPTION_GIVEN(converts),
         .help = "convert to -o FILE"})};

const struct command command_trace = {
    .name = "trace",
    COMMAND_OPERANDS("TRACE", 1, 1, OPERANDS_FILES),
    .summary = "Tell a port trace in words.",
    .size = sizeof(struct trace_options),
    .groups = OPTION_GROUPS(&group_picture, &group_own, &group_json, &group_board_of_trace,
                            &group_screen, &group_stop),
    .examples = COMMAND_EXAMPLES("trace my.trace --list | head",
                                 "trace my.trace --statistics --violations"),
    .printed = printed,
    .check = check_trace,
    .run = run_trace};
