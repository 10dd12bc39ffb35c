/* SPDX-License-Identifier: MIT */
/* The pixels of a band where an accuracy is asked for: the thresholds and the tail of each. */
#include "stream/watch.h"

void watch_begin(struct watched_pixels *pixels, const struct scene *scene, uint32_t count) {
    for (uint8_t steps = 0; steps < TAIL_STEPS; steps++) {
        pixels->at[steps] = tail_thresholds_at(scene, steps);
    }
    for (uint32_t i = 0; i < count; i++) {
        pixels->steps[i] = scene->estimate->first;
        pixels->rays[i] = 0;
        pixels->best[i].uncertainty = UINT32_MAX;
    }
}

/* What becomes of each lane's child: 1 or 0. */
struct fate_lanes {
    uint32_t enters[LANES], ends[LANES];
};

static inline real_energy largest_of(const struct watched_children *children, int i) {
    const struct energy_lanes *weight = children->weight;
    if (children->is_grey) {
        return weight->red[i];
    }
    const struct energies all = {weight->red[i], weight->green[i], weight->blue[i]};
    return energies_largest(all);
}

/* Decides on each child by its pixel's thresholds. */
static void decide(const struct watched_pixels *pixels, const struct scene *scene,
                   const struct ray_lanes *restrict rays, const struct hit_lanes *restrict hit,
                   const struct watched_children *children, struct fate_lanes *restrict fate,
                   uint32_t follow[restrict LANES], uint32_t target[restrict LANES]) {
    for (int i = 0; i < LANES; i++) {
        const uint32_t from = rays->target[i] & ~TARGET_CONTINUED;
        const uint32_t pixel = from % TARGET_PIXELS;
        const struct tail_thresholds *at = &pixels->at[pixels->steps[pixel]];
        const real_energy largest = largest_of(children, i);
        bool lives = (hit->is[i] != 0) & !energy_is_zero(largest) &
                     (path_events(rays->path[i]) < scene->depth);
        bool enters = lives & (from == pixel) & energy_less(largest, at->coarse);
        target[i] = enters
                        ? pixel + tail_place_of((enum estimate_way)children->way[i]) * TARGET_PIXELS
                        : from;
        bool ends = lives & (target[i] != pixel) & energy_less(largest, at->fine);
        fate->enters[i] = enters ? 1 : 0;
        fate->ends[i] = ends ? 1 : 0;
        follow[i] = (lives & !ends) ? 1 : 0;
    }
}

static struct energies weight_of(const struct watched_children *children, uint32_t lane) {
    const struct energy_lanes *weight = children->weight;
    const real_energy red = weight->red[lane];
    const struct energies weights = {red, children->is_grey ? red : weight->green[lane],
                                     children->is_grey ? red : weight->blue[lane]};
    return weights;
}

void watch_children(struct watched_pixels *pixels, const struct scene *scene,
                    const struct ray_lanes *rays, const struct hit_lanes *hit,
                    const struct watched_children *children, uint32_t follow[LANES],
                    uint32_t target[LANES]) {
    struct fate_lanes fate;
    const uint32_t *way = children->way;
    decide(pixels, scene, rays, hit, children, &fate, follow, target);
    for (uint64_t set = lanes_set(fate.enters); set != 0; set &= set - 1) {
        const uint32_t i = lanes_first(set);
        tail_watch(&pixels->tail[target[i] % TARGET_PIXELS], (enum estimate_way)way[i],
                   weight_of(children, i));
    }
    for (uint64_t set = lanes_set(fate.ends); set != 0; set &= set - 1) {
        const uint32_t i = lanes_first(set);
        tail_cut(&pixels->tail[target[i] % TARGET_PIXELS],
                 (enum tail_place)(target[i] / TARGET_PIXELS), (enum estimate_way)way[i],
                 weight_of(children, i), (uint8_t)(scene->depth - path_events(rays->path[i]) - 1));
    }
}
