/* SPDX-License-Identifier: MIT */
/* The tree of rays of one pixel, without recursion, to a threshold or to an accuracy. */
#include "tree.h"

#include "growth.h"

/* The weight of a branch in steps of 2^-30. */
static int64_t weight_of(const struct branch *branch) {
    return energy_steps(energies_largest(branch->weight));
}

static int64_t kept_weight(const struct kept_branches *kept) {
    int64_t sum = 0;
    for (uint16_t i = 0; i < kept->count; i++) {
        sum += weight_of(&kept->branches[i]);
    }
    return sum;
}

/* What a weight that is cut may be worth: weight times spread, in steps of 2^-16 level. The weight
 * is brought to steps of 2^-15 first, upwards: below 2^16 of them, times less than 2^31. */
static uint32_t doubt_of(const struct scene *scene, int64_t weight) {
    int64_t spread = scene->estimate ? scene->estimate->spread : (int64_t)255 << 16;
    int64_t doubt = (((weight >> 15) + 1) * spread) >> 15;
    return doubt < (int64_t)UINT32_MAX ? (uint32_t)doubt : UINT32_MAX;
}

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

/* The pixel's intensity if every kept branch is worth the mean. */
static struct colours expected(const struct tree *tree) {
    const struct estimate *estimate = tree->scene->estimate;
    struct colours sum = tree->sum;
    for (uint16_t i = 0; estimate && i < tree->kept->count; i++) {
        const struct colours mean = {colour_of_steps(estimate->mean[0]),
                                     colour_of_steps(estimate->mean[1]),
                                     colour_of_steps(estimate->mean[2])};
        sum = colours_add(sum, colours_weighed(mean, tree->kept->branches[i].weight));
    }
    return sum;
}

static uint32_t difference(int32_t a, int32_t b) {
    return a < b ? (uint32_t)b - (uint32_t)a : (uint32_t)a - (uint32_t)b;
}

/* The largest difference of a channel, in steps of 2^-16 level. */
static uint32_t change_of(struct colours a, struct colours b) {
    uint32_t red = difference(colour_steps(a.red), colour_steps(b.red));
    uint32_t green = difference(colour_steps(a.green), colour_steps(b.green));
    uint32_t blue = difference(colour_steps(a.blue), colour_steps(b.blue));
    uint32_t most = red > green ? red : green;
    return most > blue ? most : blue;
}

/* What is cut may stray this many times as far as branches do on average, and a step of the
 * threshold may bring this part of the error that is asked for. Chosen on the built-in scenes: less
 * than the first follows pixels whose doubt is idle, more than the second misses slow ones. */
enum { STRAYS_MOST = 4, STEP_SHARE = 3 };

/* Lowers the threshold, past the scene's, until neither what is cut nor what the last step brought
 * is worth the error that is asked for. Where light is trapped the steps go on bringing more than
 * was expected: those pixels are followed farther than the others, as far as the budget reaches. */
static void refine(struct tree *tree) {
    const struct scene *scene = tree->scene;
    struct kept_branches *kept = tree->kept;
    uint32_t change;
    growth_finish(tree);
    do {
        struct colours before = expected(tree);
        if (growth_is_exhausted(tree)) {
            tree->exhausted = true;
            break;
        }
        tree->threshold = energy_product(tree->threshold, REAL_ENERGY(0.5));
        follow_kept(tree);
        change = change_of(before, expected(tree));
    } while (kept->count > 0 &&
             (doubt_of(scene, tree->lost + kept_weight(kept)) / STRAYS_MOST > scene->error ||
              change > scene->error / STEP_SHARE ||
              energy_less(scene->threshold, tree->threshold)));
    uint32_t doubt = doubt_of(scene, tree->lost + kept_weight(kept));
    for (uint16_t i = 0; i < kept->count; i++) {
        growth_cut(tree, kept->branches[i].weight, kept->branches[i].events);
    }
    uint32_t proved = (uint32_t)(((tree->lost_depth >> 20) * scene->brightest) >> 10);
    if (doubt > tree->counts->estimated_error) {
        tree->counts->estimated_error = doubt;
    }
    if (proved > tree->counts->proved_error) {
        tree->counts->proved_error = proved;
    }
}

static struct colours refined_colour(const struct scene *scene, const struct ray *eye_ray,
                                     struct render_counts *counts,
                                     const struct tree_observer *observer) {
    struct tree tree;
    struct kept_branches kept;
    growth_start(&tree, scene, eye_ray, counts);
    kept.count = 0;
    tree.kept = &kept;
    tree.observer = observer;
    tree.threshold = energy_add(scene->threshold, scene->threshold);
    refine(&tree);
    counts->exhausted_pixels += tree.exhausted;
    return tree.sum;
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
