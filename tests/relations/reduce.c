/* SPDX-License-Identifier: MIT */
/* Delta debugging: from a scene that fails to a small one that fails alike. */
#include "reduce.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { TRIALS_MOST = 900, SECONDS_MOST = 15 };

struct reduction {
    struct failure *failure;
    struct trial_cache *cache;
    struct trial_room *room;
    struct syntax *attempt;
    int trials;
    time_t end;
};

static bool is_over(const struct reduction *reduction) {
    return reduction->trials >= TRIALS_MOST || time(NULL) >= reduction->end;
}

/* Keeps the attempt if it fails in the same way. */
static bool keep_if_failing(struct reduction *reduction) {
    struct failure *failure = reduction->failure;
    struct trial_result result;
    if (is_over(reduction)) {
        return false;
    }
    reduction->trials++;
    bool fails = trial_start(reduction->cache, reduction->attempt);
    if (fails) {
        trial_run(failure->relation, failure->arithmetic, failure->seed, reduction->cache,
                  reduction->room, &result);
        fails = result.applies && result.fault == failure->result.fault;
        trial_end(reduction->cache);
    }
    if (fails) {
        failure->scene = *reduction->attempt;
        failure->result = result;
    }
    return fails;
}

static void begin(struct reduction *reduction) {
    *reduction->attempt = reduction->failure->scene;
}

/* ---- Lists ---------------------------------------------------------------------------------- */

static bool drop_objects(struct reduction *reduction) {
    bool has_dropped = false;
    for (int i = reduction->failure->scene.object_count - 1; i >= 0; i--) {
        begin(reduction);
        struct syntax *scene = reduction->attempt;
        if (scene->object_count < 2) {
            break;
        }
        memmove(&scene->objects[i], &scene->objects[i + 1],
                (size_t)(--scene->object_count - i) * sizeof scene->objects[0]);
        has_dropped = keep_if_failing(reduction) || has_dropped;
    }
    for (int i = reduction->failure->scene.light_count - 1; i >= 0; i--) {
        begin(reduction);
        struct syntax *scene = reduction->attempt;
        memmove(&scene->lights[i], &scene->lights[i + 1],
                (size_t)(--scene->light_count - i) * sizeof scene->lights[0]);
        has_dropped = keep_if_failing(reduction) || has_dropped;
    }
    return has_dropped;
}

/* ---- Solids --------------------------------------------------------------------------------- */

/* Replaces a solid by one of its children, or drops that child. */
static bool reduce_children(struct reduction *reduction, int solid) {
    bool has_dropped = false;
    for (int i = reduction->failure->scene.solids[solid].child_count - 1; i >= 0; i--) {
        struct syntax *scene = reduction->attempt;
        begin(reduction);
        if (i >= scene->solids[solid].child_count) {
            continue;
        }
        scene->solids[solid] = scene->solids[scene->solids[solid].children[i]];
        if (keep_if_failing(reduction)) {
            return true;
        }
        begin(reduction);
        struct syntax_solid *node = &scene->solids[solid];
        int least = node->kind == SYNTAX_DIFFERENCE ? 2 : 1;
        if (node->child_count > least) {
            memmove(&node->children[i], &node->children[i + 1],
                    (size_t)(--node->child_count - i) * sizeof node->children[0]);
            has_dropped = keep_if_failing(reduction) || has_dropped;
        }
    }
    return has_dropped;
}

enum { PLACEMENT_STEPS = 3 };

/* Sets three numbers; returns whether they were others. */
static bool set_three(double three[3], double number) {
    bool has_changed = false;
    for (int i = 0; i < 3; i++) {
        has_changed = has_changed || three[i] < number || three[i] > number;
        three[i] = number;
    }
    return has_changed;
}

/* Drops one step of a placement; false where there is none. */
static bool drop_step(struct syntax_solid *solid, int step) {
    double *const steps[PLACEMENT_STEPS] = {solid->translate, solid->rotate, solid->scale};
    return set_three(steps[step], step == 2 ? 1 : 0);
}

static bool reduce_solids(struct reduction *reduction) {
    int list[SYNTAX_SOLIDS_MOST], count = syntax_list(&reduction->failure->scene, list);
    bool has_reduced = false;
    for (int i = 0; i < count && !is_over(reduction); i++) {
        has_reduced = reduce_children(reduction, list[i]) || has_reduced;
        for (int step = 0; step < PLACEMENT_STEPS; step++) {
            begin(reduction);
            if (drop_step(&reduction->attempt->solids[list[i]], step)) {
                has_reduced = keep_if_failing(reduction) || has_reduced;
            }
        }
        begin(reduction);
        struct syntax_solid *solid = &reduction->attempt->solids[list[i]];
        if (solid->kind == SYNTAX_PART) {
            *solid = reduction->attempt->solids[reduction->attempt->parts[solid->part]];
            has_reduced = keep_if_failing(reduction) || has_reduced;
        }
    }
    return has_reduced;
}

/* Leaves out parts and solids that nobody uses: they are written, too. */
static bool drop_parts(struct reduction *reduction) {
    begin(reduction);
    if (reduction->attempt->part_count == 0) {
        return false;
    }
    reduction->attempt->part_count--;
    return keep_if_failing(reduction);
}

/* ---- Materials and the rest ----------------------------------------------------------------- */

enum { FEATURES = 8 };

