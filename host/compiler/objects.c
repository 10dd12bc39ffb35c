/* SPDX-License-Identifier: MIT */
/* The scene compiler: turns CSG trees into objects of one material each, with postfix programs. */
#include "compiler/compiler_internal.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { PROGRAM_DEPTH_MOST = 32 };

/* What is to be applied to a solid after the solid itself: cutters, from the inside out. */
struct cutter {
    uint8_t code;
    int node;
    struct affine placement; /* of the node's parent, to scaled coordinates */
    const struct cutter *next;
};

/* A solid with all that its ancestors say of it. */
struct instance {
    int node;
    struct affine placement; /* of the node's parent, to scaled coordinates */
    int material;
    const struct cutter *cutters;
};

static uint8_t code_of(enum solid_kind kind) {
    return kind == SOLID_UNION          ? PROGRAM_UNION
           : kind == SOLID_INTERSECTION ? PROGRAM_INTERSECTION
                                        : PROGRAM_DIFFERENCE;
}

static bool is_leaf(const struct solid_node *node) {
    return node->kind < SOLID_UNION;
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
    for (size_t i = 0; i < node->child_count; i++) {
        if (!append_program(compiler, node->children[i], &placement, depth + (i > 0))) {
            return false;
        }
        if (i > 0 && !compile_append(compiler, code_of(node->kind))) {
            return false;
        }
    }
    return true;
}

/* Checks that an object is bounded or opaque: a transparent object whose boundary goes on for ever
 * cannot be left. The part of an unbounded solid within the world is there, and must not be
 * nothing. */
static bool check_bounded(struct compiler *compiler, const struct compiled_object *object,
                          const struct bounds *bounds) {
    if (bounds_are_finite(bounds)) {
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

static bool add_object(struct compiler *compiler, const struct instance *instance) {
    struct compiled_scene *scene = compiler->scene;
    int part = compiler->part++;
    if (part < compiler->dead->part_count && compiler->dead->part[part] != NULL) {
        scene->is_left_out[part] = true;
        return true;
    }
    if (scene->object_count == COMPILED_OBJECTS_MOST) {
        return compile_fail(compiler, compiler->line, "more than %d objects of one material each",
                            COMPILED_OBJECTS_MOST - 1);
    }
    if (part >= compiler->dead->part_count) {
        compiler->dead->part_count = part + 1;
        compiler->dead->object_of_part[part] = compiler->object;
    }
    struct compiled_object *object = &scene->objects[scene->object_count];
    unsigned instance_line = compiler->line; /* compiling its solids moves the line on */
    compiler->lost_line = 0;
    object->program = scene->program_length;
    object->length = 0;
    object->material = compiler->material_of[instance->material];
    object->part = (uint8_t)part;
    struct bounds bounds =
        solid_bounds(compiler->description, instance->node, &instance->placement);
    if (!append_program(compiler, instance->node, &instance->placement, 0)) {
        return false;
    }
    for (const struct cutter *cutter = instance->cutters; cutter; cutter = cutter->next) {
        if (!append_program(compiler, cutter->node, &cutter->placement, 1) ||
            !compile_append(compiler, cutter->code)) {
            return false;
        }
        if (cutter->code == PROGRAM_INTERSECTION) {
            struct bounds cut =
                solid_bounds(compiler->description, cutter->node, &cutter->placement);
            bounds = bounds_intersection(&bounds, &cut);
        }
    }
    compiler->object_bounds[scene->object_count] = bounds;
    object->line = instance_line;
    memcpy(object->low, bounds.low, sizeof object->low);
    memcpy(object->high, bounds.high, sizeof object->high);
    snprintf(scene->object_names[scene->object_count], sizeof scene->object_names[0], "%.31s",
             compiler->object_name);
    if (!check_bounded(compiler, object, &bounds)) {
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
    size_t count = node->child_count - 1;
    struct cutter *cutters = calloc(count + 1, sizeof *cutters);
    if (cutters == NULL) {
        return compile_fail(compiler, 0, "not enough memory to compile the scene");
    }
    for (size_t i = 0; i < count; i++) {
        cutters[i].code = code_of(node->kind);
        cutters[i].node = node->children[i + 1];
        cutters[i].placement = child.placement;
        cutters[i].next = i + 1 < count ? &cutters[i + 1] : instance->cutters;
    }
    child.node = node->children[0];
    if (count > 0) {
        child.cutters = cutters;
    }
    bool is_added = add_objects(compiler, &child);
    free(cutters);
    return is_added;
}

bool compile_objects(struct compiler *compiler) {
    const struct scene_description *description = compiler->description;
    compiler->scene->object_count = 1; /* object 0 is the air */
    strcpy(compiler->scene->object_names[0], "air");
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
