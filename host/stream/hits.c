/* SPDX-License-Identifier: MIT */
/* Place, normal and mirror direction of each lane's boundary. */
#include "hits.h"

#include "optics.h"
#include "solids.h"

static void set_places(const struct search_lanes *restrict search, struct hit_lanes *restrict hit) {
    for (int i = 0; i < LANES; i++) {
        const struct point origin = {search->world.origin.x[i], search->world.origin.y[i],
                                     search->world.origin.z[i]};
        const struct direction direction = {search->world.direction.x[i],
                                            search->world.direction.y[i],
                                            search->world.direction.z[i]};
        struct point where = point_along(origin, search->t[i], direction);
        hit->t[i] = search->t[i];
        hit->where.x[i] = where.x;
        hit->where.y[i] = where.y;
        hit->where.z[i] = where.z;
        hit->surface[i] = hit->is[i] != 0 ? search->place[i] >> 8 : SURFACE_NONE;
        hit->inside_before[i] = search->inside[i];
        hit->inside_after[i] = search->inside[i] ^ search->toggled[i];
    }
}

/* As if all primitives were boxes that lie straight in the world. */
static void set_box_normals(const struct search_lanes *restrict search,
                            struct direction_lanes *restrict normal) {
    const real_unit none = REAL_UNIT(0.0), one = REAL_UNIT(1.0), back = REAL_UNIT(-1.0);
    for (int i = 0; i < LANES; i++) {
        uint32_t face = search->place[i] & 0xFF;
        uint32_t low = face < 3 ? 1 : 0, leaving = search->crossed[i] & 1;
        uint32_t axis = face < 3 ? face : face - 3;
        real_unit outward = (low ^ leaving) != 0 ? back : one;
        normal->x[i] = axis == 0 ? outward : none;
        normal->y[i] = axis == 1 ? outward : none;
        normal->z[i] = axis == 2 ? outward : none;
    }
}

static bool lies_straight(const struct primitive *primitive) {
    return primitive->kind == PRIMITIVE_BOX && primitive->frame == FRAME_WORLD;
}

static void set_other_normals(const struct search_lanes *search, struct hit_lanes *hit) {
    const struct scene *scene = search->scene;
    for (int i = 0; i < LANES; i++) {
        const struct primitive *primitive = &scene->primitives[search->crossed[i] >> 1];
        if (!hit->is[i] || lies_straight(primitive)) {
            continue;
        }
        const struct point where = {hit->where.x[i], hit->where.y[i], hit->where.z[i]};
        struct direction normal =
            primitive_normal(scene, primitive, (uint8_t)(search->place[i] & 0xFF), where);
        normal = search->crossed[i] & 1 ? direction_negate(normal) : normal;
        hit->normal.x[i] = normal.x;
        hit->normal.y[i] = normal.y;
        hit->normal.z[i] = normal.z;
    }
}

static void set_mirrored(const struct search_lanes *restrict search,
                         struct hit_lanes *restrict hit) {
    for (int i = 0; i < LANES; i++) {
        const struct direction d = {search->world.direction.x[i], search->world.direction.y[i],
                                    search->world.direction.z[i]};
        const struct direction normal = {hit->normal.x[i], hit->normal.y[i], hit->normal.z[i]};
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
    set_box_normals(search, &hit->normal);
    set_other_normals(search, hit);
    set_mirrored(search, hit);
}
