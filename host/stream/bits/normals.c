/* SPDX-License-Identifier: MIT */
/* Normals: primitive_normal() of firmware/solids.c for many rays at once, primitive by primitive.
 */
#include "stream/normals.h"

#include "solids.h"
#include "stream/lane_normals.h"

/* Sets the normals of the flat faces of boxes, whose axes are those of a frame. */
static void set_flat(const struct search_lanes *restrict search,
                     const uint32_t here[restrict LANES], const struct frame frame,
                     struct direction_lanes *restrict normal) {
    for (int i = 0; i < LANES; i++) {
        uint32_t face = search->place[i] & 0xFF;
        uint32_t axis = face < 3 ? face : face - 3;
        struct direction high = {axis == 0   ? frame.axis[0].x
                                 : axis == 1 ? frame.axis[1].x
                                             : frame.axis[2].x,
                                 axis == 0   ? frame.axis[0].y
                                 : axis == 1 ? frame.axis[1].y
                                             : frame.axis[2].y,
                                 axis == 0   ? frame.axis[0].z
                                 : axis == 1 ? frame.axis[1].z
                                             : frame.axis[2].z};
        struct direction low = direction_negate(high);
        struct direction outward = {face < 3 ? low.x : high.x, face < 3 ? low.y : high.y,
                                    face < 3 ? low.z : high.z};
        set_normal(normal, i, here[i] != 0, outward, crossed_leaving(search->crossed[i]));
    }
}

/* The curved faces of a step: all of their normals are brought to length 1 together. */
struct curved_lanes {
    struct point_lanes steepness; /* along the outward normal, in the solid's frame */
    uint32_t frame[LANES];
    uint32_t is[LANES]; /* 1: a curved face */
};

static void set_ball(const uint32_t here[restrict LANES], const struct ball ball,
                     const struct point_lanes *restrict where,
                     struct curved_lanes *restrict curved) {
    for (int i = 0; i < LANES; i++) {
        const struct point there = point_in(where, i);
        struct point p = point_subtract(there, ball.centre);
        bool is = here[i] != 0;
        curved->steepness.x[i] = is ? p.x : curved->steepness.x[i];
        curved->steepness.y[i] = is ? p.y : curved->steepness.y[i];
        curved->steepness.z[i] = is ? p.z : curved->steepness.z[i];
        curved->is[i] = is ? 1 : curved->is[i];
    }
}

static void set_quadric(const struct search_lanes *restrict search,
                        const uint32_t here[restrict LANES], const struct quadric quadric,
                        const struct frame frame, uint32_t frame_number,
                        const struct point_lanes *restrict where,
                        struct curved_lanes *restrict curved) {
    const bool turned = frame_number != FRAME_WORLD;
    for (int i = 0; i < LANES; i++) {
        const struct point there = point_in(where, i);
        struct point q = point_subtract(there, quadric.centre);
        struct point t = turn_point(&frame, q);
        const struct point p = {turned ? t.x : q.x, turned ? t.y : q.y, turned ? t.z : q.z};
        struct point steepness = quadric_steepness(&quadric, p);
        bool is = (here[i] != 0) & ((search->place[i] & 0xFF) == QUADRIC_FACE);
        curved->steepness.x[i] = is ? steepness.x : curved->steepness.x[i];
        curved->steepness.y[i] = is ? steepness.y : curved->steepness.y[i];
        curved->steepness.z[i] = is ? steepness.z : curved->steepness.z[i];
        curved->frame[i] = is ? frame_number : curved->frame[i];
        curved->is[i] = is ? 1 : curved->is[i];
    }
}

static void start_curved(struct curved_lanes *restrict curved) {
    const real_length none = REAL_LENGTH(0.0);
    for (int i = 0; i < LANES; i++) {
        curved->steepness.x[i] = curved->steepness.y[i] = curved->steepness.z[i] = none;
        curved->frame[i] = FRAME_WORLD;
        curved->is[i] = 0;
    }
}

static void normalise(const struct curved_lanes *restrict curved,
                      struct direction_lanes *restrict outward) {
    for (int i = 0; i < LANES; i++) {
        real_length length;
        unit_normalise_lengths(curved->steepness.x[i], curved->steepness.y[i],
                               curved->steepness.z[i], &outward->x[i], &outward->y[i],
                               &outward->z[i], &length);
    }
}

/* Turns the lanes of one frame back into the world. */
static void turn_lanes(const struct curved_lanes *restrict curved, const struct frame frame,
                       uint32_t number, struct direction_lanes *restrict outward) {
    for (int i = 0; i < LANES; i++) {
        const struct direction u = direction_in(outward, i);
        struct direction back = turn_back(&frame, u);
        bool is = (curved->is[i] != 0) & (curved->frame[i] == number);
        outward->x[i] = is ? back.x : u.x;
        outward->y[i] = is ? back.y : u.y;
        outward->z[i] = is ? back.z : u.z;
    }
}

