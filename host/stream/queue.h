/* SPDX-License-Identifier: MIT */
/* Rays that wait to be followed, kept apart by where they run. */
#ifndef SUPERFRAME_QUEUE_H
#define SUPERFRAME_QUEUE_H

#include "stream/lanes.h"

/* Rays in one object meet the same primitives: those that wait in one bin are followed together.
 * Objects beyond the number of bins share them. A ray is written once, into a block of its bin, and
 * followed where it lies. */
enum { QUEUE_BINS = 8, QUEUE_BLOCKS = 256 };

/* Its blocks that are full, the last one first out, and the one that is not full yet. */
struct queue_bin {
    uint32_t count; /* rays in all of them */
    uint32_t full, filling;
};

struct queue {
    bool is_grey;    /* all weights are: red alone is kept */
    bool overflowed; /* a ray found no room, and is lost */
    struct queue_bin bins[QUEUE_BINS];
    uint32_t free;               /* the first block that is in no bin, QUEUE_BLOCKS: none is left */
    uint32_t next[QUEUE_BLOCKS]; /* the one behind it, among the full or the free ones */
    struct ray_lanes blocks[QUEUE_BLOCKS];
};

void queue_clear(struct queue *queue, bool is_grey);

/* Puts in the rays of the lanes that are wanted (not 0). */
void queue_push(struct queue *queue, const struct ray_columns *rays, const uint32_t wanted[LANES]);

/* The most rays that wait in one bin. */
uint32_t queue_fullest(const struct queue *queue);

/* A block of the fullest bin, the full one that came last if there is one: sets its number and
 * returns that of its rays, 0 where none wait. The other lanes hold copies of them. The block is
 * the caller's until it gives it back. */
uint32_t queue_take(struct queue *queue, uint32_t *block);
void queue_give_back(struct queue *queue, uint32_t block);

#endif
