/* SPDX-License-Identifier: MIT */
/* Where a ray runs inside a primitive: one function a kind. */
#ifndef SUPERFRAME_SOLIDS_H
#define SUPERFRAME_SOLIDS_H

#include "feature_set.h"
#include "scene.h"

/* A ray in the coordinates of a primitive's frame. */
struct local_ray {
    struct point origin;
    struct direction direction;
    real_slope slope[3]; /* of the direction's components; that of 1 where one is zero */
    uint8_t level;       /* bit 0, 1, 2: the component along x, y, z is zero */
    uint8_t falling;     /* bit 0, 1, 2: it is negative */
    uint8_t frame;       /* that of a ray that has been turned, or FRAME_WORLD: none is there yet */
};

/* The stretch in .. out of a ray that lies inside a primitive. Where the ray misses, `hit` is false
 * and the ends are those of the nearest approach: a ray that is known to be inside leaves there.
 * Ends at LENGTH_FAR are none. */
struct segment {
    real_length in, out;
    uint8_t in_face, out_face;
    bool hit;
};

/* One ray as the world sees it, and as the frames do that were asked for last. Frames whose numbers
 * differ in their last bit are both kept. */
enum { VIEW_WORLD, VIEWS = 1 + 2 * FEATURE_ROTATION };

void views_start(struct local_ray views[VIEWS], struct point origin, struct direction direction);

/* Where a ray starts: on a surface of the primitive, or SURFACE_NONE; and whether it is inside. A
 * face on that surface lies at exactly 0, and is not where a ray that is inside leaves. */
struct start {
    uint16_t surface;
    bool inside;
};

static inline void segment_enter(struct segment *segment, real_length t, uint8_t face) {
    if (length_less(segment->in, t)) {
        segment->in = t;
        segment->in_face = face;
    }
}

static inline void segment_leave(struct segment *segment, real_length t, uint8_t face) {
    if (length_less(t, segment->out)) {
        segment->out = t;
        segment->out_face = face;
    }
}

/* One axis of a box: origin and slope of the ray, low and high face of the box. A ray that is
 * inside is asked only where it leaves. */
static inline void box_axis(const struct local_ray *ray, uint8_t axis, real_length origin,
                            real_length low, real_length high, const uint16_t *surface,
                            struct start start, struct segment *segment) {
    if (ray->level >> axis & 1) {
        segment->hit = segment->hit && !length_less(origin, low) && length_less(origin, high);
        return;
    }
    bool falling = (ray->falling >> axis & 1) != 0;
    uint8_t in_face = falling ? (uint8_t)(axis + 3) : axis;
    uint8_t out_face = falling ? axis : (uint8_t)(axis + 3);
    if (surface[out_face] != start.surface) {
        real_length ahead = length_subtract(falling ? low : high, origin);
        segment_leave(segment, length_over(ahead, ray->slope[axis]), out_face);
    } else if (!start.inside) {
        segment_leave(segment, REAL_LENGTH(0.0), out_face);
    }
    if (start.inside) {
        return;
    }
    real_length in = REAL_LENGTH(0.0);
    if (surface[in_face] != start.surface) {
        in = length_over(length_subtract(falling ? high : low, origin), ray->slope[axis]);
    }
    segment_enter(segment, in, in_face);
}

static inline struct segment box_segment(const struct box *box, const struct local_ray *ray,
                                         struct start start) {
    struct segment segment = {length_negate(LENGTH_FAR), LENGTH_FAR, 0, 0, true};
    box_axis(ray, 0, ray->origin.x, box->minimum.x, box->maximum.x, box->surface, start, &segment);
    box_axis(ray, 1, ray->origin.y, box->minimum.y, box->maximum.y, box->surface, start, &segment);
    box_axis(ray, 2, ray->origin.z, box->minimum.z, box->maximum.z, box->surface, start, &segment);
    segment.hit = segment.hit && length_less(segment.in, segment.out);
    return segment;
}

/* The discriminant as r^2 - |foot|^2, foot being the point of the ray nearest to the centre: no
 * cancellation for a small ball far away. */
static inline struct segment ball_segment(const struct ball *ball, struct point origin,
                                          struct direction direction) {
    struct point p = point_subtract(origin, ball->centre);
    real_length middle = length_negate(point_dot(p, direction));
    real_area square =
        area_subtract(ball->square_radius, point_norm(point_along(p, middle, direction)));
    real_length half = length_root(square);
    struct segment segment = {length_subtract(middle, half), length_add(middle, half), 0, 0,
                              !area_is_negative(square)};
    return segment;
}

/* The stretches of a ray inside a primitive, one or two, in order: their number. */
uint8_t primitive_segments(const struct scene *scene, const struct primitive *primitive,
                           struct local_ray views[VIEWS], struct start start,
                           struct segment segments[2]);

uint16_t primitive_surface(const struct scene *scene, const struct primitive *primitive,
                           uint8_t face);

/* The outward normal at a point of a face. */
struct direction primitive_normal(const struct scene *scene, const struct primitive *primitive,
                                  uint8_t face, struct point where);

#endif
