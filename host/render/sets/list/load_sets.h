/* SPDX-License-Identifier: MIT */
/* The tables of firmware/sets/list in memory. The include path chooses this form. */
#ifndef SUPERFRAME_LOAD_SETS_H
#define SUPERFRAME_LOAD_SETS_H

#include <stdio.h>
#include <string.h>

#include "render/per_arithmetic/block.h"

typedef char levels_fit[(int)COMPILED_LEVELS_MOST <= (int)FEATURE_LEVELS ? 1 : -1];

/* Tells whether lists have room for a scene. */
static bool sets_have_room(const struct compiled_scene *from) {
    return from->nesting <= FEATURE_NESTING;
}

static bool sets_fit(const struct compiled_scene *from, struct scene_error *error) {
    if (sets_have_room(from)) {
        return true;
    }
    snprintf(error->text, sizeof error->text,
             "%.200s: up to %lu solids overlap at one place; at most %d are allowed: take solids "
             "apart, or draw them in several scenes",
             from->path, (unsigned long)from->nesting, (int)FEATURE_NESTING);
    return false;
}

static struct primitive_set set_of(const struct compiled_set *from) {
    struct primitive_set set;
    set_clear(&set);
    for (uint32_t i = 0; i < from->count; i++) {
        (void)set_flip(&set, from->members[i]);
    }
    return set;
}

#define LOAD_SET(name) to->name = set_of(&from->name);
#define LOAD_MARKS(name)

/* Sets the places of a node's faces. */
static void places_of(real_length to[3][NODE_WIDTH], const double from[3][NODE_WIDTH]) {
    for (int axis = 0; axis < 3; axis++) {
        for (int i = 0; i < NODE_WIDTH; i++) {
            to[axis][i] = REAL_LENGTH(from[axis][i]);
        }
    }
}

#define LOAD_PLACES(name)   places_of(to->name, from->name);
#define LOAD_CHILDREN(name) memcpy(to->name, from->name, sizeof to->name);

static void load_node(struct bounds_node *to, const struct compiled_node *from) {
    NODE_FIELDS(LOAD_MEMBER)
}

static void load_lead(struct lead *to, const struct compiled_lead *from) {
    LEAD_FIELDS(LOAD_MEMBER)
}

static void load_use(struct use *to, const struct compiled_use *from) {
    USE_FIELDS(LOAD_MEMBER)
}

static void load_number(uint32_t *to, const uint32_t *from) {
    *to = *from;
}

static void load_roots(struct scene *to, const struct compiled_hierarchy *from) {
    SCENE_HIERARCHY_FIELDS(LOAD_MEMBER)
}

static void sets_load(struct block *block, struct scene *to, const struct compiled_scene *from) {
    const struct compiled_hierarchy *made = &from->hierarchy;
    load_roots(to, made);
    LOAD_TABLE(struct bounds_node, made->node_count, nodes, made->nodes, load_node)
    LOAD_TABLE(entry_number, made->endless_count, endless, made->endless, load_number)
    LOAD_TABLE(struct lead, made->lead_count, leads, made->leads, load_lead)
    LOAD_TABLE(entry_number, made->key_count, keys, made->keys, load_number)
    LOAD_TABLE(struct use, made->use_count, uses, made->uses, load_use)
    LOAD_TABLE(run_first, made->parent_count, parents, made->parents, load_number)
}

#endif
