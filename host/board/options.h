/* SPDX-License-Identifier: MIT */
/* Options about the board behind the ports: what is shown of it, what spoils it, what it costs. */
#ifndef SUPERFRAME_BOARD_OPTIONS_H
#define SUPERFRAME_BOARD_OPTIONS_H

#include <stdbool.h>
#include <stdint.h>

#include "board.h"
#include "fault_bus.h"

/* Which picture a PNG holds. */
enum picture_kind {
    PICTURE_KIND_SCREEN, /* 640 x 400: what the CRT shows */
    PICTURE_KIND_MEMORY, /* 640 x 400: the frame memory, whether it is shown or not */
    PICTURE_KIND_WHOLE   /* 640 x 416: the frame memory with its hidden blocks below */
};

/* All zero but the base: no option was given. Strings point into argv. */
struct board_options {
    bool has_profile, has_base; /* given, and not the default */
    enum board_profile profile;
    uint16_t base;
    bool strict, has_strict_grade;
    enum board_grade strict_grade;
    enum picture_kind picture;
    const char *native; /* a PNG of the PC-9801's own screen; NULL: black */
    bool has_faults;
    struct fault_plan faults;
    uint64_t stop;        /* the last access that is played; 0: all are */
    double bus_wait;      /* nanoseconds added to each bus access, 0..100000 */
    double frame_seconds; /* what the whole frame takes; 0: not known */
};

#endif
