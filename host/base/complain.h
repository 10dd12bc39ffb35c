/* SPDX-License-Identifier: MIT */
/* How the program complains, and what its exit status says. */
#ifndef SUPERFRAME_COMPLAIN_H
#define SUPERFRAME_COMPLAIN_H

/* What the program's exit status says. */
enum exit_status {
    STATUS_DONE = 0,
    STATUS_FAILED = 1,    /* while working: the disk is full, a pipe was closed */
    STATUS_BAD_INPUT = 2, /* bad usage, or a file that can't be used */
    STATUS_NOT_HELD = 3,  /* a strict check or a comparison did not hold */
    STATUS_SIGNAL = 128   /* plus the number of the signal that ended the work: 130 for SIGINT */
};

#if defined(__GNUC__)
#define FORMAT_OF_PRINTF __attribute__((format(printf, 1, 2)))
#else
#define FORMAT_OF_PRINTF
#endif

/* Prints "superframe: ", the message and a line's end to standard error. Each line of a message is
 * printed so. A line that begins with a blank shows what the line before speaks of. Such a line is
 * printed as it is, and on a terminal only. */
void complain(const char *format, ...) FORMAT_OF_PRINTF;

/* Complains as complain() does; returns STATUS_FAILED. */
int failure(const char *format, ...) FORMAT_OF_PRINTF;

/* Complains as complain() does, for messages that are made elsewhere; returns STATUS_BAD_INPUT. */
int bad_input(const char *format, ...) FORMAT_OF_PRINTF;

#endif
