/* SPDX-License-Identifier: MIT */
/* Builds hierarchies of bounds by the surface-area heuristic. A ray that passes through the bounds
 * of primitives is expected to try some of them. They are divided where those are fewest. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "compiler/compiler_internal.h"

/* Bounds are wider than primitives by more than any arithmetic's rounding, in scaled units. */
#define HIERARCHY_MARGIN 0x1p-6

/* What reaches farther has no end but the world's. */
#define HIERARCHY_EXTENT (COMPILE_EXTENT + 1)

static const struct bounds never_met = {{COMPILE_EXTENT, COMPILE_EXTENT, COMPILE_EXTENT},
                                        {-COMPILE_EXTENT, -COMPILE_EXTENT, -COMPILE_EXTENT}};

/* From LEVELS_HALVED on, groups are halved by number: eleven more levels hold 2^32 primitives. */
enum { BINS = 16, LEVELS_HALVED = COMPILED_LEVELS_MOST - 11 };

/* A primitive while the hierarchy is built. */
struct item {
    struct bounds bounds;
    double middle[3];
    uint32_t primitive;
};

struct builder {
    const struct compiled_scene *scene;
    struct compiled_hierarchy *to;
    struct item *all;         /* by primitive */
    bool *takes_part;         /* by primitive: in the hierarchies that are being built */
    struct item *items;       /* sorted as the nodes take them */
    uint32_t *starts, *roots; /* by the primitive that others lie within, and of the rest */
};

static double half_area(const struct bounds *bounds) {
    double x = bounds->high[0] - bounds->low[0], y = bounds->high[1] - bounds->low[1];
    double z = bounds->high[2] - bounds->low[2];
    /* What holds no point has its low place above its high one, along some axis or along all. */
    return x < 0 || y < 0 || z < 0 ? 0 : x * y + y * z + z * x;
}

/* How a node's items are divided: those below `place` along an axis, or the first half of them. */
struct division {
    int axis; /* -1: not at all */
    double place;
    double cost;
};

/* The items of a bin: those whose middles fall into one part of an axis. */
struct bin {
    struct bounds bounds;
    uint32_t count;
};

static void fill_bins(const struct item *items, uint32_t count, int axis, double low, double high,
                      struct bin bins[BINS]) {
    for (int i = 0; i < BINS; i++) {
        bins[i].bounds = bounds_nothing;
        bins[i].count = 0;
    }
    for (uint32_t i = 0; i < count; i++) {
        int place = (int)((items[i].middle[axis] - low) / (high - low) * BINS);
        struct bin *bin = &bins[place < BINS ? place : BINS - 1];
        bin->bounds = bounds_union(&bin->bounds, &items[i].bounds);
        bin->count++;
    }
}

/* Improves the division by the borders of bins along an axis. */
static void divide_along(const struct item *items, uint32_t count, int axis, double low,
                         double high, struct division *best) {
    struct bin bins[BINS];
    double above[BINS];
    struct bounds bounds = bounds_nothing;
    uint32_t below = 0;
    if (!(low < high)) {
        return;
    }
    fill_bins(items, count, axis, low, high, bins);
    for (int i = BINS - 1; i > 0; i--) {
        bounds = bounds_union(&bounds, &bins[i].bounds);
        above[i] = half_area(&bounds);
    }
    bounds = bounds_nothing;
    for (int i = 1; i < BINS; i++) {
        bounds = bounds_union(&bounds, &bins[i - 1].bounds);
        below += bins[i - 1].count;
        double cost = half_area(&bounds) * below + above[i] * (count - below);
        if (below > 0 && below < count && cost < best->cost) {
            best->axis = axis;
            best->place = low + (high - low) * i / BINS;
            best->cost = cost;
        }
    }
}

/* Puts the items below a place first; returns how many they are. */
static uint32_t sort_by_place(struct item *items, uint32_t count, const struct division *by) {
    uint32_t below = 0;
    for (uint32_t i = 0; i < count; i++) {
        if (items[i].middle[by->axis] < by->place) {
            struct item moved = items[i];
            items[i] = items[below];
            items[below++] = moved;
        }
    }
    return below;
}

