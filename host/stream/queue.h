/* SPDX-License-Identifier: MIT */
/* Rays that wait to be followed, kept apart by where they run. */
#ifndef SUPERFRAME_QUEUE_H
#define SUPERFRAME_QUEUE_H

#include "lanes.h"

/* Rays in one object meet the same primitives: those that wait in one bin are followed together.
 * Objects beyond the number of bins share them. The room is no power of two: a cache would keep all
 * quantities of one ray in the same few lines. */
enum { QUEUE_BINS = 8, QUEUE_ROOM = 4096 + 80 };

/* See struct ray_lanes. */
struct queue_bin {
    uint32_t count;
    real_length origin_x[QUEUE_ROOM], origin_y[QUEUE_ROOM], origin_z[QUEUE_ROOM];
    real_unit direction_x[QUEUE_ROOM], direction_y[QUEUE_ROOM], direction_z[QUEUE_ROOM];
    real_energy red[QUEUE_ROOM], green[QUEUE_ROOM], blue[QUEUE_ROOM];
    real_length from[QUEUE_ROOM];
    uint32_t inside[QUEUE_ROOM], path[QUEUE_ROOM], target[QUEUE_ROOM];
};

struct queue {
    bool is_grey;    /* all weights are: red alone is kept */
    bool overflowed; /* a ray found no room, and is lost */
    struct queue_bin bins[QUEUE_BINS];
};

void queue_clear(struct queue *queue, bool is_grey);

/* Puts in the rays of the lanes that are wanted (not 0). */
void queue_push(struct queue *queue, const struct ray_lanes *rays, const uint32_t wanted[LANES]);

/* The most rays that wait in one bin. */
uint32_t queue_fullest(const struct queue *queue);

/* Takes up to LANES rays that came last out of the fullest bin: their number. The other lanes keep
 * what they had. */
uint32_t queue_pop(struct queue *queue, struct ray_lanes *rays);

#endif
