/* SPDX-License-Identifier: MIT */
/* Normals for all lanes, each of another primitive. */
#include "stream/normals.h"

#include "solids.h"
#include "stream/lane_normals.h"

/* Lanes on balls, with the way from the centre of each. */
struct ball_ways {
    uint32_t is[LANES];
    struct point_lanes way;
};

static void normalise_balls(const struct search_lanes *restrict search,
                            const struct ball_ways *restrict balls,
                            struct direction_lanes *restrict normal) {
    for (int i = 0; i < LANES; i++) {
        struct direction outward;
        real_length length;
        unit_normalise_lengths(balls->way.x[i], balls->way.y[i], balls->way.z[i], &outward.x,
                               &outward.y, &outward.z, &length);
        set_normal(normal, i, balls->is[i] != 0, outward, crossed_leaving(search->crossed[i]));
    }
}

static bool is_straight(const struct primitive *primitive) {
    return primitive->kind == PRIMITIVE_BOX && primitive->frame == FRAME_WORLD;
}

/* Finds the normals of balls for all lanes at once. What is neither a ball nor a box along the axes
 * is asked one by one. */
void normals_find(const struct search_lanes *restrict search, struct hit_lanes *restrict hit) {
    const struct scene *scene = search->scene;
    struct ball_ways balls;
    set_straight(search, &hit->normal);
    for (int i = 0; i < LANES; i++) {
        const uint32_t crossed = search->crossed[i];
        const struct primitive *primitive = &scene->primitives[crossed_primitive(crossed)];
        const struct point where = point_in(&hit->where, i);
        struct point way = {REAL_LENGTH(1.0), REAL_LENGTH(0.0), REAL_LENGTH(0.0)};
        const bool is_ball = hit->is[i] != 0 && primitive->kind == PRIMITIVE_BALL;
        if (is_ball) {
            way = point_subtract(where, scene->balls[primitive->index].centre);
        } else if (hit->is[i] != 0 && !is_straight(primitive)) {
            const uint8_t face = (uint8_t)(search->place[i] & 0xFF);
            set_normal(&hit->normal, i, true, primitive_normal(scene, primitive, face, &where),
                       crossed_leaving(crossed));
        }
        balls.is[i] = is_ball ? 1 : 0;
        balls.way.x[i] = way.x;
        balls.way.y[i] = way.y;
        balls.way.z[i] = way.z;
    }
    normalise_balls(search, &balls, &hit->normal);
}
