/* SPDX-License-Identifier: MIT */
/* An object's postfix program as a tree, which the scene compiler rewrites and the POV-Ray export
 * reads. */
#ifndef SUPERFRAME_COMPILE_TREE_H
#define SUPERFRAME_COMPILE_TREE_H

#include "compiler/bounds.h"
#include "compiler/tables.h"

/* A primitive, or an operation (PROGRAM_UNION and above) on two nodes before it. */
struct csg_node {
    uint8_t code;
    uint8_t left, right;
};

struct csg_tree {
    struct csg_node nodes[256];
    uint8_t root;
};

void csg_read(const struct compiled_scene *scene, const struct compiled_object *object,
              struct csg_tree *tree);

/* Writes a tree as the object's program, from byte `place` of the programs. Returns the place after
 * the program's last byte. */
uint16_t csg_write(struct compiled_scene *scene, struct compiled_object *object,
                   const struct csg_tree *tree, uint16_t place);

bool csg_is_leaf(const struct csg_tree *tree, uint8_t node);

/* Returns how far a part of a tree reaches along a direction of length 1, at most. */
double csg_reach(const struct compiled_scene *scene, const struct csg_tree *tree, uint8_t node,
                 const double direction[3]);

/* Returns what a part of a tree lies within; infinite where that is not known. */
struct bounds csg_bounds(const struct compiled_scene *scene, const struct csg_tree *tree,
                         uint8_t node);

#endif
