/* SPDX-License-Identifier: MIT */
/* One relation tried on one scene in one arithmetic. */
#ifndef SUPERFRAME_RELATIONS_TRIAL_H
#define SUPERFRAME_RELATIONS_TRIAL_H

#include "relation.h"
#include "rendering.h"

/* What a pair of pictures may show. */
enum {
    TRIAL_LEVELS_MOST = 1, /* by which pixels of equal signatures may differ */
    TRIAL_FLIPS_MOST = 3   /* pixels of other signatures that differ by more, in one pair */
};

/* The scene as it is, in each arithmetic, drawn once for all relations. */
struct trial_cache {
    struct form form;
    struct rendering pictures[RELATION_ARITHMETICS];
    bool is_drawn[RELATION_ARITHMETICS], is_refused[RELATION_ARITHMETICS];
};

/* Reads and compiles a scene; false where the scene is refused. */
bool trial_start(struct trial_cache *cache, const struct syntax *scene);

void trial_end(struct trial_cache *cache);

/* What a trial needs room for. */
struct trial_room {
    struct syntax prepared, rewritten;
    struct rendering first, second;
};

/* Tries a relation whose random choices follow from the seed. */
void trial_run(const struct relation *relation, int arithmetic, uint64_t seed,
               struct trial_cache *cache, struct trial_room *room, struct trial_result *result);

#endif
