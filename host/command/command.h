/* SPDX-License-Identifier: MIT */
/* What the sub-commands of superframe share: exit statuses, their table, and how they complain. */
#ifndef SUPERFRAME_COMMAND_H
#define SUPERFRAME_COMMAND_H

#include "options/options.h"

#define SUPERFRAME_VERSION "0.1.0"

/* What the program's exit status says. */
enum exit_status {
    STATUS_DONE = 0,
    STATUS_FAILED = 1,    /* while working: the disk is full, a pipe was closed */
    STATUS_BAD_INPUT = 2, /* bad usage, or a file that can't be used */
    STATUS_NOT_HELD = 3,  /* a strict check or a comparison did not hold */
    STATUS_SIGNAL = 128   /* plus the number of the signal that ended the work: 130 for SIGINT */
};

/* A sub-command. */
struct command {
    const char *name;
    const char *operands;                      /* for the usage line */
    const char *summary;                       /* one sentence */
    int least, most;                           /* how many operands it takes */
    int (*run)(const struct options *options); /* NULL: not built yet */
};

extern const struct command commands[]; /* in the order of enum command_id */

int run_render(const struct options *options);
int run_scenes(const struct options *options);
int run_check(const struct options *options);
int run_boot(const struct options *options);
int run_compile(const struct options *options);
int run_export(const struct options *options);
int run_tree(const struct options *options);
int run_replay(const struct options *options);
int run_devices(const struct options *options);
int run_adapter(const struct options *options);
int run_compare(const struct options *options);
int run_measure(const struct options *options);
int run_paper(const struct options *options);
int run_trace(const struct options *options);

#if defined(__GNUC__)
#define FORMAT_OF_PRINTF __attribute__((format(printf, 1, 2)))
#else
#define FORMAT_OF_PRINTF
#endif

/* Prints "superframe: ", the message and a line's end to standard error. */
void complain(const char *format, ...) FORMAT_OF_PRINTF;

/* The same, for messages that are made elsewhere; returns STATUS_BAD_INPUT. */
int bad_input(const char *format, ...) FORMAT_OF_PRINTF;

#endif
