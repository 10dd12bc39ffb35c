/* SPDX-License-Identifier: MIT */
/* The growing of a tree of rays: Eq. (3) as a sum over nodes, each times its weight. */
#include "growth.h"

#include "optics.h"
#include "shade.h"

/* What grows from a node: all that its branches have in common. */
struct node {
    const struct branch *branch;
    const struct hit *hit;
    const struct material *before, *after;
    const struct material *material; /* whose surface it is: one of the two */
    struct direction mirrored;
    real_unit cosine; /* of the angle of incidence */
};

static const struct energies no_energy = {REAL_ENERGY(0.0), REAL_ENERGY(0.0), REAL_ENERGY(0.0)};

static void report_end(const struct tree *tree, uint32_t parent, enum branch_kind kind,
                       uint8_t channel, struct energies weight, enum branch_end why) {
    if (FEATURE_OBSERVER && tree->observer) {
        tree->observer->end(tree->observer->context, parent, kind, channel, weight, why);
    }
}

static void report_branch_end(const struct tree *tree, const struct branch *branch,
                              enum branch_end why) {
    report_end(tree, branch->parent, (enum branch_kind)branch->kind, branch->channel,
               branch->weight, why);
}

/* Adds a part to the sum, rounded to steps of 2^-16 level: then the order of parts does not matter.
 * Whoever follows the branches in another order gets the same picture, bit for bit. */
static void add_part(struct tree *tree, struct colours part) {
    tree->sum = colours_add(tree->sum, colours_in_steps(part));
}

static enum estimate_way way_of(const struct scene *scene, const struct direction *direction) {
    return unit_is_negative(direction_dot(*direction, scene->camera.up)) ? WAY_DOWN : WAY_UP;
}

/* Adds the estimated radiance of a pruned branch; adds nothing without an estimate. */
static void cut_radiance(struct tree *tree, struct energies weight, enum estimate_way way) {
    const struct estimate *estimate = tree->scene->estimate;
    if (FEATURE_ESTIMATE && estimate) {
        const int32_t *steps = estimate->mean[way];
        const struct colours mean = {colour_of_steps(steps[0]), colour_of_steps(steps[1]),
                                     colour_of_steps(steps[2])};
        add_part(tree, colours_weighed(mean, weight));
    }
}

/* Enters a new branch into the sums of its pixel's tail, and returns whether the branch is
 * followed. `events` are those of the branch that it grows from. The new branch has one more, which
 * may be too many. */
static bool watch(struct tree *tree, struct branch *branch, uint8_t events) {
    const bool is_deep = events >= tree->scene->depth;
    const bool ends = events >= tree->last_depth;
    const real_energy largest = energies_largest(branch->weight);
    const enum estimate_way way = way_of(tree->scene, &branch->ray.direction);
    if (is_deep && !tree->learns_depth) {
        report_branch_end(tree, branch, END_DEPTH);
        return false;
    }
    if (branch->place == TAIL_NEAR && (is_deep || energy_less(largest, tree->coarse))) {
        branch->place = (uint8_t)tail_place_of(way);
        tail_watch(tree->tail, way, branch->weight);
    }
    if (ends || (branch->place != TAIL_NEAR && energy_less(largest, tree->threshold))) {
        uint8_t more = ends ? 0 : (uint8_t)(tree->last_depth - events - 1);
        tail_cut(tree->tail, (enum tail_place)branch->place, way, branch->weight, more);
        report_branch_end(tree, branch, END_THRESHOLD);
        return false;
    }
    return true;
}

/* Adds the estimate of a branch that threshold or depth level cut. */
static void cut(struct tree *tree, const struct branch *branch, enum branch_end why) {
    report_branch_end(tree, branch, why);
    cut_radiance(tree, branch->weight,
                 why == END_DEPTH ? WAY_ANY : way_of(tree->scene, &branch->ray.direction));
}

/* Tells whether the caller needs more of a pruned branch than its weight and direction. */
static bool cut_is_noticed(const struct tree *tree) {
    return (FEATURE_OBSERVER && tree->observer) || (FEATURE_ESTIMATE && tree->tail);
}

/* Makes the branch of one kind that grows from a node, without its direction and weight. What only
 * training passes or an observer look at is left out of an image that has none. */
