/* SPDX-License-Identifier: MIT */
/* The growing of a tree of rays: its state, one branch followed to its end, and the pruned
 * branches. */
#ifndef SUPERFRAME_GROWTH_H
#define SUPERFRAME_GROWTH_H

#include "image.h"
#include "tree.h"

/* Each event leaves at most one branch waiting, the other is followed at once. Dispersion, which
 * happens once on a path, leaves three. */
enum { BRANCHES_MOST = FEATURE_DEPTH + 2 + (FEATURE_DISPERSION ? 3 : 0) };

enum { KEPT_MOST = FEATURE_KEPT > 0 ? FEATURE_KEPT : 2 };

/* What is not followed any farther, with an accuracy asked for: sums in integers. */
struct losses {
    int64_t weight[WAYS][3]; /* that the threshold or the budget cut, in steps of 2^-30 */
    int64_t squares;         /* of the largest of those, in steps of 2^-52 */
    int64_t ended[3];        /* that the depth level cut, in steps of 2^-30 */

    /* A sum over the branches in `weight`, in steps of 2^-30. Each adds its largest weight times
     * the events that it could still have met. */
    int64_t depth;
};

/* Branches that the threshold pruned, kept because a lower threshold may let them through. */
struct kept_branches {
    struct losses losses; /* what could not be kept, or is not to be */
    uint16_t count;
    struct branch branches[KEPT_MOST];
};

enum { TRAINING_LEVELS = FEATURE_KEPT > 0 ? ESTIMATE_LEVELS : 1 };

/* Holds what one pixel teaches of the branches that a threshold prunes, by the ways of these
 * branches. */
struct training_level {
    int64_t radiance[WAYS][3]; /* in steps of 2^-16 level */
    int64_t weight[WAYS][3];   /* of what was pruned, in steps of 2^-30 */
    int64_t rest[WAYS][3];     /* of that, what ended beyond the cut without having been seen */
    int64_t squares;           /* of the largest weights that were pruned, in steps of 2^-52 */
};

struct training {
    int32_t first;      /* the threshold of level 0, in steps of 2^-30; each next one is half */
    int32_t last;       /* beyond the cut, branches are followed down to this */
    uint8_t levels;     /* 1..TRAINING_LEVELS */
    uint8_t last_depth; /* and to this depth level */
    bool of_depth;      /* what the scene's depth level cuts counts as cut at level 0 */
    struct training_level level[TRAINING_LEVELS];
};

struct tree {
    const struct scene *scene;
    struct render_counts *counts;
    const struct tree_observer *observer;
    struct kept_branches *kept; /* NULL: pruned branches are dropped */
    struct training *training;  /* NULL: nothing is learned */
    struct colours sum;
    real_energy threshold;
    uint64_t rays_before; /* counts->rays when the pixel began */
    uint32_t ray_budget;  /* the pixel ends so many rays later */
    bool exhausted;       /* the pixel ended by the budget, or short of the accuracy */
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

/* Returns the square of the largest of the weights, in steps of 2^-52. */
int64_t growth_square(struct energies weight);

/* Counts a branch among the losses: the branch is not followed any farther. */
void growth_lose(struct tree *tree, const struct branch *branch, enum branch_end why);

#endif
