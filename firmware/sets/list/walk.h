/* SPDX-License-Identifier: MIT */
/* The walk of a ray through a scene of many primitives. A hierarchy of bounds leads to those that
 * the ray may enter next. A list has those that the ray may leave. */
#ifndef SUPERFRAME_WALK_LIST_H
#define SUPERFRAME_WALK_LIST_H

#include "hierarchy.h"
#include "objects.h"

/* Tries to leave the primitives that the ray is inside of. A ray leaves a primitive before it
 * leaves the one around it. Tells whether just one is around no other, whose place in the list
 * becomes *sole. */
static inline bool try_exits(struct search *search, const struct primitive_set *inside,
                             real_length from, struct candidates *all, struct render_counts *counts,
                             uint16_t *sole) {
    const struct primitive *primitives = search->scene->primitives;
    bool is_around[SET_MOST] = {false};
    for (uint16_t i = 0; i < inside->count; i++) {
        entry_number enclosure = primitives[inside->member[i]].enclosure;
        uint16_t place = set_place(inside, enclosure);
        if (enclosure != ENCLOSURE_NONE && place < inside->count &&
            inside->member[place] == enclosure) {
            is_around[place] = true;
        }
    }
    uint16_t innermost = 0;
    for (uint16_t i = 0; i < inside->count; i++) {
        if (!is_around[i]) {
            try_primitive(search, inside->member[i], true, from, all, counts);
            innermost++;
            *sole = i;
        }
    }
    return innermost == 1;
}

/* Tries to enter what lies strictly within a primitive. */
static inline void try_within(struct search *search, const struct lead *lead,
                              const struct primitive_set *inside, real_length from,
                              struct candidates *all, struct render_counts *counts) {
    try_hierarchy(search, search->shadows ? lead->within_shadow : lead->within, inside, from, all,
                  counts);
}

/* Tries to enter all that may be entered from inside of these primitives. */
static inline void try_all_entries(struct search *search, const struct primitive_set *inside,
                                   real_length from, struct candidates *all,
                                   struct render_counts *counts) {
    const struct scene *scene = search->scene;
    for (run_count i = 0; i < scene->endless_count; i++) {
        entry_number index = scene->endless[i];
        if (!search->shadows || scene->leads[index].in_shadow_test) {
            try_entry(search, index, inside, from, all, counts);
        }
    }
    for (uint16_t i = 0; i < inside->count; i++) {
        try_within(search, &scene->leads[inside->member[i]], inside, from, all, counts);
    }
    try_hierarchy(search, search->shadows ? scene->shadow_root : scene->root, inside, from, all,
                  counts);
}

/* Tells whether a set has room for what is behind a crossing. */
static inline bool has_room(const struct primitive_set *inside, const crossed_set *toggled) {
    uint16_t count = inside->count;
    for (uint16_t i = 0; i < toggled->count; i++) {
        count = (uint16_t)(set_has(inside, toggled->member[i]) ? count - 1 : count + 1);
    }
    return count <= SET_MOST;
}

/* Makes a primitive the only one that is crossed. */
static inline void cross_only(crossed_set *toggled, entry_number primitive) {
    toggled->count = 1;
    toggled->member[0] = primitive;
}

/* Finds the nearest crossing at or after `from`, and all the primitives that are crossed there.
 * Where the list of a set has no room for them, there is no crossing. The ray then ends, and is
 * counted as leaked. */
static inline bool next_crossing(struct search *search, const struct primitive_set *inside,
                                 real_length from, struct crossing *best, crossed_set *toggled,
                                 struct render_counts *counts) {
    struct candidates all;
    all.limit = LENGTH_FAR;
    all.count = 0;
    toggled->count = 0;
    uint16_t sole = 0;
    bool is_sole = try_exits(search, inside, from, &all, counts, &sole);
    const struct lead *leads = search->scene->leads;
    if (is_sole && leads[inside->member[sole]].stands_apart) {
        try_within(search, &leads[inside->member[sole]], inside, from, &all, counts);
    } else {
        try_all_entries(search, inside, from, &all, counts);
    }
    drop_behind(&all);
    if (all.count == 0) {
        return false;
    }
    sort_candidates(&all);
    *best = all.found[0];
    cross_only(toggled, best->primitive);
    for (uint16_t i = 1; i < all.count; i++) {
        const struct crossing *found = &all.found[i];
        if (crossings_coincide(found, best)) {
            if (toggled->count == 2 * SET_MOST) {
                return false;
            }
            toggled->member[toggled->count++] = found->primitive;
        } else if (crossing_precedes(found, best)) {
            cross_only(toggled, found->primitive);
            *best = *found;
        }
    }
    return has_room(inside, toggled);
}

/* Enters the primitives of `which` that the set is outside of, and leaves the others of `which`.
 * Those that are left make room first. next_crossing() has seen to it that there is enough. */
static inline void set_toggle(struct primitive_set *set, const crossed_set *which) {
    const struct primitive_set before = *set;
    for (uint8_t enters = 0; enters < 2; enters++) {
        for (uint16_t i = 0; i < which->count; i++) {
            if (set_has(&before, which->member[i]) != (enters != 0)) {
                (void)set_flip(set, which->member[i]);
            }
        }
    }
}

/* Leaves the primitives alone that a search for shadows keeps account of. */
static inline void restrict_to_shadows(const struct scene *scene, struct primitive_set *inside) {
    uint16_t kept = 0;
    for (uint16_t i = 0; i < inside->count; i++) {
        if (scene->leads[inside->member[i]].in_shadow_test) {
            inside->member[kept++] = inside->member[i];
        }
    }
    inside->count = kept;
}

#endif
