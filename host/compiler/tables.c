/* SPDX-License-Identifier: MIT */
/* The tables of a compiled scene as data: their sets, and their memory. */
#include "compiler/tables.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/grow.h"

/* ---- Sets ----------------------------------------------------------------------------------- */

/* Returns how many members of a set are less than a primitive. */
static uint32_t members_below(const struct compiled_set *set, uint32_t primitive) {
    uint32_t low = 0, high = set->count;
    while (low < high) {
        uint32_t middle = low + (high - low) / 2;
        if (set->members[middle] < primitive) {
            low = middle + 1;
        } else {
            high = middle;
        }
    }
    return low;
}

bool compiled_set_has(const struct compiled_set *set, uint32_t primitive) {
    uint32_t place = members_below(set, primitive);
    return place < set->count && set->members[place] == primitive;
}

bool compiled_set_include(struct compiled_set *set, uint32_t primitive) {
    uint32_t place = members_below(set, primitive);
    if (place < set->count && set->members[place] == primitive) {
        return true;
    }
    if (!GROW(set->members, set->count)) {
        return false;
    }
    memmove(&set->members[place + 1], &set->members[place],
            (set->count - place) * sizeof *set->members);
    set->members[place] = primitive;
    set->count++;
    return true;
}

bool compiled_sets_are_equal(const struct compiled_set *a, const struct compiled_set *b) {
    return a->count == b->count &&
           (a->count == 0 || memcmp(a->members, b->members, a->count * sizeof *a->members) == 0);
}

void compiled_set_clear(struct compiled_set *set) {
    free(set->members);
    memset(set, 0, sizeof *set);
}

uint32_t compiled_set_word(const struct compiled_set *set, uint32_t word) {
    uint32_t bits = 0;
    for (uint32_t i = members_below(set, 32 * word); i < set->count && set->members[i] / 32 == word;
         i++) {
        bits |= (uint32_t)1 << set->members[i] % 32;
    }
    return bits;
}

/* ---- Numbers -------------------------------------------------------------------------------- */

const struct compiled_box *compiled_box_of(const struct compiled_scene *scene,
                                           const struct compiled_quadric *quadric) {
    return quadric->cuts != 0 ? &scene->boxes[quadric->box] : NULL;
}

/* Tells whether the numbers of all tables but the primitives' are small. */
static bool numbers_are_small(const struct compiled_scene *scene) {
    for (uint32_t i = 0; i < scene->pattern_count; i++) {
        if (scene->patterns[i].face_count > UINT8_MAX) {
            return false;
        }
    }
    return scene->frame_count < UINT8_MAX && scene->object_count < UINT8_MAX &&
           scene->light_count < UINT8_MAX && scene->surface_count < UINT16_MAX &&
           scene->program_length < UINT16_MAX && scene->plane_count < UINT16_MAX &&
           scene->pattern_face_count < UINT16_MAX;
}

bool compiled_fits_bits(const struct compiled_scene *scene) {
    bool fits = scene->primitive_count <= COMPILED_BITS_MOST && numbers_are_small(scene);
    for (uint32_t i = 0; i < scene->object_count; i++) {
        fits = fits && scene->objects[i].length <= UINT8_MAX;
    }
    return fits;
}

/* ---- Memory --------------------------------------------------------------------------------- */

static void free_sets(struct compiled_set *sets, uint32_t count) {
    for (uint32_t i = 0; i < count && sets != NULL; i++) {
        compiled_set_clear(&sets[i]);
    }
    free(sets);
}

void compiled_scene_clear(struct compiled_scene *scene) {
    free_sets(scene->surfaces, scene->surface_count);
    free_sets(scene->hidden_by, scene->primitive_count);
    for (uint32_t i = 0; i < scene->object_count; i++) {
        compiled_set_clear(&scene->objects[i].uses);
    }
    compiled_set_clear(&scene->camera.inside);
    compiled_set_clear(&scene->shadow_primitives);
    free(scene->object_names);
    free(scene->frames);
    free(scene->primitives);
    free(scene->boxes);
    free(scene->balls);
    free(scene->polyhedra);
    free(scene->planes);
    free(scene->quadrics);
    free(scene->programs);
    free(scene->objects);
    free(scene->pattern_faces);
    free(scene->lights);
    free(scene->hierarchy.nodes);
    free(scene->hierarchy.endless);
    free(scene->hierarchy.leads);
    free(scene->hierarchy.keys);
    free(scene->hierarchy.uses);
    free(scene->hierarchy.parents);
    free(scene->is_left_out);
    free(scene->dead);
    memset(scene, 0, sizeof *scene);
}

void compiled_scene_free(struct compiled_scene *scene) {
    if (scene != NULL) {
        compiled_scene_clear(scene);
        free(scene);
    }
}
