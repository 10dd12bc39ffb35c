/* SPDX-License-Identifier: MIT */
/* Mirrored and refracted rays, their weights, and which of them are followed. */
#include "children.h"

#include "optics.h"

/* A boundary's two ways on, for each lane. */
struct passage_lanes {
    struct direction_lanes refracted;
    real_energy reflectance[LANES], transmittance[LANES];
};

/* Snell's law: 1 in `passes` where light gets through, and the cosine of its angle then. */
static void find_cosines(const struct hit_lanes *restrict hit,
                         const struct border_lanes *restrict border,
                         real_unit refracted[restrict LANES], uint32_t passes[restrict LANES]) {
    for (int i = 0; i < LANES; i++) {
        real_unit cosine = REAL_UNIT(0.0);
        bool gets_through = unit_refracted_cosine(hit->cosine[i], border->eta[i], &cosine);
        refracted[i] = cosine;
        passes[i] = gets_through ? 1 : 0;
    }
}

static void find_shares(const struct hit_lanes *restrict hit,
                        const struct border_lanes *restrict border,
                        const real_unit refracted[restrict LANES],
                        const uint32_t passes[restrict LANES],
                        struct passage_lanes *restrict passage) {
    const real_energy none = REAL_ENERGY(0.0), all = REAL_ENERGY(1.0);
    for (int i = 0; i < LANES; i++) {
        bool bends = border->bends[i] != 0, clear = border->clear[i] != 0, through = passes[i] != 0;
        real_energy part = fresnel_reflectance(hit->cosine[i], refracted[i], border->n[i]);
        real_energy reflectance = through ? part : all;
        real_energy transmittance = through ? energy_complement(part) : none;
        reflectance = bends ? reflectance : none;
        transmittance = bends ? transmittance : all;
        passage->reflectance[i] = clear ? reflectance : border->specular[i];
        passage->transmittance[i] = clear ? transmittance : none;
    }
}

static void find_refracted(const struct direction_lanes *restrict direction,
                           const struct hit_lanes *restrict hit,
                           const struct border_lanes *restrict border,
                           const real_unit refracted[restrict LANES],
                           struct direction_lanes *restrict bent) {
    for (int i = 0; i < LANES; i++) {
        bool bends = border->bends[i] != 0;
        real_index eta = border->eta[i];
        real_index bend = index_bend(eta, hit->cosine[i], refracted[i]);
        real_unit x = unit_bent(direction->x[i], eta, bend, hit->normal.x[i]);
        real_unit y = unit_bent(direction->y[i], eta, bend, hit->normal.y[i]);
        real_unit z = unit_bent(direction->z[i], eta, bend, hit->normal.z[i]);
        bent->x[i] = bends ? x : direction->x[i];
        bent->y[i] = bends ? y : direction->y[i];
        bent->z[i] = bends ? z : direction->z[i];
    }
}

/* optics_passage() of firmware/optics.c. */
static void find_passages(const struct direction_lanes *direction, const struct hit_lanes *hit,
                          const struct border_lanes *border, struct passage_lanes *passage) {
    real_unit refracted[LANES];
    uint32_t passes[LANES];
    find_cosines(hit, border, refracted, passes);
    find_shares(hit, border, refracted, passes, passage);
    find_refracted(direction, hit, border, refracted, &passage->refracted);
}

/* The weights of one kind of children: which of them are followed, and what is cut of the others
 * (0 where nothing is). */
static void weigh(const struct scene *scene, const struct ray_lanes *restrict rays,
                  const struct hit_lanes *restrict hit, const real_energy share[restrict LANES],
                  struct ray_lanes *restrict child, uint32_t follow[restrict LANES],
                  struct energy_lanes *restrict cut) {
    const uint32_t depth = scene->depth;
    const real_energy threshold = scene->threshold, none = REAL_ENERGY(0.0);
    for (int i = 0; i < LANES; i++) {
        const struct energies before = {rays->weight.red[i], rays->weight.green[i],
                                        rays->weight.blue[i]};
        struct energies weight = energies_scaled(before, share[i]);
        real_energy largest = energies_largest(weight);
        bool goes_on = !((path_events(rays->path[i]) >= depth) | energy_less(largest, threshold));
        bool is = (hit->is[i] != 0) & !energy_is_zero(largest);
        child->weight.red[i] = weight.red;
        child->weight.green[i] = weight.green;
        child->weight.blue[i] = weight.blue;
        cut->red[i] = (is & !goes_on) ? weight.red : none;
        cut->green[i] = (is & !goes_on) ? weight.green : none;
        cut->blue[i] = (is & !goes_on) ? weight.blue : none;
        follow[i] = (is & goes_on) ? 1 : 0;
    }
}

/* Where the children of one kind go on. */
static void set_out(const struct ray_lanes *restrict rays, const struct hit_lanes *restrict hit,
                    const uint32_t object[restrict LANES], struct ray_lanes *restrict child) {
    child->origin = hit->where;
    for (int i = 0; i < LANES; i++) {
        child->from[i] = LENGTH_EPSILON;
        child->path[i] = path_of(hit->surface[i], object[i], path_events(rays->path[i]) + 1);
        child->target[i] = rays->target[i] & ~TARGET_CONTINUED;
    }
}

void children_grow(const struct scene *scene, const struct ray_lanes *rays,
                   const struct hit_lanes *hit, const struct border_lanes *border,
                   struct queue *queue, struct energy_lanes cut[2]) {
    struct passage_lanes passage;
    struct ray_lanes child;
    uint32_t follow[LANES];
    find_passages(&rays->direction, hit, border, &passage);

    set_out(rays, hit, hit->before, &child);
    child.direction = hit->mirrored;
    weigh(scene, rays, hit, passage.reflectance, &child, follow, &cut[0]);
    for (int i = 0; i < LANES; i++) {
        child.inside[i] = hit->inside_before[i];
    }
    queue_push(queue, &child, follow);

    set_out(rays, hit, hit->after, &child);
    child.direction = passage.refracted;
    weigh(scene, rays, hit, passage.transmittance, &child, follow, &cut[1]);
    for (int i = 0; i < LANES; i++) {
        child.inside[i] = hit->inside_after[i];
    }
    queue_push(queue, &child, follow);
}
