/* SPDX-License-Identifier: MIT */
/* Where rays cross quadrics: quadric_segments() of firmware/solids.c for many rays at once. */
#include "search_solids.h"

#include "solids.h"

bool quadric_meets(const struct search_lanes *restrict search, uint8_t index,
                   const struct chosen_lanes *restrict chosen,
                   struct quadric_lanes *restrict lanes) {
    const struct scene *scene = search->scene;
    const struct quadric quadric = scene->quadrics[scene->primitives[index].index];
    const uint32_t ends = quadric.ends ? 1 : 0;
    uint32_t meeting = 0;
    for (int i = 0; i < LANES; i++) {
        const struct point origin = point_in(&search->world.origin, i);
        const struct direction direction = direction_in(&search->world.direction, i);
        struct point p = point_subtract(origin, quadric.centre);
        real_length nearest = length_negate(point_dot(p, direction));
        struct point foot = point_along(p, nearest, direction);
        bool beyond = area_is_negative(area_subtract(quadric.square_reach, point_norm(foot)));
        lanes->foot.x[i] = foot.x;
        lanes->foot.y[i] = foot.y;
        lanes->foot.z[i] = foot.z;
        lanes->nearest[i] = nearest;
        lanes->passes[i] = beyond ? ends : 0;
    }
    for (int i = 0; i < LANES; i++) {
        meeting |= chosen->leave[i] | (chosen->enter[i] & ~lanes->passes[i]);
    }
    return meeting != 0;
}

/* Where the lanes cross a quadric. */
struct meeting_lanes {
    real_length t[LANES];
    uint32_t place[LANES], valid[LANES];
};

/* The intervals of lanes in a quadric: the second one only where `two` is 1. */
struct quadric_intervals {
    real_length in[2][LANES], out[2][LANES];
    uint32_t in_place[2][LANES], out_place[2][LANES], hit[2][LANES];
    uint32_t two[LANES];
};

/* The forms of the lanes, and what their square roots come to. See struct form, and form_segments()
 * of firmware/solids.c, which takes one ray through these steps. Each step is a short loop of its
 * own, so that it becomes vectors in every arithmetic. */
struct root_lanes {
    real_unit a[LANES];
    real_length b[LANES];
    real_area c[LANES], square[LANES];
    real_length q[LANES], divisor[LANES]; /* divisor: q, but never 0 */
    real_length near[LANES], far[LANES];
};

static inline void set_form(const struct quadric *quadric, struct point foot,
                            const struct local_lanes *local, int i, struct root_lanes *roots) {
    const struct direction direction = direction_in(&local->direction, i);
    struct form form = quadric_form(quadric, foot, direction);
    roots->a[i] = form.a;
    roots->b[i] = form.b;
    roots->c[i] = form.c;
}

static void find_forms(const struct scene *scene, const struct quadric quadric,
                       uint8_t frame_number, const struct quadric_lanes *restrict lanes,
                       const struct local_lanes *restrict local,
                       struct root_lanes *restrict roots) {
    if (frame_number == FRAME_WORLD) {
        for (int i = 0; i < LANES; i++) {
            const struct point foot = point_in(&lanes->foot, i);
            set_form(&quadric, foot, local, i, roots);
        }
        return;
    }
    const struct frame frame = scene->frames[frame_number];
    for (int i = 0; i < LANES; i++) {
        const struct point foot = point_in(&lanes->foot, i);
        set_form(&quadric, turn_point(&frame, foot), local, i, roots);
    }
}

static void find_squares(struct root_lanes *restrict roots) {
    for (int i = 0; i < LANES; i++) {
        real_area product = area_product(roots->b[i], roots->b[i]);
        roots->square[i] = area_subtract(product, area_scaled(roots->c[i], roots->a[i]));
    }
}

static void find_roots(struct root_lanes *restrict roots) {
    for (int i = 0; i < LANES; i++) {
        real_length b = roots->b[i], root = length_root(roots->square[i]);
        bool falls = length_less(b, REAL_LENGTH(0.0));
        real_length less = length_subtract(root, b), more = length_add(root, b);
        real_length q = falls ? less : length_negate(more);
        roots->q[i] = q;
        roots->divisor[i] = length_is_zero(q) ? REAL_LENGTH(1.0) : q;
    }
}

/* Finds the near roots, counted from where the ray is nearest to the centre. */
static void find_near(struct root_lanes *restrict roots) {
    for (int i = 0; i < LANES; i++) {
        roots->near[i] = length_quotient(roots->c[i], roots->divisor[i]);
    }
}

static void find_far(const struct quadric_lanes *restrict lanes,
                     struct root_lanes *restrict roots) {
    const real_length far_back = length_negate(LENGTH_FAR);
    for (int i = 0; i < LANES; i++) {
        real_length q = roots->q[i];
        real_unit a = roots->a[i];
        bool flat = unit_is_zero(a), opens = unit_is_negative(a);
        real_length over = length_over(q, slope_of(flat ? REAL_UNIT(1.0) : a));
        real_length far = length_add(lanes->nearest[i], over);
        bool ahead = length_less(q, REAL_LENGTH(0.0)) ^ !opens;
        real_length none = ahead ? LENGTH_FAR : far_back;
        roots->far[i] = flat ? none : far;
    }
}

