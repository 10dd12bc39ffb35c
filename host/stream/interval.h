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

/* A crossing's primitive, with this bit where the primitive is left, not entered. */
#define CROSSED_LEAVING UINT32_C(0x80000000)

static inline uint32_t crossed_of(uint32_t primitive, bool leaving) {
    return leaving ? primitive | CROSSED_LEAVING : primitive;
}

static inline bool crossed_leaving(uint32_t crossed) {
    return crossed >= CROSSED_LEAVING;
}

static inline uint32_t crossed_primitive(uint32_t crossed) {
    return crossed % CROSSED_LEAVING;
}

/* An interval of a ray inside a primitive: see struct segment. */
struct interval {
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

/* Returns the interval that is all of a ray; place is that of face 0. */
static inline struct interval interval_everything(uint32_t place) {
    const struct interval all = {length_negate(LENGTH_FAR), LENGTH_FAR, place, place, true};
    return all;
}

static inline struct interval interval_entered(struct interval s, real_length t, uint32_t place) {
    bool later = length_less(s.in, t);
    s.in = later ? t : s.in;
    s.in_place = later ? place : s.in_place;
    return s;
}

static inline struct interval interval_left(struct interval s, real_length t, uint32_t place) {
    bool earlier = length_less(t, s.out);
    s.out = earlier ? t : s.out;
    s.out_place = earlier ? place : s.out_place;
    return s;
}

/* Finds where a ray leaves a single interval: leaving_crossing() of firmware/ray.c. */
static inline struct meeting meeting_leaving(struct interval s, real_length from) {
    const struct meeting meeting = {length_less(from, s.out) ? s.out : from, s.out_place, true};
    return meeting;
}

/* Finds where a ray enters a single interval: entering_crossing() of firmware/ray.c. */
static inline struct meeting meeting_entering(struct interval s, real_length from,
                                              bool starts_there) {
    bool in_front = length_less(from, s.in);
    bool begun = !starts_there & length_less(LENGTH_NOISE, length_subtract(s.out, from));
    const struct meeting meeting = {in_front ? s.in : from, s.in_place,
                                    s.hit & length_less(from, s.out) & (in_front | begun)};
    return meeting;
}

/* Finds where a ray leaves or enters an interval; inside is a constant at each call. */
static inline struct meeting meeting_of(struct interval s, real_length from, bool inside,
                                        bool starts_there) {
    return inside ? meeting_leaving(s, from) : meeting_entering(s, from, starts_there);
}

/* Finds where a ray leaves the interval that it is in. There is one interval, or two in order. */
static inline struct meeting meeting_leaving_two(struct interval a, struct interval b, bool two,
                                                 real_length from) {
    bool second = two & !length_less(from, a.out) &
                  !length_less(length_subtract(from, a.out), length_subtract(b.in, from));
    struct meeting first = meeting_leaving(a, from), last = meeting_leaving(b, from);
    const struct meeting meeting = {second ? last.t : first.t, second ? last.place : first.place,
                                    true};
    return meeting;
}

/* The two faces of a box across one axis: where on the axis they lie, and their places. */
struct slab {
    real_length low, high;
    uint32_t low_place, high_place;
};

/* Cuts an interval by a slab. inside and may_be_level are constants at each call. A ray that is
 * inside is asked only where it leaves, and mostly no ray of a block runs level. */
static inline struct interval interval_slab(struct interval s, struct slab slab, real_length origin,
                                            real_slope slope, bool level, bool falling,
                                            uint32_t start, bool inside, bool may_be_level) {
    real_length ahead_in = length_subtract(falling ? slab.high : slab.low, origin);
    real_length ahead_out = length_subtract(falling ? slab.low : slab.high, origin);
    uint32_t in_place = falling ? slab.high_place : slab.low_place;
    uint32_t out_place = falling ? slab.low_place : slab.high_place;
    real_length in = length_over(ahead_in, slope), out = length_over(ahead_out, slope);
    in = in_place >> 8 == start ? REAL_LENGTH(0.0) : in;
    out = out_place >> 8 == start ? (inside ? LENGTH_FAR : REAL_LENGTH(0.0)) : out;
    if (may_be_level) {
        bool within = !length_less(origin, slab.low) & length_less(origin, slab.high);
        in = level ? length_negate(LENGTH_FAR) : in;
        out = level ? LENGTH_FAR : out;
        s.hit = s.hit & (within | !level);
    }
    s = interval_left(s, out, out_place);
    return inside ? s : interval_entered(s, in, in_place);
}

#endif
