/* SPDX-License-Identifier: MIT */
/* A ray among many primitives: the bounds that it passes through lead it to those that it may
 * enter. */
#ifndef SUPERFRAME_HIERARCHY_H
#define SUPERFRAME_HIERARCHY_H

#include "candidates.h"

/* The compiler makes no hierarchy of more levels than the image has room for. */
enum { WAITING_MOST = FEATURE_LEVELS * (NODE_WIDTH - 1) + 2 };

/* Tells whether the surface that a ray starts on bounds a primitive. */
static inline bool starts_on(const struct search *search, const struct primitive *primitive) {
    const struct scene *scene = search->scene;
    surface_number start = search->surface;
    if (start == SURFACE_NONE) {
        return false;
    }
    if (FEATURE_BALL && primitive->kind == PRIMITIVE_BALL) {
        return scene->balls[primitive->index].surface == start;
    }
    if (FEATURE_POLYHEDRON && primitive->kind == PRIMITIVE_POLYHEDRON) {
        const struct polyhedron *polyhedron = &scene->polyhedra[primitive->index];
        bool is_there = false;
        for (uint8_t i = 0; i < polyhedron->count; i++) {
            is_there |= scene->planes[polyhedron->first + i].surface == start;
        }
        return is_there;
    }
    uint8_t axes = 7;
    const struct box *box = &scene->boxes[primitive->index];
    bool is_there = false;
    if (FEATURE_QUADRIC && primitive->kind == PRIMITIVE_QUADRIC) {
        const struct quadric *quadric = &scene->quadrics[primitive->index];
        axes = quadric->cuts;
        box = &scene->boxes[quadric->box];
        is_there = quadric->surface == start;
    }
    for (uint8_t face = 0; axes != 0 && face < 6; face++) {
        is_there |= (axes >> face % 3 & 1) != 0 && box->surface[face] == start;
    }
    return is_there;
}

static inline void try_primitive(struct search *search, entry_number index, bool inside,
                                 real_length from, struct candidates *all,
                                 struct render_counts *counts) {
    struct crossing found;
    bool starts_there = starts_on(search, &search->scene->primitives[index]);
    if (primitive_crossing(search, index, inside, starts_there, from, &found, counts)) {
        found.primitive = index;
        keep_candidate(all, &found);
    }
}

/* The parts of a ray within a node's bounds; there is none where a part ends before it begins. */
struct parts {
    real_length in[NODE_WIDTH], out[NODE_WIDTH];
};

/* Cuts the parts by the faces across an axis. */
static inline void pass_axis(const struct bounds_node *node, const struct local_ray *ray,
                             uint8_t axis, real_length origin, struct parts *parts) {
    bool falling = (ray->falling >> axis & 1) != 0;
    const real_length *near = falling ? node->high[axis] : node->low[axis];
    const real_length *far = falling ? node->low[axis] : node->high[axis];
    const real_slope slope = ray->slope[axis];
    for (uint8_t i = 0; i < NODE_WIDTH; i++) {
        real_length in = length_over(length_subtract(near[i], origin), slope);
        real_length out = length_over(length_subtract(far[i], origin), slope);
        parts->in[i] = length_less(parts->in[i], in) ? in : parts->in[i];
        parts->out[i] = length_less(out, parts->out[i]) ? out : parts->out[i];
    }
}

/* Ends the parts of a ray that runs along an axis's faces and not between them. */
static inline void pass_level(const struct bounds_node *node, uint8_t axis, real_length origin,
                              struct parts *parts) {
    for (uint8_t i = 0; i < NODE_WIDTH; i++) {
        bool within =
            !length_less(origin, node->low[axis][i]) && length_less(origin, node->high[axis][i]);
        parts->out[i] = within ? parts->out[i] : length_negate(LENGTH_FAR);
    }
}

/* Finds the parts of a ray within a node's bounds, from `from` to the limit. */
static inline void find_parts(const struct search *search, const struct bounds_node *node,
                              real_length from, real_length limit, struct parts *parts) {
    const struct local_ray *ray = &search->views[VIEW_WORLD];
    const real_length origin[3] = {ray->origin.x, ray->origin.y, ray->origin.z};
    for (uint8_t i = 0; i < NODE_WIDTH; i++) {
        parts->in[i] = from;
        parts->out[i] = limit;
    }
    for (uint8_t axis = 0; axis < 3; axis++) {
        if ((ray->level >> axis & 1) != 0) {
            pass_level(node, axis, origin[axis], parts);
        } else {
            pass_axis(node, ray, axis, origin[axis], parts);
        }
    }
}

/* Tries to enter a primitive, if the ray is outside of it. */
static inline void try_entry(struct search *search, entry_number index,
                             const struct primitive_set *inside, real_length from,
                             struct candidates *all, struct render_counts *counts) {
    if (!set_has(inside, index)) {
        try_primitive(search, index, false, from, all, counts);
    }
}

/* Holds what waits to be looked at: nodes and primitives, the nearest one last. */
struct waiting {
    uint16_t count;
    run_first child[WAITING_MOST];
    real_length in[WAITING_MOST];
};

/* Returns the bounds that the ray passes through, a bit each. */
static inline uint32_t parts_met(const struct parts *parts) {
    static const uint32_t bit[NODE_WIDTH] = {1, 2, 4, 8, 16, 32, 64, 128};
    uint32_t met = 0;
    for (uint8_t i = 0; i < NODE_WIDTH; i++) {
        met |= length_less(parts->out[i], parts->in[i]) ? 0 : bit[i];
    }
    return met;
}

/* Returns the number of the lowest bit of a byte that is not 0. */
static inline uint8_t lowest_bit(uint32_t byte) {
    /* The upper three bits of 0x1D times a power of two differ for each of eight powers. */
    static const uint8_t number[8] = {0, 1, 6, 2, 7, 5, 4, 3};
    return number[(0x1D * (byte & (0 - byte)) & 0xFF) >> 5];
}

/* Lets what a node's bounds hold wait, where the ray passes through them. The nearest one comes
 * last: it is looked at first. */
static inline void wait_for(struct waiting *waiting, const struct bounds_node *node,
                            const struct parts *parts) {
    uint16_t first = waiting->count;
    for (uint32_t met = parts_met(parts); met != 0; met &= met - 1) {
        const uint8_t bound = lowest_bit(met);
        const real_length in = parts->in[bound];
        uint16_t place = waiting->count++;
        for (; place > first && length_less(waiting->in[place - 1], in); place--) {
            waiting->child[place] = waiting->child[place - 1];
            waiting->in[place] = waiting->in[place - 1];
        }
        waiting->child[place] = node->child[bound];
        waiting->in[place] = in;
    }
}

/* Tries to enter the primitives of a hierarchy, from the nearest bounds on. */
static inline void try_hierarchy(struct search *search, run_first root,
                                 const struct primitive_set *inside, real_length from,
                                 struct candidates *all, struct render_counts *counts) {
    struct waiting waiting;
    struct parts parts;
    if (root == NODE_NONE) {
        return;
    }
    waiting.count = 1;
    waiting.child[0] = root;
    waiting.in[0] = from;
    while (waiting.count > 0) {
        run_first child = waiting.child[--waiting.count];
        if (length_less(all->limit, waiting.in[waiting.count])) {
            continue;
        }
        if (child >= NODE_PRIMITIVE) {
            try_entry(search, child - NODE_PRIMITIVE, inside, from, all, counts);
        } else {
            const struct bounds_node *node = &search->scene->nodes[child];
            find_parts(search, node, from, all->limit, &parts);
            wait_for(&waiting, node, &parts);
        }
    }
}

#endif
