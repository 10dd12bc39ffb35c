/* SPDX-License-Identifier: MIT */
/* The finish and the optics of boundaries: one pair of objects after the other. */
#include "borders.h"

#include <string.h>

#include "optics.h"

static void turn_points(struct point_lanes *restrict turned, const struct frame *frame,
                        const struct point_lanes *restrict world) {
    const struct frame f = *frame;
    for (int i = 0; i < LANES; i++) {
        const struct point there = point_in(world, i);
        struct point q = point_subtract(there, f.origin);
        turned->x[i] = point_dot(q, f.axis[0]);
        turned->y[i] = point_dot(q, f.axis[1]);
        turned->z[i] = point_dot(q, f.axis[2]);
    }
}

/* Adds the cells along one axis. */
static void add_cells(const real_length where[restrict LANES], real_length origin, real_length size,
                      uint32_t odd[restrict LANES]) {
    for (int i = 0; i < LANES; i++) {
        bool is_odd = length_cell_is_odd(length_subtract(where[i], origin), size);
        odd[i] ^= is_odd ? 1 : 0;
    }
}

/* Adds 1 where the pattern has its other colour: colour_at() of firmware/shade.c. */
static void find_cells(const struct scene *scene, const struct pattern *pattern,
                       const struct point_lanes *where, uint32_t odd[LANES]) {
    struct point_lanes turned;
    const struct point_lanes *place = where;
    if (pattern->frame != FRAME_WORLD) {
        turn_points(&turned, &scene->frames[pattern->frame], where);
        place = &turned;
    }
    if (pattern->axes & 1) {
        add_cells(place->x, pattern->origin.x, pattern->size.x, odd);
    }
    if (pattern->axes & 2) {
        add_cells(place->y, pattern->origin.y, pattern->size.y, odd);
    }
    if (pattern->axes & 4) {
        add_cells(place->z, pattern->origin.z, pattern->size.z, odd);
    }
}

/* What is the same wherever two objects meet. */
struct meeting_place {
    struct colours own, own_ambient;     /* Ic and the ambient term */
    struct colours other, other_ambient; /* of the pattern's odd cells */
    const struct pattern *pattern;       /* NULL: none */
    real_energy diffuse, specular;
    uint32_t gloss;
    real_index eta, n;
    bool bends, clear;
};

static struct colours ambient_of(const struct material *material, struct colours colour) {
    return colours_add(material->ambient, colours_scaled(colour, material->ambient_share));
}

static struct meeting_place meeting_place(const struct scene *scene, uint32_t before,
                                          uint32_t after) {
    const struct material *near = &scene->materials[scene->objects[before].material];
    const struct material *far = &scene->materials[scene->objects[after].material];
    /* Whose surface it is: set_materials() of firmware/growth.c. */
    bool near_owns = near->transparent != far->transparent ? far->transparent : before > after;
    const struct material *owner = near_owns ? near : far;
    const struct pattern *pattern =
        owner->pattern == PATTERN_NONE ? 0 : &scene->patterns[owner->pattern];
    struct colours other = pattern ? pattern->colour : owner->colour;
    const struct meeting_place place = {owner->colour,
                                        ambient_of(owner, owner->colour),
                                        other,
                                        ambient_of(owner, other),
                                        pattern,
                                        owner->diffuse,
                                        owner->specular,
                                        owner->gloss,
                                        index_product(near->ior[0], far->inverse_ior[0]),
                                        index_product(far->ior[0], near->inverse_ior[0]),
                                        near->optical != far->optical,
                                        owner->transparent};
    return place;
}

/* fresh: there is nothing yet, and the other lanes get 0. */
static void apply_place(const struct meeting_place place, const uint32_t here[restrict LANES],
                        const uint32_t odd[restrict LANES], bool fresh,
                        struct border_lanes *restrict border) {
    const real_colour black = REAL_COLOUR(0.0);
    const real_energy none = REAL_ENERGY(0.0);
    const real_index nought = REAL_INDEX(0.0);
    for (int i = 0; i < LANES; i++) {
        bool is = here[i] != 0, is_odd = odd[i] != 0;
        struct colours colour = {is_odd ? place.other.red : place.own.red,
                                 is_odd ? place.other.green : place.own.green,
                                 is_odd ? place.other.blue : place.own.blue};
        struct colours ambient = {is_odd ? place.other_ambient.red : place.own_ambient.red,
                                  is_odd ? place.other_ambient.green : place.own_ambient.green,
                                  is_odd ? place.other_ambient.blue : place.own_ambient.blue};
        border->colour.red[i] = is ? colour.red : fresh ? black : border->colour.red[i];
        border->colour.green[i] = is ? colour.green : fresh ? black : border->colour.green[i];
        border->colour.blue[i] = is ? colour.blue : fresh ? black : border->colour.blue[i];
        border->ambient.red[i] = is ? ambient.red : fresh ? black : border->ambient.red[i];
        border->ambient.green[i] = is ? ambient.green : fresh ? black : border->ambient.green[i];
        border->ambient.blue[i] = is ? ambient.blue : fresh ? black : border->ambient.blue[i];
        border->diffuse[i] = is ? place.diffuse : fresh ? none : border->diffuse[i];
        border->specular[i] = is ? place.specular : fresh ? none : border->specular[i];
        border->gloss[i] = is ? place.gloss : fresh ? 0 : border->gloss[i];
        border->eta[i] = is ? place.eta : fresh ? nought : border->eta[i];
        border->n[i] = is ? place.n : fresh ? nought : border->n[i];
        border->bends[i] = is ? place.bends : fresh ? 0 : border->bends[i];
        border->clear[i] = is ? place.clear : fresh ? 0 : border->clear[i];
    }
}

void borders_find(const struct scene *scene, const struct hit_lanes *restrict hit,
                  struct border_lanes *restrict border) {
    uint32_t left[LANES], here[LANES], odd[LANES];
    bool fresh = true;
    border->gloss_most = 0;
    for (int i = 0; i < LANES; i++) {
        left[i] = hit->is[i];
    }
    for (uint64_t set = lanes_set(left); set != 0; set = lanes_set(left)) {
        uint32_t first = lanes_first(set);
        uint32_t before = hit->before[first], after = hit->after[first];
        struct meeting_place place = meeting_place(scene, before, after);
        for (int i = 0; i < LANES; i++) {
            bool same = (hit->before[i] == before) & (hit->after[i] == after);
            here[i] = same ? left[i] : 0;
            left[i] = same ? 0 : left[i];
            odd[i] = 0;
        }
        if (place.pattern) {
            find_cells(scene, place.pattern, &hit->where, odd);
        }
        apply_place(place, here, odd, fresh, border);
        fresh = false;
        border->gloss_most = place.gloss > border->gloss_most ? place.gloss : border->gloss_most;
    }
    if (fresh) {
        memset(border, 0, sizeof *border);
    }
}
