/* SPDX-License-Identifier: MIT */
/* The scene compiler: a quadric and the planes that cut it become one primitive, and two boxes that
 * meet become one. */
#include <math.h>
#include <string.h>

#include "compiler/cut.h"
#include "compiler/optimise.h"

/* Tells whether a plane takes something of a primitive away: the primitive is not strictly behind
 * the plane. */
static bool plane_cuts(const struct compiled_scene *scene, uint32_t primitive,
                       const struct compiled_face *plane) {
    return primitive_reach(scene, primitive, plane->normal) >= plane->offset - COMPILE_STRICTLY;
}

/* Tells whether a plane leaves something of a primitive. */
static bool plane_leaves(const struct compiled_scene *scene, uint32_t primitive,
                         const struct compiled_face *plane) {
    double back[3] = {-plane->normal[0], -plane->normal[1], -plane->normal[2]};
    return -primitive_reach(scene, primitive, back) < plane->offset - COMPILE_STRICTLY;
}

/* Finds the planes of a box or a polyhedron that cut a primitive. Returns their number, or -1 if
 * one of the planes leaves nothing of the primitive. */
static int cutting_planes(const struct compiled_scene *scene, uint32_t primitive, uint32_t solid,
                          struct compiled_face planes[COMPILED_FACES_MOST]) {
    enum primitive_kind kind = scene->primitives[solid].kind;
    bool is_flat = kind == PRIMITIVE_BOX || kind == PRIMITIVE_POLYHEDRON;
    int count = is_flat ? compiled_faces(scene, solid, planes) : 0, kept = 0;
    for (int i = 0; i < count; i++) {
        if (!plane_leaves(scene, primitive, &planes[i])) {
            return -1;
        }
        if (plane_cuts(scene, primitive, &planes[i])) {
            planes[kept++] = planes[i];
        }
    }
    return kept;
}

/* Makes one primitive of the part of a primitive within a solid, or of the part outside of the
 * solid. Returns COMPILED_NONE if no primitive can be that part. */
static uint32_t fuse_quadric(struct compiler *compiler, uint32_t primitive, uint32_t solid,
                             bool outside) {
    struct compiled_face planes[COMPILED_FACES_MOST];
    struct cut_quadric cut;
    int count = cutting_planes(compiler->scene, primitive, solid, planes);
    if (count <= 0 || (outside && count != 1) || !cut_start(compiler->scene, primitive, &cut)) {
        return COMPILED_NONE;
    }
    for (int i = 0; i < count; i++) {
        int axis = cut_axis(compiler, &cut, planes[i].normal);
        if (axis < 0) {
            return COMPILED_NONE;
        }
        double along =
            vector_dot(planes[i].normal, compiled_axis(compiler->scene, cut.frame, axis));
        double sign = outside ? -1 : 1;
        cut_across(&cut, axis, sign * along, sign * planes[i].offset);
    }
    return cut_finish(compiler, &cut);
}

/* Makes one box of what two boxes of one frame have in common. Returns COMPILED_NONE where the two
 * are no such boxes or have nothing in common. */
static uint32_t fuse_boxes(struct compiler *compiler, uint32_t a, uint32_t b) {
    const struct compiled_scene *scene = compiler->scene;
    const struct compiled_primitive *one = &scene->primitives[a], *other = &scene->primitives[b];
    double low[3], high[3];
    if (one->kind != PRIMITIVE_BOX || other->kind != PRIMITIVE_BOX || one->frame != other->frame) {
        return COMPILED_NONE;
    }
    for (int i = 0; i < 3; i++) {
        const struct compiled_box *first = &scene->boxes[one->index];
        const struct compiled_box *second = &scene->boxes[other->index];
        low[i] = fmax(first->minimum[i], second->minimum[i]);
        high[i] = fmin(first->maximum[i], second->maximum[i]);
        if (high[i] - low[i] < COMPILE_STRICTLY) {
            return COMPILED_NONE;
        }
    }
    compiler->line = one->line;
    return compile_box_in(compiler, one->frame, low, high);
}

/* Tells whether a primitive may be changed: a ball only if the ball is used nowhere else. A ball
 * that becomes a quadric must not stay a ball elsewhere, for the two would round differently. */
static bool may_change(const struct optimiser *optimiser, uint32_t primitive) {
    return optimiser->compiler->scene->primitives[primitive].kind != PRIMITIVE_BALL ||
           optimiser->uses[primitive] == 1;
}

/* Cuts a part of a tree by a primitive, or by what is outside of the primitive. Returns false if
 * none of the part's own primitives can take in the cut. */
static bool absorb(struct optimiser *optimiser, uint32_t index, uint32_t solid, bool outside) {
    struct csg_tree *tree = &optimiser->tree;
    struct csg_node *node = &tree->nodes[index];
    if (!csg_is_leaf(tree, index)) {
        return node->code != COMPILED_UNION && (absorb(optimiser, node->left, solid, outside) ||
                                                (node->code == COMPILED_INTERSECTION &&
                                                 absorb(optimiser, node->right, solid, outside)));
    }
    uint32_t fused = outside ? COMPILED_NONE : fuse_boxes(optimiser->compiler, node->code, solid);
    if (fused == COMPILED_NONE && may_change(optimiser, node->code)) {
        fused = fuse_quadric(optimiser->compiler, node->code, solid, outside);
    }
    if (fused == COMPILED_NONE) {
        return false;
    }
    node->code = fused;
    optimiser->compiler->scene->report.fused++;
    return true;
}

/* Replaces a node by one of its two sides where that side can take in the other. */
static void fuse_node(struct optimiser *optimiser, uint32_t index) {
    struct csg_tree *tree = &optimiser->tree;
    struct csg_node *node = &tree->nodes[index];
    if (csg_is_leaf(tree, index)) {
        return;
    }
    fuse_node(optimiser, node->left);
    fuse_node(optimiser, node->right);
    if (node->code == COMPILED_UNION) {
        return;
    }
    bool outside = node->code == COMPILED_DIFFERENCE;
    if (csg_is_leaf(tree, node->right) &&
        absorb(optimiser, node->left, tree->nodes[node->right].code, outside)) {
        *node = tree->nodes[node->left];
    } else if (!outside && csg_is_leaf(tree, node->left) &&
               absorb(optimiser, node->right, tree->nodes[node->left].code, false)) {
        *node = tree->nodes[node->right];
    }
}

void optimise_fuse(struct optimiser *optimiser) {
    fuse_node(optimiser, optimiser->tree.root);
}
