/* SPDX-License-Identifier: MIT */
/* The scene compiler: leaves out operations of CSG that change nothing. */
#include "compiler/optimise.h"

/* Stands for a solid without a point, while a tree is simplified. */
#define CODE_NOTHING (COMPILED_UNION - 1)

static bool is_nothing(const struct csg_tree *tree, uint32_t node) {
    return tree->nodes[node].code == CODE_NOTHING;
}

/* Tells whether two parts of a tree are the same solid, word for word. */
static bool are_equal(const struct csg_tree *tree, uint32_t one, uint32_t other) {
    const struct csg_node *a = &tree->nodes[one], *b = &tree->nodes[other];
    return a->code == b->code && (csg_is_leaf(tree, one) || (are_equal(tree, a->left, b->left) &&
                                                             are_equal(tree, a->right, b->right)));
}

static bool is_within(const struct compiled_scene *scene, const struct csg_tree *tree,
                      uint32_t inner, uint32_t outer) {
    return csg_is_leaf(tree, inner) && csg_is_leaf(tree, outer) &&
           primitive_is_within(scene, tree->nodes[inner].code, tree->nodes[outer].code);
}

static bool are_apart(const struct compiled_scene *scene, const struct csg_tree *tree, uint32_t one,
                      uint32_t other) {
    if (csg_is_leaf(tree, one) && csg_is_leaf(tree, other)) {
        return primitives_are_apart(scene, tree->nodes[one].code, tree->nodes[other].code);
    }
    struct bounds first = csg_bounds(scene, tree, one), second = csg_bounds(scene, tree, other);
    return bounds_are_apart(&first, &second, COMPILE_GAP);
}

/* Replaces a node by what the node amounts to: one of its sides, nothing, or the node itself. */
static void simplify_node(struct optimiser *optimiser, uint32_t index) {
    struct compiled_scene *scene = optimiser->compiler->scene;
    struct csg_tree *tree = &optimiser->tree;
    struct csg_node *node = &tree->nodes[index];
    if (csg_is_leaf(tree, index)) {
        return;
    }
    simplify_node(optimiser, node->left);
    simplify_node(optimiser, node->right);
    const uint32_t left = node->left, right = node->right, code = node->code;
    const bool no_left = is_nothing(tree, left), no_right = is_nothing(tree, right);
    const bool both = !no_left && !no_right;
    const bool equal = both && are_equal(tree, left, right);
    const bool right_covers = equal || (both && is_within(scene, tree, left, right));
    const bool left_covers = equal || (both && is_within(scene, tree, right, left));
    const bool apart =
        code != COMPILED_UNION && both && !equal && are_apart(scene, tree, left, right);
    struct csg_node result = *node;
    if (code == COMPILED_UNION) {
        result = no_left || right_covers   ? tree->nodes[right]
                 : no_right || left_covers ? tree->nodes[left]
                                           : *node;
    } else if (no_left || (code == COMPILED_INTERSECTION && (no_right || apart)) ||
               (code == COMPILED_DIFFERENCE && right_covers)) {
        result.code = CODE_NOTHING;
    } else if (code == COMPILED_DIFFERENCE && (no_right || apart)) {
        result = tree->nodes[left];
    } else if (code == COMPILED_INTERSECTION && (right_covers || left_covers)) {
        result = tree->nodes[right_covers ? left : right];
    }
    scene->report.simplified += result.code != code;
    *node = result;
}

bool optimise_simplify(struct optimiser *optimiser) {
    simplify_node(optimiser, optimiser->tree.root);
    return !is_nothing(&optimiser->tree, optimiser->tree.root);
}
