/* SPDX-License-Identifier: MIT */
/* Primitives: a ray in their coordinates, their surfaces, their normals. */
#include "solids.h"

static void set_slope(struct local_ray *ray, uint8_t axis, real_unit u) {
    bool level = unit_is_zero(u);
    ray->slope[axis] = slope_of(level ? REAL_UNIT(1.0) : u);
    ray->level = (uint8_t)(ray->level | level << axis);
    ray->falling = (uint8_t)(ray->falling | unit_is_negative(u) << axis);
}

static void set_slopes(struct local_ray *ray) {
    ray->level = ray->falling = 0;
    set_slope(ray, 0, ray->direction.x);
    set_slope(ray, 1, ray->direction.y);
    set_slope(ray, 2, ray->direction.z);
}

void views_start(struct local_ray views[VIEWS], struct point origin, struct direction direction) {
    views[VIEW_WORLD].origin = origin;
    views[VIEW_WORLD].direction = direction;
    set_slopes(&views[VIEW_WORLD]);
    for (uint8_t i = VIEW_WORLD + 1; i < VIEWS; i++) {
        views[i].frame = FRAME_WORLD;
    }
}

/* The ray in a primitive's frame, turned once for all of its primitives. */
static const struct local_ray *view_from(const struct scene *scene, uint8_t frame,
                                         struct local_ray views[VIEWS]) {
    const struct local_ray *world = &views[VIEW_WORLD];
    if (!FEATURE_ROTATION || frame == FRAME_WORLD) {
        return world;
    }
    struct local_ray *ray = &views[(1 + (frame & 1)) * FEATURE_ROTATION];
    if (ray->frame != frame) {
        const struct direction *axis = scene->frames[frame].axis;
        ray->frame = frame;
        ray->origin = turn_point(&scene->frames[frame], world->origin);
        ray->direction.x = direction_dot(world->direction, axis[0]);
        ray->direction.y = direction_dot(world->direction, axis[1]);
        ray->direction.z = direction_dot(world->direction, axis[2]);
        set_slopes(ray);
    }
    return ray;
}

/* Whether a ray that runs along a plane is on the inner side of it: as with boxes, no ray slips
 * between two solids that share one. */
