/* SPDX-License-Identifier: MIT */
/* The growing of a tree of rays: its state, one branch followed to its end, and what is cut. */
#ifndef SUPERFRAME_GROWTH_H
#define SUPERFRAME_GROWTH_H

#include "tree.h"

/* Each event leaves at most one branch waiting, the other is followed at once; dispersion, which
 * happens once on a way, leaves three. */
enum { BRANCHES_MOST = FEATURE_DEPTH + 2 + (FEATURE_DISPERSION ? 3 : 0) };

enum { KEPT_MOST = FEATURE_KEPT > 0 ? FEATURE_KEPT : 1 };

/* Branches that the threshold cut, kept because a lower one may follow them. */
struct kept_branches {
    uint16_t count;
    struct branch branches[KEPT_MOST];
};

/* What is learned about cut branches: sums over their leaves, in integers (real.h, *_steps). */
struct lesson {
    real_energy last_threshold; /* beyond the cut, branches are followed down to this */
    uint8_t last_depth;
    int64_t worth[3];  /* in steps of 2^-16 level */
    int64_t weight[3]; /* of what was cut, in steps of 2^-30 */
    int64_t rest[3];   /* of that, what ended beyond the cut without having been seen */
};

struct tree {
    const struct scene *scene;
    struct render_counts *counts;
    const struct tree_observer *observer;
    struct kept_branches *kept; /* NULL: what is cut is cut */
    struct lesson *lesson;      /* NULL: nothing is learned */
    struct colours sum;
    real_energy threshold;
    uint32_t rays_before; /* counts->rays when it began: it ends scene->ray_budget later */
    bool exhausted;       /* it has */
    uint32_t node;        /* the number of the node at work */
    int64_t lost;         /* the weight of what was cut for good, in steps of 2^-30 */
    int64_t lost_depth;   /* that times the events which it could still have met */
    uint16_t waiting;
    struct branch branches[BRANCHES_MOST];
};

/* Makes it a tree of one branch, the eye's ray, with the scene's own threshold. */
void growth_start(struct tree *tree, const struct scene *scene, const struct ray *eye_ray,
                  struct render_counts *counts);

/* Whether the pixel's budget of rays is used up. */
bool growth_is_exhausted(const struct tree *tree);

/* Follows what is waiting until nothing is; cuts it where the budget ends. */
void growth_finish(struct tree *tree);

/* Counts a branch as cut: it adds what the scene's estimate says, or nothing. */
void growth_cut(struct tree *tree, struct energies weight, uint8_t events);

#endif
