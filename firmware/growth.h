/* SPDX-License-Identifier: MIT */
/* The growing of a tree of rays: its state, and one branch followed to its end. */
#ifndef SUPERFRAME_GROWTH_H
#define SUPERFRAME_GROWTH_H

#include "tail.h"
#include "tree.h"

/* Each event leaves at most one branch waiting, the other is followed at once. Dispersion, which
 * happens once on a path, leaves three. */
enum { BRANCHES_MOST = FEATURE_DEPTH + 2 + (FEATURE_DISPERSION ? 3 : 0) };

struct tree {
    const struct scene *scene;
    struct render_counts *counts;
    const struct tree_observer *observer;
    struct tail *tail; /* sums take the place of `sum`; NULL: none are kept */
    struct colours sum;
    real_energy threshold;
    real_energy coarse;   /* of a tail: a branch that weighs less is not near */
    uint8_t last_depth;   /* of a tail: the last depth level that is looked at */
    bool learns_depth;    /* of a tail: what the scene's depth level cuts is not near either */
    uint64_t rays_before; /* counts->rays when the pixel began */
    uint32_t ray_budget;  /* the pixel ends so many rays later */
    bool exhausted;       /* the budget ended the pixel */
    uint32_t node;        /* the number of the node at work */
    uint16_t waiting;
    struct branch branches[BRANCHES_MOST];
};

/* Makes a tree of one branch, the eye's ray, with the scene's own threshold. */
void growth_start(struct tree *tree, const struct scene *scene, const struct ray *eye_ray,
                  struct render_counts *counts);

/* Tells whether the pixel's budget of rays is used up. */
bool growth_is_exhausted(const struct tree *tree);

/* Follows the waiting branches until none is left; cuts them where the budget ends. */
void growth_finish(struct tree *tree);

#endif
