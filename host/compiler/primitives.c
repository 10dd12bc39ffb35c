/* SPDX-License-Identifier: MIT */
/* The scene compiler: turns leaves into primitives. */
#include "compiler/compiler_internal.h"

#include <math.h>

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

/* Compiles a box whose axes the placement skews. */
static uint32_t skewed_box(struct compiler *compiler, const struct solid_node *leaf,
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
uint32_t compile_box(struct compiler *compiler, const struct solid_node *leaf,
                     const struct affine *placement) {
    double axis[3][3], sign[3], low[3], high[3], corner[2][3];
    int permutation[3];
    uint32_t frame;
    if (!right_angled(compiler, placement, axis)) {
        return skewed_box(compiler, leaf, placement);
    }
    if (!compile_frame(compiler, axis, false, permutation, sign, &frame)) {
        return COMPILED_NONE;
    }
    affine_point(placement, leaf->a, corner[0]);
    affine_point(placement, leaf->b, corner[1]);
    for (int i = 0; i < 3; i++) {
        const double *along = compiled_axis(compiler->scene, frame, i);
        double a = vector_dot(corner[0], along), b = vector_dot(corner[1], along);
        low[i] = fmin(a, b);
        high[i] = fmax(a, b);
    }
    return compile_box_in(compiler, frame, low, high);
}

/* Appends a placed leaf that is round about an axis: the quadric, then the slab that ends the
 * quadric. */
static bool append_round(struct compiler *compiler, const struct solid_node *leaf,
                         const struct affine *placement) {
    struct scene_plane ends[2];
    double u[3], v[3], forward[3], back[3];
    uint32_t round = compile_quadric(compiler, leaf, placement);
    leaf_axes(leaf, u, v, forward);
    for (int i = 0; i < 3; i++) {
        back[i] = -forward[i];
    }
    uint32_t slab = COMPILED_NONE;
    if (round != COMPILED_NONE &&
        compile_placed_plane(compiler, forward, leaf->b, placement, &ends[0]) &&
        compile_placed_plane(compiler, back, leaf->a, placement, &ends[1])) {
        slab = compile_placed_polyhedron(compiler, ends, 2);
    }
    return slab != COMPILED_NONE && compile_append(compiler, round) &&
           compile_append(compiler, slab) && compile_append(compiler, COMPILED_INTERSECTION);
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
    uint32_t primitive = COMPILED_NONE;
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
    return primitive != COMPILED_NONE && compile_append(compiler, primitive);
}
