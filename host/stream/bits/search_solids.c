/* SPDX-License-Identifier: MIT */
/* Where rays cross boxes, balls and polyhedra: firmware/solids.c for many rays at once. */
#include "search_solids.h"

#include "solids.h"

/* Finds where one lane leaves or enters a box; inside and may_be_level are constants at each
 * call. */
static inline struct meeting box_meeting(const struct search_lanes *search, int i, uint32_t bit,
                                         const struct slabs *slabs, const struct local_lanes *local,
                                         bool inside, bool may_be_level) {
    uint32_t start = search->surface[i];
    struct interval s = interval_everything(slabs->x.low_place);
    s = interval_slab(s, slabs->x, local->origin.x[i], local->slope[0][i], local->level[0][i] != 0,
                      local->falling[0][i] != 0, start, inside, may_be_level);
    s = interval_slab(s, slabs->y, local->origin.y[i], local->slope[1][i], local->level[1][i] != 0,
                      local->falling[1][i] != 0, start, inside, may_be_level);
    s = interval_slab(s, slabs->z, local->origin.z[i], local->slope[2][i], local->level[2][i] != 0,
                      local->falling[2][i] != 0, start, inside, may_be_level);
    s.hit = s.hit & length_less(s.in, s.out);
    return meeting_of(s, search->from[i], inside, (search->touch[i] & bit) != 0);
}

static void leave_box(struct search_lanes *restrict search, uint8_t index, const struct slabs slabs,
                      const struct local_lanes *restrict local,
                      const uint32_t chosen[restrict LANES]) {
    uint32_t bit = (uint32_t)1 << index;
    for (int i = 0; i < LANES; i++) {
        struct meeting found = box_meeting(search, i, bit, &slabs, local, true, true);
        search_consider(search, i, index, found, true, chosen[i] != 0);
    }
}

static void enter_box(struct search_lanes *restrict search, uint8_t index, const struct slabs slabs,
                      const struct local_lanes *restrict local,
                      const uint32_t chosen[restrict LANES]) {
    uint32_t bit = (uint32_t)1 << index;
    for (int i = 0; i < LANES; i++) {
        struct meeting found = box_meeting(search, i, bit, &slabs, local, false, false);
        search_consider(search, i, index, found, false, chosen[i] != 0);
    }
}

/* Enters a box as enter_box() does, where a ray may run along a face. */
static void enter_box_level(struct search_lanes *restrict search, uint8_t index,
                            const struct slabs slabs, const struct local_lanes *restrict local,
                            const uint32_t chosen[restrict LANES]) {
    uint32_t bit = (uint32_t)1 << index;
    for (int i = 0; i < LANES; i++) {
        struct meeting found = box_meeting(search, i, bit, &slabs, local, false, true);
        search_consider(search, i, index, found, false, chosen[i] != 0);
    }
}

void search_box(struct search_lanes *search, uint8_t index, const struct local_lanes *local,
                bool any_level, const struct chosen_lanes *chosen) {
    const struct scene *scene = search->scene;
    const struct slabs slabs = slabs_of(&scene->boxes[scene->primitives[index].index]);
    if (chosen->leaving > 0) {
        leave_box(search, index, slabs, local, chosen->leave);
    }
    if (chosen->entering > 0 && any_level) {
        enter_box_level(search, index, slabs, local, chosen->enter);
    } else if (chosen->entering > 0) {
        enter_box(search, index, slabs, local, chosen->enter);
    }
}

/* ball_segment() of firmware/solids.h in two steps: the roots only where a lane comes to them. */
struct ball_lanes {
    real_length middle[LANES]; /* where the ray is nearest to the centre */
    real_area square[LANES];   /* of half the path inside; negative: the ray passes by */
};

/* Tells whether any chosen lane meets a ball; false: all pass by. */
static bool ball_meets(const struct search_lanes *restrict search, const struct ball ball,
                       const struct chosen_lanes *restrict chosen,
                       struct ball_lanes *restrict lanes) {
    uint32_t meeting = 0;
    for (int i = 0; i < LANES; i++) {
        const struct point origin = point_in(&search->world.origin, i);
        const struct direction direction = direction_in(&search->world.direction, i);
        struct point p = point_subtract(origin, ball.centre);
        real_length middle = length_negate(point_dot(p, direction));
        struct point foot = point_along(p, middle, direction);
        real_area square = area_subtract(ball.square_radius, point_norm(foot));
        lanes->middle[i] = middle;
        lanes->square[i] = square;
        meeting |= chosen->leave[i] | (area_is_negative(square) ? 0 : chosen->enter[i]);
    }
    return meeting != 0;
}

static inline struct meeting ball_meeting(const struct search_lanes *search, int i, uint32_t bit,
                                          const struct ball_lanes *lanes, uint32_t place,
                                          bool inside) {
    real_length middle = lanes->middle[i], half = length_root(lanes->square[i]);
    const struct interval s = {length_subtract(middle, half), length_add(middle, half), place,
                               place, !area_is_negative(lanes->square[i])};
    return meeting_of(s, search->from[i], inside, (search->touch[i] & bit) != 0);
}

