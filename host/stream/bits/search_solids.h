/* SPDX-License-Identifier: MIT */
/* The search's step for one primitive: one function a kind. */
#ifndef SUPERFRAME_SEARCH_SOLIDS_H
#define SUPERFRAME_SEARCH_SOLIDS_H

#include "search.h"
#include "stream/interval.h"

/* The lanes that may leave a primitive and those that may enter it, as 1 or 0, and how many they
 * are. Rays of one object are mostly all on one side: each step knows one side alone. */
struct chosen_lanes {
    uint32_t leave[LANES], enter[LANES];
    uint32_t leaving, entering;
};

/* Compares the chosen lanes' crossings with primitive `index` to the best so far, and keeps the
 * better. local holds the rays in the primitive's frame. */
void search_box(struct search_lanes *search, uint8_t index, const struct local_lanes *local,
                bool any_level, const struct chosen_lanes *chosen);
void search_ball(struct search_lanes *search, uint8_t index, const struct chosen_lanes *chosen);
void search_polyhedron(struct search_lanes *search, uint8_t index,
                       const struct chosen_lanes *chosen);

/* Where the lanes' rays are nearest to a quadric's centre: points from the centre, and distances
 * along the rays. */
struct quadric_lanes {
    struct point_lanes foot;
    real_length nearest[LANES];
    uint32_t passes[LANES]; /* 1: beyond the quadric's reach */
};

/* Fills in *quadric; false where the chosen lanes all pass by, from outside: nothing is to be done
 * then. Rays need not be turned into the quadric's frame first. */
bool quadric_meets(const struct search_lanes *search, uint8_t index,
                   const struct chosen_lanes *chosen, struct quadric_lanes *quadric);
void search_quadric(struct search_lanes *search, uint8_t index, const struct quadric_lanes *lanes,
                    const struct local_lanes *local, const struct chosen_lanes *chosen);

/* The slabs of a box. */
struct slabs {
    struct slab x, y, z;
};

static inline struct slabs slabs_of(const struct box *box) {
    const uint16_t *surface = box->surface;
    const struct slabs slabs = {
        {box->minimum.x, box->maximum.x, place_of(surface[0], 0), place_of(surface[3], 3)},
        {box->minimum.y, box->maximum.y, place_of(surface[1], 1), place_of(surface[4], 4)},
        {box->minimum.z, box->maximum.z, place_of(surface[2], 2), place_of(surface[5], 5)}};
    return slabs;
}

/* Compares one lane's crossing with a primitive to the best so far, and keeps the better, as
 * next_crossing() of firmware/ray.c does. */
static inline void search_consider(struct search_lanes *restrict search, int i, uint32_t index,
                                   struct meeting found, bool leaving, bool chosen) {
    uint32_t bit = (uint32_t)1 << index;
    real_length best = search->t[i];
    uint32_t place = search->place[i], toggled = search->toggled[i];
    bool valid = chosen & found.valid & length_less(found.t, LENGTH_FAR);
    bool same = (found.place ^ place) >> 8 == 0;
    bool near = length_less(found.t, length_add(best, LENGTH_NOISE)) &
                length_less(best, length_add(found.t, LENGTH_NOISE));
    bool coincide = valid & same & near;
    bool precedes = leaving ? !length_less(best, found.t) : length_less(found.t, best);
    bool better = valid & !(same & near) & precedes;
    search->t[i] = better ? found.t : best;
    search->place[i] = better ? found.place : place;
    search->crossed[i] = better ? crossed_of(index, leaving) : search->crossed[i];
    search->toggled[i] = better ? bit : toggled | (coincide ? bit : 0);
}

#endif
