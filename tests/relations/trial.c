/* SPDX-License-Identifier: MIT */
/* One relation tried on one scene in one arithmetic. */
#include "trial.h"

#include <stdlib.h>
#include <string.h>

#include "chance.h"

bool trial_start(struct trial_cache *cache, const struct syntax *scene) {
    memset(cache->is_drawn, 0, sizeof cache->is_drawn);
    memset(cache->is_refused, 0, sizeof cache->is_refused);
    return form_start(&cache->form, scene);
}

void trial_end(struct trial_cache *cache) {
    form_end(&cache->form);
}

/* Draws the scene as it is, once; NULL where the arithmetic refuses it. */
static const struct rendering *cached(struct trial_cache *cache, int arithmetic) {
    if (!cache->is_drawn[arithmetic]) {
        cache->is_drawn[arithmetic] = true;
        cache->is_refused[arithmetic] =
            !rendering_draw(&cache->form, relation_arithmetic(arithmetic), ORACLE_AIR,
                            &cache->pictures[arithmetic]);
    }
    return cache->is_refused[arithmetic] ? NULL : &cache->pictures[arithmetic];
}

static int difference(const struct rendering_pixel *a, const struct rendering_pixel *b) {
    int most = 0;
    for (int i = 0; i < 3; i++) {
        int off = abs(a->level[i] - b->level[i]);
        most = off > most ? off : most;
    }
    return most;
}

static void judge_pixel(const struct rendering_pixel *a, const struct rendering_pixel *b, int x,
                        int y, struct trial_result *result) {
    int off = difference(a, b);
    result->pixels++;
    if (a->signature == b->signature) {
        result->agreeing++;
        result->worst = off > result->worst ? off : result->worst;
        if (off > TRIAL_LEVELS_MOST) {
            result_fail(result, FAULT_DRIFT,
                        "pixel %d %d, equal paths, levels %d %d %d and %d %d %d", x, y, a->level[0],
                        a->level[1], a->level[2], b->level[0], b->level[1], b->level[2]);
        }
    } else if (off > TRIAL_LEVELS_MOST) {
        result->flips++;
        result->worst_flip = off > result->worst_flip ? off : result->worst_flip;
        if (result->flips > TRIAL_FLIPS_MOST) {
            result_fail(result, FAULT_FLIPS,
                        "more than %d other paths, such as at pixel %d %d, levels %d %d %d and "
                        "%d %d %d",
                        TRIAL_FLIPS_MOST, x, y, a->level[0], a->level[1], a->level[2], b->level[0],
                        b->level[1], b->level[2]);
        }
    }
}

/* Holds the pictures of a pair against each other. What a ghost's boundaries bring to an end is no
 * part of the relation. */
static void judge(const struct relation *relation, const struct rendering *a,
                  const struct rendering *b, struct trial_result *result) {
    int width = a->width, height = a->height;
    for (int y = 0; y < height; y++) {
        for (int x = 0; x < width; x++) {
            int column = relation->map == MAP_SAME ? x : width - 1 - x;
            int row = relation->map == MAP_ROLLED ? height - 1 - y : y;
            const struct rendering_pixel *first = &a->pixels[y * width + x];
            const struct rendering_pixel *second = &b->pixels[row * width + column];
            bool is_passed =
                relation->has_ghost && (first->is_cut_by_depth || second->is_cut_by_depth);
            if (!is_passed) {
                judge_pixel(first, second, x, y, result);
            }
        }
    }
}

static void judge_alone(const struct rendering *picture, const char *which,
                        struct trial_result *result) {
    if (picture->leaked > 0) {
        result_fail(result, FAULT_LEAKED, "%s: %llu leaked rays", which,
                    (unsigned long long)picture->leaked);
    }
    if (picture->is_wrong) {
        result_fail(result, FAULT_MEMBERSHIP, "%s: pixel %d %d: %s", which, picture->wrong_x,
                    picture->wrong_y, picture->wrong);
    }
}

/* Returns true where two forms lie in the scaled world alike: a coarse arithmetic's numbers are the
 * same then, and what has no end is cut at the same place. */
static bool same_scale(const struct compiled_scene *a, const struct compiled_scene *b) {
    for (int i = 0; i < 3; i++) {
        if (a->centre[i] < b->centre[i] || a->centre[i] > b->centre[i]) {
            return false;
        }
    }
    return a->exponent == b->exponent;
}

