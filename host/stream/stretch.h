/* SPDX-License-Identifier: MIT */
/* Where a ray runs inside a primitive, without a branch: firmware/solids.h and ray.c for a lane. */
#ifndef SUPERFRAME_STRETCH_H
#define SUPERFRAME_STRETCH_H

#include "scene.h"

/* A surface and a face of a primitive in one word. */
#define PLACE_NONE UINT32_C(0xFFFFFFFF)

static inline uint32_t place_of(uint32_t surface, uint32_t face) {
    return surface << 8 | face;
}

/* See struct segment. */
struct stretch {
    real_length in, out;
    uint32_t in_place, out_place;
    bool hit;
};

/* A crossing of one primitive. */
struct meeting {
    real_length t;
    uint32_t place;
    bool valid;
};

/* All of a ray; place is that of face 0. */
static inline struct stretch stretch_everything(uint32_t place) {
    const struct stretch all = {length_negate(LENGTH_FAR), LENGTH_FAR, place, place, true};
    return all;
}

static inline struct stretch stretch_entered(struct stretch s, real_length t, uint32_t place) {
    bool later = length_less(s.in, t);
    s.in = later ? t : s.in;
    s.in_place = later ? place : s.in_place;
    return s;
}

static inline struct stretch stretch_left(struct stretch s, real_length t, uint32_t place) {
    bool earlier = length_less(t, s.out);
    s.out = earlier ? t : s.out;
    s.out_place = earlier ? place : s.out_place;
    return s;
}

/* leaving_crossing() of firmware/ray.c for a single stretch. */
static inline struct meeting meeting_leaving(struct stretch s, real_length from) {
    const struct meeting meeting = {length_less(from, s.out) ? s.out : from, s.out_place, true};
    return meeting;
}

/* entering_crossing() of firmware/ray.c for a single stretch. */
static inline struct meeting meeting_entering(struct stretch s, real_length from,
                                              bool starts_there) {
    bool in_front = length_less(from, s.in);
    bool begun = !starts_there & length_less(LENGTH_NOISE, length_subtract(s.out, from));
    const struct meeting meeting = {in_front ? s.in : from, s.in_place,
                                    s.hit & length_less(from, s.out) & (in_front | begun)};
    return meeting;
}

static inline struct meeting meeting_of(struct stretch s, real_length from, bool inside,
                                        bool starts_there) {
    struct meeting leaving = meeting_leaving(s, from);
    struct meeting entering = meeting_entering(s, from, starts_there);
    struct meeting meeting = {inside ? leaving.t : entering.t,
                              inside ? leaving.place : entering.place, inside | entering.valid};
    return meeting;
}

/* Of two stretches in order: the ray leaves the one that it is in, and enters the first that is
 * ahead. */
static inline struct meeting meeting_of_two(struct stretch a, struct stretch b, real_length from,
                                            bool inside, bool starts_there) {
    bool second = b.hit & !length_less(from, a.out) &
                  !length_less(length_subtract(from, a.out), length_subtract(b.in, from));
    struct meeting first_left = meeting_leaving(a, from), second_left = meeting_leaving(b, from);
    struct meeting first = meeting_entering(a, from, starts_there);
    struct meeting last = meeting_entering(b, from, starts_there);
    real_length left = second ? second_left.t : first_left.t;
    uint32_t left_place = second ? second_left.place : first_left.place;
    real_length entered = first.valid ? first.t : last.t;
    uint32_t entered_place = first.valid ? first.place : last.place;
    const struct meeting meeting = {inside ? left : entered, inside ? left_place : entered_place,
                                    inside | first.valid | last.valid};
    return meeting;
}

/* One axis of a box; see box_axis(). */
struct slab {
    real_length low, high;
    uint32_t low_place, high_place;
};

static inline struct stretch stretch_slab(struct stretch s, const struct slab slab,
                                          real_length origin, real_slope slope, bool level,
                                          bool falling, uint32_t start, bool inside) {
    real_length to_low = length_over(length_subtract(slab.low, origin), slope);
    real_length to_high = length_over(length_subtract(slab.high, origin), slope);
    uint32_t in_place = falling ? slab.high_place : slab.low_place;
    uint32_t out_place = falling ? slab.low_place : slab.high_place;
    bool on_in = in_place >> 8 == start, on_out = out_place >> 8 == start;
    real_length near = falling ? to_high : to_low, far = falling ? to_low : to_high;
    real_length zero = REAL_LENGTH(0.0);
    near = on_in ? zero : near;
    far = on_out ? (inside ? LENGTH_FAR : zero) : far;
    near = level ? length_negate(LENGTH_FAR) : near;
    far = level ? LENGTH_FAR : far;
    bool within = !length_less(origin, slab.low) & length_less(origin, slab.high);
    s = stretch_left(s, far, out_place);
    s = stretch_entered(s, near, in_place);
    s.hit = s.hit & (within | !level);
    return s;
}

#endif