static void set_outward(const struct search_lanes *restrict search,
                        const struct curved_lanes *restrict curved,
                        const struct direction_lanes *restrict outward,
                        struct direction_lanes *restrict normal) {
    for (int i = 0; i < LANES; i++) {
        const struct direction u = direction_in(outward, i);
        set_normal(normal, i, curved->is[i] != 0, u, crossed_leaving(search->crossed[i]));
    }
}

static void set_curved(const struct search_lanes *search, const struct curved_lanes *curved,
                       struct direction_lanes *normal) {
    struct direction_lanes outward;
    uint32_t left[LANES];
    normalise(curved, &outward);
    for (int i = 0; i < LANES; i++) {
        left[i] = curved->frame[i] != FRAME_WORLD ? 1 : 0;
    }
    for (uint64_t set = lanes_set(left); set != 0; set = lanes_set(left)) {
        uint32_t number = curved->frame[lanes_first(set)];
        turn_lanes(curved, search->scene->frames[number], number, &outward);
        for (int i = 0; i < LANES; i++) {
            left[i] = curved->frame[i] == number ? 0 : left[i];
        }
    }
    set_outward(search, curved, &outward, normal);
}

static void set_polyhedron(const struct search_lanes *restrict search,
                           const uint32_t here[restrict LANES], const struct polyhedron *polyhedron,
                           struct direction_lanes *restrict normal) {
    for (uint32_t face = 0; face < polyhedron->count; face++) {
        const struct direction outward = search->scene->planes[polyhedron->first + face].normal;
        for (int i = 0; i < LANES; i++) {
            bool is = (here[i] != 0) & ((search->place[i] & 0xFF) == face);
            set_normal(normal, i, is, outward, crossed_leaving(search->crossed[i]));
        }
    }
}

static struct frame frame_of(const struct scene *scene, uint8_t number) {
    const struct frame world = {{REAL_LENGTH(0.0), REAL_LENGTH(0.0), REAL_LENGTH(0.0)},
                                {{REAL_UNIT(1.0), REAL_UNIT(0.0), REAL_UNIT(0.0)},
                                 {REAL_UNIT(0.0), REAL_UNIT(1.0), REAL_UNIT(0.0)},
                                 {REAL_UNIT(0.0), REAL_UNIT(0.0), REAL_UNIT(1.0)}}};
    return number == FRAME_WORLD ? world : scene->frames[number];
}

/* Sets the normals of the lanes that have come to one primitive; those of curved faces wait in
 * *curved. */
static void set_normals(const struct search_lanes *search, uint32_t index,
                        const uint32_t here[LANES], struct curved_lanes *curved,
                        struct hit_lanes *hit) {
    const struct scene *scene = search->scene;
    const struct primitive *primitive = &scene->primitives[index];
    if (primitive->kind == PRIMITIVE_BALL) {
        set_ball(here, scene->balls[primitive->index], &hit->where, curved);
        return;
    }
    if (primitive->kind == PRIMITIVE_POLYHEDRON) {
        set_polyhedron(search, here, &scene->polyhedra[primitive->index], &hit->normal);
        return;
    }
    struct frame frame = frame_of(scene, primitive->frame);
    set_flat(search, here, frame, &hit->normal);
    if (primitive->kind == PRIMITIVE_QUADRIC) {
        set_quadric(search, here, scene->quadrics[primitive->index], frame, primitive->frame,
                    &hit->where, curved);
    }
}

/* Returns the set of boxes whose axes are the world's: all of their normals are set at once. */
static uint32_t straight_boxes(const struct scene *scene) {
    uint32_t set = 0;
    for (uint8_t i = 0; i < scene->primitive_count; i++) {
        const struct primitive *primitive = &scene->primitives[i];
        bool is = primitive->kind == PRIMITIVE_BOX && primitive->frame == FRAME_WORLD;
        set |= is ? (uint32_t)1 << i : 0;
    }
    return set;
}

void normals_find(const struct search_lanes *restrict search, struct hit_lanes *restrict hit) {
    const uint32_t straight = straight_boxes(search->scene);
    struct curved_lanes curved;
    uint32_t left[LANES], here[LANES];
    set_straight(search, &hit->normal);
    for (int i = 0; i < LANES; i++) {
        uint32_t bit = (uint32_t)1 << crossed_primitive(search->crossed[i]);
        left[i] = (straight & bit) != 0 ? 0 : hit->is[i];
    }
    start_curved(&curved);
    for (uint64_t set = lanes_set(left); set != 0; set = lanes_set(left)) {
        uint32_t index = crossed_primitive(search->crossed[lanes_first(set)]);
        for (int i = 0; i < LANES; i++) {
            bool same = crossed_primitive(search->crossed[i]) == index;
            here[i] = same ? left[i] : 0;
            left[i] = same ? 0 : left[i];
        }
        set_normals(search, index, here, &curved, hit);
    }
    if (lanes_any(curved.is)) {
        set_curved(search, &curved, &hit->normal);
    }
}
