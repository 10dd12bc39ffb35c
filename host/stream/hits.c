/* SPDX-License-Identifier: MIT */
/* Place, normal and mirror direction of each lane's boundary. */
#include "stream/hits.h"

#include "optics.h"
#include "stream/normals.h"

static void set_places(const struct search_lanes *restrict search, struct hit_lanes *restrict hit) {
    for (int i = 0; i < LANES; i++) {
        const struct point origin = point_in(&search->world.origin, i);
        const struct direction direction = direction_in(&search->world.direction, i);
        struct point where = point_along(origin, search->t[i], direction);
        hit->t[i] = search->t[i];
        hit->where.x[i] = where.x;
        hit->where.y[i] = where.y;
        hit->where.z[i] = where.z;
        hit->surface[i] = hit->is[i] != 0 ? search->place[i] >> 8 : SURFACE_NONE;
        hit->inside_before[i] = search->inside[i];
    }
}

static void set_mirrored(const struct search_lanes *restrict search,
                         struct hit_lanes *restrict hit) {
    for (int i = 0; i < LANES; i++) {
        const struct direction d = direction_in(&search->world.direction, i);
        const struct direction normal = direction_in(&hit->normal, i);
        real_unit cosine = incidence_cosine(d, normal);
        struct direction mirrored = mirror_direction(d, cosine, normal);
        hit->cosine[i] = cosine;
        hit->mirrored.x[i] = mirrored.x;
        hit->mirrored.y[i] = mirrored.y;
        hit->mirrored.z[i] = mirrored.z;
    }
}

void hits_describe(const struct search_lanes *search, struct hit_lanes *hit) {
    set_places(search, hit);
    normals_find(search, hit);
    set_mirrored(search, hit);
}
