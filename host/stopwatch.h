/* SPDX-License-Identifier: MIT */
/* Seconds by a clock that nobody sets. */
#ifndef SUPERFRAME_STOPWATCH_H
#define SUPERFRAME_STOPWATCH_H

#include <time.h>

static inline struct timespec stopwatch_start(void) {
    struct timespec now = {0, 0};
    (void)clock_gettime(CLOCK_MONOTONIC, &now);
    return now;
}

/* Seconds since then. */
static inline double stopwatch_seconds(const struct timespec *began) {
    struct timespec now = stopwatch_start();
    return (double)(now.tv_sec - began->tv_sec) + (double)(now.tv_nsec - began->tv_nsec) * 1e-9;
}

#endif
