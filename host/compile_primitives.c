/* SPDX-License-Identifier: MIT */
/* The scene compiler: leaves to primitives, and faces that coincide to one surface. */
#include "compile_internal.h"

#include <math.h>
#include <string.h>

int compile_new_surface(struct compiler *compiler) {
    struct compiled_scene *scene = compiler->scene;
    if (scene->surface_count == COMPILED_SURFACES_MOST) {
        compile_fail(compiler, compiler->line, "more than %d different surfaces",
                     COMPILED_SURFACES_MOST);
        return -1;
    }
    return scene->surface_count++;
}

bool compile_same(double a, double b) {
    return fabs(a - b) <= COMPILE_SAME;
}

bool compile_same_point(const double a[3], const double b[3]) {
    return compile_same(a[0], b[0]) && compile_same(a[1], b[1]) && compile_same(a[2], b[2]);
}

int compile_plane_surface(struct compiler *compiler, const double normal[3], double offset) {
    struct compile_plane plane = {{normal[0], normal[1], normal[2]}, offset};
    int first = fabs(normal[0]) > COMPILE_SAME ? 0 : fabs(normal[1]) > COMPILE_SAME ? 1 : 2;
    if (normal[first] < 0) {
        for (int i = 0; i < 3; i++) {
            plane.normal[i] = -plane.normal[i];
        }
        plane.offset = -plane.offset;
    }
    for (int i = 0; i < compiler->scene->surface_count; i++) {
        if (compile_same_point(plane.normal, compiler->planes[i].normal) &&
            compile_same(plane.offset, compiler->planes[i].offset)) {
            return i;
        }
    }
    int surface = compile_new_surface(compiler);
    if (surface >= 0) {
        compiler->planes[surface] = plane;
    }
    return surface;
}

double compile_place_of_plane(const struct compiler *compiler, int surface, const double axis[3]) {
    const struct compile_plane *plane = &compiler->planes[surface];
    return vector_dot(axis, plane->normal) < 0 ? -plane->offset : plane->offset;
}

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

int compile_frame(struct compiler *compiler, double axis[3][3]) {
    struct compiled_scene *scene = compiler->scene;
    int i = 0;
    for (; i < scene->frame_count; i++) {
        const struct compiled_frame *frame = &scene->frames[i];
        if (compile_same_point(axis[0], frame->axis[0]) &&
            compile_same_point(axis[1], frame->axis[1]) &&
            compile_same_point(axis[2], frame->axis[2])) {
            return i;
        }
    }
    if (i == COMPILED_FRAMES_MOST) {
        compile_fail(compiler, compiler->line, "more than %d different places and rotations",
                     COMPILED_FRAMES_MOST);
        return -1;
    }
    memset(scene->frames[i].origin, 0, sizeof scene->frames[i].origin);
    memcpy(scene->frames[i].axis, axis, sizeof scene->frames[i].axis);
    scene->frame_count++;
    return i;
}

/* A box turned by quarter turns is a box of the world. */
bool compile_straighten(double axis[3][3], int permutation[3], double sign[3]) {
    double sorted[3][3];
    bool straight = true;
    for (int i = 0; i < 3; i++) {
        permutation[i] = i;
        sign[i] = 1;
    }
    for (int world = 0; world < 3 && straight; world++) {
        straight = false;
        for (int i = 0; i < 3; i++) {
            if (compile_same(fabs(axis[i][world]), 1)) {
                permutation[world] = i;
                sign[world] = axis[i][world] < 0 ? -1 : 1;
                straight = true;
            }
        }
        memcpy(sorted[world], affine_identity.m[world], sizeof sorted[world]);
    }
    if (straight) {
        memcpy(axis, sorted, sizeof sorted);
    } else {
        for (int i = 0; i < 3; i++) {
            permutation[i] = i;
            sign[i] = 1;
        }
    }
    return straight;
}

/* The axes of a placement whose axes stay at right angles, and how it stretches each; false if it
 * skews. */
static bool right_angled(const struct affine *placement, double axis[3][3], double stretch[3]) {
    for (int i = 0; i < 3; i++) {
        affine_axis(placement, i, axis[i]);
        stretch[i] = vector_length(axis[i]);
        vector_normalise(axis[i]);
    }
    return fabs(vector_dot(axis[0], axis[1])) < COMPILE_SAME &&
           fabs(vector_dot(axis[1], axis[2])) < COMPILE_SAME &&
           fabs(vector_dot(axis[2], axis[0])) < COMPILE_SAME;
}

