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

/* Grows the tree of a pixel. Returns false where memory ran out, or the tree has more than 2^21
 * nodes or ends: room doubles up to 4 * RAY_TREE_NODES_MOST. Free the tree all the same. */
bool ray_tree_grow(struct ray_tree *tree, const struct arithmetic *arithmetic,
                   const struct scene *scene, uint16_t x, uint16_t y);

void ray_tree_free(struct ray_tree *tree);

/* Prints a line for each node, indented by its depth, and one for each branch that ends. Lengths
 * are in the file's unit. Returns 0, or -1 where writing failed or memory ran out. */
int ray_tree_print(FILE *out, const struct ray_tree *tree, const struct compiled_scene *compiled);

/* Prints the tree as a directed graph, as in the paper's Fig. 2: the arrows point where the light
 * goes. Returns 0, or -1 where writing failed. */
int ray_tree_print_dot(FILE *out, const struct ray_tree *tree,
                       const struct compiled_scene *compiled);

/* Prints the tree as a JSON object: the intensity, the nodes by their numbers, the ends of
 * branches. Returns 0, or -1 where writing failed. */
int ray_tree_print_json(FILE *out, const struct ray_tree *tree,
                        const struct compiled_scene *compiled);

#endif
