/* SPDX-License-Identifier: MIT */
/* Rays that wait to be followed, kept apart by where they run. */
#ifndef SUPERFRAME_QUEUE_H
#define SUPERFRAME_QUEUE_H

#include "stream/lanes.h"

/* Rays in one object meet the same primitives: the rays that wait in one bin are followed together.
 * Objects beyond the number of bins share bins. A ray is written into a block of its bin and
 * followed where it lies. Some rays are copied once, to fill a block. */
enum { QUEUE_BINS = 8, QUEUE_BLOCKS = 256 };

/* The full blocks of a bin, the last one first out, and the block that is not full yet. */
struct queue_bin {
    uint32_t count; /* rays in all of them */
    uint32_t full, filling;
};

struct queue {
    bool is_grey;    /* all weights are grey: red alone is kept */
    bool overflowed; /* a ray found no room, and is lost */
    struct queue_bin bins[QUEUE_BINS];
    uint32_t free;               /* the first block that is in no bin, QUEUE_BLOCKS: none is left */
    uint32_t next[QUEUE_BLOCKS]; /* the block behind it, among the full or the free ones */
    struct ray_lanes blocks[QUEUE_BLOCKS];
};

void queue_clear(struct queue *queue, bool is_grey);

/* Puts the rays of the lanes that are wanted (1, all others 0) into their bins. */
void queue_push(struct queue *queue, const struct ray_columns *rays, const uint32_t wanted[LANES]);

/* Returns how many rays wait in the fullest bin. */
uint32_t queue_fullest(const struct queue *queue);

/* Takes a block of the fullest bin: the full one that came last, if there is one. Sets *block to
 * its number and returns how many rays it has, 0 where none wait. The other lanes hold copies of
 * these rays. The block is the caller's until queue_give_back(). */
uint32_t queue_take(struct queue *queue, uint32_t *block);
void queue_give_back(struct queue *queue, uint32_t block);

#endif
