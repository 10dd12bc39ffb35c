/* SPDX-License-Identifier: MIT */
/* Where rays cross quadrics: quadric_segments() of firmware/solids.c for many rays at once. */
#include "search_solids.h"

#include "solids.h"

bool quadric_meets(const struct search_lanes *restrict search, uint8_t index,
                   const struct chosen_lanes *restrict chosen,
                   struct quadric_lanes *restrict lanes) {
    const struct scene *scene = search->scene;
    const struct quadric quadric = scene->quadrics[scene->primitives[index].index];
    uint32_t meeting = 0;
    for (int i = 0; i < LANES; i++) {
        const struct point origin = {search->world.origin.x[i], search->world.origin.y[i],
                                     search->world.origin.z[i]};
        const struct direction direction = {search->world.direction.x[i],
                                            search->world.direction.y[i],
                                            search->world.direction.z[i]};
        struct point p = point_subtract(origin, quadric.centre);
        real_length nearest = length_negate(point_dot(p, direction));
        struct point foot = point_along(p, nearest, direction);
        bool beyond = area_is_negative(area_subtract(quadric.square_reach, point_norm(foot)));
        lanes->foot.x[i] = foot.x;
        lanes->foot.y[i] = foot.y;
        lanes->foot.z[i] = foot.z;
        lanes->nearest[i] = nearest;
        lanes->passes[i] = (quadric.ends & beyond) ? 1 : 0;
        meeting |= chosen->leave[i] | (chosen->enter[i] & ~lanes->passes[i]);
    }
    return meeting != 0;
}

/* The stretches of lanes in a quadric: the second one only where `two` is 1. */
struct quadric_stretches {
    real_length in[2][LANES], out[2][LANES];
    uint32_t in_place[2][LANES], out_place[2][LANES], hit[2][LANES];
    uint32_t two[LANES];
};

/* The form of one lane: turned into the quadric's frame; NULL: it has none. */
static inline struct form lane_form(const struct quadric *quadric, const struct frame *frame,
                                    const struct quadric_lanes *lanes,
                                    const struct local_lanes *local, int i) {
    const struct point there = {lanes->foot.x[i], lanes->foot.y[i], lanes->foot.z[i]};
    const struct direction direction = {local->direction.x[i], local->direction.y[i],
                                        local->direction.z[i]};
    struct form form = quadric_form(quadric, frame ? turn_point(frame, there) : there, direction);
    form.start = lanes->nearest[i];
    return form;
}

/* form_segments() of firmware/solids.c for one lane. */
static inline void set_stretches(struct quadric_stretches *found, int i, const struct form form,
                                 bool on_curve, uint32_t place) {
    const real_length far_back = length_negate(LENGTH_FAR);
    real_area square = area_subtract(area_product(form.b, form.b), area_scaled(form.c, form.a));
    bool opens = unit_is_negative(form.a), falls = length_less(form.b, REAL_LENGTH(0.0));
    real_length root = length_root(square);
    real_length q = falls ? length_subtract(root, form.b) : length_negate(length_add(root, form.b));
    bool no_root = area_is_negative(square), no_q = length_is_zero(q), flat = unit_is_zero(form.a);
    real_length near = length_add(form.start, length_quotient(form.c, no_q ? REAL_LENGTH(1.0) : q));
    real_length over = length_over(q, slope_of(flat ? REAL_UNIT(1.0) : form.a));
    bool ahead = length_less(q, REAL_LENGTH(0.0)) ^ !opens;
    real_length none = ahead ? LENGTH_FAR : far_back;
    real_length far = flat ? none : length_add(form.start, over);
    bool far_is_nearer = length_less(length_magnitude(far), length_magnitude(near));
    far = (on_curve & far_is_nearer) ? REAL_LENGTH(0.0) : far;
    near = (on_curve & !far_is_nearer) ? REAL_LENGTH(0.0) : near;
    bool ordered = length_less(near, far);
    real_length low = ordered ? near : far, high = ordered ? far : near;
    bool whole = no_root | no_q, full = opens | (!no_root & area_is_negative(form.c));
    real_length whole_in = full ? far_back : form.start;
    real_length whole_out = full ? LENGTH_FAR : form.start;
    found->in[0][i] = whole ? whole_in : opens ? far_back : low;
    found->out[0][i] = whole ? whole_out : opens ? low : high;
    found->hit[0][i] = (full | !whole) ? 1 : 0;
    found->in[1][i] = high;
    found->out[1][i] = LENGTH_FAR;
    found->hit[1][i] = 1;
    found->two[i] = (opens & !whole) ? 1 : 0;
    found->in_place[0][i] = found->out_place[0][i] = place;
    found->in_place[1][i] = found->out_place[1][i] = place;
}

static void find_stretches(const struct search_lanes *restrict search, const struct quadric quadric,
                           uint8_t frame_number, const struct quadric_lanes *restrict lanes,
                           const struct local_lanes *restrict local,
                           struct quadric_stretches *restrict found) {
    const uint32_t place = place_of(quadric.surface, QUADRIC_FACE);
    if (frame_number == FRAME_WORLD) {
        for (int i = 0; i < LANES; i++) {
            struct form form = lane_form(&quadric, 0, lanes, local, i);
            set_stretches(found, i, form, search->surface[i] == quadric.surface, place);
        }
        return;
    }
    const struct frame frame = search->scene->frames[frame_number];
    for (int i = 0; i < LANES; i++) {
        struct form form = lane_form(&quadric, &frame, lanes, local, i);
        set_stretches(found, i, form, search->surface[i] == quadric.surface, place);
    }
}

