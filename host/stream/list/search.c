/* SPDX-License-Identifier: MIT */
/* The next crossing of each lane's ray, one ray after the other. Each goes its own way through the
 * hierarchies of bounds, as in the image's rows. */
#include "search.h"

#include "sets/list/walk.h"

void search_begin(struct search_lanes *restrict search, struct set_memory *restrict memory) {
    struct world_lanes *restrict world = &search->world;
    const real_unit *components[3] = {world->direction.x, world->direction.y, world->direction.z};
    search->memory = memory;
    for (int i = 0; i < LANES; i++) {
        world->level[i] = world->falling[i] = 0;
    }
    for (int axis = 0; axis < 3; axis++) {
        const real_unit *restrict u = components[axis];
        for (int i = 0; i < LANES; i++) {
            bool level = unit_is_zero(u[i]);
            world->slope[axis][i] = slope_of(level ? REAL_UNIT(1.0) : u[i]);
            world->level[i] |= (level ? 1u : 0u) << axis;
            world->falling[i] |= (unit_is_negative(u[i]) ? 1u : 0u) << axis;
        }
    }
}

static void set_view(const struct search_lanes *restrict search, int lane,
                     struct search *restrict one) {
    struct local_ray *view = &one->views[VIEW_WORLD];
    view->origin = point_in(&search->world.origin, lane);
    view->direction = direction_in(&search->world.direction, lane);
    for (int axis = 0; axis < 3; axis++) {
        view->slope[axis] = search->world.slope[axis][lane];
    }
    view->level = (uint8_t)search->world.level[lane];
    view->falling = (uint8_t)search->world.falling[lane];
    for (uint8_t i = VIEW_WORLD + 1; i < VIEWS; i++) {
        one->views[i].frame = FRAME_WORLD;
    }
}

static void search_lane(struct search_lanes *search, int lane, struct render_counts *counts) {
    struct search one;
    struct crossing crossing;
    crossed_set toggled;
    one.scene = search->scene;
    one.shadows = search->shadows;
    one.surface = search->surface[lane];
    set_view(search, lane, &one);
    if (!next_crossing(&one, set_numbered(search->memory, search->inside[lane]), search->from[lane],
                       &crossing, &toggled, counts)) {
        return;
    }
    search->t[lane] = crossing.t;
    search->place[lane] = place_of(crossing.surface, crossing.face);
    search->crossed[lane] = crossed_of(crossing.primitive, crossing.leaving);
    search->behind[lane] = set_behind(search->memory, search->inside[lane], &toggled);
}

void search_next(struct search_lanes *search, uint64_t *solid_tests) {
    struct render_counts counts = {0};
    for (int i = 0; i < LANES; i++) {
        search->t[i] = LENGTH_FAR;
        search->place[i] = PLACE_NONE;
        search->crossed[i] = 0;
        search->behind[i] = search->inside[i];
    }
    for (int i = 0; i < LANES; i++) {
        if (search->active[i] != 0) {
            search_lane(search, i, &counts);
        }
    }
    *solid_tests += counts.solid_tests;
}