static void make_branch(const struct tree *tree, const struct node *node, enum branch_kind kind,
                        uint8_t channel, struct branch *branch) {
    const struct hit *hit = node->hit;
    bool through = kind == BRANCH_REFRACTED;
    branch->ray.origin = hit->where;
    branch->ray.inside = through ? hit->inside_after : hit->inside_before;
    branch->ray.surface = hit->surface;
    branch->ray.object = through ? hit->after : hit->before;
    branch->events = (uint8_t)(node->branch->events + 1);
    branch->channel = channel;
    if (FEATURE_OBSERVER) {
        branch->kind = (uint8_t)kind;
        branch->parent = tree->node;
    }
    if (FEATURE_ESTIMATE) {
        branch->place = node->branch->place;
    }
}

/* Puts a branch among the waiting ones, if it is to be followed at all. */
static void grow(struct tree *tree, const struct node *node, enum branch_kind kind, uint8_t channel,
                 const struct direction *direction, const struct energies *coefficient) {
    struct energies weight = energies_product(node->branch->weight, *coefficient);
    real_energy largest = energies_largest(weight);
    if (energy_is_zero(largest)) {
        report_end(tree, tree->node, kind, channel, weight, END_NOTHING);
        return;
    }
    bool deep = node->branch->events >= tree->scene->depth;
    bool ends = deep || energy_less(largest, tree->threshold);
    if (ends && !cut_is_noticed(tree)) {
        cut_radiance(tree, weight, deep ? WAY_ANY : way_of(tree->scene, direction));
        return;
    }
    struct branch *branch = &tree->branches[tree->waiting];
    make_branch(tree, node, kind, channel, branch);
    branch->ray.direction = *direction;
    branch->weight = weight;
    if (FEATURE_ESTIMATE && tree->tail) {
        if (!watch(tree, branch, node->branch->events)) {
            return;
        }
    } else if (ends) {
        cut(tree, branch, deep ? END_DEPTH : END_THRESHOLD);
        return;
    }
    tree->waiting++;
}

/* Returns what is left of each primary after the path through the medium (Lambert-Bouguer). */
static struct energies attenuated(const struct material *medium, struct energies weight,
                                  real_length way) {
    struct energies rest = {energy_transmitted(medium->absorption[0], way),
                            energy_transmitted(medium->absorption[1], way),
                            energy_transmitted(medium->absorption[2], way)};
    return energies_product(weight, rest);
}

static const struct material *material_of(const struct scene *scene, entry_number object) {
    return &scene->materials[scene->objects[object].material];
}

/* Sets the materials of a boundary. The surface is that of the opaque material where just one is
 * opaque. Otherwise the surface is that of the object which fills the place of both. */
static void set_materials(const struct scene *scene, const struct hit *hit, struct node *node) {
    const struct material *before = material_of(scene, hit->before);
    const struct material *after = material_of(scene, hit->after);
    bool is_mixed = before->transparent != after->transparent;
    bool is_before = is_mixed ? after->transparent : hit->before > hit->after;
    node->before = before;
    node->after = after;
    node->material = is_before ? before : after;
}

static struct energies energies_equal(real_energy share) {
    struct energies all = {share, share, share};
    return all;
}

/* Returns a share for one primary, and 0 for the others. */
static struct energies energies_only(real_energy share, uint8_t channel) {
    struct energies one = no_energy;
    if (channel == 0) {
        one.red = share;
    } else if (channel == 1) {
        one.green = share;
    } else {
        one.blue = share;
    }
    return one;
}

/* Returns a coefficient of transmission times the medium's own factors, and times the filter that
 * the ray goes into. */
static struct energies transmitted(const struct scene *scene, const struct node *node,
                                   struct energies coefficient) {
    if (FEATURE_TINT && node->material->tints) {
        coefficient = energies_product(coefficient, node->material->transmits);
    }
    if (FEATURE_FILTER && scene->filters && node->hit->after > node->hit->before) {
        coefficient = energies_product(coefficient, node->material->filter);
    }
    return coefficient;
}

static struct energies reflected(const struct node *node, struct energies coefficient) {
    if (FEATURE_TINT && node->material->tints) {
        coefficient = energies_product(coefficient, node->material->reflects);
    }
    return coefficient;
}