/* What two faces of the quadric's box leave of the stretches: cut_segment() of firmware/solids.c.
 */
static void cut_stretches(const struct search_lanes *restrict search, uint32_t bit,
                          const struct slab slab, const real_length origin[restrict LANES],
                          const struct local_lanes *restrict local, int axis, int which,
                          struct quadric_stretches *restrict found) {
    for (int i = 0; i < LANES; i++) {
        uint32_t start = search->surface[i];
        bool level = local->level[axis][i] != 0, falling = local->falling[axis][i] != 0;
        real_slope slope = local->slope[axis][i];
        const struct stretch before = {found->in[which][i], found->out[which][i],
                                       found->in_place[which][i], found->out_place[which][i],
                                       found->hit[which][i] != 0};
        struct stretch left =
            stretch_slab(before, slab, origin[i], slope, level, falling, start, true, true);
        struct stretch entered =
            stretch_slab(before, slab, origin[i], slope, level, falling, start, false, true);
        bool inside = (search->inside[i] & bit) != 0;
        found->in[which][i] = inside ? left.in : entered.in;
        found->in_place[which][i] = inside ? left.in_place : entered.in_place;
        found->out[which][i] = inside ? left.out : entered.out;
        found->out_place[which][i] = inside ? left.out_place : entered.out_place;
        found->hit[which][i] = left.hit ? 1 : 0;
    }
}

static void cut_by_box(const struct search_lanes *search, uint32_t bit,
                       const struct quadric *quadric, const struct local_lanes *local, int which,
                       struct quadric_stretches *found) {
    const struct slabs slabs = slabs_of(&search->scene->boxes[quadric->box]);
    if (quadric->cuts & 1) {
        cut_stretches(search, bit, slabs.x, local->origin.x, local, 0, which, found);
    }
    if (quadric->cuts & 2) {
        cut_stretches(search, bit, slabs.y, local->origin.y, local, 1, which, found);
    }
    if (quadric->cuts & 4) {
        cut_stretches(search, bit, slabs.z, local->origin.z, local, 2, which, found);
    }
    for (int i = 0; i < LANES; i++) {
        bool is =
            (found->hit[which][i] != 0) & length_less(found->in[which][i], found->out[which][i]);
        found->hit[which][i] = is ? 1 : 0;
    }
}

static inline struct stretch stretch_of(const struct quadric_stretches *found, int which, int i) {
    const struct stretch s = {found->in[which][i], found->out[which][i], found->in_place[which][i],
                              found->out_place[which][i], found->hit[which][i] != 0};
    return s;
}

static void leave_quadric(struct search_lanes *restrict search, uint8_t index, uint32_t place,
                          const struct quadric_lanes *restrict lanes,
                          const struct quadric_stretches *restrict found,
                          const uint32_t chosen[restrict LANES]) {
    for (int i = 0; i < LANES; i++) {
        struct stretch first = stretch_of(found, 0, i), second = stretch_of(found, 1, i);
        bool passes = lanes->passes[i] != 0;
        first.out = passes ? lanes->nearest[i] : first.out;
        first.out_place = passes ? place : first.out_place;
        struct meeting meeting = meeting_of_two(first, second, (found->two[i] != 0) & !passes,
                                                search->from[i], true, false);
        search_consider(search, i, index, meeting, true, chosen[i] != 0);
    }
}

static void enter_quadric(struct search_lanes *restrict search, uint8_t index,
                          const struct quadric *restrict quadric,
                          const struct quadric_lanes *restrict lanes,
                          const struct quadric_stretches *restrict found,
                          const uint32_t chosen[restrict LANES]) {
    const uint32_t bit = (uint32_t)1 << index, surface = quadric->surface;
    const bool for_good = quadric->left_for_good;
    for (int i = 0; i < LANES; i++) {
        bool starts_there = (search->touch[i] & bit) != 0;
        bool left = for_good & (search->surface[i] == surface);
        struct meeting meeting =
            meeting_of_two(stretch_of(found, 0, i), stretch_of(found, 1, i), found->two[i] != 0,
                           search->from[i], false, starts_there);
        meeting.valid = meeting.valid & !left & (lanes->passes[i] == 0);
        search_consider(search, i, index, meeting, false, chosen[i] != 0);
    }
}

void search_quadric(struct search_lanes *search, uint8_t index, const struct quadric_lanes *lanes,
                    const struct local_lanes *local, const struct chosen_lanes *chosen) {
    const struct scene *scene = search->scene;
    const struct primitive *primitive = &scene->primitives[index];
    const struct quadric *quadric = &scene->quadrics[primitive->index];
    const uint32_t bit = (uint32_t)1 << index;
    struct quadric_stretches found;
    find_stretches(search, *quadric, primitive->frame, lanes, local, &found);
    if (quadric->cuts) {
        bool may_open = unit_is_negative(quadric->square.x) | unit_is_negative(quadric->square.y) |
                        unit_is_negative(quadric->square.z);
        cut_by_box(search, bit, quadric, local, 0, &found);
        if (may_open) {
            cut_by_box(search, bit, quadric, local, 1, &found);
        }
    }
    if (chosen->leaving > 0) {
        leave_quadric(search, index, place_of(quadric->surface, QUADRIC_FACE), lanes, &found,
                      chosen->leave);
    }
    if (chosen->entering > 0) {
        enter_quadric(search, index, quadric, lanes, &found, chosen->enter);
    }
}
