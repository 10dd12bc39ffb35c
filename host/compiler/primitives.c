/* SPDX-License-Identifier: MIT */
/* The scene compiler: turns leaves into primitives. */
#include "compiler/compiler_internal.h"

#include <math.h>
#include <string.h>

int compile_new_primitive(struct compiler *compiler, uint8_t kind, uint8_t index, uint8_t frame,
                          bool left_for_good) {
    struct compiled_scene *scene = compiler->scene;
    if (scene->primitive_count == COMPILED_DRAFTS_MOST ||
        scene->box_count == COMPILED_DRAFTS_MOST) {
        compile_fail(compiler, compiler->line, "more than %d different solids",
                     COMPILED_PRIMITIVES_MOST);
        return -1;
    }
    struct compiled_primitive *primitive = &scene->primitives[scene->primitive_count];
    primitive->kind = kind;
    primitive->index = index;
    primitive->frame = frame;
    primitive->left_for_good = left_for_good;
    primitive->line = compiler->line;
    return scene->primitive_count++;
}

/* Finds the axes of a placement, made of length 1, and tells whether the axes stay at right
 * angles. */
static bool right_angled(const struct compiler *compiler, const struct affine *placement,
                         double axis[3][3]) {
    for (int i = 0; i < 3; i++) {
        affine_axis(placement, i, axis[i]);
        vector_normalise(axis[i]);
    }
    double skew =
        fmax(fabs(vector_dot(axis[0], axis[1])),
             fmax(fabs(vector_dot(axis[1], axis[2])), fabs(vector_dot(axis[2], axis[0]))));
    return skew * COMPILE_EXTENT <= compiler->same;
}

/* Sets the faces of a box: faces of one surface lie at the same place to the last bit. Returns
 * false with the failure recorded. */
static bool set_faces(struct compiler *compiler, struct compiled_box *box, uint8_t frame,
                      const double low[3], const double high[3]) {
    for (int face = 0; face < 6; face++) {
        const double *axis = compiled_axis(compiler->scene, frame, face % 3);
        int surface = compile_plane_surface(compiler, axis, face < 3 ? low[face] : high[face - 3]);
        if (surface < 0) {
            return false;
        }
        double place = compile_place_of_plane(compiler, surface, axis);
        *(face < 3 ? &box->minimum[face] : &box->maximum[face - 3]) = place;
        box->surface[face] = (uint16_t)surface;
    }
    return true;
}

int compile_box_in(struct compiler *compiler, uint8_t frame, const double low[3],
                   const double high[3]) {
    struct compiled_scene *scene = compiler->scene;
    struct compiled_box box = {{0}, {0}, {0}};
    if (!set_faces(compiler, &box, frame, low, high)) {
        return -1;
    }
    for (int i = 0; i < 3; i++) {
        if (box.surface[i] == box.surface[i + 3]) {
            return compile_fail_thin(compiler);
        }
    }
    for (int i = 0; i < scene->primitive_count; i++) {
        const struct compiled_primitive *other = &scene->primitives[i];
        if (other->kind == KIND_BOX && other->frame == frame &&
            memcmp(box.surface, scene->boxes[other->index].surface, sizeof box.surface) == 0) {
            return i;
        }
    }
    int primitive = compile_new_primitive(compiler, KIND_BOX, scene->box_count, frame, false);
    if (primitive >= 0) {
        scene->boxes[scene->box_count++] = box;
    }
    return primitive;
}

int compile_world_box(struct compiler *compiler, const double low[3], const double high[3]) {
    return compile_box_in(compiler, WORLD_FRAME, low, high);
}

/* Compiles a box whose axes the placement skews. */
static int skewed_box(struct compiler *compiler, const struct solid_node *leaf,
                      const struct affine *placement) {
    struct scene_plane planes[6] = {{{0, 0, 0}, 0}};
    for (int i = 0; i < 3; i++) {
        planes[i].normal[i] = -1;
        planes[i].offset = -leaf->a[i];
        planes[i + 3].normal[i] = 1;
        planes[i + 3].offset = leaf->b[i];
    }
    return compile_polyhedron(compiler, planes, 6, placement);
}

