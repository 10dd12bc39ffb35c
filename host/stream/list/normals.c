/* SPDX-License-Identifier: MIT */
/* Normals for all lanes, each of another primitive. */
#include "stream/normals.h"

#include "solids.h"

/* Sets the normals of boxes along the world's axes; what it sets in other lanes is of no use. */
static void set_straight(const struct search_lanes *restrict search,
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

static void set_normal(struct direction_lanes *normal, int i, struct direction outward,
                       bool leaving) {
    struct direction turned = leaving ? direction_negate(outward) : outward;
    normal->x[i] = turned.x;
    normal->y[i] = turned.y;
    normal->z[i] = turned.z;
}

/* Lanes on balls, with the way from the centre of each. */
struct ball_ways {
    uint32_t is[LANES];
    struct point_lanes way;
};

static void normalise_balls(const struct search_lanes *restrict search,
                            const struct ball_ways *restrict balls,
                            struct direction_lanes *restrict normal) {
    for (int i = 0; i < LANES; i++) {
        struct direction u;
        real_length length;
        unit_normalise_lengths(balls->way.x[i], balls->way.y[i], balls->way.z[i], &u.x, &u.y, &u.z,
                               &length);
        struct direction inward = direction_negate(u);
        bool is = balls->is[i] != 0, leaving = crossed_leaving(search->crossed[i]);
        normal->x[i] = is ? (leaving ? inward.x : u.x) : normal->x[i];
        normal->y[i] = is ? (leaving ? inward.y : u.y) : normal->y[i];
        normal->z[i] = is ? (leaving ? inward.z : u.z) : normal->z[i];
    }
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
        balls.is[i] = 0;
        if (hit->is[i] == 0) {
            /* nothing */
        } else if (primitive->kind == PRIMITIVE_BALL) {
            way = point_subtract(where, scene->balls[primitive->index].centre);
            balls.is[i] = 1;
        } else if (primitive->kind != PRIMITIVE_BOX || primitive->frame != FRAME_WORLD) {
            struct direction outward =
                primitive_normal(scene, primitive, (uint8_t)(search->place[i] & 0xFF), &where);
            set_normal(&hit->normal, i, outward, crossed_leaving(crossed));
        }
        balls.way.x[i] = way.x;
        balls.way.y[i] = way.y;
        balls.way.z[i] = way.z;
    }
    normalise_balls(search, &balls, &hit->normal);
}
