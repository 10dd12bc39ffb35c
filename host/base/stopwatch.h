/* SPDX-License-Identifier: MIT */
/* Measures time by a clock that nobody sets. */
#ifndef SUPERFRAME_STOPWATCH_H
#define SUPERFRAME_STOPWATCH_H

#include <stdint.h>
#include <time.h>

static inline struct timespec stopwatch_start(void) {
    struct timespec now = {0, 0};
    (void)clock_gettime(CLOCK_MONOTONIC, &now);
    return now;
}

/* Returns the seconds from one reading to a later one. */
static inline double stopwatch_between(const struct timespec *began, const struct timespec *ended) {
    return (double)(ended->tv_sec - began->tv_sec) +
           (double)(ended->tv_nsec - began->tv_nsec) * 1e-9;
}

/* Returns the seconds since a reading. */
static inline double stopwatch_seconds(const struct timespec *began) {
    struct timespec now = stopwatch_start();
    return stopwatch_between(began, &now);
}

/* Returns milliseconds since a moment that stays the same while the machine runs. */
static inline int64_t stopwatch_ms(void) {
    const struct timespec now = stopwatch_start();
    return (int64_t)now.tv_sec * 1000 + now.tv_nsec / 1000000;
}

#endif