static void compare_forms(const struct relation *relation, int arithmetic, struct form *prepared,
                          const struct rendering *first, struct trial_room *room,
                          struct trial_result *result) {
    struct form rewritten;
    int ghost = relation->has_ghost ? room->rewritten.material_count - 1 : ORACLE_AIR;
    if (!form_start(&rewritten, &room->rewritten)) {
        bool is_limit = room->rewritten.is_full || strstr(rewritten.error.text, "more than") ||
                        strstr(rewritten.error.text, "too large for");
        result->applies = !is_limit;
        if (!is_limit) {
            result_fail(result, FAULT_REFUSED, "only the rewritten scene: %.200s",
                        rewritten.error.text);
        }
        return;
    }
    bool needs_scale = arithmetic != 0 || syntax_has_endless(&room->prepared);
    if (needs_scale && relation->map == MAP_SAME &&
        !same_scale(prepared->compiled, rewritten.compiled)) {
        result->applies = relation->rewrite == rewrite_move;
    }
    if (result->applies &&
        !rendering_draw(&rewritten, relation_arithmetic(arithmetic), ghost, &room->second)) {
        result_fail(result, FAULT_REFUSED, "only the rewritten scene: %.200s",
                    rewritten.error.text);
    } else if (result->applies) {
        if (first->leaked == 0 && !first->is_wrong) {
            judge_alone(&room->second, "the rewritten scene", result);
        }
        judge(relation, first, &room->second, result);
    }
    form_end(&rewritten);
}

static void run_rewriting(const struct relation *relation, int arithmetic, uint64_t random,
                          struct trial_cache *cache, struct trial_room *room,
                          struct trial_result *result) {
    const struct rendering *first = &room->first;
    struct form prepared = cache->form;
    room->prepared = *cache->form.syntax;
    if (relation->prepare == NULL) {
        first = cached(cache, arithmetic);
        result->applies = first != NULL;
    } else {
        result->applies =
            relation->prepare(&room->prepared, &random) && form_start(&prepared, &room->prepared);
        if (result->applies) {
            result->applies = rendering_draw(&prepared, relation_arithmetic(arithmetic), ORACLE_AIR,
                                             &room->first);
        }
    }
    if (result->applies) {
        room->rewritten = room->prepared;
        result->applies = relation->rewrite(&room->rewritten, &random) && !room->rewritten.is_full;
    }
    if (result->applies) {
        compare_forms(relation, arithmetic, &prepared, first, room, result);
    }
    if (prepared.compiled != cache->form.compiled) {
        form_end(&prepared);
    }
}

static void run_f128(const struct relation *relation, struct trial_cache *cache,
                     struct trial_room *room, struct trial_result *result) {
    const struct arithmetic *f128 = arithmetic_find("f128");
    const struct rendering *first = f128 != NULL ? cached(cache, 0) : NULL;
    result->applies = first != NULL;
    if (first != NULL && rendering_draw(&cache->form, f128, ORACLE_AIR, &room->second)) {
        if (first->leaked == 0 && !first->is_wrong) {
            judge_alone(&room->second, "f128", result);
        }
        judge(relation, first, &room->second, result);
    }
}

void trial_run(const struct relation *relation, int arithmetic, uint64_t seed,
               struct trial_cache *cache, struct trial_room *room, struct trial_result *result) {
    uint64_t random = (seed + 1) * UINT64_C(0xD6E8FEB86659FD93);
    for (const char *letter = relation->name; *letter != '\0'; letter++) {
        random = random * 31 + (uint64_t)*letter;
    }
    memset(result, 0, sizeof *result);
    if (relation->is_f128) {
        run_f128(relation, cache, room, result);
    } else if (relation->rewrite != NULL) {
        run_rewriting(relation, arithmetic, random, cache, room, result);
    } else if (relation->check != NULL) {
        result->applies = true;
        relation->check(&cache->form, arithmetic, &room->first, result);
    } else {
        const struct rendering *picture = cached(cache, arithmetic);
        result->applies = picture != NULL;
        if (picture != NULL) {
            judge_alone(picture, "the scene", result);
            result->pixels = result->agreeing =
                (uint64_t)picture->width * (uint64_t)picture->height;
        }
    }
}
