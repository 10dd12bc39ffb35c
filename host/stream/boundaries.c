/* SPDX-License-Identifier: MIT */
/* The finish and the optics of boundaries: one pair of materials after the other. */
#include "stream/boundaries.h"

#include <string.h>

#include "optics.h"

/* Finds out which cells along one axis are odd. */
static void find_odd(const real_length where[restrict LANES], real_length origin, real_length size,
                     uint32_t odd[restrict LANES]) {
    for (int i = 0; i < LANES; i++) {
        odd[i] = length_cell_is_odd(length_subtract(where[i], origin), size) ? 1 : 0;
    }
}

/* Corrects the cells of lanes on a face in which cells end: face_is_odd() of firmware/shade.c. */
static void set_odd_on_face(const struct pattern_face face, const uint32_t surface[restrict LANES],
                            const real_unit normal[restrict LANES], bool is_behind,
                            uint32_t odd[restrict LANES]) {
    const uint32_t from_below = is_behind ? face.odd_above : face.odd_below;
    const uint32_t from_above = is_behind ? face.odd_below : face.odd_above;
    for (int i = 0; i < LANES; i++) {
        uint32_t there = unit_is_negative(normal[i]) ? from_below : from_above;
        odd[i] = surface[i] == face.surface ? there : odd[i];
    }
}

/* Finds the lanes where the pattern has its other colour; `odd` is all 0 before. See colour_at() of
 * firmware/shade.c. is_behind: the material with the pattern is behind the boundary. */
static void find_cells(const struct scene *scene, const struct pattern *pattern,
                       const struct hit_lanes *hit, bool is_behind, uint32_t odd[LANES]) {
    const real_length *where[3] = {hit->where.x, hit->where.y, hit->where.z};
    const real_unit *normal[3] = {hit->normal.x, hit->normal.y, hit->normal.z};
    const real_length origin[3] = {pattern->origin.x, pattern->origin.y, pattern->origin.z};
    const real_length size[3] = {pattern->size.x, pattern->size.y, pattern->size.z};
    for (int axis = 0; axis < 3; axis++) {
        uint32_t cells[LANES];
        if ((pattern->axes >> axis & 1) == 0) {
            continue;
        }
        find_odd(where[axis], origin[axis], size[axis], cells);
        for (run_count j = 0; j < pattern->face_count; j++) {
            const struct pattern_face face = scene->pattern_faces[pattern->first_face + j];
            if (face.axis == axis) {
                set_odd_on_face(face, hit->surface, normal[axis], is_behind, cells);
            }
        }
        for (int i = 0; i < LANES; i++) {
            odd[i] ^= cells[i];
        }
    }
}

/* Of a pair of materials, the near one below: the near one's object is the later one. */
enum { NEAR_IS_LATER = 0x10000 };

/* What is the same wherever the same two materials meet. */
struct meeting_place {
    struct colours own, own_ambient;     /* Ic and the ambient term */
    struct colours other, other_ambient; /* of the pattern's odd cells */
    const struct pattern *pattern;       /* NULL: none */
    bool is_behind;                      /* these are of the far side's material */
    real_energy diffuse, specular;
    uint32_t gloss;
    real_index eta, n;
    bool bends, clear;
};

static struct colours ambient_of(const struct material *material, struct colours colour) {
    return colours_add(material->ambient, colours_scaled(colour, material->ambient_share));
}

/* Returns what is the same wherever two materials meet, the near one's object being the later one
 * of the table or not. */
