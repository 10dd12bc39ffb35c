/* SPDX-License-Identifier: MIT */
/* The scene compiler: turns CSG trees into objects of one material each, with postfix programs. */
#include "compiler/compiler_internal.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/grow.h"

enum {
    PROGRAM_DEPTH_MOST = 32,
    CHAIN_MOST = 64 /* children that are taken one after the other; more are halved first */
};

/* What is to be applied to a solid after the solid itself. That is all but the first child of a
 * difference or an intersection. Cutters come from the inside out. */
struct cutter {
    const struct solid_node *node;
    struct affine placement; /* of the node, to scaled coordinates */
    const struct cutter *next;
};

/* A solid with all that its ancestors say of it. */
struct instance {
    int node;
    struct affine placement; /* of the node's parent, to scaled coordinates */
    int material;
    const struct cutter *cutters;
};

static uint32_t code_of(enum solid_kind kind) {
    return kind == SOLID_UNION          ? COMPILED_UNION
           : kind == SOLID_INTERSECTION ? COMPILED_INTERSECTION
                                        : COMPILED_DIFFERENCE;
}

static bool is_leaf(const struct solid_node *node) {
    return node->kind < SOLID_UNION;
}

/* Some children of a node, in a row. */
struct children {
    const struct solid_node *node;
    size_t first, count;
};

static bool append_program(struct compiler *compiler, int index, const struct affine *outer,
                           int depth);

/* Appends what an operation makes of some children of a node. The program of many children is a
 * tree of halves: neither the evaluation nor what reads the program goes deep. */
static bool append_children(struct compiler *compiler, const struct children *children,
                            uint32_t code, const struct affine *placement, int depth) {
    struct children half = *children;
    if (children->count > CHAIN_MOST) {
        half.count = children->count / 2;
        if (!append_children(compiler, &half, code, placement, depth)) {
            return false;
        }
        half.first += half.count;
        half.count = children->count - half.count;
        return append_children(compiler, &half, code, placement, depth + 1) &&
               compile_append(compiler, code);
    }
    for (size_t i = 0; i < children->count; i++) {
        int child = children->node->children[children->first + i];
        if (!append_program(compiler, child, placement, depth + (i > 0)) ||
            (i > 0 && !compile_append(compiler, code))) {
            return false;
        }
    }
    return true;
}

/* Appends what cuts the solid whose program is there already: all but the first child of a
 * difference or an intersection. Many cut as one. */
static bool append_cuts(struct compiler *compiler, const struct solid_node *node,
                        const struct affine *placement, int depth) {
    const struct children all = {node, 1, node->child_count - 1};
    const uint32_t code = code_of(node->kind);
    if (all.count > CHAIN_MOST) {
        uint32_t joined = code == COMPILED_DIFFERENCE ? COMPILED_UNION : code;
        return append_children(compiler, &all, joined, placement, depth + 1) &&
               compile_append(compiler, code);
    }
    for (size_t i = 0; i < all.count; i++) {
        if (!append_program(compiler, node->children[i + 1], placement, depth + 1) ||
            !compile_append(compiler, code)) {
            return false;
        }
    }
    return true;
}

/* Appends a node's postfix program. `depth` is how much of the evaluation's stack is in use. */
static bool append_program(struct compiler *compiler, int index, const struct affine *outer,
                           int depth) {
    const struct solid_node *node = &compiler->description->nodes[index];
    struct affine placement = affine_compose(outer, &node->placement);
    if (is_leaf(node)) {
        if (depth + 2 > PROGRAM_DEPTH_MOST) { /* a leaf may take two places */
            return compile_fail(compiler, node->line,
                                "solids nested deeper than %d levels: build the parts flatter",
                                PROGRAM_DEPTH_MOST);
        }
        return compile_leaf(compiler, node, &placement);
    }
    if (node->kind == SOLID_UNION) {
        const struct children all = {node, 0, node->child_count};
        return append_children(compiler, &all, COMPILED_UNION, &placement, depth);
    }
    return append_program(compiler, node->children[0], &placement, depth) &&
           append_cuts(compiler, node, &placement, depth);
}

/* Checks that an object is bounded or opaque: a transparent object whose boundary goes on for ever
 * cannot be left. The part of an unbounded solid within the world is there, and must not be
 * nothing. */
static bool check_bounded(struct compiler *compiler, const struct compiled_object *object) {
    if (bounds_are_finite(&object->bounds)) {
        return true;
    }
    if (compiler->scene->materials[object->material].transparent) {
        return compile_fail(compiler, object->line,
                            "a transparent object without an end: intersect it with a bounded "
                            "solid, or give it an opaque material");
    }
    if (compiler->lost_line != 0) {
        return compile_fail(
            compiler, compiler->lost_line,
            "a half_space or quadric out of the scene, which ends %g units from the middle of "
            "its bounded solids, eye and lights: move it nearer, or add a "
            "bounded solid that is as far away",
            ldexp(COMPILE_WORLD, -compiler->scene->exponent));
    }
    return true;
}

