/* SPDX-License-Identifier: MIT */
/* Delta debugging: from a scene that fails to a small one that fails alike. */
#ifndef SUPERFRAME_RELATIONS_REDUCE_H
#define SUPERFRAME_RELATIONS_REDUCE_H

#include "trial.h"

/* A failure: which relation says what of which scene. */
struct failure {
    const struct relation *relation;
    int arithmetic;
    uint64_t seed;
    struct syntax scene;
    struct trial_result result;
};

/* Makes failure->scene as small as a bounded number of trials finds it, with failure->result of the
 * same kind. */
void reduce_failure(struct failure *failure, struct trial_cache *cache, struct trial_room *room);

#endif