static void leave_ball(struct search_lanes *restrict search, uint8_t index, uint32_t place,
                       const struct ball_lanes *restrict lanes,
                       const uint32_t chosen[restrict LANES]) {
    uint32_t bit = (uint32_t)1 << index;
    for (int i = 0; i < LANES; i++) {
        struct meeting found = ball_meeting(search, i, bit, lanes, place, true);
        search_consider(search, i, index, found, true, chosen[i] != 0);
    }
}

static void enter_ball(struct search_lanes *restrict search, uint8_t index, uint32_t place,
                       const struct ball_lanes *restrict lanes,
                       const uint32_t chosen[restrict LANES]) {
    uint32_t bit = (uint32_t)1 << index;
    for (int i = 0; i < LANES; i++) {
        struct meeting found = ball_meeting(search, i, bit, lanes, place, false);
        search_consider(search, i, index, found, false, chosen[i] != 0);
    }
}

void search_ball(struct search_lanes *search, uint8_t index, const struct chosen_lanes *chosen) {
    const struct scene *scene = search->scene;
    const struct ball ball = scene->balls[scene->primitives[index].index];
    const uint32_t place = place_of(ball.surface, 0);
    struct ball_lanes lanes;
    if (!ball_meets(search, ball, chosen, &lanes)) {
        return;
    }
    if (chosen->leaving > 0) {
        leave_ball(search, index, place, &lanes, chosen->leave);
    }
    if (chosen->entering > 0) {
        enter_ball(search, index, place, &lanes, chosen->enter);
    }
}

/* Cuts a lane's interval by one plane of a polyhedron: see polyhedron_segment() of
 * firmware/solids.c. */
static inline struct interval interval_plane(struct interval s, const struct plane plane,
                                             uint32_t place, bool upper, struct point origin,
                                             struct direction direction, uint32_t start,
                                             bool inside) {
    real_length ahead = length_subtract(plane.offset, point_dot(origin, plane.normal));
    real_unit along = direction_dot(direction, plane.normal);
    bool level = unit_is_zero(along), falling = unit_is_negative(along);
    bool on_it = plane.surface == start;
    real_length t = length_over(ahead, slope_of(level ? REAL_UNIT(1.0) : along));
    t = on_it ? REAL_LENGTH(0.0) : t;
    bool behind = length_less(REAL_LENGTH(0.0), ahead) | (upper & length_is_zero(ahead));
    bool enters = falling & !level, leaves = !falling & !level & !(on_it & inside);
    s = interval_entered(s, enters ? t : length_negate(LENGTH_FAR), place);
    s = interval_left(s, leaves ? t : LENGTH_FAR, place);
    s.hit = s.hit & (behind | !level);
    return s;
}

static void cross_polyhedron(struct search_lanes *restrict search, uint8_t index,
                             const uint32_t chosen[restrict LANES], bool inside) {
    const struct scene *scene = search->scene;
    const struct polyhedron *polyhedron = &scene->polyhedra[scene->primitives[index].index];
    uint32_t bit = (uint32_t)1 << index;
    real_length in[LANES], out[LANES];
    uint32_t in_place[LANES], out_place[LANES], hit[LANES];
    uint32_t place = place_of(scene->planes[polyhedron->first].surface, 0);
    for (int i = 0; i < LANES; i++) {
        in[i] = length_negate(LENGTH_FAR);
        out[i] = LENGTH_FAR;
        in_place[i] = out_place[i] = place;
        hit[i] = 1;
    }
    for (uint32_t face = 0; face < polyhedron->count; face++) {
        const struct plane plane = scene->planes[polyhedron->first + face];
        bool upper = plane_is_upper(&plane);
        place = place_of(plane.surface, face);
        for (int i = 0; i < LANES; i++) {
            const struct point origin = point_in(&search->world.origin, i);
            const struct direction direction = direction_in(&search->world.direction, i);
            struct interval s = {in[i], out[i], in_place[i], out_place[i], hit[i] != 0};
            s = interval_plane(s, plane, place, upper, origin, direction, search->surface[i],
                               inside);
            in[i] = s.in;
            out[i] = s.out;
            in_place[i] = s.in_place;
            out_place[i] = s.out_place;
            hit[i] = s.hit ? 1 : 0;
        }
    }
    for (int i = 0; i < LANES; i++) {
        const struct interval s = {in[i], out[i], in_place[i], out_place[i],
                                   (hit[i] != 0) & length_less(in[i], out[i])};
        real_length from = search->from[i];
        struct meeting leaving = meeting_leaving(s, from);
        struct meeting entering = meeting_entering(s, from, (search->touch[i] & bit) != 0);
        const struct meeting found = {inside ? leaving.t : entering.t,
                                      inside ? leaving.place : entering.place,
                                      entering.valid | inside};
        search_consider(search, i, index, found, inside, chosen[i] != 0);
    }
}

void search_polyhedron(struct search_lanes *search, uint8_t index,
                       const struct chosen_lanes *chosen) {
    if (chosen->leaving > 0) {
        cross_polyhedron(search, index, chosen->leave, true);
    }
    if (chosen->entering > 0) {
        cross_polyhedron(search, index, chosen->enter, false);
    }
}
