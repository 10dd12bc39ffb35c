/* SPDX-License-Identifier: MIT */
/* The tree of rays of one pixel, without recursion, to a threshold or to an accuracy. */
#include "tree.h"

#include "growth.h"
#include "refine.h"

static struct colours refined_colour(const struct scene *scene, const struct ray *eye_ray,
                                     struct render_counts *counts,
                                     const struct tree_observer *observer) {
    struct tail tail;
    struct tail_verdict verdict;
    struct refining refining = {scene, observer, scene->ray_budget};
    refine_pixel(&refining, eye_ray, counts, &tail, &verdict);
    (void)tail_note(scene, &verdict, counts);
    const struct colours colours = {colour_of_steps(verdict.colour[0]),
                                    colour_of_steps(verdict.colour[1]),
                                    colour_of_steps(verdict.colour[2])};
    return colours;
}

struct colours tree_colour(const struct scene *scene, const struct ray *eye_ray,
                           struct render_counts *counts, const struct tree_observer *observer) {
    if (FEATURE_ACCURACY && scene->error > 0) {
        return refined_colour(scene, eye_ray, counts, observer);
    }
    struct tree tree;
    growth_start(&tree, scene, eye_ray, counts);
    tree.observer = observer;
    growth_finish(&tree);
    counts->exhausted_pixels += tree.exhausted;
    return tree.sum;
}