/* Items that stand side by side, from `first`. */
struct group {
    uint32_t first, count;
    struct bounds bounds;
};

static struct group group_of(const struct item *items, uint32_t first, uint32_t count) {
    struct group group = {first, count, bounds_nothing};
    for (uint32_t i = 0; i < count; i++) {
        group.bounds = bounds_union(&group.bounds, &items[first + i].bounds);
    }
    return group;
}

/* Divides a group of two items or more, which are sorted for that; *group keeps the first part.
 * Returns the other part. */
static struct group divide(struct item *all, struct group *group, unsigned level) {
    struct item *items = &all[group->first];
    struct bounds middles = bounds_nothing;
    struct division best = {-1, 0, HUGE_VAL};
    for (uint32_t i = 0; i < group->count; i++) {
        bounds_include(&middles, items[i].middle);
    }
    for (int axis = 0; axis < 3 && level < LEVELS_HALVED; axis++) {
        divide_along(items, group->count, axis, middles.low[axis], middles.high[axis], &best);
    }
    uint32_t below = best.axis < 0 ? 0 : sort_by_place(items, group->count, &best);
    if (below == 0 || below == group->count) {
        below = group->count / 2;
    }
    struct group other = group_of(all, group->first + below, group->count - below);
    *group = group_of(all, group->first, below);
    return other;
}

/* Returns the group that costs most, among those that can be divided; -1: none can. */
static int costliest(const struct group *groups, int count, bool by_number) {
    int found = -1;
    double most = 0;
    for (int i = 0; i < count; i++) {
        double cost = by_number ? groups[i].count : groups[i].count * half_area(&groups[i].bounds);
        if (groups[i].count > 1 && (found < 0 || cost > most)) {
            found = i;
            most = cost;
        }
    }
    return found;
}

/* Makes a node of items, and the nodes below. Returns its number. Recursion goes no deeper than
 * the levels. */
static uint32_t build_node(struct builder *builder, const struct group *whole, unsigned level) {
    struct compiled_hierarchy *to = builder->to;
    struct group groups[NODE_WIDTH] = {*whole};
    uint32_t number = to->node_count++;
    int count = 1, next;
    while (count < NODE_WIDTH && (next = costliest(groups, count, level >= LEVELS_HALVED)) >= 0) {
        groups[count++] = divide(builder->items, &groups[next], level);
    }
    to->levels = level + 1 > to->levels ? level + 1 : to->levels;
    for (int i = 0; i < NODE_WIDTH; i++) {
        const struct bounds bounds = i < count ? groups[i].bounds : never_met;
        uint32_t child = COMPILED_NODE_NONE;
        if (i < count && groups[i].count == 1) {
            child = COMPILED_NODE_PRIMITIVE + builder->items[groups[i].first].primitive;
        } else if (i < count) {
            child = build_node(builder, &groups[i], level + 1);
        }
        to->nodes[number].child[i] = child;
        for (int axis = 0; axis < 3; axis++) {
            to->nodes[number].low[axis][i] = bounds.low[axis];
            to->nodes[number].high[axis][i] = bounds.high[axis];
        }
    }
    return number;
}

/* ---- Which primitives go into which hierarchy ------------------------------------------------ */

static bool is_endless(const struct bounds *bounds) {
    bool is_within = true;
    for (int i = 0; i < 3; i++) {
        is_within =
            is_within && bounds->low[i] >= -HIERARCHY_EXTENT && bounds->high[i] <= HIERARCHY_EXTENT;
    }
    return !is_within;
}

/* Returns the primitive whose hierarchy has this one; primitive_count where none has. In a search
 * for shadows, only primitives of that search lie around others. */
static uint32_t holder_of(const struct compiled_scene *scene, uint32_t primitive, bool shadows) {
    uint32_t holder = scene->primitives[primitive].enclosure;
    while (holder != COMPILED_ENCLOSURE_NONE && shadows &&
           !compiled_set_has(&scene->shadow_primitives, holder)) {
        holder = scene->primitives[holder].enclosure;
    }
    return holder != COMPILED_ENCLOSURE_NONE ? holder : scene->primitive_count;
}

