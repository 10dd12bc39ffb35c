/* SPDX-License-Identifier: MIT */
/* Relations: leaves and placements in other words. */
#include <math.h>
#include <string.h>

#include "chance.h"
#include "relation.h"
#include "wording.h"

bool rewrite_ends(struct syntax *scene, uint64_t *random) {
    int list[SYNTAX_SOLIDS_MOST], count = syntax_list(scene, list);
    bool has_changed = false;
    for (int i = 0; i < count; i++) {
        if (chance_is(random, 70)) {
            has_changed = wording_ends(&scene->solids[list[i]]) || has_changed;
        }
    }
    return has_changed;
}

bool rewrite_leaves(struct syntax *scene, uint64_t *random) {
    int list[SYNTAX_SOLIDS_MOST], count = syntax_list(scene, list);
    bool has_changed = false;
    for (int i = 0; i < count; i++) {
        if (chance_is(random, 60)) {
            has_changed = wording_leaf(&scene->solids[list[i]], random) || has_changed;
        }
    }
    return has_changed && !syntax_has_endless(scene);
}

/* Says a placement by one wrapper for each of its steps, or mirrors twice what is turned half. */
static void reword_placement(struct syntax *scene, int solid, uint64_t *random) {
    int below = syntax_push_down(scene, solid, SYNTAX_UNION);
    struct syntax_solid *inner = &scene->solids[below], *outer = &scene->solids[solid];
    memcpy(outer->translate, inner->translate, sizeof outer->translate);
    memset(inner->translate, 0, sizeof inner->translate);
    outer->rotate[2] = inner->rotate[2];
    inner->rotate[2] = 0;
    if (chance_is(random, 40)) { /* a half turn about z and its mirrors */
        outer->rotate[2] += outer->rotate[2] > 0 ? -180 : 180;
        outer->scale[0] = outer->scale[1] = -1;
    }
    syntax_adopt(scene, solid, below);
}

bool rewrite_placements(struct syntax *scene, uint64_t *random) {
    int list[SYNTAX_SOLIDS_MOST], count = syntax_list(scene, list);
    bool has_changed = false;
    for (int i = 0; i < count && !scene->is_full; i++) {
        const struct syntax_solid *solid = &scene->solids[list[i]];
        bool is_placed = fabs(solid->translate[0]) + fabs(solid->translate[2]) > 0;
        if (is_placed && chance_is(random, 60) && solid->kind != SYNTAX_HALF_SPACE) {
            reword_placement(scene, list[i], random);
            has_changed = true;
        }
    }
    return has_changed;
}
