/* SPDX-License-Identifier: MIT */
/* The command line: which options a sub-command takes, and their values, checked. */
#ifndef SUPERFRAME_OPTIONS_H
#define SUPERFRAME_OPTIONS_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

#include "adapter/options.h"
#include "board.h"
#include "board/options.h"
#include "scene/overrides.h"
#include "trace.h"

enum command_id {
    COMMAND_RENDER,
    COMMAND_SCENES,
    COMMAND_CHECK,
    COMMAND_COMPILE,
    COMMAND_EXPORT,
    COMMAND_TREE,
    COMMAND_REPLAY,
    COMMAND_COMPARE,
    COMMAND_MEASURE,
    COMMAND_PAPER,
    COMMAND_DEVICES,
    COMMAND_ADAPTER,
    COMMAND_TRACE,
    COMMAND_BOOT,
    COMMAND_COUNT
};

enum bus_choice {
    BUS_CHOICE_EMULATOR,
    BUS_CHOICE_TRACE,
    BUS_CHOICE_PORTS,
    BUS_CHOICE_USB,
    BUS_CHOICE_HID
};

/* What `superframe trace` is asked for. */
struct trace_options {
    bool lists, counts, judges; /* --list, --statistics, --violations */
    const char *against;        /* --compare; NULL: not given */
    bool converts;              /* --to */
    enum trace_format to;
};

struct options;

/* A sub-command. */
struct command {
    enum command_id id;
    const char *name;
    const char *operands;                      /* for the usage line */
    const char *summary;                       /* one sentence */
    int least, most;                           /* how many operands it takes */
    int (*run)(const struct options *options); /* returns an exit status */
};

/* The options of a command line. Strings point into argv. */
struct options {
    bool help;
    char **operands; /* what is no option */
    int operand_count;

    const char *output;     /* -o; NULL: not given; "-": standard output */
    const char *arithmetic; /* a name that arithmetic_find() knows */
    bool has_arithmetic;    /* --arith was given */
    struct scene_overrides overrides;
    enum bus_choice bus;
    const char *bus_file;       /* of --bus trace:FILE */
    const char *trace;          /* NULL: none */
    const char *keep_exposures; /* a folder; NULL: none */
    bool has_rows;
    unsigned first_row, last_row; /* rows first .. last-1 */
    bool ports_are_mine;
    struct board_options board;
    struct adapter_options adapter;
    struct trace_options tracing;
    unsigned jobs;     /* 1..OPTIONS_JOBS_MOST */
    const char *stats; /* NULL: none; "-": standard output */
    bool quiet;
    bool pov;                   /* export writes source for POV-Ray */
    bool dot;                   /* tree writes a graph for Graphviz */
    bool validates;             /* check holds the compiler's tables against the scene */
    bool minimal;               /* compile writes a feature_set.h instead of the tables */
    uint64_t instructions_most; /* that an emulated CPU may run */
    uint64_t escape_after;      /* Esc when the keyboard has been asked so many times; 0: never */
    int within;                 /* LSB, 0..255 */
    double share;               /* per cent, 0..100 */
    bool json;
    const char *difference; /* NULL: no picture of it */
    const char *signatures; /* render: where they go; compare: the first file; NULL: none */
};

enum { OPTIONS_JOBS_MOST = 256 };

/* Instructions: a frame of 640 x 400 takes some 60 thousand million. */
#define OPTIONS_INSTRUCTIONS UINT64_C(200000000000)

/* Why a command line is refused. */
struct options_error {
    char text[512];
};

/* What an option's value turned out to be. */
enum value_verdict { VALUE_TAKEN, VALUE_WRONG, VALUE_NOT_BUILT };

/* One option of the table. */
struct option_entry {
    const char *name;  /* without the dashes */
    char letter;       /* of the short form, or 0 */
    const char *value; /* what the help calls the value; NULL: none; "[=X]": may be left out */
    unsigned commands; /* bit 1 << command_id for each command that takes the option */
    enum value_verdict (*set)(struct options *options, const char *value);
    const char *allowed; /* what the value may be, for messages and the help */
    const char *help;    /* NULL: known, but not built into this version; the help leaves it out */
};

/* Ended by an entry without a name. */
extern const struct option_entry option_table[];

/* Reads what stands after the sub-command's name; argv[0] is that name. argv is permuted: options
 * may stand anywhere. False with *error filled where the command line is refused. */
bool options_parse(const struct command *command, int argc, char **argv, struct options *options,
                   struct options_error *error);

/* Prints the options of a sub-command. */
void options_print(FILE *out, enum command_id command);

#endif
