/* SPDX-License-Identifier: MIT */
/* The crossings that may be the next one of a ray, or part of it. */
#ifndef SUPERFRAME_CANDIDATES_H
#define SUPERFRAME_CANDIDATES_H

#include "crossing.h"

/* Crossings within the noise of the nearest one, and a few more. */
enum { CANDIDATES_MOST = 2 * SET_MOST + 16 };

/* The crossings that may be the next one or part of it. */
struct candidates {
    real_length limit; /* that crossings after it play no part */
    uint16_t count;
    struct crossing found[CANDIDATES_MOST];
};

/* Drops the candidates behind the limit. */
static inline void drop_behind(struct candidates *all) {
    uint16_t kept = 0;
    for (uint16_t i = 0; i < all->count; i++) {
        if (!length_less(all->limit, all->found[i].t)) {
            all->found[kept++] = all->found[i];
        }
    }
    all->count = kept;
}

/* Returns the place of the candidate that is farthest away. */
static inline uint16_t farthest(const struct candidates *all) {
    uint16_t place = 0;
    for (uint16_t i = 1; i < all->count; i++) {
        if (length_less(all->found[place].t, all->found[i].t)) {
            place = i;
        }
    }
    return place;
}

static inline void keep_candidate(struct candidates *all, const struct crossing *found) {
    if (length_less(all->limit, found->t)) {
        return;
    }
    real_length limit = length_add(found->t, length_add(LENGTH_NOISE, LENGTH_NOISE));
    if (length_less(limit, all->limit)) {
        all->limit = limit;
    }
    if (all->count == CANDIDATES_MOST) {
        drop_behind(all);
    }
    if (all->count < CANDIDATES_MOST) {
        all->found[all->count++] = *found;
        return;
    }
    uint16_t last = farthest(all);
    if (length_less(found->t, all->found[last].t)) {
        all->found[last] = *found;
    }
}

/* Sorts the candidates by their primitives: the order of the table decides where distances do
 * not. */
static inline void sort_candidates(struct candidates *all) {
    for (uint16_t i = 1; i < all->count; i++) {
        const struct crossing moved = all->found[i];
        uint16_t place = i;
        for (; place > 0 && moved.primitive < all->found[place - 1].primitive; place--) {
            all->found[place] = all->found[place - 1];
        }
        all->found[place] = moved;
    }
}

#endif