/* Counts the items of each holder into starts[holder + 1], and makes starts of the counts. */
static void find_starts(const struct builder *builder, bool shadows) {
    uint32_t holders = builder->scene->primitive_count + 1;
    memset(builder->starts, 0, (holders + 1) * sizeof *builder->starts);
    for (uint32_t i = 0; i < builder->scene->primitive_count; i++) {
        builder->starts[holder_of(builder->scene, i, shadows) + 1] += builder->takes_part[i];
    }
    for (uint32_t i = 0; i < holders; i++) {
        builder->starts[i + 1] += builder->starts[i];
    }
}

/* Builds one hierarchy for each primitive that others lie within, and one of the rest. Puts their
 * roots into `roots`, the last one for the rest. */
static void build_all(struct builder *builder, bool shadows) {
    const struct compiled_scene *scene = builder->scene;
    find_starts(builder, shadows);
    for (uint32_t i = 0; i < scene->primitive_count; i++) {
        if (builder->takes_part[i]) {
            builder->items[builder->starts[holder_of(scene, i, shadows)]++] = builder->all[i];
        }
    }
    uint32_t first = 0;
    for (uint32_t i = 0; i <= scene->primitive_count; i++) {
        uint32_t count = builder->starts[i] - first;
        builder->roots[i] = COMPILED_NODE_NONE;
        if (count > 0) {
            const struct group group = group_of(builder->items, first, count);
            builder->roots[i] = build_node(builder, &group, 0);
        }
        first = builder->starts[i];
    }
}

/* Sets each primitive's bounds, and lists what has no end. */
static void find_items(struct builder *builder) {
    for (uint32_t i = 0; i < builder->scene->primitive_count; i++) {
        struct item *item = &builder->all[i];
        item->primitive = i;
        item->bounds = primitive_bounds(builder->scene, i);
        builder->takes_part[i] = !is_endless(&item->bounds);
        if (!builder->takes_part[i]) {
            builder->to->endless[builder->to->endless_count++] = i;
            continue;
        }
        for (int axis = 0; axis < 3; axis++) {
            item->bounds.low[axis] -= HIERARCHY_MARGIN;
            item->bounds.high[axis] += HIERARCHY_MARGIN;
            item->middle[axis] = (item->bounds.low[axis] + item->bounds.high[axis]) / 2;
        }
    }
}

/* ---- Which primitives stand apart ------------------------------------------------------------ */

/* A primitive that is looked at, by its bounds with their margin. */
struct lone {
    const struct compiled_scene *scene;
    uint32_t primitive;
    struct bounds bounds;
};

/* Tells whether one primitive lies within another, or within what lies within that. */
static bool lies_below(const struct compiled_scene *scene, uint32_t primitive, uint32_t other) {
    while (primitive != COMPILED_ENCLOSURE_NONE && primitive != other) {
        primitive = scene->primitives[primitive].enclosure;
    }
    return primitive == other;
}

/* Tells whether the primitive is apart from one that is neither within it nor around it. */
static bool is_apart_from(const struct lone *lone, uint32_t other) {
    return lies_below(lone->scene, lone->primitive, other) ||
           primitives_are_apart(lone->scene, lone->primitive, other);
}

/* Tells whether the primitive is apart from all below a node. Recursion goes no deeper than the
 * levels. */
static bool is_apart_below(const struct lone *lone, uint32_t number) {
    const struct compiled_node *node = &lone->scene->hierarchy.nodes[number];
    bool is_apart = true;
    for (int i = 0; i < NODE_WIDTH && is_apart; i++) {
        uint32_t child = node->child[i];
        bool meets = child != COMPILED_NODE_NONE;
        for (int axis = 0; axis < 3 && meets; axis++) {
            meets = node->low[axis][i] <= lone->bounds.high[axis] &&
                    lone->bounds.low[axis] <= node->high[axis][i];
        }
        is_apart = !meets || (child >= COMPILED_NODE_PRIMITIVE
                                  ? is_apart_from(lone, child - COMPILED_NODE_PRIMITIVE)
                                  : is_apart_below(lone, child));
    }
    return is_apart;
}