/* Counts the near roots from the ray's start. The root at which a ray starts becomes exactly 0. */
static void pin_starts(const struct quadric_lanes *restrict lanes,
                       const uint32_t start[restrict LANES], uint32_t surface,
                       struct root_lanes *restrict roots) {
    for (int i = 0; i < LANES; i++) {
        real_length near = length_add(lanes->nearest[i], roots->near[i]), far = roots->far[i];
        bool on_curve = start[i] == surface;
        bool far_is_nearer = length_less(length_magnitude(far), length_magnitude(near));
        roots->far[i] = (on_curve & far_is_nearer) ? REAL_LENGTH(0.0) : far;
        roots->near[i] = (on_curve & !far_is_nearer) ? REAL_LENGTH(0.0) : near;
    }
}

static void set_stretches(const struct quadric_lanes *restrict lanes, uint32_t place,
                          const struct root_lanes *restrict roots,
                          struct quadric_intervals *restrict found) {
    const real_length far_back = length_negate(LENGTH_FAR);
    for (int i = 0; i < LANES; i++) {
        real_length near = roots->near[i], far = roots->far[i], start = lanes->nearest[i];
        bool opens = unit_is_negative(roots->a[i]), no_q = length_is_zero(roots->q[i]);
        bool no_root = area_is_negative(roots->square[i]);
        bool ordered = length_less(near, far);
        real_length low = ordered ? near : far, high = ordered ? far : near;
        bool whole = no_root | no_q, full = opens | (!no_root & area_is_negative(roots->c[i]));
        real_length in = opens ? far_back : low, out = opens ? low : high;
        real_length whole_in = full ? far_back : start, whole_out = full ? LENGTH_FAR : start;
        found->in[0][i] = whole ? whole_in : in;
        found->out[0][i] = whole ? whole_out : out;
        found->hit[0][i] = (full | !whole) ? 1 : 0;
        found->in_place[0][i] = found->out_place[0][i] = place;
        found->in[1][i] = high;
        found->two[i] = (opens & !whole) ? 1 : 0;
    }
}

/* Sets what is the same for all second intervals: all but where they begin. */
static void set_second(uint32_t place, struct quadric_intervals *restrict found) {
    for (int i = 0; i < LANES; i++) {
        found->out[1][i] = LENGTH_FAR;
        found->hit[1][i] = 1;
        found->in_place[1][i] = found->out_place[1][i] = place;
    }
}

static void find_stretches(const struct search_lanes *search, const struct quadric *quadric,
                           uint8_t frame, const struct quadric_lanes *lanes,
                           const struct local_lanes *local, struct quadric_intervals *found) {
    struct root_lanes roots;
    find_forms(search->scene, *quadric, frame, lanes, local, &roots);
    find_squares(&roots);
    find_roots(&roots);
    find_near(&roots);
    find_far(lanes, &roots);
    pin_starts(lanes, search->surface, quadric->surface, &roots);
    set_stretches(lanes, place_of(quadric->surface, QUADRIC_FACE), &roots, found);
}

