/* SPDX-License-Identifier: MIT */
/* Rays that wait to be followed, kept apart by where they run. */
#ifndef SUPERFRAME_QUEUE_H
#define SUPERFRAME_QUEUE_H

#include "lanes.h"

/* Rays in one object meet the same primitives: those that wait in one bin are followed together.
 * Objects beyond the number of bins share them. */
enum { QUEUE_BINS = 8, QUEUE_ROOM = 4096 };

/* A queue's numbers are all of one type: those of the arithmetics that streams are built for are.
 */
enum { QUEUE_NUMBERS = 10, QUEUE_WORDS = 3 };

struct queue_bin {
    uint32_t count;
    real_length numbers[QUEUE_NUMBERS][QUEUE_ROOM];
    uint32_t words[QUEUE_WORDS][QUEUE_ROOM];
};

struct queue {
    bool overflowed; /* a ray found no room, and is lost */
    struct queue_bin bins[QUEUE_BINS];
};

void queue_clear(struct queue *queue);

/* Puts in the rays of the lanes that are wanted (not 0). */
void queue_push(struct queue *queue, const struct ray_lanes *rays, const uint32_t wanted[LANES]);

/* The most rays that wait in one bin. */
uint32_t queue_fullest(const struct queue *queue);

/* Takes up to LANES rays that came last out of the fullest bin: their number. The other lanes keep
 * what they had. */
uint32_t queue_pop(struct queue *queue, struct ray_lanes *rays);

#endif