/* Numbers the part at work, and finds whether it is left out; false if memory is out. */
static bool add_part(struct compiler *compiler, uint32_t *part) {
    struct compiled_scene *scene = compiler->scene;
    struct compile_dead *dead = compiler->dead;
    *part = scene->part_count;
    if (!GROW(scene->is_left_out, *part)) {
        return false;
    }
    if (*part == dead->part_count) {
        if (!GROW(dead->part, *part) || !GROW(dead->object_of_part, *part)) {
            return false;
        }
        dead->object_of_part[*part] = compiler->object;
        dead->part_count++;
    }
    scene->is_left_out[*part] = dead->part[*part] != NULL;
    scene->part_count++;
    return true;
}

/* Narrows the bounds of a solid to what a cutter leaves of them. */
static void cut_bounds(const struct scene_description *description, const struct cutter *cutter,
                       struct bounds *bounds) {
    for (size_t i = 1; i < cutter->node->child_count && cutter->node->kind == SOLID_INTERSECTION;
         i++) {
        struct bounds cut =
            solid_bounds(description, cutter->node->children[i], &cutter->placement);
        *bounds = bounds_intersection(bounds, &cut);
    }
}

static bool add_object(struct compiler *compiler, const struct instance *instance) {
    struct compiled_scene *scene = compiler->scene;
    uint32_t part;
    if (!add_part(compiler, &part)) {
        return compile_fail_memory(compiler);
    }
    if (scene->is_left_out[part]) {
        return true;
    }
    if (!GROW(scene->objects, scene->object_count) ||
        !GROW(scene->object_names, scene->object_count)) {
        return compile_fail_memory(compiler);
    }
    struct compiled_object *object = &scene->objects[scene->object_count];
    unsigned instance_line = compiler->line; /* compiling its solids moves the line on */
    compiler->lost_line = 0;
    object->program = scene->program_length;
    object->material = compiler->material_of[instance->material];
    object->part = part;
    object->bounds = solid_bounds(compiler->description, instance->node, &instance->placement);
    if (!append_program(compiler, instance->node, &instance->placement, 0)) {
        return false;
    }
    for (const struct cutter *cutter = instance->cutters; cutter; cutter = cutter->next) {
        if (!append_cuts(compiler, cutter->node, &cutter->placement, 0)) {
            return false;
        }
        cut_bounds(compiler->description, cutter, &object->bounds);
    }
    object->line = instance_line;
    snprintf(scene->object_names[scene->object_count], sizeof scene->object_names[0], "%.31s",
             compiler->object_name);
    if (!check_bounded(compiler, object)) {
        return false;
    }
    scene->object_count++;
    return true;
}

/* Returns the one material of a tree's leaves that add to the tree, or -2 if there are several. The
 * cutters of a difference or an intersection give shape only. */
static int sole_material(const struct scene_description *description, int index, int inherited) {
    const struct solid_node *node = &description->nodes[index];
    int material = node->material >= 0 ? node->material : inherited;
    if (is_leaf(node)) {
        return material;
    }
    int sole = sole_material(description, node->children[0], material);
    for (size_t i = 1; i < node->child_count && node->kind == SOLID_UNION; i++) {
        if (sole_material(description, node->children[i], material) != sole) {
            return -2;
        }
    }
    return sole;
}

/* Adds one object for each material: unions of several materials fall apart, and what cuts the
 * whole cuts each part. */
static bool add_objects(struct compiler *compiler, const struct instance *instance) {
    const struct scene_description *description = compiler->description;
    const struct solid_node *node = &description->nodes[instance->node];
    int material = node->material >= 0 ? node->material : instance->material;
    int sole = sole_material(description, instance->node, instance->material);
    if (sole != -2) {
        struct instance single = *instance;
        single.material = sole;
        return add_object(compiler, &single);
    }
    struct instance child = {0, affine_compose(&instance->placement, &node->placement), material,
                             instance->cutters};
    if (node->kind == SOLID_UNION || node->kind == SOLID_PART) {
        for (size_t i = 0; i < node->child_count; i++) {
            child.node = node->children[i];
            if (!add_objects(compiler, &child)) {
                return false;
            }
        }
        return true;
    }
    const struct cutter cutter = {node, child.placement, instance->cutters};
    child.node = node->children[0];
    child.cutters = &cutter;
    return add_objects(compiler, &child);
}

bool compile_objects(struct compiler *compiler) {
    const struct scene_description *description = compiler->description;
    struct compiled_scene *scene = compiler->scene;
    if (!GROW(scene->objects, 0) || !GROW(scene->object_names, 0)) {
        return compile_fail_memory(compiler);
    }
    scene->object_count = 1; /* object 0 is the air */
    strcpy(scene->object_names[0], "air");
    for (size_t i = 0; i < description->object_count; i++) {
        const struct scene_object *object = &description->objects[i];
        const struct instance whole = {object->solid, compiler->scaling, -1, NULL};
        compiler->line = object->line;
        compiler->object_name = object->name ? object->name : "";
        compiler->object = i;
        if (!add_objects(compiler, &whole)) {
            return false;
        }
    }
    return true;
}
