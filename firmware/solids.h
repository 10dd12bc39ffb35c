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
    entry_number frame;  /* that of a ray that has been turned, or FRAME_WORLD: none is there yet */
};

/* The interval in .. out of a ray that lies inside a primitive. Where the ray misses, `hit` is
 * false and the ends are those of the nearest approach. A ray that is known to be inside leaves
 * at that approach. Ends at LENGTH_FAR are none. */
struct segment {
    real_length in, out;
    uint8_t in_face, out_face;
    bool hit;
};

/* One ray as the world sees it, and as the frames see it that were asked for last. Two frames whose
 * numbers differ in their last bit are both kept. */
enum { VIEW_WORLD, VIEWS = 1 + 2 * FEATURE_ROTATION };

/* Sets up the world's view of a ray. A frame's view is made when view_in() asks for it. */
void views_start(struct local_ray views[VIEWS], const struct point *origin,
                 const struct direction *direction);

/* Where a ray starts: on a surface of the primitive, or SURFACE_NONE; and whether it is inside. A
 * face on that surface lies at exactly 0, and is not where a ray that is inside leaves. */
struct start {
    surface_number surface;
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

/* One end of an interval in a box: where the end is, and on which face. */
struct box_end {
    real_length t;
    uint8_t face;
};

/* Returns the interval of a ray inside a ball. The discriminant is r^2 - |foot|^2, where foot is
 * the point of the ray nearest to the centre. So nothing cancels for a small ball far away. */
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

/* A quadric's form along a ray, a x^2 + 2 b x + c. x is counted from the foot, the point of the ray
 * nearest to the centre. There a, b and c are of the solid's own size. */
struct form {
    real_unit a;
    real_length b;
    real_area c;
    real_length start; /* where on the ray the foot is */
};

static inline struct form quadric_form(const struct quadric *quadric, struct point foot,
                                       struct direction d) {
    struct direction slant = {unit_product(quadric->square.x, d.x),
                              unit_product(quadric->square.y, d.y),
                              unit_product(quadric->square.z, d.z)};
    struct form form;
    real_area bend = area_product(foot.z, quadric->linear);
    form.start = REAL_LENGTH(0.0);
    form.a = direction_dot(slant, d);
    form.b = length_add(point_dot(foot, slant), length_scaled(quadric->linear, d.z));
    form.c = area_add(area_product(foot.x, length_scaled(foot.x, quadric->square.x)),
                      area_product(foot.y, length_scaled(foot.y, quadric->square.y)));
    form.c = area_add(form.c, area_product(foot.z, length_scaled(foot.z, quadric->square.z)));
    form.c = area_add(area_add(form.c, quadric->constant), area_add(bend, bend));
    return form;
}

static inline real_length length_magnitude(real_length a) {
    return length_less(a, REAL_LENGTH(0.0)) ? length_negate(a) : a;
}

/* Turns a point, or a difference of two, into a frame that has the scene's own origin. */
static inline struct point turn_point(const struct frame *frame, struct point p) {
    struct point turned = {point_dot(p, frame->axis[0]), point_dot(p, frame->axis[1]),
                           point_dot(p, frame->axis[2])};
    return turned;
}

/* Tells whether the solid behind a plane is the upper one of two that share the plane. The upper
 * solid has what lies exactly in the plane. */
static inline bool plane_is_upper(const struct plane *plane) {
    const struct direction *normal = &plane->normal;
    return unit_is_negative(!unit_is_zero(normal->x)   ? normal->x
                            : !unit_is_zero(normal->y) ? normal->y
                                                       : normal->z);
}

/* Returns half of the form's gradient at a point of a quadric. The point is counted from the
 * quadric's centre, in the quadric's frame. */
static inline struct point quadric_steepness(const struct quadric *quadric, struct point q) {
    struct point steepness = {length_scaled(q.x, quadric->square.x),
                              length_scaled(q.y, quadric->square.y),
                              length_add(length_scaled(q.z, quadric->square.z), quadric->linear)};
    return steepness;
}

/* Returns the direction of the form's gradient; (0, 0, 0) at the tip of a cone. */
static inline struct direction quadric_gradient(const struct quadric *quadric, struct point q) {
    struct point steepness = quadric_steepness(quadric, q);
    struct direction u;
    real_length length;
    unit_normalise_lengths(steepness.x, steepness.y, steepness.z, &u.x, &u.y, &u.z, &length);
    return u;
}

/* Returns a direction in a frame as the world sees it. */
static inline struct direction turn_back(const struct frame *frame, struct direction u) {
    const struct direction *axis = frame->axis;
    struct direction turned = {unit_dot(u.x, u.y, u.z, axis[0].x, axis[1].x, axis[2].x),
                               unit_dot(u.x, u.y, u.z, axis[0].y, axis[1].y, axis[2].y),
                               unit_dot(u.x, u.y, u.z, axis[0].z, axis[1].z, axis[2].z)};
    return turned;
}

/* Returns a ray in a primitive's frame, turned once for all primitives of that frame. */
const struct local_ray *view_in(const struct scene *scene, entry_number frame,
                                struct local_ray views[VIEWS]);

/* Finds where a ray, or what is before its start, leaves a box: at LENGTH_FAR where there is no
 * end. A ray may start on the face by which it would leave. Such a ray leaves there if it is
 * outside, and elsewhere if it is inside. */
struct box_end box_exit(const struct box *box, const struct local_ray *ray, struct start start);

/* Finds where a ray enters a box; false if the ray runs past, along two faces. A ray that leaves
 * before it enters does not meet the box. */
bool box_entry(const struct box *box, const struct local_ray *ray, surface_number surface,
               struct box_end *entry);

/* Finds the intervals of a ray inside a primitive that is no box, in order. Returns how many there
 * are: one or two. */
uint8_t primitive_segments(const struct scene *scene, const struct primitive *primitive,
                           struct local_ray views[VIEWS], struct start start,
                           struct segment segments[2]);

/* Returns the number of the surface that a face lies on. */
surface_number primitive_surface(const struct scene *scene, const struct primitive *primitive,
                                 uint8_t face);

/* Returns the outward normal at a point of a face. */
struct direction primitive_normal(const struct scene *scene, const struct primitive *primitive,
                                  uint8_t face, const struct point *where);

#endif
