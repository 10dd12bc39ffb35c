/* SPDX-License-Identifier: MIT */
/* An object's postfix program as a tree, for the scene compiler to rewrite. */
#include "compiler/tree.h"

#include <math.h>

#include "compiler/compiler_internal.h"

void csg_read(const struct compiled_scene *scene, const struct compiled_object *object,
              struct csg_tree *tree) {
    uint8_t stack[256] = {0};
    int depth = 0;
    for (uint8_t i = 0; i < object->length; i++) {
        struct csg_node *node = &tree->nodes[i];
        node->code = scene->programs[object->program + i];
        node->left = node->right = 0;
        if (node->code >= PROGRAM_UNION) {
            node->right = stack[--depth];
            node->left = stack[--depth];
        }
        stack[depth++] = i;
    }
    tree->root = (uint8_t)(object->length - 1);
}

static uint16_t write_node(struct compiled_scene *scene, const struct csg_tree *tree, uint8_t index,
                           uint16_t place) {
    const struct csg_node *node = &tree->nodes[index];
    if (node->code >= PROGRAM_UNION) {
        place = write_node(scene, tree, node->left, place);
        place = write_node(scene, tree, node->right, place);
    }
    scene->programs[place] = node->code;
    return (uint16_t)(place + 1);
}

uint16_t csg_write(struct compiled_scene *scene, struct compiled_object *object,
                   const struct csg_tree *tree, uint16_t place) {
    uint16_t end = write_node(scene, tree, tree->root, place);
    object->program = place;
    object->length = (uint8_t)(end - place);
    return end;
}

bool csg_is_leaf(const struct csg_tree *tree, uint8_t node) {
    return tree->nodes[node].code < PROGRAM_UNION;
}

double csg_reach(const struct compiled_scene *scene, const struct csg_tree *tree, uint8_t index,
                 const double direction[3]) {
    const struct csg_node *node = &tree->nodes[index];
    if (csg_is_leaf(tree, index)) {
        return primitive_reach(scene, node->code, direction);
    }
    double left = csg_reach(scene, tree, node->left, direction);
    if (node->code == PROGRAM_DIFFERENCE) {
        return left;
    }
    double right = csg_reach(scene, tree, node->right, direction);
    return node->code == PROGRAM_UNION ? fmax(left, right) : fmin(left, right);
}

struct bounds csg_bounds(const struct compiled_scene *scene, const struct csg_tree *tree,
                         uint8_t index) {
    const struct csg_node *node = &tree->nodes[index];
    if (csg_is_leaf(tree, index)) {
        return primitive_bounds(scene, node->code);
    }
    struct bounds left = csg_bounds(scene, tree, node->left);
    if (node->code == PROGRAM_DIFFERENCE) {
        return left;
    }
    struct bounds right = csg_bounds(scene, tree, node->right);
    return node->code == PROGRAM_UNION ? bounds_union(&left, &right)
                                       : bounds_intersection(&left, &right);
}
