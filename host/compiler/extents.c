/* SPDX-License-Identifier: MIT */
/* The scene compiler: finds how far primitives reach. */
#include <math.h>

#include "compiler/compiler_internal.h"

const double *compiled_axis(const struct compiled_scene *scene, uint32_t frame, int axis) {
    return frame == COMPILED_FRAME_WORLD ? affine_identity.m[axis]
                                         : scene->frames[frame].axis[axis];
}

/* ---- Quadrics, in their own axes ------------------------------------------------------------ */

/* Returns the least of square x^2 + 2 linear x over an interval, which may be infinite. The linear
 * term counts only where square is 0. */
static double least_of(double square, double linear, double low, double high) {
    double zero = fmax(low, fmin(high, 0));
    if (square > 0) {
        return square * zero * zero;
    }
    if (square < 0) {
        return square * fmax(low * low, high * high);
    }
    return linear > 0 ? 2 * linear * low : linear < 0 ? 2 * linear * high : 0;
}

/* Narrows the interval of an axis to what the form leaves where the other axes take as little as
 * they can. */
static void tighten_axis(const struct compiled_quadric *quadric, int axis, double low[3],
                         double high[3]) {
    double left = -quadric->constant;
    double square = quadric->square[axis], linear = axis == 2 ? quadric->linear : 0;
    for (int i = 0; i < 3; i++) {
        if (i != axis) {
            left -= least_of(quadric->square[i], i == 2 ? quadric->linear : 0, low[i], high[i]);
        }
    }
    if (!isfinite(left)) {
        return;
    }
    if (square > 0) {
        double most = sqrt(fmax(0, left / square));
        low[axis] = fmax(low[axis], -most);
        high[axis] = fmin(high[axis], most);
    } else if (square == 0 && linear > 0) {
        high[axis] = fmin(high[axis], left / (2 * linear));
    } else if (square == 0 && linear < 0) {
        low[axis] = fmax(low[axis], left / (2 * linear));
    }
}

void quadric_extent(const struct compiled_scene *scene, const struct compiled_quadric *quadric,
                    const struct compiled_box *box, uint32_t frame, double low[3], double high[3]) {
    for (int i = 0; i < 3; i++) {
        double centre = vector_dot(quadric->centre, compiled_axis(scene, frame, i));
        bool cut = (quadric->cuts >> i & 1) != 0;
        low[i] = cut ? box->minimum[i] - centre : -HUGE_VAL;
        high[i] = cut ? box->maximum[i] - centre : HUGE_VAL;
    }
    for (int round = 0; round < 3; round++) {
        for (int i = 0; i < 3; i++) {
            tighten_axis(quadric, i, low, high);
        }
    }
}

/* Returns the square of the largest distance from the centre, by the interval of one axis. The two
 * axes at right angles to it take all that the form leaves them. That is the most of a parabola
 * over the interval; infinite where there is no such bound. */
static double square_reach_about(const struct compiled_quadric *quadric, int axis, double low,
                                 double high) {
    double narrow = fmin(quadric->square[(axis + 1) % 3], quadric->square[(axis + 2) % 3]);
    double linear = axis == 2 ? quadric->linear : 0;
    if (narrow <= 0 || (axis != 2 && quadric->linear != 0) || !isfinite(low) || !isfinite(high)) {
        return HUGE_VAL;
    }
    double square = 1 - quadric->square[axis] / narrow;
    double places[3] = {low, high, low}, most = 0;
    if (square < 0) {
        places[2] = fmax(low, fmin(high, linear / narrow / square));
    }
    for (int i = 0; i < 3; i++) {
        double x = places[i];
        most = fmax(most, (square * x - 2 * linear / narrow) * x - quadric->constant / narrow);
    }
    return most;
}

double quadric_ball(const struct compiled_quadric *quadric, const double low[3],
                    const double high[3]) {
    double corner = 0;
    for (int i = 0; i < 3; i++) {
        corner += fmax(low[i] * low[i], high[i] * high[i]);
    }
    double square = corner;
    for (int i = 0; i < 3; i++) {
        square = fmin(square, square_reach_about(quadric, i, low[i], high[i]));
    }
    return sqrt(square);
}

/* ---- Along a direction ---------------------------------------------------------------------- */

static double box_reach(const struct compiled_scene *scene,
                        const struct compiled_primitive *primitive, const double direction[3]) {
    const struct compiled_box *box = &scene->boxes[primitive->index];
    double reach = 0;
    for (int i = 0; i < 3; i++) {
        double along = vector_dot(direction, compiled_axis(scene, primitive->frame, i));
        reach += along * (along < 0 ? box->minimum[i] : box->maximum[i]);
    }
    return reach;
}

/* Returns the reach of a quadric; exact for an ellipsoid that nothing cuts, and along the axes of
 * any quadric. */
static double quadric_reach(const struct compiled_scene *scene,
                            const struct compiled_primitive *primitive, const double direction[3]) {
    const struct compiled_quadric *quadric = &scene->quadrics[primitive->index];
    double low[3], high[3], reach = 0, square = 0;
    quadric_extent(scene, quadric, compiled_box_of(scene, quadric), primitive->frame, low, high);
    for (int i = 0; i < 3; i++) {
        double along = vector_dot(direction, compiled_axis(scene, primitive->frame, i));
        if (along < 0 || along > 0) {
            reach += along * (along < 0 ? low[i] : high[i]);
        }
        square -= quadric->square[i] > 0 ? along * along * quadric->constant / quadric->square[i]
                                         : -HUGE_VAL;
    }
    return vector_dot(direction, quadric->centre) + fmin(reach, sqrt(square));
}

/* Returns the reach of a polyhedron; exact across its own faces, and along the axes of the
 * world. */
static double polyhedron_reach(const struct compiled_scene *scene,
                               const struct compiled_polyhedron *polyhedron,
                               const double direction[3]) {
    double reach = 0;
    for (int i = 0; i < 3; i++) {
        if (direction[i] < 0 || direction[i] > 0) {
            reach += direction[i] * (direction[i] < 0 ? polyhedron->low[i] : polyhedron->high[i]);
        }
    }
    for (uint32_t i = polyhedron->first; i < polyhedron->first + polyhedron->count; i++) {
        if (vector_parallel(direction, scene->planes[i].normal) > 0) {
            reach = fmin(reach, scene->planes[i].offset);
        }
    }
    return reach;
}

double primitive_reach(const struct compiled_scene *scene, uint32_t index,
                       const double direction[3]) {
    const struct compiled_primitive *primitive = &scene->primitives[index];
    switch (primitive->kind) {
    case PRIMITIVE_BOX:
        return box_reach(scene, primitive, direction);
    case PRIMITIVE_BALL:
        return vector_dot(direction, scene->balls[primitive->index].centre) +
               scene->balls[primitive->index].radius;
    case PRIMITIVE_QUADRIC:
        return quadric_reach(scene, primitive, direction);
    case PRIMITIVE_POLYHEDRON:
        break;
    }
    return polyhedron_reach(scene, &scene->polyhedra[primitive->index], direction);
}

struct bounds primitive_bounds(const struct compiled_scene *scene, uint32_t primitive) {
    struct bounds bounds;
    for (int i = 0; i < 3; i++) {
        double up[3] = {0, 0, 0}, down[3] = {0, 0, 0};
        up[i] = 1;
        down[i] = -1;
        bounds.low[i] = -primitive_reach(scene, primitive, down);
        bounds.high[i] = primitive_reach(scene, primitive, up);
    }
    return bounds;
}
