/* SPDX-License-Identifier: MIT */
/* The tree of rays of one pixel: Eq. (2) and (3). */
#ifndef SUPERFRAME_TREE_H
#define SUPERFRAME_TREE_H

#include "ray.h"

/* Which light a branch carries: all three primaries alike, or one after dispersion. */
enum { CHANNEL_ALL = 3 };

/* How a branch came to be. */
enum branch_kind { BRANCH_EYE, BRANCH_REFLECTED, BRANCH_REFRACTED };

/* Why a branch is not followed any farther. */
enum branch_end {
    END_LEFT_SCENE, /* nothing is ahead: the background */
    END_DEPTH,      /* its events have reached the depth level N */
    END_THRESHOLD,  /* it weighs less than the threshold */
    END_NOTHING,    /* its coefficient is 0: total reflection, or no mirror */
    END_BUDGET      /* the pixel's budget of rays is used up */
};

/* A branch as it is followed. Nodes are numbered from 1 in the order in which they are reached. */
struct branch {
    struct ray ray;
    struct energies weight; /* the product of the coefficients on its path */
    uint8_t events;         /* boundary events on its path: their number is held against N */
    uint8_t channel;        /* 0, 1, 2 or CHANNEL_ALL */
    uint8_t kind;           /* enum branch_kind */
    uint8_t place;          /* enum tail_place, where a pixel's tail is kept */
    uint32_t parent;        /* for an observer: the node where it began; 0: the eye */
};

/* The observer of a tree while the tree is grown. Both members may be called many times a pixel. A
 * pixel that begins again comes to a node 1 again: what was reported before is void. */
struct tree_observer {
    void *context;

    /* A branch has come to a boundary: node `number`. weight is the branch's, attenuated on its
     * path. */
    void (*node)(void *context, uint32_t number, const struct branch *branch, const struct hit *hit,
                 const struct colours *local);

    /* A branch with that weight, which began or would have begun at node `parent`, ends. */
    void (*end)(void *context, uint32_t parent, enum branch_kind kind, uint8_t channel,
                struct energies weight, enum branch_end why);
};

/* Returns the intensity that arrives at the eye along a ray; observer may be NULL. */
struct colours tree_colour(const struct scene *scene, const struct ray *eye_ray,
                           struct render_counts *counts, const struct tree_observer *observer);

#endif
