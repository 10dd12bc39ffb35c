/* SPDX-License-Identifier: MIT */
/* The next crossing of each lane's ray, primitive by primitive. */
#include "search_solids.h"
#include "solids.h"

static const struct sloping sloping_unknown = {0, 0};

/* Makes slopes when a solid asks for them, on the axes that the solid is cut across. */
static void need_slopes(struct local_lanes *restrict local, struct sloping *sloping, uint8_t axes) {
    const real_unit *components[3] = {local->direction.x, local->direction.y, local->direction.z};
    for (int axis = 0; axis < 3; axis++) {
        const real_unit *u = components[axis];
        uint32_t levels = 0;
        if ((axes & ~sloping->known & 1 << axis) == 0) {
            continue;
        }
        for (int i = 0; i < LANES; i++) {
            bool level = unit_is_zero(u[i]);
            local->slope[axis][i] = slope_of(level ? REAL_UNIT(1.0) : u[i]);
            local->level[axis][i] = level ? 1 : 0;
            local->falling[axis][i] = unit_is_negative(u[i]) ? 1 : 0;
            levels |= local->level[axis][i];
        }
        sloping->known = (uint8_t)(sloping->known | 1 << axis);
        sloping->level = (uint8_t)(sloping->level | levels << axis);
    }
}

void search_begin(struct search_lanes *restrict search, struct set_memory *restrict memory) {
    search->world_sloping = sloping_unknown;
    for (int i = 0; i < SEARCH_VIEWS; i++) {
        search->frames[i] = FRAME_WORLD;
    }
    for (int i = 0; i < LANES; i++) {
        search->touch[i] = touches_of(memory, search->surface[i]);
    }
}

/* The primitives that all active lanes are inside of, and those that any active lane is inside
 * of. */
struct insides {
    uint32_t all, any;
};

static struct insides find_insides(const struct search_lanes *restrict search) {
    uint32_t all = ~(uint32_t)0, any = 0;
    for (int i = 0; i < LANES; i++) {
        all &= search->active[i] != 0 ? search->inside[i] : ~(uint32_t)0;
        any |= search->active[i] != 0 ? search->inside[i] : 0;
    }
    const struct insides insides = {all, any};
    return insides;
}

/* Returns, as a set, the primitive that a ray must be inside of to meet this one; an empty set:
 * none. */
static uint32_t enclosure_of(const struct search_lanes *search, uint8_t index) {
    const struct scene *scene = search->scene;
    uint8_t enclosure = scene->primitives[index].enclosure;
    uint32_t set = enclosure == ENCLOSURE_NONE ? 0 : (uint32_t)1 << enclosure;
    return search->shadows ? set & scene->shadow_primitives.word[0] : set;
}

/* Returns false where no lane can come to a primitive next, for a reason that all lanes share. */
static bool may_be_met(const struct search_lanes *search, uint8_t index, struct insides insides) {
    const struct scene *scene = search->scene;
    bool is_left_out = search->shadows && !set_has(&scene->shadow_primitives, index);
    uint32_t enclosure = enclosure_of(search, index);
    return !is_left_out && (insides.all & scene->hidden_by[index].word[0]) == 0 &&
           (insides.any & enclosure) == enclosure;
}

/* Chooses the lanes that may leave a primitive, and those that may enter it: may_be_next() of
 * firmware/ray.c for all lanes. */
