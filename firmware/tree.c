/* SPDX-License-Identifier: MIT */
/* The tree of rays without recursion: Eq. (3) as a sum over nodes, each times its weight. */
#include "tree.h"

#include "optics.h"
#include "shade.h"

/* A branch that is still to be followed. */
struct branch {
    struct ray ray;
    struct energies weight; /* the product of the coefficients on its way */
    uint8_t events;         /* boundary events on its way: their number is held against N */
};

/* Each event leaves at most one branch waiting, the other is followed at once. */
enum { BRANCHES_MOST = FEATURE_DEPTH + 2 };

struct tree {
    const struct scene *scene;
    struct render_counts *counts;
    struct colours sum;
    uint16_t waiting;
    struct branch branches[BRANCHES_MOST];
};

/* Puts a branch aside, if it is to be followed at all. */
static void grow(struct tree *tree, const struct branch *from, const struct hit *hit,
                 struct direction direction, struct energies weight, bool through) {
    real_energy largest = energies_largest(weight);
    if (energy_is_zero(largest) || energy_less(largest, tree->scene->threshold)) {
        return;
    }
    struct branch *branch = &tree->branches[tree->waiting++];
    branch->ray.origin = hit->where;
    branch->ray.direction = direction;
    branch->ray.inside = through ? hit->inside_after : hit->inside_before;
    branch->ray.surface = hit->surface;
    branch->ray.object = through ? hit->after : hit->before;
    branch->weight = weight;
    branch->events = (uint8_t)(from->events + 1);
}

/* Lambert-Bouguer: what is left of each primary after the way through the medium. */
static struct energies attenuated(const struct material *medium, struct energies weight,
                                  real_length way) {
    struct energies rest = {energy_transmitted(medium->absorption[0], way),
                            energy_transmitted(medium->absorption[1], way),
                            energy_transmitted(medium->absorption[2], way)};
    return energies_product(weight, rest);
}

static const struct material *material_of(const struct scene *scene, uint8_t object) {
    return &scene->materials[scene->objects[object].material];
}

/* The material whose surface a boundary is: the opaque one, else that of the object which fills
 * the place where both are. */
static const struct material *surface_material(const struct scene *scene, const struct hit *hit) {
    const struct material *before = material_of(scene, hit->before);
    const struct material *after = material_of(scene, hit->after);
    if (before->transparent != after->transparent) {
        return before->transparent ? after : before;
    }
    return hit->before > hit->after ? before : after;
}

static void visit(struct tree *tree, const struct branch *branch, const struct hit *hit) {
    const struct scene *scene = tree->scene;
    const struct material *material = surface_material(scene, hit);
    struct direction d = branch->ray.direction;
    struct split split;
    if (FEATURE_TRANSPARENCY && material->transparent) {
        split = optics_transparent(material_of(scene, hit->before), material_of(scene, hit->after),
                                   d, hit->normal);
    } else {
        split.mirrored = mirror_direction(d, incidence_cosine(d, hit->normal), hit->normal);
        split.reflectance = material->specular;
        split.transmittance = REAL_ENERGY(0.0);
    }
    struct colours local = shade(scene, material, &branch->ray, hit, split.mirrored, tree->counts);
    tree->sum = colours_add(tree->sum, colours_weighed(local, branch->weight));
    tree->counts->nodes++;
    if (branch->events >= scene->depth) {
        return;
    }
    grow(tree, branch, hit, split.mirrored, energies_scaled(branch->weight, split.reflectance),
         false);
    if (FEATURE_TRANSPARENCY) {
        grow(tree, branch, hit, split.refracted,
             energies_scaled(branch->weight, split.transmittance), true);
    }
}

struct colours tree_colour(const struct scene *scene, const struct ray *eye_ray,
                           struct render_counts *counts) {
    struct tree tree;
    tree.scene = scene;
    tree.counts = counts;
    tree.sum.red = tree.sum.green = tree.sum.blue = REAL_COLOUR(0.0);
    tree.waiting = 1;
    tree.branches[0].ray = *eye_ray;
    tree.branches[0].events = 0;
    const struct energies all = {REAL_ENERGY(1.0), REAL_ENERGY(1.0), REAL_ENERGY(1.0)};
    tree.branches[0].weight = all;
    while (tree.waiting > 0) {
        struct branch branch = tree.branches[--tree.waiting];
        struct hit hit;
        counts->rays++;
        if (!ray_hit(scene, &branch.ray, &hit, counts)) {
            if (hit.before != OBJECT_AIR) {
                counts->leaked_rays++;
            }
            tree.sum = colours_add(tree.sum, colours_weighed(scene->background, branch.weight));
            continue;
        }
        const struct material *medium = material_of(scene, branch.ray.object);
        if (FEATURE_ABSORPTION && medium->absorbs) {
            branch.weight = attenuated(medium, branch.weight, hit.t);
        }
        visit(&tree, &branch, &hit);
    }
    return tree.sum;
}
