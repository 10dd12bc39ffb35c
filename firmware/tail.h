/* SPDX-License-Identifier: MIT */
/* What is left out of a pixel: what it is worth, how sure that is, and what bounds it. */
#ifndef SUPERFRAME_TAIL_H
#define SUPERFRAME_TAIL_H

#include "image.h"
#include "scene.h"

/* A pixel's threshold lies 0..TAIL_STEPS - 1 half octaves below the scene's own. */
enum { TAIL_STEPS = 40 };

/* Where a part of a pixel comes from. A branch is near until it weighs less than the coarse
 * threshold. From there on the branch and what grows from it belong to the way it was going. */
enum tail_place { TAIL_NEAR, TAIL_DOWN, TAIL_UP, TAIL_PLACES };

/* Returns the place of what goes that way, behind what is near. */
static inline enum tail_place tail_place_of(enum estimate_way way) {
    return way == WAY_DOWN ? TAIL_DOWN : TAIL_UP;
}

/* What a pixel's tree has gathered, and what it has left out. These are sums in integers, so that
 * the order of branches does not matter. */
struct tail {
    int64_t gathered[TAIL_PLACES][3]; /* in steps of 2^-16 level */

    /* Weights in steps of 2^-30. Branches weighed `watched` as they left what is near. Later on,
     * `rest` of that was cut. `cut` is all that was cut, by the way that it was going itself. */
    int64_t watched[WAYS][3], rest[WAYS][3], cut[WAYS][3];

    /* Squares of the largest of the weights, in steps of 2^-52. */
    int64_t watched_squares[WAYS], cut_squares;

    /* The squares of what single boundaries above white have sent from behind what is near, in
     * steps of 2^-16 level^2. A training pass alone looks at these. */
    int64_t above_white;

    /* The weights of what was cut, each times the boundaries that it could still meet after the
     * first, in steps of 2^-30. */
    int64_t reach[3];
};

/* The thresholds of one look at a pixel. Without an accuracy asked for, a training pass has
 * its own. */
struct tail_thresholds {
    real_energy coarse, fine;
};

/* What a look at a pixel has found. */
struct tail_verdict {
    int32_t colour[3];    /* in steps of 2^-16 level */
    uint32_t uncertainty; /* the estimated error, in such steps */
    uint32_t proved;      /* no channel is farther off than this, in such steps */
    uint8_t steps;        /* of the next look; TAIL_STEPS: there is none */
};

/* Returns the thresholds so many half octaves below the scene's own, 0..TAIL_STEPS - 1. */
struct tail_thresholds tail_thresholds_at(const struct scene *scene, uint8_t steps);

/* Returns the square of the largest of the weights, in steps of 2^-52. */
static inline int64_t tail_square(struct energies weight) {
    int64_t steps = energy_steps(energies_largest(weight)) >> 4;
    return steps * steps;
}

static inline void tail_add_weight(int64_t sum[3], struct energies weight) {
    sum[0] += energy_steps(weight.red);
    sum[1] += energy_steps(weight.green);
    sum[2] += energy_steps(weight.blue);
}

/* Notes a branch that leaves what is near, going that way. */
static inline void tail_watch(struct tail *tail, enum estimate_way way, struct energies weight) {
    tail_add_weight(tail->watched[way], weight);
    tail->watched_squares[way] += tail_square(weight);
}

/* Notes a branch that is not near, and that is not followed any farther. The branch could still
 * meet 1 + `more` boundaries. */
static inline void tail_cut(struct tail *tail, enum tail_place place, enum estimate_way way,
                            struct energies weight, uint8_t more) {
    const int64_t steps[3] = {energy_steps(weight.red), energy_steps(weight.green),
                              energy_steps(weight.blue)};
    int64_t *rest = tail->rest[place == TAIL_DOWN ? WAY_DOWN : WAY_UP];
    for (uint8_t i = 0; i < 3; i++) {
        rest[i] += steps[i];
        tail->cut[way][i] += steps[i];
        tail->reach[i] += steps[i] * more;
    }
    tail->cut_squares += tail_square(weight);
}

void tail_clear(struct tail *tail);

/* The rays of one look at a pixel, of all looks, and how many these may be. */
struct tail_rays {
    uint64_t of_look, in_all;
    uint32_t budget;
};

/* Judges a pixel that was looked at with the thresholds of `steps`. The scene's error is not 0. */
void tail_judge(const struct scene *scene, const struct tail *tail, uint8_t steps,
                const struct tail_rays *rays, struct tail_verdict *verdict);

/* Notes a pixel's errors, the worst of all pixels that are counted. Returns whether the estimated
 * one is the worst by now. */
bool tail_note(const struct scene *scene, const struct tail_verdict *verdict,
               struct render_counts *counts);

#endif
