/* SPDX-License-Identifier: MIT */
/* An object's postfix program as a tree, which the scene compiler rewrites and the POV-Ray export
 * reads. */
#ifndef SUPERFRAME_COMPILE_TREE_H
#define SUPERFRAME_COMPILE_TREE_H

#include <stddef.h>

#include "compiler/bounds.h"
#include "compiler/tables.h"

/* A primitive, or an operation (COMPILED_UNION and above) on two nodes before it. */
struct csg_node {
    uint32_t code;
    uint32_t left, right;
    uint32_t first; /* of the nodes below it, or itself, as read: they all stand in a row */
};

/* All zero: no tree yet. */
struct csg_tree {
    struct csg_node *nodes;
    size_t room; /* for nodes */
    uint32_t root;
};

/* Reads an object's program into a tree, in place of what was there. Returns false if memory is
 * out. */
bool csg_read(const struct compiled_scene *scene, const struct compiled_object *object,
              struct csg_tree *tree);

void csg_free(struct csg_tree *tree);

/* Writes a tree as the object's program, from code `place` of the programs. Returns the place after
 * the program's last code. */
uint32_t csg_write(struct compiled_scene *scene, struct compiled_object *object,
                   const struct csg_tree *tree, uint32_t place);

bool csg_is_leaf(const struct csg_tree *tree, uint32_t node);

/* Returns how far a part of a tree reaches along a direction of length 1, at most. */
double csg_reach(const struct compiled_scene *scene, const struct csg_tree *tree, uint32_t node,
                 const double direction[3]);

/* Returns what a part of a tree lies within; infinite where that is not known. */
struct bounds csg_bounds(const struct compiled_scene *scene, const struct csg_tree *tree,
                         uint32_t node);

#endif
