/* SPDX-License-Identifier: MIT */
/* Mirrored and refracted rays, their weights, and which of them are followed. */
#include "stream/branches.h"

#include "optics.h"

/* The two rays that leave a boundary, for each lane: direction of the refracted one, both
 * shares. */
struct passage_lanes {
    struct direction_lanes refracted;
    real_energy reflectance[LANES], transmittance[LANES];
};

/* Applies Snell's law: sets `passes` to 1 where light gets through, and then the cosine of its
 * angle. */
static void find_cosines(const struct hit_lanes *restrict hit,
                         const struct boundary_lanes *restrict boundary,
                         real_unit refracted[restrict LANES], uint32_t passes[restrict LANES]) {
    for (int i = 0; i < LANES; i++) {
        real_unit cosine = REAL_UNIT(0.0);
        bool gets_through = unit_refracted_cosine(hit->cosine[i], boundary->eta[i], &cosine);
        refracted[i] = cosine;
        passes[i] = gets_through ? 1 : 0;
    }
}

static void find_shares(const struct hit_lanes *restrict hit,
                        const struct boundary_lanes *restrict boundary,
                        const real_unit refracted[restrict LANES],
                        const uint32_t passes[restrict LANES],
                        struct passage_lanes *restrict passage) {
    const real_energy none = REAL_ENERGY(0.0), all = REAL_ENERGY(1.0);
    for (int i = 0; i < LANES; i++) {
        bool bends = boundary->bends[i] != 0, clear = boundary->clear[i] != 0,
             through = passes[i] != 0;
        real_energy part = fresnel_reflectance(hit->cosine[i], refracted[i], boundary->n[i]);
        real_energy reflectance = through ? part : all;
        real_energy transmittance = through ? energy_complement(part) : none;
        reflectance = bends ? reflectance : none;
        transmittance = bends ? transmittance : all;
        passage->reflectance[i] = clear ? reflectance : boundary->specular[i];
        passage->transmittance[i] = clear ? transmittance : none;
    }
}

static void find_refracted(const struct direction_lanes *restrict direction,
                           const struct hit_lanes *restrict hit,
                           const struct boundary_lanes *restrict boundary,
                           const real_unit refracted[restrict LANES],
                           struct direction_lanes *restrict bent) {
    for (int i = 0; i < LANES; i++) {
        bool bends = boundary->bends[i] != 0;
        real_index eta = boundary->eta[i];
        real_index bend = index_bend(eta, hit->cosine[i], refracted[i]);
        real_unit x = unit_bent(direction->x[i], eta, bend, hit->normal.x[i]);
        real_unit y = unit_bent(direction->y[i], eta, bend, hit->normal.y[i]);
        real_unit z = unit_bent(direction->z[i], eta, bend, hit->normal.z[i]);
        bent->x[i] = bends ? x : direction->x[i];
        bent->y[i] = bends ? y : direction->y[i];
        bent->z[i] = bends ? z : direction->z[i];
    }
}

/* Finds the refracted direction and the shares of both rays: optics_passage() of
 * firmware/optics.c. */
static void find_passages(const struct direction_lanes *direction, const struct hit_lanes *hit,
                          const struct boundary_lanes *boundary, struct passage_lanes *passage) {
    real_unit refracted[LANES];
    uint32_t passes[LANES];
    find_cosines(hit, boundary, refracted, passes);
    find_shares(hit, boundary, refracted, passes, passage);
    find_refracted(direction, hit, boundary, refracted, &passage->refracted);
}

/* Tells whether a child is followed, by the largest of its three weights. hit, path and largest are
 * those of one lane. */
static inline uint32_t is_followed(const struct scene *scene, uint32_t hit, uint32_t path,
                                   real_energy largest) {
    bool goes_on = (path_events(path) < scene->depth) & !energy_less(largest, scene->threshold);
    return ((hit != 0) & !energy_is_zero(largest) & goes_on) ? 1 : 0;
}

/* Finds the weights of one kind of children, and which of the children are followed. */
static void weigh(const struct scene *scene, const struct ray_lanes *restrict rays,
                  const struct hit_lanes *restrict hit, const real_energy share[restrict LANES],
                  struct energy_lanes *restrict child, uint32_t follow[restrict LANES]) {
    for (int i = 0; i < LANES; i++) {
        const struct energies before = {rays->weight.red[i], rays->weight.green[i],
                                        rays->weight.blue[i]};
        struct energies weight = energies_scaled(before, share[i]);
        child->red[i] = weight.red;
        child->green[i] = weight.green;
        child->blue[i] = weight.blue;
        follow[i] = is_followed(scene, hit->is[i], rays->path[i], energies_largest(weight));
    }
}