/* Grows one branch in the mirror direction and three refracted ones (Table 1 (c)). */
static void grow_dispersed(struct tree *tree, const struct node *node) {
    struct passage passage[3];
    for (uint8_t i = 0; i < 3; i++) {
        optics_passage(node->before, node->after, i, &node->branch->ray.direction, node->cosine,
                       &node->hit->normal, &passage[i]);
    }
    struct energies coefficient = {passage[0].reflectance, passage[1].reflectance,
                                   passage[2].reflectance};
    coefficient = reflected(node, coefficient);
    grow(tree, node, BRANCH_REFLECTED, CHANNEL_ALL, &node->mirrored, &coefficient);
    for (uint8_t i = 0; i < 3; i++) {
        coefficient = transmitted(tree->scene, node, energies_only(passage[i].transmittance, i));
        grow(tree, node, BRANCH_REFRACTED, i, &passage[i].refracted, &coefficient);
    }
}

static void grow_transparent(struct tree *tree, const struct node *node) {
    const struct scene *scene = tree->scene;
    const struct branch *branch = node->branch;
    struct energies coefficient;
    if (FEATURE_SIMPLE && scene->simple) {
        coefficient = transmitted(scene, node, energies_equal(node->material->transmittance));
        grow(tree, node, BRANCH_REFRACTED, CHANNEL_ALL, &branch->ray.direction, &coefficient);
        return;
    }
    uint8_t channel = branch->channel;
    if (FEATURE_DISPERSION && channel == CHANNEL_ALL) {
        if (node->before->disperses || node->after->disperses) {
            grow_dispersed(tree, node);
            return;
        }
        channel = 0;
    }
    struct passage passage;
    optics_passage(node->before, node->after, FEATURE_DISPERSION ? channel : 0,
                   &branch->ray.direction, node->cosine, &node->hit->normal, &passage);
    coefficient = reflected(node, energies_equal(passage.reflectance));
    grow(tree, node, BRANCH_REFLECTED, branch->channel, &node->mirrored, &coefficient);
    coefficient = transmitted(scene, node, energies_equal(passage.transmittance));
    grow(tree, node, BRANCH_REFRACTED, branch->channel, &passage.refracted, &coefficient);
}

static bool is_above_white(struct colours intensity) {
    const int32_t white = INT32_C(255) << 16;
    return colour_steps(intensity.red) > white || colour_steps(intensity.green) > white ||
           colour_steps(intensity.blue) > white;
}

/* Adds a part to the sums of a pixel's tail. `intensity` is without the branch's weight. A square
 * counts up to 4096 levels, so that no sum leaves 64 bits. */
static void gather(struct tail *tail, uint8_t place, struct colours intensity,
                   struct colours part) {
    const int32_t steps[3] = {colour_steps(part.red), colour_steps(part.green),
                              colour_steps(part.blue)};
    int64_t largest = 0;
    for (uint8_t i = 0; i < 3; i++) {
        tail->gathered[place][i] += steps[i];
        largest = steps[i] > largest ? steps[i] : largest;
    }
    if (place != TAIL_NEAR && is_above_white(intensity)) {
        const int64_t most = (int64_t)4096 << 16;
        largest = (largest < most ? largest : most) >> 8;
        tail->above_white += largest * largest;
    }
}

/* Adds what arrives from the end of a branch, to the picture or to the sums of its tail. */
static void add_intensity(struct tree *tree, const struct branch *branch,
                          struct colours intensity) {
    struct colours part = colours_weighed(intensity, branch->weight);
    if (FEATURE_ESTIMATE && tree->tail) {
        gather(tree->tail, branch->place, intensity, part);
    } else {
        add_part(tree, part);
    }
}

static void visit(struct tree *tree, const struct branch *branch, const struct hit *hit) {
    const struct scene *scene = tree->scene;
    struct node node;
    node.branch = branch;
    node.hit = hit;
    set_materials(scene, hit, &node);
    node.cosine = incidence_cosine(branch->ray.direction, hit->normal);
    node.mirrored = mirror_direction(branch->ray.direction, node.cosine, hit->normal);
    tree->counts->nodes++;
    if (FEATURE_OBSERVER) {
        tree->node++;
    }
    struct colours local = {REAL_COLOUR(0.0), REAL_COLOUR(0.0), REAL_COLOUR(0.0)};
    if (!FEATURE_FILTER || !scene->filters || !node.material->transparent) {
        local = shade(scene, node.material, &branch->ray, hit, &node.mirrored, tree->counts);
        add_intensity(tree, branch, local);
    }
    if (FEATURE_OBSERVER && tree->observer) {
        tree->observer->node(tree->observer->context, tree->node, branch, hit, &local);
    }
    if (FEATURE_TRANSPARENCY && node.material->transparent) {
        grow_transparent(tree, &node);
    } else {
        const struct energies coefficient =
            energies_equal(specular_at(scene, node.material, node.cosine));
        grow(tree, &node, BRANCH_REFLECTED, branch->channel, &node.mirrored, &coefficient);
    }
}

