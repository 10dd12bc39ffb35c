/* SPDX-License-Identifier: MIT */
/* The scene compiler: leaves to primitives, and faces that coincide to one surface. */
#include "compile_internal.h"

#include <math.h>
#include <string.h>

/* Same numbers as firmware/scene.h, which needs an arithmetic. */
enum { KIND_BOX, KIND_BALL };
enum { WORLD_FRAME = 0xFF };

int compile_new_surface(struct compiler *compiler) {
    struct compiled_scene *scene = compiler->scene;
    if (scene->surface_count == COMPILED_SURFACES_MOST) {
        compile_fail(compiler, compiler->line, "more than %d different surfaces",
                     COMPILED_SURFACES_MOST);
        return -1;
    }
    return scene->surface_count++;
}

static bool same(double a, double b) {
    return fabs(a - b) <= COMPILE_SAME;
}

static bool same_point(const double a[3], const double b[3]) {
    return same(a[0], b[0]) && same(a[1], b[1]) && same(a[2], b[2]);
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
        if (same_point(plane.normal, compiler->planes[i].normal) &&
            same(plane.offset, compiler->planes[i].offset)) {
            return i;
        }
    }
    int surface = compile_new_surface(compiler);
    if (surface >= 0) {
        compiler->planes[surface] = plane;
    }
    return surface;
}

static void bound_by(struct compiled_scene *scene, int surface, int primitive) {
    scene->surfaces[surface].word[primitive / 32] |= (uint32_t)1 << primitive % 32;
}

static int new_primitive(struct compiler *compiler, uint8_t kind, uint8_t index, uint8_t frame) {
    struct compiled_scene *scene = compiler->scene;
    if (scene->primitive_count == COMPILED_PRIMITIVES_MOST) {
        compile_fail(compiler, compiler->line, "more than %d different solids",
                     COMPILED_PRIMITIVES_MOST);
        return -1;
    }
    struct compiled_primitive *primitive = &scene->primitives[scene->primitive_count];
    primitive->kind = kind;
    primitive->index = index;
    primitive->frame = frame;
    primitive->line = compiler->line;
    return scene->primitive_count++;
}

/* The frame with these axes through the scaled world's origin; the world's own if they are its. */
static int frame_of(struct compiler *compiler, double axis[3][3]) {
    struct compiled_scene *scene = compiler->scene;
    if (same_point(axis[0], affine_identity.m[0]) && same_point(axis[1], affine_identity.m[1]) &&
        same_point(axis[2], affine_identity.m[2])) {
        return WORLD_FRAME;
    }
    int i = 0;
    for (; i < scene->frame_count; i++) {
        const struct compiled_frame *frame = &scene->frames[i];
        if (same_point(axis[0], frame->axis[0]) && same_point(axis[1], frame->axis[1]) &&
            same_point(axis[2], frame->axis[2])) {
            return i;
        }
    }
    if (i == COMPILED_FRAMES_MOST) {
        compile_fail(compiler, compiler->line, "more than %d different rotations",
                     COMPILED_FRAMES_MOST);
        return -1;
    }
    memcpy(scene->frames[i].axis, axis, sizeof scene->frames[i].axis);
    scene->frame_count++;
    return i;
}

/* Sorts axes that are the world's, up to order and sign, into the world's order: a box turned by
 * quarter turns is a box of the world. permutation[i] is the axis that became axis i. */
static void straighten(double axis[3][3], int permutation[3], double sign[3]) {
    double sorted[3][3];
    bool straight = true;
    for (int i = 0; i < 3; i++) {
        permutation[i] = i;
        sign[i] = 1;
    }
    for (int world = 0; world < 3 && straight; world++) {
        straight = false;
        for (int i = 0; i < 3; i++) {
            if (same(fabs(axis[i][world]), 1)) {
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
            same_point(low, scene->boxes[other->index].minimum) &&
            same_point(high, scene->boxes[other->index].maximum)) {
            return i;
        }
    }
    int primitive = new_primitive(compiler, KIND_BOX, scene->box_count, (uint8_t)frame);
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
        const struct compile_plane *plane = &compiler->planes[surface];
        double place =
            vector_dot(axis[face % 3], plane->normal) < 0 ? -plane->offset : plane->offset;
        *(face < 3 ? &box->minimum[face] : &box->maximum[face - 3]) = place;
        box->surface[face] = (uint16_t)surface;
        bound_by(scene, surface, primitive);
    }
    return primitive;
}

static int box_primitive(struct compiler *compiler, const struct solid_node *leaf,
                         const struct affine *placement) {
    double axis[3][3], stretch[3], centre[3], sign[3], low[3], high[3];
    int permutation[3];
    if (!right_angled(placement, axis, stretch)) {
        compile_fail(compiler, leaf->line, "a box that is skewed by its scale and rotate keys");
        return -1;
    }
    affine_point(placement, (double[3]){0, 0, 0}, centre);
    straighten(axis, permutation, sign);
    for (int i = 0; i < 3; i++) {
        int from = permutation[i];
        double middle = vector_dot(centre, axis[i]);
        double a = middle + sign[i] * stretch[from] * leaf->a[from];
        double b = middle + sign[i] * stretch[from] * leaf->b[from];
        low[i] = fmin(a, b);
        high[i] = fmax(a, b);
    }
    int frame = frame_of(compiler, axis);
    return frame < 0 ? -1 : add_box(compiler, frame, axis, low, high);
}

