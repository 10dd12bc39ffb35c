/* SPDX-License-Identifier: MIT */
/* Normals of lanes: what both forms of sets do alike. */
#ifndef SUPERFRAME_LANE_NORMALS_H
#define SUPERFRAME_LANE_NORMALS_H

#include "search.h"

/* Puts a normal into lane i where `is` is true, turned round where the primitive is left. */
static inline void set_normal(struct direction_lanes *normal, int i, bool is,
                              struct direction outward, bool leaving) {
    struct direction inward = direction_negate(outward);
    real_unit x = leaving ? inward.x : outward.x;
    real_unit y = leaving ? inward.y : outward.y;
    real_unit z = leaving ? inward.z : outward.z;
    normal->x[i] = is ? x : normal->x[i];
    normal->y[i] = is ? y : normal->y[i];
    normal->z[i] = is ? z : normal->z[i];
}

/* Sets the normals of flat faces across the world's axes, in all lanes. */
static inline void set_straight(const struct search_lanes *restrict search,
                                struct direction_lanes *restrict normal) {
    const real_unit none = REAL_UNIT(0.0), high = REAL_UNIT(1.0), low = REAL_UNIT(-1.0);
    for (int i = 0; i < LANES; i++) {
        uint32_t face = search->place[i] & 0xFF;
        bool inwards = (face < 3) ^ crossed_leaving(search->crossed[i]);
        real_unit along = inwards ? low : high;
        normal->x[i] = ((face == 0) | (face == 3)) ? along : none;
        normal->y[i] = ((face == 1) | (face == 4)) ? along : none;
        normal->z[i] = ((face == 2) | (face == 5)) ? along : none;
    }
}

#endif
