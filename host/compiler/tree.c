/* SPDX-License-Identifier: MIT */
/* An object's postfix program as a tree, for the scene compiler to rewrite. */
#include "compiler/tree.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "compiler/compiler_internal.h"

bool csg_read(const struct compiled_scene *scene, const struct compiled_object *object,
              struct csg_tree *tree) {
    if (object->length > tree->room) {
        struct csg_node *nodes = realloc(tree->nodes, object->length * sizeof *nodes);
        if (nodes == NULL) {
            return false;
        }
        tree->nodes = nodes;
        tree->room = object->length;
    }
    for (uint32_t i = 0; i < object->length; i++) {
        struct csg_node *node = &tree->nodes[i];
        node->code = scene->programs[object->program + i];
        node->left = node->right = 0;
        node->first = i;
        if (node->code >= COMPILED_UNION) {
            node->right = i - 1;
            node->left = tree->nodes[node->right].first - 1;
            node->first = tree->nodes[node->left].first;
        }
    }
    tree->root = object->length - 1;
    return true;
}

void csg_free(struct csg_tree *tree) {
    free(tree->nodes);
    memset(tree, 0, sizeof *tree);
}

static uint32_t write_node(struct compiled_scene *scene, const struct csg_tree *tree,
                           uint32_t index, uint32_t place) {
    const struct csg_node *node = &tree->nodes[index];
    if (node->code >= COMPILED_UNION) {
        place = write_node(scene, tree, node->left, place);
        place = write_node(scene, tree, node->right, place);
    }
    scene->programs[place] = node->code;
    return place + 1;
}

uint32_t csg_write(struct compiled_scene *scene, struct compiled_object *object,
                   const struct csg_tree *tree, uint32_t place) {
    uint32_t end = write_node(scene, tree, tree->root, place);
    object->program = place;
    object->length = end - place;
    return end;
}

bool csg_is_leaf(const struct csg_tree *tree, uint32_t node) {
    return tree->nodes[node].code < COMPILED_UNION;
}

double csg_reach(const struct compiled_scene *scene, const struct csg_tree *tree, uint32_t index,
                 const double direction[3]) {
    const struct csg_node *node = &tree->nodes[index];
    if (csg_is_leaf(tree, index)) {
        return primitive_reach(scene, node->code, direction);
    }
    double left = csg_reach(scene, tree, node->left, direction);
    if (node->code == COMPILED_DIFFERENCE) {
        return left;
    }
    double right = csg_reach(scene, tree, node->right, direction);
    return node->code == COMPILED_UNION ? fmax(left, right) : fmin(left, right);
}

struct bounds csg_bounds(const struct compiled_scene *scene, const struct csg_tree *tree,
                         uint32_t index) {
    const struct csg_node *node = &tree->nodes[index];
    if (csg_is_leaf(tree, index)) {
        return primitive_bounds(scene, node->code);
    }
    struct bounds left = csg_bounds(scene, tree, node->left);
    if (node->code == COMPILED_DIFFERENCE) {
        return left;
    }
    struct bounds right = csg_bounds(scene, tree, node->right);
    return node->code == COMPILED_UNION ? bounds_union(&left, &right)
                                        : bounds_intersection(&left, &right);
}
