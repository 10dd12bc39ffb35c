/* SPDX-License-Identifier: MIT */
/* Files that appear whole under the name that was asked for, or not at all. */
#ifndef SUPERFRAME_OUTPUT_H
#define SUPERFRAME_OUTPUT_H

#include <stdbool.h>
#include <stdio.h>

/* A result on its way to its place. A regular file, or one that is not there yet, is first written
 * under another name in the same folder, then renamed. A symbolic link stays, and the file that
 * the link names is replaced. "-" is standard output. Anything else (a terminal, /dev/null, a FIFO)
 * is written to as it is. All zero: not open. */
struct output {
    FILE *file;
    const char *path; /* as it was asked for; must outlive the output */
    char *target;     /* what is replaced; NULL where it is written to directly */
    char *temporary;
};

/* Opens the output. False, with the reason printed, if the output can't be written. */
bool output_open(struct output *output, const char *path);

/* Hands everything on and puts the file into its place. On failure: false, with the reason printed;
 * what stands under the asked name is what was there before. The output is closed either way. */
bool output_commit(struct output *output);

/* Commits the output where all was written. Otherwise gives the output up and prints errno's
 * reason, which the caller has set to 0 before writing. Returns an exit status. */
int output_finish(struct output *output, bool is_written);

/* Gives the output up: what was there before stays. Harmless if the output is not open. */
void output_discard(struct output *output);

/* Tells whether standard output is a pipe that nobody reads any more. */
bool output_is_closed_pipe(void);

/* Prints why a write to the output failed. Prints nothing where a reader of standard output, head
 * for instance, has had enough. */
void output_complain(const struct output *output, const char *reason);

#endif
