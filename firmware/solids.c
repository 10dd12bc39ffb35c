/* SPDX-License-Identifier: MIT */
/* Primitives: a ray in their coordinates, their surfaces, their normals. */
#include "solids.h"

static real_slope slope_unless_zero(real_unit u) {
    return unit_is_zero(u) ? slope_of(REAL_UNIT(1.0)) : slope_of(u);
}

struct local_ray local_ray_world(struct point origin, struct direction direction) {
    struct local_ray ray = {origin,
                            direction,
                            {slope_unless_zero(direction.x), slope_unless_zero(direction.y),
                             slope_unless_zero(direction.z)}};
    return ray;
}

struct local_ray local_ray_in(const struct frame *frame, struct point origin,
                              struct direction direction) {
    struct point p = point_subtract(origin, frame->origin);
    struct point local = {point_dot(p, frame->axis[0]), point_dot(p, frame->axis[1]),
                          point_dot(p, frame->axis[2])};
    struct direction turned = {direction_dot(direction, frame->axis[0]),
                               direction_dot(direction, frame->axis[1]),
                               direction_dot(direction, frame->axis[2])};
    return local_ray_world(local, turned);
}

struct segment primitive_segment(const struct scene *scene, const struct primitive *primitive,
                                 const struct local_ray *world, uint16_t skip) {
    if (FEATURE_BALL && primitive->kind == PRIMITIVE_BALL) {
        return ball_segment(&scene->balls[primitive->index], world->origin, world->direction);
    }
    const struct box *box = &scene->boxes[primitive->index];
    if (FEATURE_ROTATION && primitive->frame != FRAME_WORLD) {
        struct local_ray local =
            local_ray_in(&scene->frames[primitive->frame], world->origin, world->direction);
        return box_segment(box, &local, skip);
    }
    return box_segment(box, world, skip);
}

uint16_t primitive_surface(const struct scene *scene, const struct primitive *primitive,
                           uint8_t face) {
    if (FEATURE_BALL && primitive->kind == PRIMITIVE_BALL) {
        return scene->balls[primitive->index].surface;
    }
    return scene->boxes[primitive->index].surface[face];
}

static struct direction box_normal(const struct scene *scene, const struct primitive *primitive,
                                   uint8_t face) {
    uint8_t axis = face < 3 ? face : (uint8_t)(face - 3);
    struct direction high;
    if (FEATURE_ROTATION && primitive->frame != FRAME_WORLD) {
        high = scene->frames[primitive->frame].axis[axis];
    } else {
        high.x = axis == 0 ? REAL_UNIT(1.0) : REAL_UNIT(0.0);
        high.y = axis == 1 ? REAL_UNIT(1.0) : REAL_UNIT(0.0);
        high.z = axis == 2 ? REAL_UNIT(1.0) : REAL_UNIT(0.0);
    }
    return face < 3 ? direction_negate(high) : high;
}

struct direction primitive_normal(const struct scene *scene, const struct primitive *primitive,
                                  uint8_t face, struct point where) {
    if (FEATURE_BALL && primitive->kind == PRIMITIVE_BALL) {
        struct point p = point_subtract(where, scene->balls[primitive->index].centre);
        struct direction normal;
        real_length radius;
        unit_normalise_lengths(p.x, p.y, p.z, &normal.x, &normal.y, &normal.z, &radius);
        return normal;
    }
    return box_normal(scene, primitive, face);
}