/* Clears a flag; returns whether it was set. */
static bool clear(bool *flag) {
    bool was_set = *flag;
    *flag = false;
    return was_set;
}

/* Makes a material plainer; false where it is plain already. */
static bool drop_feature(struct syntax_material *material, int feature) {
    double *const numbers[] = {&material->specular, &material->diffuse};
    bool has_tint = false;
    switch (feature) {
    case 0:
        return clear(&material->pattern.present);
    case 1:
        return clear(&material->has_table);
    case 2:
        return clear(&material->disperses);
    case 3:
        return clear(&material->casts_shadow);
    case 4:
        return set_three(material->absorption, 0);
    case 5:
        has_tint = set_three(material->reflects, 1);
        return set_three(material->transmits, 1) || has_tint;
    default: { /* the last two */
        double *number = numbers[feature - 6];
        bool has_changed = *number > 0;
        *number = 0;
        return has_changed;
    }
    }
}

static bool reduce_materials(struct reduction *reduction) {
    bool has_reduced = false;
    for (int i = 0; i < reduction->failure->scene.material_count; i++) {
        if (!syntax_uses_material(&reduction->failure->scene, i)) {
            continue;
        }
        for (int feature = 0; feature < FEATURES; feature++) {
            begin(reduction);
            if (drop_feature(&reduction->attempt->materials[i], feature)) {
                has_reduced = keep_if_failing(reduction) || has_reduced;
            }
        }
    }
    return has_reduced;
}

/* Gives all objects of a material another one, and solids that name it the object's. */
static bool replace_material(struct syntax *scene, int from, int to) {
    bool has_changed = false;
    for (int j = 0; j < scene->object_count && from != to; j++) {
        if (scene->objects[j].material == from) {
            scene->objects[j].material = to;
            has_changed = true;
        }
    }
    for (int j = 0; j < scene->solid_count; j++) {
        if (scene->solids[j].material == from) {
            scene->solids[j].material = -1;
            has_changed = true;
        }
    }
    return has_changed;
}

static bool merge_materials(struct reduction *reduction) {
    bool has_merged = false;
    for (int i = 1; i < reduction->failure->scene.material_count; i++) {
        begin(reduction);
        struct syntax *scene = reduction->attempt;
        if (replace_material(scene, i, scene->objects[0].material)) {
            has_merged = keep_if_failing(reduction) || has_merged;
        }
    }
    return has_merged;
}

enum { PLAINER = 7 };

/* Makes the scene as a whole plainer; false where it is so already. */
static bool make_plainer(struct syntax *scene, int step) {
    bool has_changed = false;
    switch (step) {
    case 0:
        has_changed = scene->depth > 0;
        scene->depth /= 2;
        return has_changed;
    case 1:
        return clear(&scene->fades);
    case 2:
        return clear(&scene->filters);
    case 3:
        return clear(&scene->blinn);
    case 4:
        has_changed = scene->model != SYNTAX_FRESNEL;
        scene->model = SYNTAX_FRESNEL;
        return has_changed;
    case 5:
        scene->width /= 2;
        scene->height /= 2;
        return scene->height > 0;
    default: /* the last */
        has_changed = scene->threshold < 1.0 / 256;
        scene->threshold = 1.0 / 256;
        return has_changed;
    }
}

static bool reduce_rest(struct reduction *reduction) {
    bool has_reduced = false;
    for (int step = 0; step < PLAINER; step++) {
        begin(reduction);
        if (make_plainer(reduction->attempt, step)) {
            has_reduced = keep_if_failing(reduction) || has_reduced;
        }
    }
    return has_reduced;
}

/* Rounds the numbers of one solid to quarters; returns whether any was finer. */
static bool round_solid(struct syntax_solid *solid) {
    double *const numbers[] = {solid->a, solid->b, solid->translate};
    bool has_changed = false;
    for (int j = 0; j < 9; j++) {
        double *number = &numbers[j / 3][j % 3];
        double quarters = floor(4 * *number + 0.5) / 4;
        has_changed = has_changed || *number < quarters || *number > quarters;
        *number = quarters;
    }
    return has_changed;
}

static bool round_numbers(struct reduction *reduction) {
    int list[SYNTAX_SOLIDS_MOST], count = syntax_list(&reduction->failure->scene, list);
    bool has_rounded = false;
    for (int i = 0; i < count; i++) {
        begin(reduction);
        if (round_solid(&reduction->attempt->solids[list[i]])) {
            has_rounded = keep_if_failing(reduction) || has_rounded;
        }
    }
    return has_rounded;
}

void reduce_failure(struct failure *failure, struct trial_cache *cache, struct trial_room *room) {
    struct reduction reduction = {
        failure, cache, room, malloc(sizeof *reduction.attempt), 0, time(NULL) + SECONDS_MOST};
    bool has_reduced = reduction.attempt != NULL;
    while (has_reduced && !is_over(&reduction)) {
        has_reduced = drop_objects(&reduction);
        has_reduced = reduce_solids(&reduction) || has_reduced;
        has_reduced = drop_parts(&reduction) || has_reduced;
        has_reduced = reduce_rest(&reduction) || has_reduced;
        has_reduced = reduce_materials(&reduction) || has_reduced;
        has_reduced = merge_materials(&reduction) || has_reduced;
        has_reduced = round_numbers(&reduction) || has_reduced;
    }
    free(reduction.attempt);
}
