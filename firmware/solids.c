/* SPDX-License-Identifier: MIT */
/* Primitives: a ray in their coordinates, their surfaces, their normals. */
#include "solids.h"

static void set_slope(struct local_ray *ray, uint8_t axis, real_unit u) {
    bool level = unit_is_zero(u);
    ray->slope[axis] = slope_of(level ? REAL_UNIT(1.0) : u);
    ray->level = (uint8_t)(ray->level | level << axis);
    ray->falling = (uint8_t)(ray->falling | unit_is_negative(u) << axis);
}

void local_ray_world(struct local_ray *ray, struct point origin, struct direction direction) {
    ray->origin = origin;
    ray->direction = direction;
    ray->level = ray->falling = 0;
    set_slope(ray, 0, direction.x);
    set_slope(ray, 1, direction.y);
    set_slope(ray, 2, direction.z);
}

/* The same ray in a frame, without the slopes, which only boxes ask for. */
static void turn_ray(struct local_ray *ray, const struct frame *frame,
                     const struct local_ray *world) {
    struct point p = point_subtract(world->origin, frame->origin);
    ray->origin.x = point_dot(p, frame->axis[0]);
    ray->origin.y = point_dot(p, frame->axis[1]);
    ray->origin.z = point_dot(p, frame->axis[2]);
    ray->direction.x = direction_dot(world->direction, frame->axis[0]);
    ray->direction.y = direction_dot(world->direction, frame->axis[1]);
    ray->direction.z = direction_dot(world->direction, frame->axis[2]);
}

/* Whether a ray that runs along a plane is on the inner side of it. Of two solids that share the
 * plane one has what lies exactly in it, the upper one, as with boxes: no ray slips between. */
static bool plane_is_ahead(const struct plane *plane, real_length ahead) {
    const struct direction *normal = &plane->normal;
    if (!length_is_zero(ahead)) {
        return length_less(REAL_LENGTH(0.0), ahead);
    }
    return unit_is_negative(!unit_is_zero(normal->x)   ? normal->x
                            : !unit_is_zero(normal->y) ? normal->y
                                                       : normal->z);
}

static struct segment polyhedron_segment(const struct scene *scene,
                                         const struct polyhedron *polyhedron,
                                         const struct local_ray *ray, struct start start) {
    struct segment segment = {length_negate(LENGTH_FAR), LENGTH_FAR, 0, 0, true};
    for (uint8_t i = 0; i < polyhedron->count; i++) {
        const struct plane *plane = &scene->planes[polyhedron->first + i];
        real_length ahead = length_subtract(plane->offset, point_dot(ray->origin, plane->normal));
        real_unit along = direction_dot(ray->direction, plane->normal);
        if (unit_is_zero(along)) {
            segment.hit = segment.hit && plane_is_ahead(plane, ahead);
            continue;
        }
        bool on_it = plane->surface == start.surface;
        real_length t = on_it ? REAL_LENGTH(0.0) : length_over(ahead, slope_of(along));
        if (unit_is_negative(along)) {
            segment_enter(&segment, t, i);
        } else if (!on_it || !start.inside) {
            segment_leave(&segment, t, i);
        }
    }
    segment.hit = segment.hit && length_less(segment.in, segment.out);
    return segment;
}

/* A quadric's form along a ray, a x^2 + 2 b x + c, x being counted from the point `start` of the
 * ray that is nearest to the frame's origin: there all three are of the solid's own size. */
struct form {
    real_unit a;
    real_length b;
    real_area c;
    real_length start;
};

static struct form quadric_form(const struct quadric *quadric, const struct local_ray *ray) {
    struct direction d = ray->direction;
    struct direction slant = {unit_product(quadric->square.x, d.x),
                              unit_product(quadric->square.y, d.y),
                              unit_product(quadric->square.z, d.z)};
    struct form form;
    form.start = length_negate(point_dot(ray->origin, d));
    struct point p = point_along(ray->origin, form.start, d);
    real_area bend = area_product(p.z, quadric->linear);
    form.a = direction_dot(slant, d);
    form.b = length_add(point_dot(p, slant), length_scaled(quadric->linear, d.z));
    form.c = area_add(area_product(p.x, length_scaled(p.x, quadric->square.x)),
                      area_product(p.y, length_scaled(p.y, quadric->square.y)));
    form.c = area_add(form.c, area_product(p.z, length_scaled(p.z, quadric->square.z)));
    form.c = area_add(area_add(form.c, quadric->constant), area_add(bend, bend));
    return form;
}

/* Everything, or nothing. */
static struct segment whole_segment(real_length start, bool hit) {
    struct segment segment = {start, start, 0, 0, hit};
    if (hit) {
        segment.in = length_negate(LENGTH_FAR);
        segment.out = LENGTH_FAR;
    }
    return segment;
}

static real_length length_magnitude(real_length a) {
    return length_less(a, REAL_LENGTH(0.0)) ? length_negate(a) : a;
}

/* The stretches between or outside of two roots. */
static uint8_t segments_of_roots(real_length low, real_length high, bool outside,
                                 struct segment segments[2]) {
    if (!outside) {
        const struct segment between = {low, high, 0, 0, true};
        segments[0] = between;
        return 1;
    }
    const struct segment before = {length_negate(LENGTH_FAR), low, 0, 0, true};
    const struct segment after = {high, LENGTH_FAR, 0, 0, true};
    segments[0] = before;
    segments[1] = after;
    return 2;
}