/* Follows a branch to the next boundary, or out of the scene. */
static void follow(struct tree *tree, struct branch *branch) {
    const struct scene *scene = tree->scene;
    struct hit hit;
    tree->counts->rays++;
    if (ray_hit(scene, &branch->ray, &hit, tree->counts)) {
        const struct material *medium = material_of(scene, branch->ray.object);
        if (FEATURE_ABSORPTION && medium->absorbs) {
            branch->weight = attenuated(medium, branch->weight, hit.t);
        }
        visit(tree, branch, &hit);
        return;
    }
    if (hit.before != OBJECT_AIR) {
        tree->counts->leaked_rays++;
    }
    add_intensity(tree, branch, scene->background);
    report_branch_end(tree, branch, END_LEFT_SCENE);
}

void growth_start(struct tree *tree, const struct scene *scene, const struct ray *eye_ray,
                  struct render_counts *counts) {
    tree->scene = scene;
    tree->counts = counts;
    tree->observer = 0;
    tree->tail = 0;
    tree->learns_depth = false;
    tree->last_depth = scene->depth;
    tree->sum.red = tree->sum.green = tree->sum.blue = REAL_COLOUR(0.0);
    tree->threshold = tree->coarse = scene->threshold;
    tree->rays_before = counts->rays;
    tree->ray_budget = scene->ray_budget;
    tree->exhausted = false;
    tree->node = 0;
    tree->waiting = 1;
    tree->branches[0].ray = *eye_ray;
    tree->branches[0].weight = energies_equal(REAL_ENERGY(1.0));
    tree->branches[0].events = 0;
    tree->branches[0].channel = CHANNEL_ALL;
    tree->branches[0].kind = BRANCH_EYE;
    tree->branches[0].place = TAIL_NEAR;
    tree->branches[0].parent = 0;
}

bool growth_is_exhausted(const struct tree *tree) {
    return tree->counts->rays - tree->rays_before >= tree->ray_budget;
}

/* Notes a branch that waited when the budget ended among what is cut. */
static void watch_end(struct tree *tree, const struct branch *branch) {
    enum estimate_way way = way_of(tree->scene, &branch->ray.direction);
    enum tail_place place = (enum tail_place)branch->place;
    if (place == TAIL_NEAR) {
        place = tail_place_of(way);
        tail_watch(tree->tail, way, branch->weight);
    }
    tail_cut(tree->tail, place, way, branch->weight, (uint8_t)(tree->last_depth - branch->events));
}

/* Cuts, unseen, all branches that wait when the budget is used up. */
static void cut_waiting(struct tree *tree) {
    while (tree->waiting > 0) {
        const struct branch *branch = &tree->branches[--tree->waiting];
        report_branch_end(tree, branch, END_BUDGET);
        if (FEATURE_ESTIMATE && tree->tail) {
            watch_end(tree, branch);
        } else {
            cut_radiance(tree, branch->weight, way_of(tree->scene, &branch->ray.direction));
        }
    }
}

void growth_finish(struct tree *tree) {
    while (tree->waiting > 0) {
        if (growth_is_exhausted(tree)) {
            tree->exhausted = true;
            cut_waiting(tree);
            return;
        }
        const struct branch *last = &tree->branches[--tree->waiting];
        /* Copied by members: on a Cortex-M0 gcc copies a whole branch by memcpy. */
        struct branch branch = {last->ray,
                                last->weight,
                                last->events,
                                last->channel,
                                FEATURE_OBSERVER ? last->kind : 0,
                                FEATURE_ESTIMATE ? last->place : TAIL_NEAR,
                                FEATURE_OBSERVER ? last->parent : 0};
        follow(tree, &branch);
    }
}