/* Compiles a box. The corners are placed as points, so that far from the origin nothing is lost
 * between them. */
int compile_box(struct compiler *compiler, const struct solid_node *leaf,
                const struct affine *placement) {
    double axis[3][3], sign[3], low[3], high[3], corner[2][3];
    int permutation[3];
    if (!right_angled(compiler, placement, axis)) {
        return skewed_box(compiler, leaf, placement);
    }
    int frame = compile_frame(compiler, axis, false, permutation, sign);
    if (frame < 0) {
        return -1;
    }
    affine_point(placement, leaf->a, corner[0]);
    affine_point(placement, leaf->b, corner[1]);
    for (int i = 0; i < 3; i++) {
        const double *along = compiled_axis(compiler->scene, (uint8_t)frame, i);
        double a = vector_dot(corner[0], along), b = vector_dot(corner[1], along);
        low[i] = fmin(a, b);
        high[i] = fmax(a, b);
    }
    return compile_box_in(compiler, (uint8_t)frame, low, high);
}

/* Appends a placed leaf that is round about an axis: the quadric, then the slab that ends the
 * quadric. */
static bool append_round(struct compiler *compiler, const struct solid_node *leaf,
                         const struct affine *placement) {
    struct scene_plane ends[2];
    double u[3], v[3], forward[3], back[3];
    int round = compile_quadric(compiler, leaf, placement);
    leaf_axes(leaf, u, v, forward);
    for (int i = 0; i < 3; i++) {
        back[i] = -forward[i];
    }
    int slab = -1;
    if (round >= 0 && compile_placed_plane(compiler, forward, leaf->b, placement, &ends[0]) &&
        compile_placed_plane(compiler, back, leaf->a, placement, &ends[1])) {
        slab = compile_placed_polyhedron(compiler, ends, 2);
    }
    return slab >= 0 && compile_append(compiler, (uint8_t)round) &&
           compile_append(compiler, (uint8_t)slab) && compile_append(compiler, CODE_INTERSECTION);
}

/* Checks that a polyhedron has an inside and an end. */
static bool check_polyhedron(struct compiler *compiler, const struct solid_node *leaf) {
    if (!polyhedron_is_bounded(leaf)) {
        return compile_fail(compiler, leaf->line,
                            "a polyhedron without an end: add the planes that close it, or "
                            "intersect half_spaces");
    }
    struct bounds bounds = polyhedron_bounds(&affine_identity, leaf);
    for (int i = 0; i < 3; i++) {
        if (!(bounds.low[i] < bounds.high[i])) {
            return compile_fail(compiler, leaf->line,
                                "an empty polyhedron: no point lies behind all of its planes; "
                                "look for a normal that points inwards");
        }
    }
    return true;
}

bool compile_leaf(struct compiler *compiler, const struct solid_node *leaf,
                  const struct affine *placement) {
    int primitive = -1;
    compiler->line = leaf->line;
    switch (leaf->kind) {
    case SOLID_BOX:
        primitive = compile_box(compiler, leaf, placement);
        break;
    case SOLID_HALF_SPACE:
        primitive = compile_half_space(compiler, leaf->planes, placement);
        break;
    case SOLID_POLYHEDRON:
        if (!check_polyhedron(compiler, leaf)) {
            return false;
        }
        primitive = compile_polyhedron(compiler, leaf->planes, leaf->plane_count, placement);
        break;
    case SOLID_BALL:
    case SOLID_ELLIPSOID:
        primitive = compile_quadric(compiler, leaf, placement);
        break;
    case SOLID_QUADRIC:
        return compile_general_quadric(compiler, leaf, placement);
    case SOLID_CYLINDER:
    case SOLID_CONE:
    case SOLID_PARABOLOID:
    case SOLID_HYPERBOLOID:
        return append_round(compiler, leaf, placement);
    case SOLID_UNION:
    case SOLID_INTERSECTION:
    case SOLID_DIFFERENCE:
    case SOLID_PART:
        break; /* no leaves */
    }
    return primitive >= 0 && compile_append(compiler, (uint8_t)primitive);
}
