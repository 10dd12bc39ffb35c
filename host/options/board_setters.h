/* SPDX-License-Identifier: MIT */
/* The table's setters for what is asked of the board and of a trace: struct board_options and
 * struct trace_options. */
#ifndef SUPERFRAME_BOARD_SETTERS_H
#define SUPERFRAME_BOARD_SETTERS_H

#include "options/options.h"

/* Reads an option's value, as the member `set` of struct option_entry does. The table says what is
 * allowed. */
enum value_verdict set_ports_are_mine(struct options *options, const char *value);
enum value_verdict set_picture(struct options *options, const char *value);
enum value_verdict set_native(struct options *options, const char *value);
enum value_verdict set_stop(struct options *options, const char *value);
enum value_verdict set_bus_wait(struct options *options, const char *value);
enum value_verdict set_frame_seconds(struct options *options, const char *value);
enum value_verdict set_list(struct options *options, const char *value);
enum value_verdict set_statistics(struct options *options, const char *value);
enum value_verdict set_violations(struct options *options, const char *value);
enum value_verdict set_against(struct options *options, const char *value);
enum value_verdict set_to(struct options *options, const char *value);

/* Reads a list of faults with commas between. lose=N, flip=N and flip-read=N, N 1..1000000000, hit
 * one access in N. The others are seed=N, dead=PORT, absent, vanish=N (after N accesses), lost (and
 * the bus says so). */
enum value_verdict set_faults(struct options *options, const char *value);

/* What set_faults() allows, for messages and the help. */
#define FAULTS_ALLOWED                                                                             \
    "seed=N, lose=N, flip=N, flip-read=N, dead=PORT, absent, vanish=N, lost, with commas between"

#endif
