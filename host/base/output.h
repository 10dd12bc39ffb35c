/* SPDX-License-Identifier: MIT */
/* Files that appear whole under the asked name, or not at all. */
#ifndef SUPERFRAME_OUTPUT_H
#define SUPERFRAME_OUTPUT_H

#include <stdbool.h>
#include <stdio.h>

/* A result on its way to its place. A regular file, or one that is not there yet, is written under
 * another name in the same folder and renamed at the end; a symbolic link stays and what it names
 * is replaced. "-" is standard output. Anything else (a terminal, /dev/null, a FIFO) is written
 * to as it is. All zero: not open. */
struct output {
    FILE *file;
    const char *path; /* as it was asked for; must outlive the output */
    char *target;     /* what is replaced; NULL where it is written to directly */
    char *temporary;
};

/* Opens the output. False, with the reason printed, if it can't be written. */
bool output_open(struct output *output, const char *path);

/* Hands everything on and puts the file into its place. False, with the reason printed and nothing
 * left under the asked name that was not there before. The output is closed either way. */
bool output_commit(struct output *output);

/* Gives the output up: what was there before stays. Harmless if it is not open. */
void output_discard(struct output *output);

/* Prints why a write to the output failed. */
void output_complain(const struct output *output, const char *reason);

#endif