/* Tells whether a primitive stands apart. The hierarchies that the primitive lies in are asked, and
 * those of the primitives around it. What lies within something that is apart is apart, too. */
static bool stands_apart(const struct compiled_scene *scene, const struct item *item) {
    const struct compiled_hierarchy *hierarchy = &scene->hierarchy;
    const struct lone lone = {scene, item->primitive, item->bounds};
    bool is_apart = true;
    for (uint32_t i = 0; i < hierarchy->endless_count && is_apart; i++) {
        is_apart = is_apart_from(&lone, hierarchy->endless[i]);
    }
    for (uint32_t i = item->primitive; is_apart && i != COMPILED_ENCLOSURE_NONE;
         i = scene->primitives[i].enclosure) {
        uint32_t enclosure = scene->primitives[i].enclosure;
        uint32_t root = enclosure == COMPILED_ENCLOSURE_NONE ? hierarchy->root
                                                             : hierarchy->leads[enclosure].within;
        is_apart = root == COMPILED_NODE_NONE || is_apart_below(&lone, root);
    }
    return is_apart;
}

/* ---- All together ---------------------------------------------------------------------------- */

static void build_hierarchies(struct builder *builder) {
    const struct compiled_scene *scene = builder->scene;
    struct compiled_hierarchy *to = builder->to;
    find_items(builder);
    build_all(builder, false);
    to->root = builder->roots[scene->primitive_count];
    for (uint32_t i = 0; i < scene->primitive_count; i++) {
        to->leads[i].within = builder->roots[i];
        to->leads[i].in_shadow_test = compiled_set_has(&scene->shadow_primitives, i);
    }
    for (uint32_t i = 0; i < scene->primitive_count; i++) {
        to->leads[i].stands_apart = builder->takes_part[i] && stands_apart(scene, &builder->all[i]);
        builder->takes_part[i] = builder->takes_part[i] && to->leads[i].in_shadow_test;
    }
    build_all(builder, true);
    to->shadow_root = builder->roots[scene->primitive_count];
    for (uint32_t i = 0; i < scene->primitive_count; i++) {
        to->leads[i].within_shadow = builder->roots[i];
    }
}

/* Makes room for what is built. Each primitive is in two hierarchies, and each node but a root has
 * two items or more. */
static bool make_tables(struct compiled_hierarchy *to, uint32_t primitives) {
    to->lead_count = primitives;
    to->nodes = calloc(4 * (size_t)primitives + 2, sizeof *to->nodes);
    to->endless = calloc((size_t)primitives + 1, sizeof *to->endless);
    to->leads = calloc((size_t)primitives + 1, sizeof *to->leads);
    return to->nodes != NULL && to->endless != NULL && to->leads != NULL;
}

bool compile_hierarchy(struct compiler *compiler) {
    struct compiled_scene *scene = compiler->scene;
    const size_t room = (size_t)scene->primitive_count + 2;
    struct builder builder = {.scene = scene,
                              .to = &scene->hierarchy,
                              .all = calloc(room, sizeof *builder.all),
                              .items = calloc(room, sizeof *builder.items),
                              .takes_part = calloc(room, sizeof *builder.takes_part),
                              .starts = calloc(room, sizeof *builder.starts),
                              .roots = calloc(room, sizeof *builder.roots)};
    const bool has_memory = builder.all != NULL && builder.items != NULL &&
                            builder.takes_part != NULL && builder.starts != NULL &&
                            builder.roots != NULL &&
                            make_tables(builder.to, scene->primitive_count);
    if (has_memory) {
        build_hierarchies(&builder);
    }
    free(builder.all);
    free(builder.items);
    free(builder.takes_part);
    free(builder.starts);
    free(builder.roots);
    return has_memory || compile_fail_memory(compiler);
}
