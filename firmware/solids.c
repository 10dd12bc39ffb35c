/* SPDX-License-Identifier: MIT */
/* Primitives: a ray in their coordinates, their surfaces, their normals. */
#include "solids.h"

/* Returns three flags as bits 0, 1, 2 for x, y, z. */
static uint8_t bits_of(bool x, bool y, bool z) {
    return (uint8_t)(x | y << 1 | z << 2);
}

static real_slope slope_unless(bool level, real_unit u) {
    return slope_of(level ? REAL_UNIT(1.0) : u);
}

static void set_slopes(struct local_ray *ray) {
    const struct direction d = ray->direction;
    bool x = unit_is_zero(d.x), y = unit_is_zero(d.y), z = unit_is_zero(d.z);
    ray->level = bits_of(x, y, z);
    ray->falling = bits_of(unit_is_negative(d.x), unit_is_negative(d.y), unit_is_negative(d.z));
    ray->slope[0] = slope_unless(x, d.x);
    ray->slope[1] = slope_unless(y, d.y);
    ray->slope[2] = slope_unless(z, d.z);
}

void views_start(struct local_ray views[VIEWS], const struct point *origin,
                 const struct direction *direction) {
    views[VIEW_WORLD].origin = *origin;
    views[VIEW_WORLD].direction = *direction;
    set_slopes(&views[VIEW_WORLD]);
    for (uint8_t i = VIEW_WORLD + 1; i < VIEWS; i++) {
        views[i].frame = FRAME_WORLD;
    }
}