static void choose_lanes(const struct search_lanes *restrict search, uint8_t index,
                         struct chosen_lanes *restrict chosen) {
    const struct scene *scene = search->scene;
    uint32_t bit = (uint32_t)1 << index;
    uint32_t hidden_by = scene->hidden_by[index].word[0];
    uint32_t enclosure = enclosure_of(search, index);
    uint32_t barred = scene->primitives[index].left_for_good ? bit : 0;
    uint32_t leaving = 0, entering = 0;
    for (int i = 0; i < LANES; i++) {
        uint32_t inside = search->inside[i];
        bool is_inside = (inside & bit) != 0;
        bool may = (search->active[i] != 0) & ((inside & hidden_by) == 0) &
                   ((inside & enclosure) == enclosure);
        bool may_leave = may & is_inside;
        bool may_enter = may & !is_inside & ((search->touch[i] & barred) == 0);
        chosen->leave[i] = may_leave ? 1 : 0;
        chosen->enter[i] = may_enter ? 1 : 0;
        leaving += chosen->leave[i];
        entering += chosen->enter[i];
    }
    chosen->leaving = leaving;
    chosen->entering = entering;
}

/* Returns the rays in a frame. The rays are turned once for all primitives of a frame, unless
 * another frame takes their place in between. */
static struct local_lanes *view_from(struct search_lanes *restrict search, uint8_t number) {
    if (number == FRAME_WORLD) {
        return &search->world;
    }
    struct local_lanes *restrict local = &search->views[number % SEARCH_VIEWS];
    const struct local_lanes *restrict world = &search->world;
    if (search->frames[number % SEARCH_VIEWS] == number) {
        return local;
    }
    const struct frame frame = search->scene->frames[number];
    search->frames[number % SEARCH_VIEWS] = number;
    for (int i = 0; i < LANES; i++) {
        const struct point origin = point_in(&world->origin, i);
        const struct direction direction = direction_in(&world->direction, i);
        struct point turned = turn_point(&frame, origin);
        local->origin.x[i] = turned.x;
        local->origin.y[i] = turned.y;
        local->origin.z[i] = turned.z;
        local->direction.x[i] = direction_dot(direction, frame.axis[0]);
        local->direction.y[i] = direction_dot(direction, frame.axis[1]);
        local->direction.z[i] = direction_dot(direction, frame.axis[2]);
    }
    search->sloping[number % SEARCH_VIEWS] = sloping_unknown;
    return local;
}

static struct sloping *sloping_of(struct search_lanes *search, uint8_t frame) {
    return frame == FRAME_WORLD ? &search->world_sloping : &search->sloping[frame % SEARCH_VIEWS];
}

static void search_primitive(struct search_lanes *search, uint8_t index,
                             const struct chosen_lanes *chosen) {
    const struct primitive *primitive = &search->scene->primitives[index];
    if (primitive->kind == PRIMITIVE_BALL) {
        search_ball(search, index, chosen);
    } else if (primitive->kind == PRIMITIVE_POLYHEDRON) {
        search_polyhedron(search, index, chosen);
    } else if (primitive->kind == PRIMITIVE_QUADRIC) {
        struct quadric_lanes quadric;
        if (quadric_meets(search, index, chosen, &quadric)) {
            struct local_lanes *local = view_from(search, primitive->frame);
            need_slopes(local, sloping_of(search, primitive->frame),
                        search->scene->quadrics[primitive->index].cuts);
            search_quadric(search, index, &quadric, local, chosen);
        }
    } else {
        struct local_lanes *local = view_from(search, primitive->frame);
        struct sloping *sloping = sloping_of(search, primitive->frame);
        need_slopes(local, sloping, 7);
        search_box(search, index, local, sloping->level != 0, chosen);
    }
}

void search_next(struct search_lanes *search, uint64_t *solid_tests) {
    const struct insides insides = find_insides(search);
    for (int i = 0; i < LANES; i++) {
        search->t[i] = LENGTH_FAR;
        search->place[i] = PLACE_NONE;
        search->crossed[i] = search->toggled[i] = 0;
    }
    for (uint8_t index = 0; index < search->scene->primitive_count; index++) {
        struct chosen_lanes chosen;
        if (!may_be_met(search, index, insides)) {
            continue;
        }
        choose_lanes(search, index, &chosen);
        if (chosen.leaving + chosen.entering > 0) {
            *solid_tests += chosen.leaving + chosen.entering;
            search_primitive(search, index, &chosen);
        }
    }
}
