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

/* Drops one step of a placement; false where there is none. */
static bool drop_step(struct syntax_solid *solid, int step) {
    static const double none[PLACEMENT_STEPS][3] = {{0, 0, 0}, {0, 0, 0}, {1, 1, 1}};
    double *steps[PLACEMENT_STEPS] = {solid->translate, solid->rotate, solid->scale};
    if (memcmp(steps[step], none[step], sizeof none[step]) == 0) {
        return false;
    }
    memcpy(steps[step], none[step], sizeof none[step]);
    return true;
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

/* Makes a material plainer; false where it is plain already. */
static bool drop_feature(struct syntax_material *material, int feature) {
    const struct syntax_material before = *material;
    switch (feature) {
    case 0:
        material->pattern.present = false;
        break;
    case 1:
        material->has_table = false;
        break;
    case 2:
        memset(material->absorption, 0, sizeof material->absorption);
        break;
    case 3:
        material->disperses = false;
        break;
    case 4:
        material->specular = 0;
        break;
    case 5:
        material->casts_shadow = false;
        break;
    case 6:
        material->diffuse = 0;
        break;
    default: /* the last */
        for (int i = 0; i < 3; i++) {
            material->reflects[i] = material->transmits[i] = 1;
        }
        break;
    }
    return memcmp(&before, material, sizeof before) != 0;
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

/* Gives all objects and solids of one material another one. */
static bool merge_materials(struct reduction *reduction) {
    bool has_merged = false;
    for (int i = 1; i < reduction->failure->scene.material_count; i++) {
        begin(reduction);
        struct syntax *scene = reduction->attempt;
        if (!syntax_uses_material(scene, i)) {
            continue;
        }
        for (int j = 0; j < scene->object_count; j++) {
            scene->objects[j].material = scene->objects[j].material == i
                                             ? scene->objects[0].material
                                             : scene->objects[j].material;
        }
        for (int j = 0; j < scene->solid_count; j++) {
            scene->solids[j].material =
                scene->solids[j].material == i ? -1 : scene->solids[j].material;
        }
        if (memcmp(scene, &reduction->failure->scene, sizeof *scene) != 0) {
            has_merged = keep_if_failing(reduction) || has_merged;
        }
    }
    return has_merged;
}

enum { PLAINER = 7 };

/* Makes the scene as a whole plainer; false where it is so already. */
static bool make_plainer(struct syntax *scene, int step) {
    switch (step) {
    case 0:
        scene->depth /= 2;
        return true;
    case 1:
        scene->fades = false;
        return true;
    case 2:
        scene->filters = false;
        return true;
    case 3:
        scene->model = SYNTAX_FRESNEL;
        return true;
    case 4:
        scene->blinn = false;
        return true;
    case 5:
        scene->width /= 2;
        scene->height /= 2;
        return scene->height > 0;
    default: /* the last */
        scene->threshold = 1.0 / 256;
        return true;
    }
}

static bool reduce_rest(struct reduction *reduction) {
    bool has_reduced = false;
    for (int step = 0; step < PLAINER; step++) {
        begin(reduction);
        if (make_plainer(reduction->attempt, step) &&
            memcmp(reduction->attempt, &reduction->failure->scene, sizeof *reduction->attempt)) {
            has_reduced = keep_if_failing(reduction) || has_reduced;
        }
    }
    return has_reduced;
}

/* Rounds a solid's numbers to quarters. */
static bool round_numbers(struct reduction *reduction) {
    int list[SYNTAX_SOLIDS_MOST], count = syntax_list(&reduction->failure->scene, list);
    bool has_rounded = false;
    for (int i = 0; i < count; i++) {
        begin(reduction);
        struct syntax_solid *solid = &reduction->attempt->solids[list[i]];
        double *const numbers[] = {solid->a, solid->b, solid->translate};
        for (int j = 0; j < 9; j++) {
            numbers[j / 3][j % 3] = floor(4 * numbers[j / 3][j % 3] + 0.5) / 4;
        }
        if (memcmp(solid, &reduction->failure->scene.solids[list[i]], sizeof *solid) != 0) {
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
