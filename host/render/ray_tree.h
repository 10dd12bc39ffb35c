/* SPDX-License-Identifier: MIT */
/* The tree of rays of one pixel as text, or as a graph for Graphviz. */
#ifndef SUPERFRAME_TREE_PRINT_H
#define SUPERFRAME_TREE_PRINT_H

#include <stdio.h>

#include "render/arithmetic.h"

/* A collected tree. */
struct ray_tree {
    struct observed_node *nodes; /* [i] is node i + 1 */
    struct observed_end *ends;
    size_t node_count, end_count, node_room, end_room;
    bool out_of_memory;
    double intensity[3];
    struct render_counts counts;
};

enum { RAY_TREE_NODES_MOST = 1000000 };

/* Grows the tree of a pixel. False where memory ran out, or the tree has more than
 * RAY_TREE_NODES_MOST nodes; free it all the same. */
bool ray_tree_grow(struct ray_tree *tree, const struct arithmetic *arithmetic,
                   const struct scene *scene, uint16_t x, uint16_t y);

void ray_tree_free(struct ray_tree *tree);

/* Prints a line for each node, indented by its depth, and one for each branch that ends; lengths in
 * the file's unit. 0, or -1 where writing failed. */
int ray_tree_print(FILE *out, const struct ray_tree *tree, const struct compiled_scene *compiled);

/* The same as a directed graph, as in the paper's Fig. 2: the arrows go the way of the light. */
int ray_tree_print_dot(FILE *out, const struct ray_tree *tree,
                       const struct compiled_scene *compiled);

#endif