static struct meeting_place meeting_place(const struct scene *scene, uint32_t before,
                                          uint32_t after, bool near_is_later) {
    const struct material *near = &scene->materials[before];
    const struct material *far = &scene->materials[after];
    /* Whose surface it is: set_materials() of firmware/growth.c. */
    bool near_owns = near->transparent != far->transparent ? far->transparent : near_is_later;
    const struct material *owner = near_owns ? near : far;
    const struct pattern *pattern =
        owner->pattern == PATTERN_NONE ? 0 : &scene->patterns[owner->pattern];
    struct colours other = pattern ? pattern->colour : owner->colour;
    const struct meeting_place place = {owner->colour,
                                        ambient_of(owner, owner->colour),
                                        other,
                                        ambient_of(owner, other),
                                        pattern,
                                        !near_owns,
                                        owner->diffuse,
                                        owner->specular,
                                        owner->gloss,
                                        index_product(near->ior[0], far->inverse_ior[0]),
                                        index_product(far->ior[0], near->inverse_ior[0]),
                                        near->optical != far->optical,
                                        owner->transparent};
    return place;
}

/* Gives what a meeting place says to the lanes that are `here`. fresh: *boundary holds nothing yet,
 * and the other lanes get 0. */
static void apply_place(const struct meeting_place place, const uint32_t here[restrict LANES],
                        const uint32_t odd[restrict LANES], bool fresh,
                        struct boundary_lanes *restrict boundary) {
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
        boundary->colour.red[i] = is ? colour.red : fresh ? black : boundary->colour.red[i];
        boundary->colour.green[i] = is ? colour.green : fresh ? black : boundary->colour.green[i];
        boundary->colour.blue[i] = is ? colour.blue : fresh ? black : boundary->colour.blue[i];
        boundary->ambient.red[i] = is ? ambient.red : fresh ? black : boundary->ambient.red[i];
        boundary->ambient.green[i] = is      ? ambient.green
                                     : fresh ? black
                                             : boundary->ambient.green[i];
        boundary->ambient.blue[i] = is ? ambient.blue : fresh ? black : boundary->ambient.blue[i];
        boundary->diffuse[i] = is ? place.diffuse : fresh ? none : boundary->diffuse[i];
        boundary->specular[i] = is ? place.specular : fresh ? none : boundary->specular[i];
        boundary->gloss[i] = is ? place.gloss : fresh ? 0 : boundary->gloss[i];
        boundary->eta[i] = is ? place.eta : fresh ? nought : boundary->eta[i];
        boundary->n[i] = is ? place.n : fresh ? nought : boundary->n[i];
        boundary->bends[i] = is ? place.bends : fresh ? 0 : boundary->bends[i];
        boundary->clear[i] = is ? place.clear : fresh ? 0 : boundary->clear[i];
    }
}

void boundaries_find(const struct scene *scene, const struct hit_lanes *restrict hit,
                     struct boundary_lanes *restrict boundary) {
    uint32_t left[LANES], here[LANES], odd[LANES], pair[LANES];
    bool fresh = true;
    boundary->gloss_most = 0;
    for (int i = 0; i < LANES; i++) {
        left[i] = hit->is[i];
        pair[i] = hit->material_before[i] | hit->material_after[i] << 8 |
                  (hit->before[i] > hit->after[i] ? NEAR_IS_LATER : 0);
    }
    for (uint64_t set = lanes_set(left); set != 0; set = lanes_set(left)) {
        uint32_t first = lanes_first(set);
        uint32_t those = pair[first];
        struct meeting_place place =
            meeting_place(scene, those & 0xFF, those >> 8 & 0xFF, (those & NEAR_IS_LATER) != 0);
        for (int i = 0; i < LANES; i++) {
            bool same = pair[i] == those;
            here[i] = same ? left[i] : 0;
            left[i] = same ? 0 : left[i];
            odd[i] = 0;
        }
        if (place.pattern) {
            find_cells(scene, place.pattern, hit, place.is_behind, odd);
        }
        apply_place(place, here, odd, fresh, boundary);
        fresh = false;
        boundary->gloss_most =
            place.gloss > boundary->gloss_most ? place.gloss : boundary->gloss_most;
    }
    if (fresh) {
        memset(boundary, 0, sizeof *boundary);
    }
}
