/* SPDX-License-Identifier: MIT */
/* One pixel, looked at until it is as accurate as was asked for. */
#include "refine.h"

/* Looks at the pixel once; false where the budget ended the look. */
static bool look(const struct refining *refining, const struct ray *eye_ray, uint8_t steps,
                 uint64_t rays_before, struct render_counts *counts, struct tail *tail) {
    struct tree tree;
    const struct tail_thresholds at = tail_thresholds_at(refining->scene, steps);
    tail_clear(tail);
    growth_start(&tree, refining->scene, eye_ray, counts);
    tree.rays_before = rays_before;
    tree.ray_budget = refining->ray_budget;
    tree.observer = refining->observer;
    tree.tail = tail;
    tree.threshold = at.fine;
    tree.coarse = at.coarse;
    growth_finish(&tree);
    return !tree.exhausted;
}

uint8_t refine_pixel(const struct refining *refining, const struct ray *eye_ray,
                     struct render_counts *counts, struct tail *tail,
                     struct tail_verdict *verdict) {
    const uint64_t rays_before = counts->rays;
    uint64_t best_began = rays_before;
    uint8_t steps = refining->scene->estimate->first, best_steps = steps;
    bool is_whole = true;
    verdict->uncertainty = UINT32_MAX;
    for (;;) {
        struct tail_verdict found;
        const uint64_t rays_so_far = counts->rays;
        is_whole = look(refining, eye_ray, steps, rays_before, counts, tail);
        const struct tail_rays rays = {counts->rays - rays_so_far, counts->rays - rays_before,
                                       refining->ray_budget};
        tail_judge(refining->scene, tail, steps, &rays, &found);
        /* A look that the budget has ended may be worse than the one before. */
        if (found.uncertainty <= verdict->uncertainty) {
            *verdict = found;
            best_began = rays_so_far;
            best_steps = steps;
        }
        if (found.steps == TAIL_STEPS) {
            break;
        }
        steps = found.steps;
    }
    counts->exhausted_pixels += !is_whole;
    /* An observer is to keep the look whose colour counts. Its rays are not counted once more. */
    if (FEATURE_OBSERVER && refining->observer && best_steps != steps) {
        struct render_counts again = *counts;
        again.rays = best_began;
        (void)look(refining, eye_ray, best_steps, rays_before, &again, tail);
    }
    return steps;
}