/* Half a world, as a box in a frame of its own whose x axis is the plane's normal. */
static int half_space_primitive(struct compiler *compiler, const struct solid_node *leaf,
                                const struct affine *placement) {
    const struct scene_plane *plane = &leaf->planes[0];
    /* A normal goes by the inverse transpose: the cross products of the other two axes. */
    double column[3][3], normal[3] = {0, 0, 0}, on_plane[3], image[3];
    for (int i = 0; i < 3; i++) {
        affine_axis(placement, i, column[i]);
        on_plane[i] = plane->normal[i] * plane->offset;
    }
    for (int i = 0; i < 3; i++) {
        double cofactor[3];
        vector_cross(column[(i + 1) % 3], column[(i + 2) % 3], cofactor);
        for (int j = 0; j < 3; j++) {
            normal[j] += plane->normal[i] * cofactor[j];
        }
    }
    double turn[3];
    vector_cross(column[0], column[1], turn);
    if (vector_dot(turn, column[2]) < 0) {
        for (int j = 0; j < 3; j++) {
            normal[j] = -normal[j]; /* the placement mirrors */
        }
    }
    vector_normalise(normal);
    affine_point(placement, on_plane, image);
    double end = vector_dot(normal, image);
    for (int i = 0; i < 3; i++) {
        if (same(fabs(normal[i]), 1)) {
            double low[3] = {-COMPILE_WORLD, -COMPILE_WORLD, -COMPILE_WORLD};
            double high[3] = {COMPILE_WORLD, COMPILE_WORLD, COMPILE_WORLD};
            double axis[3][3];
            for (int j = 0; j < 3; j++) {
                memcpy(axis[j], affine_identity.m[j], sizeof axis[j]);
            }
            *(normal[i] > 0 ? &high[i] : &low[i]) = end * normal[i];
            return add_box(compiler, WORLD_FRAME, axis, low, high);
        }
    }
    double axis[3][3];
    memcpy(axis[0], normal, sizeof axis[0]);
    int least = fabs(normal[0]) < fabs(normal[1]) ? 0 : 1;
    vector_cross(normal, affine_identity.m[least], axis[1]);
    vector_normalise(axis[1]);
    vector_cross(axis[0], axis[1], axis[2]);
    /* Its corners must not lie farther out than the world's. */
    double reach = COMPILE_WORLD / sqrt(3);
    const double low[3] = {-COMPILE_WORLD, -reach, -reach}, high[3] = {end, reach, reach};
    int frame = frame_of(compiler, axis);
    return frame < 0 ? -1 : add_box(compiler, frame, axis, low, high);
}

static int ball_primitive(struct compiler *compiler, const struct solid_node *leaf,
                          const struct affine *placement) {
    struct compiled_scene *scene = compiler->scene;
    double axis[3][3], stretch[3], centre[3];
    if (!right_angled(placement, axis, stretch) || !same(stretch[0] / stretch[1], 1) ||
        !same(stretch[1] / stretch[2], 1)) {
        compile_fail(compiler, leaf->line, "a ball that is stretched by its scale key");
        return -1;
    }
    affine_point(placement, leaf->a, centre);
    double radius = leaf->radius * stretch[0];
    for (int i = 0; i < scene->primitive_count; i++) {
        const struct compiled_primitive *other = &scene->primitives[i];
        if (other->kind == KIND_BALL && same_point(centre, scene->balls[other->index].centre) &&
            same(radius, scene->balls[other->index].radius)) {
            return i;
        }
    }
    int primitive = new_primitive(compiler, KIND_BALL, scene->ball_count, WORLD_FRAME);
    int surface = primitive < 0 ? -1 : compile_new_surface(compiler);
    if (surface < 0) {
        return -1;
    }
    struct compiled_ball *ball = &scene->balls[scene->ball_count++];
    memcpy(ball->centre, centre, sizeof centre);
    ball->radius = radius;
    ball->surface = (uint16_t)surface;
    bound_by(scene, surface, primitive);
    return primitive;
}

int compile_primitive(struct compiler *compiler, const struct solid_node *leaf,
                      const struct affine *placement) {
    compiler->line = leaf->line;
    switch (leaf->kind) {
    case SOLID_BOX:
        return box_primitive(compiler, leaf, placement);
    case SOLID_BALL:
        return ball_primitive(compiler, leaf, placement);
    case SOLID_HALF_SPACE:
        return half_space_primitive(compiler, leaf, placement);
    default:
        compile_fail(compiler, leaf->line, "a solid that the firmware does not know yet");
        return -1;
    }
}