static void weigh_grey(const struct scene *scene, const struct ray_lanes *restrict rays,
                       const struct hit_lanes *restrict hit,
                       const real_energy share[restrict LANES], struct energy_lanes *restrict child,
                       uint32_t follow[restrict LANES]) {
    for (int i = 0; i < LANES; i++) {
        real_energy weight = energy_product(rays->weight.red[i], share[i]);
        child->red[i] = weight;
        follow[i] = is_followed(scene, hit->is[i], rays->path[i], weight);
    }
}

/* Finds which way each child goes: an enum estimate_way. */
static void find_ways(const struct scene *scene, const struct direction_lanes *restrict direction,
                      uint32_t way[restrict LANES]) {
    const struct direction up = scene->camera.up;
    for (int i = 0; i < LANES; i++) {
        real_unit rise =
            unit_dot(direction->x[i], direction->y[i], direction->z[i], up.x, up.y, up.z);
        way[i] = unit_is_negative(rise) ? WAY_DOWN : WAY_UP;
    }
}

/* Sets the weights and the ways of the children that are not followed; the others weigh 0. */
static void set_cut(const struct scene *scene, const struct ray_lanes *restrict rays,
                    const struct hit_lanes *restrict hit, const uint32_t way[restrict LANES],
                    const struct energy_lanes *restrict weight,
                    const uint32_t follow[restrict LANES], struct cut_lanes *restrict cut) {
    const real_energy none = REAL_ENERGY(0.0);
    for (int i = 0; i < LANES; i++) {
        bool is_cut = (hit->is[i] != 0) & (follow[i] == 0);
        bool is_deep = path_events(rays->path[i]) >= scene->depth;
        cut->way[i] = is_deep ? WAY_ANY : way[i];
        cut->weight.red[i] = is_cut ? weight->red[i] : none;
        cut->weight.green[i] = is_cut ? weight->green[i] : none;
        cut->weight.blue[i] = is_cut ? weight->blue[i] : none;
    }
}

/* One kind of children: where they go, and what share of the light they get. */
struct kind_of_children {
    const struct direction_lanes *direction;
    const uint32_t *object, *inside;
    const real_energy *share;
};

/* What is the same for both kinds of children. */
struct start_lanes {
    real_length from[LANES];
    uint32_t events[LANES], target[LANES];
};

static void set_starts(const struct ray_lanes *restrict rays, const struct hit_lanes *restrict hit,
                       struct start_lanes *restrict start) {
    for (int i = 0; i < LANES; i++) {
        start->from[i] = LENGTH_EPSILON;
        start->events[i] = path_of(hit->surface[i], 0, path_events(rays->path[i]) + 1);
        start->target[i] = rays->target[i] & ~TARGET_CONTINUED;
    }
}

static void send(const struct scene *scene, const struct ray_lanes *rays,
                 const struct hit_lanes *hit, const struct start_lanes *start,
                 const struct kind_of_children *kind, struct watched_pixels *watched,
                 struct queue *queue, struct cut_lanes *cut) {
    struct energy_lanes weight;
    uint32_t follow[LANES], path[LANES], places[LANES], way[LANES];
    const uint32_t *target = start->target;
    if (queue->is_grey) {
        weigh_grey(scene, rays, hit, kind->share, &weight, follow);
    } else {
        weigh(scene, rays, hit, kind->share, &weight, follow);
    }
    if (scene->estimate) {
        find_ways(scene, kind->direction, way);
    }
    if (watched != NULL) {
        const struct watched_children children = {way, &weight, queue->is_grey};
        watch_children(watched, scene, rays, hit, &children, follow, places);
        target = places;
    } else if (scene->estimate) {
        set_cut(scene, rays, hit, way, &weight, follow, cut);
    }
    for (int i = 0; i < LANES; i++) {
        path[i] = start->events[i] | path_of(0, kind->object[i], 0);
    }
    const struct ray_columns children = {
        &hit->where, kind->direction, &weight, start->from, kind->inside, path, target};
    queue_push(queue, &children, follow);
}

void children_grow(const struct scene *scene, const struct ray_lanes *rays,
                   const struct hit_lanes *hit, const struct boundary_lanes *boundary,
                   struct watched_pixels *watched, struct queue *queue, struct cut_lanes cut[2]) {
    struct passage_lanes passage;
    struct start_lanes start;
    find_passages(&rays->direction, hit, boundary, &passage);
    set_starts(rays, hit, &start);
    const struct kind_of_children mirrored = {&hit->mirrored, hit->before, hit->inside_before,
                                              passage.reflectance};
    const struct kind_of_children refracted = {&passage.refracted, hit->after, hit->inside_after,
                                               passage.transmittance};
    send(scene, rays, hit, &start, &mirrored, watched, queue, &cut[0]);
    send(scene, rays, hit, &start, &refracted, watched, queue, &cut[1]);
}
