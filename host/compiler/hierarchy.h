/* SPDX-License-Identifier: MIT */
/* What leads rays through a scene of many primitives: hierarchies of bounds, and which objects a
 * primitive takes part in. */
#ifndef SUPERFRAME_COMPILE_HIERARCHY_H
#define SUPERFRAME_COMPILE_HIERARCHY_H

#include "compiler/tables.h"

struct compiled_node {
    NODE_FIELDS(COMPILED_MEMBER)
};

struct compiled_lead {
    LEAD_FIELDS(COMPILED_MEMBER)
};

struct compiled_use {
    USE_FIELDS(COMPILED_MEMBER)
};

/* The tables of firmware/sets/list, made from those of a compiled scene. No hierarchy has
 * more than HIERARCHY_LEVELS_MOST levels of nodes. */
struct compiled_hierarchy {
    SCENE_HIERARCHY_FIELDS(COMPILED_MEMBER)
    uint32_t node_count, lead_count, key_count, use_count, parent_count;
    unsigned levels; /* of nodes, in the deepest hierarchy */
    struct compiled_node *nodes;
    uint32_t *endless;
    struct compiled_lead *leads; /* by primitive */
    uint32_t *keys;
    struct compiled_use *uses;
    uint32_t *parents; /* by code of the programs */
};

enum { HIERARCHY_LEVELS_MOST = 36 };

/* Stands for no node, and for the place above a program's last code. */
#define COMPILED_NODE_NONE  UINT32_MAX
#define COMPILED_PLACE_ROOT UINT32_MAX

/* In front of the number of a primitive, among a node's children. */
#define COMPILED_NODE_PRIMITIVE UINT32_C(0x80000000)

/* Makes the tables; false where memory is out. hierarchy_free() takes them back in either case. */
bool hierarchy_make(const struct compiled_scene *scene, struct compiled_hierarchy *hierarchy);
void hierarchy_free(struct compiled_hierarchy *hierarchy);

/* Returns how many levels of nodes the deepest hierarchy has; HIERARCHY_LEVELS_MOST where memory is
 * out. */
unsigned hierarchy_levels(const struct compiled_scene *scene);

#endif
