/* SPDX-License-Identifier: MIT */
/* Options about the board behind the ports: what is shown of it, what spoils it, what it costs. */
#ifndef SUPERFRAME_BOARD_OPTIONS_H
#define SUPERFRAME_BOARD_OPTIONS_H

#include <stdbool.h>
#include <stdint.h>

#include "fault_bus.h"

/* Which picture a PNG holds. */
enum picture_kind {
    PICTURE_KIND_SCREEN, /* 640 x 400: what the CRT shows */
    PICTURE_KIND_MEMORY, /* 640 x 400: the frame memory, whether it is shown or not */
    PICTURE_KIND_WHOLE   /* 640 x 416: the frame memory with its hidden blocks below */
};

/* All zero: none of them was given. Strings point into argv. */
struct board_options {
    enum picture_kind picture;
    const char *native; /* a PNG of the PC-9801's own screen; NULL: black */
    bool has_faults;
    struct fault_plan faults;
    uint64_t stop;        /* the last access that is played; 0: all are */
    double bus_wait;      /* nanoseconds added to each bus access, 0..100000 */
    double frame_seconds; /* what the whole frame takes; 0: not known */
};

/* These read a value; false if it is not allowed. */
bool read_picture_kind(struct board_options *options, const char *value);
bool read_native(struct board_options *options, const char *value);
bool read_stop(struct board_options *options, const char *value);
bool read_bus_wait(struct board_options *options, const char *value);
bool read_frame_seconds(struct board_options *options, const char *value);

/* A list of faults with commas between: seed=N, lose=N, flip=N, flip-read=N (one access in N, N
 * 1..1000000000), dead=PORT, absent, vanish=N (after N accesses), lost (and the bus says so). */
bool read_faults(struct board_options *options, const char *value);

/* What read_faults() allows, for messages and the help. */
#define FAULTS_ALLOWED                                                                             \
    "seed=N, lose=N, flip=N, flip-read=N, dead=PORT, absent, vanish=N, lost, with commas between"

#endif