/* The roots without cancellation: q / a and c / q, where q = -(b + sign(b) sqrt(b^2 - a c)). On a
 * surface that the ray starts on, the root nearest to the start is the start. */
static uint8_t quadric_segments(const struct quadric *quadric, const struct local_ray *ray,
                                bool starts_there, struct segment segments[2]) {
    struct form form = quadric_form(quadric, ray);
    real_area square = area_subtract(area_product(form.b, form.b), area_scaled(form.c, form.a));
    bool opens = unit_is_negative(form.a);
    if (area_is_negative(square)) {
        segments[0] = whole_segment(form.start, opens);
        return 1;
    }
    bool falls = length_less(form.b, REAL_LENGTH(0.0));
    real_length root = length_root(square);
    real_length q = falls ? length_subtract(root, form.b) : length_negate(length_add(root, form.b));
    if (length_is_zero(q)) {
        segments[0] = whole_segment(form.start, opens || area_is_negative(form.c));
        return 1;
    }
    real_length near = length_add(form.start, length_quotient(form.c, q));
    real_length far =
        length_less(q, REAL_LENGTH(0.0)) == opens ? LENGTH_FAR : length_negate(LENGTH_FAR);
    if (!unit_is_zero(form.a)) {
        far = length_add(form.start, length_over(q, slope_of(form.a)));
    }
    if (starts_there) {
        real_length *nearest =
            length_less(length_magnitude(far), length_magnitude(near)) ? &far : &near;
        *nearest = REAL_LENGTH(0.0);
    }
    bool ordered = length_less(near, far);
    return segments_of_roots(ordered ? near : far, ordered ? far : near, opens, segments);
}

uint8_t primitive_segments(const struct scene *scene, const struct primitive *primitive,
                           const struct local_ray *world, struct start start,
                           struct segment segments[2]) {
    const struct local_ray *ray = world;
    struct local_ray local;
    if (FEATURE_BALL && primitive->kind == PRIMITIVE_BALL) {
        segments[0] =
            ball_segment(&scene->balls[primitive->index], world->origin, world->direction);
        return 1;
    }
    if (FEATURE_POLYHEDRON && primitive->kind == PRIMITIVE_POLYHEDRON) {
        segments[0] = polyhedron_segment(scene, &scene->polyhedra[primitive->index], world, start);
        return 1;
    }
    if (FEATURE_ROTATION && primitive->frame != FRAME_WORLD) {
        turn_ray(&local, &scene->frames[primitive->frame], world);
        ray = &local;
    }
    if (FEATURE_QUADRIC && primitive->kind == PRIMITIVE_QUADRIC) {
        return quadric_segments(&scene->quadrics[primitive->index], ray,
                                start.surface != SURFACE_NONE, segments);
    }
    if (FEATURE_ROTATION && ray == &local) {
        local_ray_world(&local, local.origin, local.direction);
    }
    segments[0] = box_segment(&scene->boxes[primitive->index], ray, start);
    return 1;
}

uint16_t primitive_surface(const struct scene *scene, const struct primitive *primitive,
                           uint8_t face) {
    if (FEATURE_BALL && primitive->kind == PRIMITIVE_BALL) {
        return scene->balls[primitive->index].surface;
    }
    if (FEATURE_QUADRIC && primitive->kind == PRIMITIVE_QUADRIC) {
        return scene->quadrics[primitive->index].surface;
    }
    if (FEATURE_POLYHEDRON && primitive->kind == PRIMITIVE_POLYHEDRON) {
        return scene->planes[scene->polyhedra[primitive->index].first + face].surface;
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

/* The direction of the form's gradient; (0, 0, 0) at the tip of a cone. */
static struct direction quadric_normal(const struct scene *scene, const struct primitive *primitive,
                                       struct point where) {
    const struct quadric *quadric = &scene->quadrics[primitive->index];
    const struct frame *frame = &scene->frames[primitive->frame];
    struct point q = point_subtract(where, frame->origin);
    struct direction u;
    real_length steepness;
    unit_normalise_lengths(
        length_scaled(point_dot(q, frame->axis[0]), quadric->square.x),
        length_scaled(point_dot(q, frame->axis[1]), quadric->square.y),
        length_add(length_scaled(point_dot(q, frame->axis[2]), quadric->square.z), quadric->linear),
        &u.x, &u.y, &u.z, &steepness);
    const struct direction *axis = frame->axis;
    struct direction normal = {unit_dot(u.x, u.y, u.z, axis[0].x, axis[1].x, axis[2].x),
                               unit_dot(u.x, u.y, u.z, axis[0].y, axis[1].y, axis[2].y),
                               unit_dot(u.x, u.y, u.z, axis[0].z, axis[1].z, axis[2].z)};
    return normal;
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
    if (FEATURE_QUADRIC && primitive->kind == PRIMITIVE_QUADRIC) {
        return quadric_normal(scene, primitive, where);
    }
    if (FEATURE_POLYHEDRON && primitive->kind == PRIMITIVE_POLYHEDRON) {
        return scene->planes[scene->polyhedra[primitive->index].first + face].normal;
    }
    return box_normal(scene, primitive, face);
}
