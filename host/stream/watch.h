/* SPDX-License-Identifier: MIT */
/* The pixels of a band where an accuracy is asked for: the thresholds and the tail of each. */
#ifndef SUPERFRAME_WATCH_H
#define SUPERFRAME_WATCH_H

#include "stream/hits.h"
#include "tail.h"

struct watched_pixels {
    struct tail_thresholds at[TAIL_STEPS];
    uint8_t steps[TARGET_PIXELS];    /* of the look at work, an index into `at` */
    uint64_t rays[TARGET_PIXELS];    /* of the looks before */
    struct tail tail[TARGET_PIXELS]; /* without what is gathered */
    struct tail_verdict best[TARGET_PIXELS];
};

/* One kind of children, by lane: where they go, and what they weigh. */
struct watched_children {
    const uint32_t *way; /* enum estimate_way */
    const struct energy_lanes *weight;
    bool is_grey; /* red stands for all three weights */
};

/* Begins the looks at the first `count` pixels of a band. */
void watch_begin(struct watched_pixels *pixels, const struct scene *scene, uint32_t count);

/* Enters the children of the rays that have hit a boundary into the tails of their pixels: watch()
 * of firmware/growth.c. Sets which of the children are followed, and where their parts are
 * summed. */
void watch_children(struct watched_pixels *pixels, const struct scene *scene,
                    const struct ray_lanes *rays, const struct hit_lanes *hit,
                    const struct watched_children *children, uint32_t follow[LANES],
                    uint32_t target[LANES]);

#endif