/* Cuts the intervals by two faces of the quadric's box: cut_segment() of firmware/solids.c. */
static void cut_stretches(const struct search_lanes *restrict search, uint32_t bit,
                          const struct slab slab, const real_length origin[restrict LANES],
                          const struct local_lanes *restrict local, int axis, int which,
                          struct quadric_intervals *restrict found) {
    for (int i = 0; i < LANES; i++) {
        uint32_t start = search->surface[i];
        bool level = local->level[axis][i] != 0, falling = local->falling[axis][i] != 0;
        real_slope slope = local->slope[axis][i];
        const struct interval before = {found->in[which][i], found->out[which][i],
                                        found->in_place[which][i], found->out_place[which][i],
                                        found->hit[which][i] != 0};
        struct interval left =
            interval_slab(before, slab, origin[i], slope, level, falling, start, true, true);
        struct interval entered =
            interval_slab(before, slab, origin[i], slope, level, falling, start, false, true);
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
                       struct quadric_intervals *found) {
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

static inline struct interval interval_of(const struct quadric_intervals *found, int which, int i) {
    const struct interval s = {found->in[which][i], found->out[which][i], found->in_place[which][i],
                               found->out_place[which][i], found->hit[which][i] != 0};
    return s;
}

static inline void set_meeting(struct meeting_lanes *meetings, int i, struct meeting meeting) {
    meetings->t[i] = meeting.t;
    meetings->place[i] = meeting.place;
    meetings->valid[i] = meeting.valid ? 1 : 0;
}

/* Finds where lanes leave a quadric. may_open is a constant at each call: false where no lane can
 * have two intervals. */
static inline void find_leaving(const struct search_lanes *restrict search, uint32_t place,
                                const struct quadric_lanes *restrict lanes,
                                const struct quadric_intervals *restrict found, bool may_open,
                                struct meeting_lanes *restrict meetings) {
    for (int i = 0; i < LANES; i++) {
        struct interval first = interval_of(found, 0, i), second = interval_of(found, 1, i);
        bool passes = lanes->passes[i] != 0, two = (found->two[i] != 0) & !passes;
        first.out = passes ? lanes->nearest[i] : first.out;
        first.out_place = passes ? place : first.out_place;
        set_meeting(meetings, i,
                    may_open ? meeting_leaving_two(first, second, two, search->from[i])
                             : meeting_leaving(first, search->from[i]));
    }
}

/* Finds where lanes enter one of the two intervals. */
static void find_entering(const struct search_lanes *restrict search, uint32_t bit,
                          const struct quadric_lanes *restrict lanes,
                          const struct quadric_intervals *restrict found, int which,
                          struct meeting_lanes *restrict meetings) {
    for (int i = 0; i < LANES; i++) {
        bool starts_there = (search->touch[i] & bit) != 0, passes = lanes->passes[i] != 0;
        struct meeting meeting =
            meeting_entering(interval_of(found, which, i), search->from[i], starts_there);
        meeting.valid = meeting.valid & !passes;
        set_meeting(meetings, i, meeting);
    }
}

/* Takes the second interval's entry in lanes that have two intervals and the first not ahead. */
static void prefer_first(const struct quadric_intervals *restrict found,
                         const struct meeting_lanes *restrict second,
                         struct meeting_lanes *restrict first) {
    for (int i = 0; i < LANES; i++) {
        bool is_second = (first->valid[i] == 0) & (found->two[i] != 0);
        first->t[i] = is_second ? second->t[i] : first->t[i];
        first->place[i] = is_second ? second->place[i] : first->place[i];
        first->valid[i] = is_second ? second->valid[i] : first->valid[i];
    }
}

static struct meeting meeting_in(const struct meeting_lanes *meetings, int i) {
    const struct meeting meeting = {meetings->t[i], meetings->place[i], meetings->valid[i] != 0};
    return meeting;
}

static void leave_quadric(struct search_lanes *restrict search, uint8_t index,
                          const struct meeting_lanes *restrict meetings,
                          const uint32_t chosen[restrict LANES]) {
    for (int i = 0; i < LANES; i++) {
        search_consider(search, i, index, meeting_in(meetings, i), true, chosen[i] != 0);
    }
}

static void enter_quadric(struct search_lanes *restrict search, uint8_t index,
                          const struct quadric *restrict quadric,
                          const struct meeting_lanes *restrict meetings,
                          const uint32_t chosen[restrict LANES]) {
    const uint32_t surface = quadric->surface;
    const bool for_good = quadric->left_for_good;
    for (int i = 0; i < LANES; i++) {
        bool left = for_good & (search->surface[i] == surface);
        search_consider(search, i, index, meeting_in(meetings, i), false, (chosen[i] != 0) & !left);
    }
}

static bool quadric_may_open(const struct quadric *quadric) {
    return unit_is_negative(quadric->square.x) || unit_is_negative(quadric->square.y) ||
           unit_is_negative(quadric->square.z);
}

static void find_all_stretches(const struct search_lanes *search, uint8_t index,
                               const struct quadric_lanes *lanes, const struct local_lanes *local,
                               bool may_open, struct quadric_intervals *found) {
    const struct primitive *primitive = &search->scene->primitives[index];
    const struct quadric *quadric = &search->scene->quadrics[primitive->index];
    const uint32_t bit = (uint32_t)1 << index;
    find_stretches(search, quadric, primitive->frame, lanes, local, found);
    if (may_open) {
        set_second(place_of(quadric->surface, QUADRIC_FACE), found);
    }
    if (quadric->cuts) {
        cut_by_box(search, bit, quadric, local, 0, found);
    }
    if (quadric->cuts && may_open) {
        cut_by_box(search, bit, quadric, local, 1, found);
    }
}

void search_quadric(struct search_lanes *search, uint8_t index, const struct quadric_lanes *lanes,
                    const struct local_lanes *local, const struct chosen_lanes *chosen) {
    const struct scene *scene = search->scene;
    const struct quadric *quadric = &scene->quadrics[scene->primitives[index].index];
    const uint32_t place = place_of(quadric->surface, QUADRIC_FACE), bit = (uint32_t)1 << index;
    const bool may_open = quadric_may_open(quadric);
    struct quadric_intervals found;
    struct meeting_lanes meetings;
    find_all_stretches(search, index, lanes, local, may_open, &found);
    if (chosen->leaving > 0) {
        if (may_open) {
            find_leaving(search, place, lanes, &found, true, &meetings);
        } else {
            find_leaving(search, place, lanes, &found, false, &meetings);
        }
        leave_quadric(search, index, &meetings, chosen->leave);
    }
    if (chosen->entering > 0) {
        find_entering(search, bit, lanes, &found, 0, &meetings);
        if (may_open) {
            struct meeting_lanes second;
            find_entering(search, bit, lanes, &found, 1, &second);
            prefer_first(&found, &second, &meetings);
        }
        enter_quadric(search, index, quadric, &meetings, chosen->enter);
    }
}
