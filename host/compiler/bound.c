/* SPDX-License-Identifier: MIT */
/* The scene compiler: cuts off solids that reach beyond what their objects can show. */
#include <math.h>
#include <stdlib.h>

#include "compiler/cut.h"
#include "compiler/optimise.h"

/* The bounds of what may be seen of each primitive: the union over its uses. */
struct views {
    const struct compiled_scene *scene;
    struct bounds *of;
};

/* Adds to the view of each leaf below a node. `within` bounds what the operations above the node
 * let through. */
static void look_at(struct views *views, const struct csg_tree *tree, uint32_t index,
                    const struct bounds *within) {
    const struct csg_node *node = &tree->nodes[index];
    if (csg_is_leaf(tree, index)) {
        views->of[node->code] = bounds_union(&views->of[node->code], within);
        return;
    }
    struct bounds left = *within, right = *within;
    if (node->code != COMPILED_UNION) {
        struct bounds first = csg_bounds(views->scene, tree, node->left);
        right = bounds_intersection(within, &first);
    }
    if (node->code == COMPILED_INTERSECTION) {
        struct bounds second = csg_bounds(views->scene, tree, node->right);
        left = bounds_intersection(within, &second);
    }
    look_at(views, tree, node->left, &left);
    look_at(views, tree, node->right, &right);
}

/* Returns how far bounds reach along an axis times `sign`, plus COMPILE_MARGIN. */
static double bounds_reach(const struct bounds *bounds, const double axis[3], double sign) {
    double reach = COMPILE_MARGIN;
    for (int i = 0; i < 3; i++) {
        double along = sign * axis[i];
        if (along < 0 || along > 0) {
            reach += along * (along < 0 ? bounds->low[i] : bounds->high[i]);
        }
    }
    return reach;
}

static bool bound_quadric(struct compiler *compiler, uint32_t primitive,
                          const struct bounds *view) {
    const struct compiled_scene *scene = compiler->scene;
    struct cut_quadric cut;
    bool changed = false;
    cut_start(scene, primitive, &cut);
    for (int face = 0; face < 6; face++) {
        double sign = face < 3 ? -1 : 1;
        const double *axis = compiled_axis(scene, cut.frame, face % 3);
        const double outward[3] = {sign * axis[0], sign * axis[1], sign * axis[2]};
        double end = bounds_reach(view, axis, sign);
        if (end < COMPILE_FAR && primitive_reach(scene, primitive, outward) > end) {
            cut_across(&cut, face % 3, sign, end);
            changed = true;
        }
    }
    return changed && cut_replace(compiler, &cut, primitive);
}

static bool bound_box(struct compiler *compiler, uint32_t index, const struct bounds *view) {
    struct compiled_scene *scene = compiler->scene;
    const struct compiled_primitive *primitive = &scene->primitives[index];
    struct compiled_box *box = &scene->boxes[primitive->index];
    bool changed = false;
    for (int face = 0; face < 6; face++) {
        double sign = face < 3 ? -1 : 1;
        const double *axis = compiled_axis(scene, primitive->frame, face % 3);
        double *place = face < 3 ? &box->minimum[face] : &box->maximum[face - 3];
        double end = bounds_reach(view, axis, sign);
        if (sign * *place > end) {
            uint32_t surface = compile_plane_surface(compiler, axis, sign * end);
            if (surface != COMPILED_NONE) {
                *place = compile_place_of_plane(compiler, surface, axis);
                box->surface[face] = surface;
                changed = true;
            }
        }
    }
    return changed;
}

/* Narrows a polyhedron's bounds to what a plane across an axis of the world leaves of them. */
static void cut_bounds(struct compiled_polyhedron *polyhedron, const struct compiled_plane *plane) {
    for (int i = 0; i < 3; i++) {
        if (plane->normal[i] >= 1) {
            polyhedron->high[i] = fmin(polyhedron->high[i], plane->offset);
        } else if (plane->normal[i] <= -1) {
            polyhedron->low[i] = fmax(polyhedron->low[i], -plane->offset);
        }
    }
}

/* Moves the planes that end a half-space at the world's end to where its view ends. Returns true if
 * one was moved. */
static bool bound_polyhedron(struct compiler *compiler, uint32_t index, const struct bounds *view) {
    struct compiled_scene *scene = compiler->scene;
    struct compiled_polyhedron *polyhedron = &scene->polyhedra[scene->primitives[index].index];
    bool changed = false;
    for (uint32_t i = 0; i < polyhedron->count; i++) {
        struct compiled_plane *plane = &scene->planes[polyhedron->first + i];
        double end = bounds_reach(view, plane->normal, 1);
        if (plane->offset >= COMPILE_WORLD && end < COMPILE_WORLD) {
            uint32_t surface = compile_plane_surface(compiler, plane->normal, end);
            if (surface != COMPILED_NONE) {
                plane->offset = compile_place_of_plane(compiler, surface, plane->normal);
                plane->surface = surface;
                changed = true;
                cut_bounds(polyhedron, plane);
            }
        }
    }
    return changed;
}

static bool bound_primitive(struct compiler *compiler, uint32_t primitive,
                            const struct bounds *view) {
    compiler->line = compiler->scene->primitives[primitive].line;
    switch (compiler->scene->primitives[primitive].kind) {
    case PRIMITIVE_BOX:
        return bound_box(compiler, primitive, view);
    case PRIMITIVE_QUADRIC:
        return bound_quadric(compiler, primitive, view);
    case PRIMITIVE_POLYHEDRON:
        return bound_polyhedron(compiler, primitive, view);
    case PRIMITIVE_BALL:
        break;
    }
    return false;
}

bool optimise_bound(struct optimiser *optimiser) {
    struct compiler *compiler = optimiser->compiler;
    struct compiled_scene *scene = compiler->scene;
    struct views views = {scene, malloc(((size_t)scene->primitive_count + 1) * sizeof *views.of)};
    if (views.of == NULL) {
        return compile_fail_memory(compiler);
    }
    for (uint32_t i = 0; i < scene->primitive_count; i++) {
        views.of[i] = bounds_nothing;
    }
    for (uint32_t i = 1; i < scene->object_count; i++) {
        if (!csg_read(scene, &scene->objects[i], &optimiser->tree)) {
            free(views.of);
            return compile_fail_memory(compiler);
        }
        look_at(&views, &optimiser->tree, optimiser->tree.root, &bounds_everything);
    }
    for (uint32_t i = 0; i < scene->primitive_count; i++) {
        if (!bounds_are_empty(&views.of[i]) && bound_primitive(compiler, i, &views.of[i])) {
            scene->report.bounded++;
        }
    }
    free(views.of);
    return true;
}
