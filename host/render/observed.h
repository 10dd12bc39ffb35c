/* SPDX-License-Identifier: MIT */
/* What a host can see of the tree of rays of one pixel, in doubles, whatever the arithmetic. */
#ifndef SUPERFRAME_OBSERVED_H
#define SUPERFRAME_OBSERVED_H

#include <stdbool.h>
#include <stdint.h>

/* Lengths are in scaled units, intensities in levels; weights are products of coefficients. The
 * kinds and ends are those of firmware/tree.h. */
enum observed_kind { OBSERVED_EYE, OBSERVED_REFLECTED, OBSERVED_REFRACTED };
enum observed_why {
    OBSERVED_LEFT,
    OBSERVED_DEPTH,
    OBSERVED_THRESHOLD,
    OBSERVED_NOTHING,
    OBSERVED_BUDGET
};

enum { OBSERVED_ALL_CHANNELS = 3 };

/* A branch that has come to a boundary. */
struct observed_node {
    uint32_t number, parent; /* from 1 in the order they are reached; parent 0: the eye */
    enum observed_kind kind;
    uint8_t channel;        /* 0, 1, 2 or OBSERVED_ALL_CHANNELS */
    uint8_t events;         /* on the path from the eye to here, this boundary not counted */
    uint32_t before, after; /* objects on the near and the far side; 0: the air */
    uint32_t primitive, surface;
    uint8_t face;
    bool leaving;
    double distance; /* from the node before */
    double where[3], normal[3];
    double weight[3]; /* after what the media on the path have absorbed */
    double local[3];  /* own intensity: Eq. (1) without its last two terms */
};

/* A branch that is followed no farther. */
struct observed_end {
    uint32_t parent; /* the node where it began or would have begun */
    enum observed_kind kind;
    uint8_t channel;
    double weight[3];
    enum observed_why why;
};

/* Where an accuracy is asked for, a pixel may begin again. What was reported before the new node 1
 * is void. */
struct pixel_observer {
    void *context;
    void (*node)(void *context, const struct observed_node *node);
    void (*end)(void *context, const struct observed_end *end);
};

#endif