static bool plane_is_ahead(const struct plane *plane, real_length ahead) {
    return length_is_zero(ahead) ? plane_is_upper(plane) : length_less(REAL_LENGTH(0.0), ahead);
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

/* Everything, or nothing. */
static struct segment whole_segment(real_length start, bool hit) {
    struct segment segment = {start, start, QUADRIC_FACE, QUADRIC_FACE, hit};
    if (hit) {
        segment.in = length_negate(LENGTH_FAR);
        segment.out = LENGTH_FAR;
    }
    return segment;
}

/* The stretches between or outside of two roots. */
static uint8_t segments_of_roots(real_length low, real_length high, bool outside,
                                 struct segment segments[2]) {
    if (!outside) {
        const struct segment between = {low, high, QUADRIC_FACE, QUADRIC_FACE, true};
        segments[0] = between;
        return 1;
    }
    const struct segment before = {length_negate(LENGTH_FAR), low, QUADRIC_FACE, QUADRIC_FACE,
                                   true};
    const struct segment after = {high, LENGTH_FAR, QUADRIC_FACE, QUADRIC_FACE, true};
    segments[0] = before;
    segments[1] = after;
    return 2;
}

/* The roots without cancellation: q / a and c / q, where q = -(b + sign(b) sqrt(b^2 - a c)). On a
 * surface that the ray starts on, the root nearest to the start is the start. */
static uint8_t form_segments(const struct form *form, bool starts_there,
                             struct segment segments[2]) {
    real_area square = area_subtract(area_product(form->b, form->b), area_scaled(form->c, form->a));
    bool opens = unit_is_negative(form->a);
    if (area_is_negative(square)) {
        segments[0] = whole_segment(form->start, opens);
        return 1;
    }
    bool falls = length_less(form->b, REAL_LENGTH(0.0));
    real_length root = length_root(square);
    real_length q =
        falls ? length_subtract(root, form->b) : length_negate(length_add(root, form->b));
    if (length_is_zero(q)) {
        segments[0] = whole_segment(form->start, opens || area_is_negative(form->c));
        return 1;
    }
    real_length near = length_add(form->start, length_quotient(form->c, q));
    real_length far =
        length_less(q, REAL_LENGTH(0.0)) == opens ? LENGTH_FAR : length_negate(LENGTH_FAR);
    if (!unit_is_zero(form->a)) {
        far = length_add(form->start, length_over(q, slope_of(form->a)));
    }
    if (starts_there) {
        real_length *nearest =
            length_less(length_magnitude(far), length_magnitude(near)) ? &far : &near;
        *nearest = REAL_LENGTH(0.0);
    }
    bool ordered = length_less(near, far);
    return segments_of_roots(ordered ? near : far, ordered ? far : near, opens, segments);
}

/* What the faces of a quadric's box leave of a stretch. */
static void cut_segment(const struct box *box, uint8_t cuts, const struct local_ray *ray,
                        struct start start, struct segment *segment) {
    const struct point *low = &box->minimum, *high = &box->maximum;
    if (cuts & 1) {
        box_axis(ray, 0, ray->origin.x, low->x, high->x, box->surface, start, segment);
    }
    if (cuts & 2) {
        box_axis(ray, 1, ray->origin.y, low->y, high->y, box->surface, start, segment);
    }
    if (cuts & 4) {
        box_axis(ray, 2, ray->origin.z, low->z, high->z, box->surface, start, segment);
    }
    segment->hit = segment->hit && length_less(segment->in, segment->out);
}

/* The reach is looked at before the ray is turned: most rays pass by. */
static uint8_t quadric_segments(const struct scene *scene, const struct primitive *primitive,
                                struct local_ray views[VIEWS], struct start start,
                                struct segment segments[2]) {
    const struct quadric *quadric = &scene->quadrics[primitive->index];
    const struct local_ray *world = &views[VIEW_WORLD];
    bool on_curve = start.surface == quadric->surface;
    if (on_curve && !start.inside && quadric->left_for_good) {
        segments[0] = whole_segment(REAL_LENGTH(0.0), false);
        return 1;
    }
    struct point p = point_subtract(world->origin, quadric->centre);
    real_length nearest = length_negate(point_dot(p, world->direction));
    struct point foot = point_along(p, nearest, world->direction);
    if (quadric->ends && area_is_negative(area_subtract(quadric->square_reach, point_norm(foot)))) {
        segments[0] = whole_segment(nearest, false);
        return 1;
    }
    const struct local_ray *ray = view_from(scene, primitive->frame, views);
    if (FEATURE_ROTATION && ray != world) {
        foot = turn_point(&scene->frames[primitive->frame], foot);
    }
    struct form form = quadric_form(quadric, foot, ray->direction);
    form.start = nearest;
    uint8_t count = form_segments(&form, on_curve, segments);
    if (quadric->cuts) {
        for (uint8_t i = 0; i < count; i++) {
            cut_segment(&scene->boxes[quadric->box], quadric->cuts, ray, start, &segments[i]);
        }
    }
    return count;
}

uint8_t primitive_segments(const struct scene *scene, const struct primitive *primitive,
                           struct local_ray views[VIEWS], struct start start,
                           struct segment segments[2]) {
    const struct local_ray *world = &views[VIEW_WORLD];
    if (FEATURE_BALL && primitive->kind == PRIMITIVE_BALL) {
        segments[0] =
            ball_segment(&scene->balls[primitive->index], world->origin, world->direction);
        return 1;
    }
    if (FEATURE_POLYHEDRON && primitive->kind == PRIMITIVE_POLYHEDRON) {
        segments[0] = polyhedron_segment(scene, &scene->polyhedra[primitive->index], world, start);
        return 1;
    }
    if (FEATURE_QUADRIC && primitive->kind == PRIMITIVE_QUADRIC) {
        return quadric_segments(scene, primitive, views, start, segments);
    }
    segments[0] = box_segment(&scene->boxes[primitive->index],
                              view_from(scene, primitive->frame, views), start);
    return 1;
}

/* The box that a flat face belongs to: a primitive's own, or that which cuts a quadric. */
static const struct box *box_of(const struct scene *scene, const struct primitive *primitive) {
    bool cut = FEATURE_QUADRIC && primitive->kind == PRIMITIVE_QUADRIC;
    return &scene->boxes[cut ? scene->quadrics[primitive->index].box : primitive->index];
}

uint16_t primitive_surface(const struct scene *scene, const struct primitive *primitive,
                           uint8_t face) {
    if (FEATURE_BALL && primitive->kind == PRIMITIVE_BALL) {
        return scene->balls[primitive->index].surface;
    }
    if (FEATURE_QUADRIC && face == QUADRIC_FACE && primitive->kind == PRIMITIVE_QUADRIC) {
        return scene->quadrics[primitive->index].surface;
    }
    if (FEATURE_POLYHEDRON && primitive->kind == PRIMITIVE_POLYHEDRON) {
        return scene->planes[scene->polyhedra[primitive->index].first + face].surface;
    }
    return box_of(scene, primitive)->surface[face];
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

static struct direction quadric_normal(const struct scene *scene, const struct primitive *primitive,
                                       struct point where) {
    const struct quadric *quadric = &scene->quadrics[primitive->index];
    struct point q = point_subtract(where, quadric->centre);
    if (!FEATURE_ROTATION || primitive->frame == FRAME_WORLD) {
        return quadric_gradient(quadric, q);
    }
    const struct frame *frame = &scene->frames[primitive->frame];
    return turn_back(frame, quadric_gradient(quadric, turn_point(frame, q)));
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
    if (FEATURE_QUADRIC && face == QUADRIC_FACE && primitive->kind == PRIMITIVE_QUADRIC) {
        return quadric_normal(scene, primitive, where);
    }
    if (FEATURE_POLYHEDRON && primitive->kind == PRIMITIVE_POLYHEDRON) {
        return scene->planes[scene->polyhedra[primitive->index].first + face].normal;
    }
    return box_normal(scene, primitive, face);
}
