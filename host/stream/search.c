/* SPDX-License-Identifier: MIT */
/* The next crossing of each lane's ray, primitive by primitive. */
#include "search_solids.h"

static void set_slopes(struct local_lanes *local) {
    const real_unit *components[3] = {local->direction.x, local->direction.y, local->direction.z};
    for (int axis = 0; axis < 3; axis++) {
        const real_unit *u = components[axis];
        for (int i = 0; i < LANES; i++) {
            bool level = unit_is_zero(u[i]);
            local->slope[axis][i] = slope_of(level ? REAL_UNIT(1.0) : u[i]);
            local->level[axis][i] = level ? 1 : 0;
            local->falling[axis][i] = unit_is_negative(u[i]) ? 1 : 0;
        }
    }
}

void search_begin(struct search_lanes *search) {
    const struct scene *scene = search->scene;
    set_slopes(&search->world);
    for (int i = 0; i < LANES; i++) {
        uint32_t surface = search->surface[i];
        search->touch[i] = surface == SURFACE_NONE ? 0 : scene->surfaces[surface].word[0];
    }
}

/* may_be_next() of firmware/ray.c for all lanes: whether any may. */
static bool choose_lanes(const struct search_lanes *search, uint8_t index, uint32_t chosen[LANES],
                         uint32_t *solid_tests) {
    const struct scene *scene = search->scene;
    const struct primitive *primitive = &scene->primitives[index];
    uint32_t bit = (uint32_t)1 << index;
    bool all = search->shadows;
    uint32_t enclosed = all ? 0 : scene->enclosed[index].word[0];
    uint32_t enclosure = all || primitive->enclosure == ENCLOSURE_NONE
                             ? 0
                             : (uint32_t)1 << primitive->enclosure;
    uint32_t barred = primitive->left_for_good ? bit : 0;
    uint32_t count = 0;
    if (all && !set_has(&scene->shadow_primitives, index)) {
        return false;
    }
    for (int i = 0; i < LANES; i++) {
        uint32_t inside = search->inside[i];
        bool may_leave = (inside & enclosed) == 0;
        bool may_enter = ((inside & enclosure) == enclosure) & ((search->touch[i] & barred) == 0);
        bool may = (inside & bit) != 0 ? may_leave : may_enter;
        chosen[i] = may ? search->active[i] : 0;
        count += chosen[i];
    }
    *solid_tests += count;
    return count > 0;
}

/* The rays in a primitive's own frame. */
static void turn_lanes(struct local_lanes *restrict local, const struct frame *frame,
                       const struct local_lanes *restrict world) {
    const struct frame f = *frame;
    for (int i = 0; i < LANES; i++) {
        const struct point origin = {world->origin.x[i], world->origin.y[i], world->origin.z[i]};
        const struct direction direction = {world->direction.x[i], world->direction.y[i],
                                            world->direction.z[i]};
        struct point p = point_subtract(origin, f.origin);
        local->origin.x[i] = point_dot(p, f.axis[0]);
        local->origin.y[i] = point_dot(p, f.axis[1]);
        local->origin.z[i] = point_dot(p, f.axis[2]);
        local->direction.x[i] = direction_dot(direction, f.axis[0]);
        local->direction.y[i] = direction_dot(direction, f.axis[1]);
        local->direction.z[i] = direction_dot(direction, f.axis[2]);
    }
}

static void search_primitive(struct search_lanes *search, uint8_t index,
                             const uint32_t chosen[LANES]) {
    const struct scene *scene = search->scene;
    const struct primitive *primitive = &scene->primitives[index];
    const struct local_lanes *local = &search->world;
    struct local_lanes turned;
    if (primitive->kind == PRIMITIVE_BALL) {
        search_ball(search, index, chosen);
        return;
    }
    if (primitive->kind == PRIMITIVE_POLYHEDRON) {
        search_polyhedron(search, index, chosen);
        return;
    }
    if (primitive->frame != FRAME_WORLD) {
        turn_lanes(&turned, &scene->frames[primitive->frame], &search->world);
        local = &turned;
    }
    if (primitive->kind == PRIMITIVE_QUADRIC) {
        search_quadric(search, index, local, chosen);
        return;
    }
    if (local == &turned) {
        set_slopes(&turned);
    }
    search_box(search, index, local, chosen);
}

void search_next(struct search_lanes *search, uint32_t *solid_tests) {
    for (int i = 0; i < LANES; i++) {
        search->t[i] = LENGTH_FAR;
        search->place[i] = PLACE_NONE;
        search->primitive[i] = search->leaving[i] = search->toggled[i] = 0;
    }
    for (uint8_t index = 0; index < search->scene->primitive_count; index++) {
        uint32_t chosen[LANES];
        if (choose_lanes(search, index, chosen, solid_tests)) {
            search_primitive(search, index, chosen);
        }
    }
}