/* Adds a box given in the frame's coordinates, or finds it again. */
static int add_box(struct compiler *compiler, int frame, double axis[3][3], const double low[3],
                   const double high[3]) {
    struct compiled_scene *scene = compiler->scene;
    for (int i = 0; i < scene->primitive_count; i++) {
        const struct compiled_primitive *other = &scene->primitives[i];
        if (other->kind == KIND_BOX && other->frame == frame &&
            compile_same_point(low, scene->boxes[other->index].minimum) &&
            compile_same_point(high, scene->boxes[other->index].maximum)) {
            return i;
        }
    }
    int primitive =
        compile_new_primitive(compiler, KIND_BOX, scene->box_count, (uint8_t)frame, false);
    if (primitive < 0) {
        return -1;
    }
    struct compiled_box *box = &scene->boxes[scene->box_count++];
    for (int face = 0; face < 6; face++) {
        double offset = face < 3 ? low[face] : high[face - 3];
        int surface = compile_plane_surface(compiler, axis[face % 3], offset);
        if (surface < 0) {
            return -1;
        }
        /* Faces of one surface lie at the same place to the last bit. */
        double place = compile_place_of_plane(compiler, surface, axis[face % 3]);
        *(face < 3 ? &box->minimum[face] : &box->maximum[face - 3]) = place;
        box->surface[face] = (uint16_t)surface;
    }
    return primitive;
}

int compile_box_in(struct compiler *compiler, uint8_t frame, const double low[3],
                   const double high[3]) {
    double axis[3][3];
    for (int i = 0; i < 3; i++) {
        memcpy(axis[i], compiled_axis(compiler->scene, frame, i), sizeof axis[i]);
    }
    return add_box(compiler, frame, axis, low, high);
}

int compile_world_box(struct compiler *compiler, const double low[3], const double high[3]) {
    return compile_box_in(compiler, WORLD_FRAME, low, high);
}

/* A box whose axes the placement skews. */
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

int compile_box(struct compiler *compiler, const struct solid_node *leaf,
                const struct affine *placement) {
    static const double origin[3] = {0, 0, 0};
    double axis[3][3], stretch[3], centre[3], sign[3], low[3], high[3];
    int permutation[3];
    if (!right_angled(placement, axis, stretch)) {
        return skewed_box(compiler, leaf, placement);
    }
    affine_point(placement, origin, centre);
    bool straight = compile_straighten(axis, permutation, sign);
    for (int i = 0; i < 3; i++) {
        int from = permutation[i];
        double middle = vector_dot(centre, axis[i]);
        double a = middle + sign[i] * stretch[from] * leaf->a[from];
        double b = middle + sign[i] * stretch[from] * leaf->b[from];
        low[i] = fmin(a, b);
        high[i] = fmax(a, b);
    }
    int frame = straight ? WORLD_FRAME : compile_frame(compiler, axis);
    return frame < 0 ? -1 : add_box(compiler, frame, axis, low, high);
}

/* A placed leaf that is round about an axis: the quadric, then the slab that ends it. */
static bool append_round(struct compiler *compiler, const struct solid_node *leaf,
                         const struct affine *placement) {
    struct scene_plane ends[2];
    double u[3], v[3];
    int round = compile_quadric(compiler, leaf, placement);
    double length = leaf_axes(leaf, u, v, ends[0].normal);
    for (int i = 0; i < 3; i++) {
        ends[1].normal[i] = -ends[0].normal[i];
    }
    ends[0].offset = vector_dot(ends[0].normal, leaf->a) + length;
    ends[1].offset = -vector_dot(ends[0].normal, leaf->a);
    int slab = round < 0 ? -1 : compile_polyhedron(compiler, ends, 2, placement);
    return slab >= 0 && compile_append(compiler, (uint8_t)round) &&
           compile_append(compiler, (uint8_t)slab) && compile_append(compiler, CODE_INTERSECTION);
}

/* A polyhedron has to have an inside and an end. */
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
    default:
        if (leaf->kind != SOLID_BALL && leaf->kind != SOLID_ELLIPSOID &&
            leaf->kind != SOLID_QUADRIC) {
            return append_round(compiler, leaf, placement);
        }
        primitive = compile_quadric(compiler, leaf, placement);
    }
    return primitive >= 0 && compile_append(compiler, (uint8_t)primitive);
}