const struct local_ray *view_in(const struct scene *scene, entry_number frame,
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

static inline bool is_level(const struct local_ray *ray, uint8_t axis) {
    return (ray->level >> axis & 1) != 0;
}

static inline bool is_falling(const struct local_ray *ray, uint8_t axis) {
    return (ray->falling >> axis & 1) != 0;
}

/* Moves `end` back to the farther one of the two faces across an axis, if that face is before
 * `end`. origin, low and high: where the ray's origin and the low and high face lie on the axis. */
static inline void leave_axis(const struct local_ray *ray, uint8_t axis, real_length origin,
                              real_length low, real_length high, const surface_number *surface,
                              struct start start, struct box_end *end) {
    if (is_level(ray, axis)) {
        return;
    }
    bool falling = is_falling(ray, axis);
    uint8_t face = falling ? axis : (uint8_t)(axis + 3);
    real_length t = REAL_LENGTH(0.0);
    if (surface[face] != start.surface) {
        t = length_over(length_subtract(falling ? low : high, origin), ray->slope[axis]);
    } else if (start.inside) {
        return;
    }
    if (length_less(t, end->t)) {
        end->t = t;
        end->face = face;
    }
}

struct box_end box_exit(const struct box *box, const struct local_ray *ray, struct start start) {
    const struct point *low = &box->minimum, *high = &box->maximum;
    struct box_end end = {LENGTH_FAR, 0};
    leave_axis(ray, 0, ray->origin.x, low->x, high->x, box->surface, start, &end);
    leave_axis(ray, 1, ray->origin.y, low->y, high->y, box->surface, start, &end);
    leave_axis(ray, 2, ray->origin.z, low->z, high->z, box->surface, start, &end);
    return end;
}

/* Moves `entry` on to the nearer one of the two faces across an axis, if that face is after
 * `entry`. Returns false if the ray runs along the faces and not between them. */
static inline bool enter_axis(const struct local_ray *ray, uint8_t axis, real_length origin,
                              real_length low, real_length high, const surface_number *surface,
                              surface_number start_surface, struct box_end *entry) {
    if (is_level(ray, axis)) {
        return !length_less(origin, low) && length_less(origin, high);
    }
    bool falling = is_falling(ray, axis);
    uint8_t face = falling ? (uint8_t)(axis + 3) : axis;
    real_length t = REAL_LENGTH(0.0);
    if (surface[face] != start_surface) {
        t = length_over(length_subtract(falling ? high : low, origin), ray->slope[axis]);
    }
    if (length_less(entry->t, t)) {
        entry->t = t;
        entry->face = face;
    }
    return true;
}

bool box_entry(const struct box *box, const struct local_ray *ray, surface_number surface,
               struct box_end *entry) {
    const struct point *low = &box->minimum, *high = &box->maximum;
    entry->t = length_negate(LENGTH_FAR);
    entry->face = 0;
    return enter_axis(ray, 0, ray->origin.x, low->x, high->x, box->surface, surface, entry) &&
           enter_axis(ray, 1, ray->origin.y, low->y, high->y, box->surface, surface, entry) &&
           enter_axis(ray, 2, ray->origin.z, low->z, high->z, box->surface, surface, entry);
}

/* Tells whether a ray that runs along a plane is on the inner side of the plane. As with boxes, no
 * ray slips between two solids that share a plane. */
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

/* Returns the whole ray if `hit` is set, else a miss with both ends at `start`. */
static struct segment whole_segment(real_length start, bool hit) {
    struct segment segment = {start, start, QUADRIC_FACE, QUADRIC_FACE, hit};
    if (hit) {
        segment.in = length_negate(LENGTH_FAR);
        segment.out = LENGTH_FAR;
    }
    return segment;
}

/* Finds the intervals between or outside of two roots; returns how many there are. */
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

/* Finds the intervals by the form's roots; returns how many there are. The roots are worked out
 * without cancellation: q / a and c / q, where q = -(b + sign(b) sqrt(b^2 - a c)). On a surface
 * that the ray starts on, the root nearest to the start is the start. */
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

/* Cuts an interval by the faces across one axis; false if the ray runs past them. A ray that is
 * inside is asked only where it leaves. */
static bool cut_axis(const struct local_ray *ray, uint8_t axis, real_length origin, real_length low,
                     real_length high, const surface_number *surface, struct start start,
                     struct box_end *in, struct box_end *out) {
    leave_axis(ray, axis, origin, low, high, surface, start, out);
    return start.inside || enter_axis(ray, axis, origin, low, high, surface, start.surface, in);
}

/* Cuts an interval by the faces of a quadric's box. */
static void cut_segment(const struct box *box, uint8_t cuts, const struct local_ray *ray,
                        struct start start, struct segment *segment) {
    const real_length origin[3] = {ray->origin.x, ray->origin.y, ray->origin.z};
    const real_length low[3] = {box->minimum.x, box->minimum.y, box->minimum.z};
    const real_length high[3] = {box->maximum.x, box->maximum.y, box->maximum.z};
    struct box_end in = {segment->in, segment->in_face}, out = {segment->out, segment->out_face};
    bool hit = segment->hit;
    for (uint8_t axis = 0; axis < 3; axis++) {
        if (cuts >> axis & 1) {
            hit &= cut_axis(ray, axis, origin[axis], low[axis], high[axis], box->surface, start,
                            &in, &out);
        }
    }
    segment->in = in.t;
    segment->in_face = in.face;
    segment->out = out.t;
    segment->out_face = out.face;
    segment->hit = hit && length_less(segment->in, segment->out);
}

/* Finds the intervals inside a quadric; returns how many there are. The reach is looked at before
 * the ray is turned, for most rays pass by. */
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
    const struct local_ray *ray = view_in(scene, primitive->frame, views);
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
    return FEATURE_QUADRIC ? quadric_segments(scene, primitive, views, start, segments) : 0;
}

/* Returns the box of a flat face: a primitive's own, or the one that cuts a quadric. */
static const struct box *box_of(const struct scene *scene, const struct primitive *primitive) {
    bool cut = FEATURE_QUADRIC && primitive->kind == PRIMITIVE_QUADRIC;
    return &scene->boxes[cut ? scene->quadrics[primitive->index].box : primitive->index];
}

surface_number primitive_surface(const struct scene *scene, const struct primitive *primitive,
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
                                  uint8_t face, const struct point *where) {
    if (FEATURE_BALL && primitive->kind == PRIMITIVE_BALL) {
        struct point p = point_subtract(*where, scene->balls[primitive->index].centre);
        struct direction normal;
        real_length radius;
        unit_normalise_lengths(p.x, p.y, p.z, &normal.x, &normal.y, &normal.z, &radius);
        return normal;
    }
    if (FEATURE_QUADRIC && face == QUADRIC_FACE && primitive->kind == PRIMITIVE_QUADRIC) {
        return quadric_normal(scene, primitive, *where);
    }
    if (FEATURE_POLYHEDRON && primitive->kind == PRIMITIVE_POLYHEDRON) {
        return scene->planes[scene->polyhedra[primitive->index].first + face].normal;
    }
    return box_normal(scene, primitive, face);
}
