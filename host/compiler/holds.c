/* SPDX-License-Identifier: MIT */
/* What holds a point: primitives, and objects by their programs. */
#include "compiler/tables.h"

#include "compiler/affine.h"

static bool is_inside_ball(const struct compiled_ball *ball, const double point[3]) {
    const double p[3] = {point[0] - ball->centre[0], point[1] - ball->centre[1],
                         point[2] - ball->centre[2]};
    return vector_dot(p, p) < ball->radius * ball->radius;
}

static bool is_inside_box(const struct compiled_box *box, const double p[3]) {
    return p[0] > box->minimum[0] && p[0] < box->maximum[0] && p[1] > box->minimum[1] &&
           p[1] < box->maximum[1] && p[2] > box->minimum[2] && p[2] < box->maximum[2];
}

static bool is_inside_polyhedron(const struct compiled_scene *scene,
                                 const struct compiled_polyhedron *polyhedron,
                                 const double point[3]) {
    for (uint32_t i = 0; i < polyhedron->count; i++) {
        const struct compiled_plane *plane = &scene->planes[polyhedron->first + i];
        if (vector_dot(plane->normal, point) >= plane->offset) {
            return false;
        }
    }
    return true;
}

/* Tells whether a point is strictly inside a quadric. p: the point in the frame's coordinates,
 * which the box shares. q: the same from the quadric's centre. */
static bool is_inside_quadric(const struct compiled_scene *scene,
                              const struct compiled_quadric *quadric, const double p[3],
                              const double q[3]) {
    const double squares[3] = {q[0] * q[0], q[1] * q[1], q[2] * q[2]};
    const struct compiled_box *box = compiled_box_of(scene, quadric);
    for (int i = 0; i < 3; i++) {
        if ((quadric->cuts >> i & 1) != 0 && (p[i] <= box->minimum[i] || p[i] >= box->maximum[i])) {
            return false;
        }
    }
    return vector_dot(quadric->square, squares) + 2 * quadric->linear * q[2] + quadric->constant <
           0;
}

/* Turns a point into the axes of a frame; the frames of solids have no origin of their own. */
static void to_frame(const struct compiled_scene *scene, uint32_t frame, const double point[3],
                     double turned[3]) {
    const double from[3] = {point[0], point[1], point[2]};
    for (int i = 0; i < 3; i++) {
        turned[i] = frame == COMPILED_FRAME_WORLD ? from[i]
                                                  : vector_dot(from, scene->frames[frame].axis[i]);
    }
}

bool compiled_primitive_holds(const struct compiled_scene *scene, uint32_t index,
                              const double point[3]) {
    const struct compiled_primitive *primitive = &scene->primitives[index];
    const struct compiled_quadric *quadric;
    double p[3], q[3] = {0, 0, 0};
    to_frame(scene, primitive->frame, point, p);
    switch (primitive->kind) {
    case PRIMITIVE_BALL:
        return is_inside_ball(&scene->balls[primitive->index], p);
    case PRIMITIVE_POLYHEDRON:
        return is_inside_polyhedron(scene, &scene->polyhedra[primitive->index], p);
    case PRIMITIVE_QUADRIC:
        quadric = &scene->quadrics[primitive->index];
        for (int i = 0; i < 3; i++) {
            q[i] = point[i] - quadric->centre[i];
        }
        to_frame(scene, primitive->frame, q, q);
        return is_inside_quadric(scene, quadric, p, q);
    case PRIMITIVE_BOX:
        break;
    }
    return is_inside_box(&scene->boxes[primitive->index], p);
}

/* Evaluates an object's program in the host's words; the program means the same as in ray_hit(). */
bool compiled_object_holds(const struct compiled_scene *scene, uint32_t index,
                           const double point[3]) {
    const struct compiled_object *object = &scene->objects[index];
    uint32_t stack = 0;
    for (uint32_t i = 0; i < object->length; i++) {
        uint32_t code = scene->programs[object->program + i];
        uint32_t right = stack & 1, left = stack >> 1 & 1;
        if (code < COMPILED_UNION) {
            stack = stack << 1 | compiled_primitive_holds(scene, code, point);
        } else {
            uint32_t value = code == COMPILED_UNION          ? left | right
                             : code == COMPILED_INTERSECTION ? left & right
                                                             : left & ~right & 1;
            stack = (stack >> 2) << 1 | value;
        }
    }
    return (stack & 1) != 0;
}
