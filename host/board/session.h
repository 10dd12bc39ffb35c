/* SPDX-License-Identifier: MIT */
/* Does what every sub-command with a board needs: puts buses together, writes results, judges. The
 * functions below stand in the order in which a sub-command calls them. */
#ifndef SUPERFRAME_SESSION_H
#define SUPERFRAME_SESSION_H

#include <stdbool.h>
#include <stdint.h>
#include <time.h>

#include "base/output.h"
#include "board/options.h"
#include "board/port_chain.h"
#include "picture/sink.h"

/* The files of a session's results, by name. NULL: that result is not asked for; "-": standard
 * output. Names must outlive the session. */
struct session_files {
    const char *picture, *trace, *stats;
};

/* Describes a device that takes the board's place at the end of the buses. */
struct session_device {
    struct bus *bus;                      /* stays the caller's; NULL: an empty slot */
    void (*explain)(const void *context); /* prints why the bus failed; NULL: the session does */
    const void *context;                  /* of explain */
};

/* All zero: not begun, which session_free() takes too. */
struct session {
    const struct board_options *options;
    struct timespec began; /* by the clock of stopwatch_start() */
    struct port_chain *chain;
    struct session_device device;
    struct session_files files;
    struct picture_sink *picture; /* NULL: not asked for */
    char *partial_name;           /* where the picture went instead; NULL: it did not */
    struct output trace, stats;   /* not open: not asked for */
};

/* Begins a session with a board of the asked profile at the asked base, or with a device. The
 * device is copied; NULL: the board. Options must outlive the session. Returns STATUS_DONE;
 * otherwise the reason is printed. */
int session_begin(struct session *session, const struct board_options *options,
                  const struct session_device *device);

/* Puts in the PC's own screen, faults, and where statistics are asked for the count of accesses.
 * Opens all results, so that a bad name is known before the work begins. Puts in the recorder of
 * the trace. Has to be called before any access. Returns STATUS_DONE; otherwise the reason is
 * printed. */
int session_open(struct session *session, const struct session_files *files);

/* Lets the trace, where one is asked for, end after so many accesses, at least 1. What is past them
 * is told on standard error. Has to be called before any access. */
void session_limit_trace(struct session *session, uint64_t accesses_most);

/* Returns the bus to bind. Writes are hashed and timed where statistics are asked for. */
struct bus *session_bus(struct session *session);

/* Hands on what the buses still hold, and puts the trace into its place. No access may follow.
 * Returns STATUS_DONE; otherwise the reason is printed. */
int session_end_accesses(struct session *session);

/* Lets the picture go to NAME.partial.png, since the work was interrupted: what stands under the
 * asked name stays. A picture that goes to standard output or to a device goes there all the same.
 * False, with the reason printed, on failure. */
bool session_divert_picture(struct session *session);

/* Returns the picture that is asked for, as it stands now: the screen, or the memory. The picture
 * holds until the next access. */
struct shown_picture session_picture(struct session *session);

/* Puts the picture into its place, where one is asked for. A screen that is black because the board
 * was not set up is reported on standard error. False, with the reason printed, on failure. */
bool session_commit_picture(struct session *session);

/* Returns STATUS_NOT_HELD where --strict is asked for and does not hold; STATUS_DONE otherwise.
 * What breaks the check is printed. */
int session_judge(const struct session *session);

/* Unbinds and frees the session, and gives up what was not committed. */
void session_free(struct session *session);

#endif
