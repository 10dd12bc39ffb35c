/* SPDX-License-Identifier: MIT */
/* The tree of rays of one pixel, without recursion, to a threshold or to an accuracy. */
#include "tree.h"

#include "growth.h"
#include "learn.h"

/* Follows the kept branches that a lower threshold lets through. */
static void follow_kept(struct tree *tree) {
    struct kept_branches *kept = tree->kept;
    uint16_t i = 0;
    while (i < kept->count && !growth_is_exhausted(tree)) {
        if (energy_less(energies_largest(kept->branches[i].weight), tree->threshold)) {
            i++;
            continue;
        }
        tree->branches[0] = kept->branches[i];
        tree->waiting = 1;
        kept->branches[i] = kept->branches[--kept->count];
        growth_finish(tree);
    }
}

/* The sum of the squares of the weights that are cut, in steps of 2^-52. */
static int64_t squares_of(const struct kept_branches *kept) {
    int64_t sum = kept->losses.squares;
    for (uint16_t i = 0; i < kept->count; i++) {
        sum += growth_square(kept->branches[i].weight);
    }
    return sum;
}

/* Begins the pixel, or begins it again: nothing is kept of it but the rays that it took. */
static void begin(struct tree *tree, const struct ray *eye_ray, real_energy threshold) {
    struct kept_branches *kept = tree->kept;
    const struct tree_observer *observer = tree->observer;
    uint32_t rays_before = tree->rays_before;
    growth_start(tree, tree->scene, eye_ray, tree->counts);
    tree->rays_before = rays_before;
    tree->observer = observer;
    tree->threshold = threshold;
    tree->kept = kept;
    kept->count = 0;
    for (uint8_t i = 0; i < 3; i++) {
        kept->losses.weight[i] = kept->losses.ended[i] = 0;
    }
    kept->losses.squares = kept->losses.depth = 0;
    growth_finish(tree);
}

/* Whether the losses alone are too much, and there are rays enough to begin again: that takes
 * about twice as many as what was done so far. */
static bool must_begin_again(const struct tree *tree, const struct estimate_level *level) {
    uint32_t used = tree->counts->rays - tree->rays_before;
    return tree->kept->losses.squares > level->squares_most && used < tree->ray_budget / 4;
}

/* A threshold on its way down: at a level of the estimate, or half-way to the next one. */
struct descent {
    uint8_t level;
    bool is_between;
    real_energy threshold;
};

static void go_down(struct descent *descent, bool whole_level) {
    if (descent->is_between) {
        descent->threshold = energy_product(descent->threshold, REAL_ENERGY(2.0 / 3));
    } else {
        descent->threshold =
            energy_product(descent->threshold, whole_level ? REAL_ENERGY(0.5) : REAL_ENERGY(0.75));
    }
    descent->is_between = !descent->is_between && !whole_level;
    descent->level = (uint8_t)(descent->level + !descent->is_between);
}

/* Lowers the threshold until the pixel is as accurate as was asked for; returns the level. Branches
 * stray from the mean independently of each other, nearly: their squares add. */
static uint8_t refine(struct tree *tree, const struct ray *eye_ray) {
    const struct estimate *estimate = tree->scene->estimate;
    struct descent descent = {0, false, tree->scene->threshold};
    while (descent.level < estimate->first) {
        go_down(&descent, true);
    }
    begin(tree, eye_ray, descent.threshold);
    while (squares_of(tree->kept) > estimate->level[descent.level].squares_most) {
        bool again = must_begin_again(tree, &estimate->level[descent.level]);
        bool is_stuck = tree->kept->count == 0 && !again;
        if (growth_is_exhausted(tree) || is_stuck || descent.level + 1 >= ESTIMATE_LEVELS) {
            tree->exhausted = true;
            break;
        }
        go_down(&descent, again);
        if (again) {
            begin(tree, eye_ray, descent.threshold);
        } else {
            tree->threshold = descent.threshold;
            follow_kept(tree);
        }
    }
    return descent.level;
}

/* Everything that is still kept is cut now. */
static void lose_kept(struct tree *tree) {
    struct kept_branches *kept = tree->kept;
    while (kept->count > 0) {
        growth_lose(tree, &kept->branches[--kept->count]);
    }
}

/* A weight in steps of 2^-30 times a mean in steps of 2^-16 level, in these. */
static int32_t weighed(int64_t weight, int32_t mean) {
    return (int32_t)((weight * mean) >> 30);
}

/* Half of what the ways that the depth level ended are worth if they go on, in the channel where
 * that is most. */
static int32_t open_half(const struct losses *losses, const struct estimate_level *level) {
    int32_t most = 0;
    for (uint8_t i = 0; i < 3; i++) {
        int32_t half = weighed(losses->ended[i] / 2, level->mean[i]);
        most = half > most ? half : most;
    }
    return most;
}

/* What the losses are worth. Where the depth level ends a way, a picture of that level has nothing,
 * and one without an end the mean: half the mean is within the error asked for of both, or else the
 * picture of that level is meant. */
static struct colours worth_of(const struct losses *losses, const struct estimate_level *level,
                               bool counts_open) {
    int32_t worth[3];
    for (uint8_t i = 0; i < 3; i++) {
        worth[i] = weighed(losses->weight[i], level->mean[i]);
        if (counts_open) {
            worth[i] += weighed(losses->ended[i] / 2, level->mean[i]);
        }
    }
    const struct colours colours = {colour_of_steps(worth[0]), colour_of_steps(worth[1]),
                                    colour_of_steps(worth[2])};
    return colours;
}

/* The worst pixel's, of all that are counted. */
static void note_error(const struct scene *scene, const struct losses *losses, int64_t doubt,
                       struct render_counts *counts) {
    uint32_t estimated = doubt < (int64_t)UINT32_MAX ? (uint32_t)doubt : UINT32_MAX;
    uint32_t proved = (uint32_t)(((losses->depth >> 20) * scene->brightest) >> 10);
    if (estimated > counts->estimated_error) {
        counts->estimated_error = estimated;
    }
    if (proved > counts->proved_error) {
        counts->proved_error = proved;
    }
}

static struct colours refined_colour(const struct scene *scene, const struct ray *eye_ray,
                                     struct render_counts *counts,
                                     const struct tree_observer *observer) {
    struct tree tree;
    struct kept_branches kept;
    tree.scene = scene;
    tree.counts = counts;
    tree.observer = observer;
    tree.rays_before = counts->rays;
    tree.kept = &kept;
    const struct estimate_level *level = &scene->estimate->level[refine(&tree, eye_ray)];
    const struct losses *losses = &kept.losses;
    lose_kept(&tree);
    int32_t open = open_half(losses, level);
    bool counts_open = (uint32_t)open <= scene->error;
    int64_t doubt = (((int64_t)learn_root(losses->squares) * level->spread) >> 26) + open;
    note_error(scene, losses, doubt, counts);
    counts->exhausted_pixels += tree.exhausted;
    return colours_add(tree.sum, worth_of(losses, level, counts_open));
}

struct colours tree_colour(const struct scene *scene, const struct ray *eye_ray,
                           struct render_counts *counts, const struct tree_observer *observer) {
    if (FEATURE_KEPT > 0 && scene->error > 0) {
        return refined_colour(scene, eye_ray, counts, observer);
    }
    struct tree tree;
    growth_start(&tree, scene, eye_ray, counts);
    tree.observer = observer;
    growth_finish(&tree);
    counts->exhausted_pixels += tree.exhausted;
    return tree.sum;
}
