/* SPDX-License-Identifier: MIT */
/* A ray that knows where it is, and the next boundary of a medium on its path. */
#ifndef SUPERFRAME_RAY_H
#define SUPERFRAME_RAY_H

#include "image.h"
#include "scene.h"

/* The state that a ray carries from one boundary to the next. The set of primitives that the ray is
 * inside of decides where it may enter and leave. The sign of a distance does not decide, for
 * rounding has touched distances. */
struct ray {
    struct point origin;
    struct direction direction;
    struct primitive_set inside;
    surface_number surface; /* that it starts on, or SURFACE_NONE */
    entry_number object;    /* that it runs in */
};

/* A boundary between two materials. */
struct hit {
    real_length t;
    struct point where;
    struct direction normal; /* turned towards the arriving ray */
    surface_number surface;
    entry_number primitive;
    uint8_t face;
    entry_number before, after; /* objects on the near and the far side */
    bool leaving;               /* the primitive is left, not entered */
    struct primitive_set inside_before, inside_after;
};

/* Finds the nearest boundary between different materials; false if the ray leaves the scene. Then
 * hit->before is the object that the ray ends in, OBJECT_AIR unless something is wrong. */
bool ray_hit(const struct scene *scene, const struct ray *ray, struct hit *hit,
             struct render_counts *counts);

/* Tells whether something within `distance` of a ray's origin keeps light off (Eq. (1), A). */
bool ray_is_shadowed(const struct scene *scene, const struct ray *ray, real_length distance,
                     struct render_counts *counts);

#endif
