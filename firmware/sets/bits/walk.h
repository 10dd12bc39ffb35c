/* SPDX-License-Identifier: MIT */
/* The walk of a ray through a scene of few primitives: all that may be met next are tried. */
#ifndef SUPERFRAME_WALK_BITS_H
#define SUPERFRAME_WALK_BITS_H

#include "crossing.h"
#include "program.h"

/* Tells whether the next crossing can be one of a primitive. A primitive strictly within another
 * can only be entered from inside of the other. A ray leaves a primitive before it crosses one that
 * lies around that primitive or elsewhere. The search for shadows keeps account of its own
 * primitives only. */
static bool may_be_next(const struct scene *scene, const struct primitive_set *only,
                        entry_number index, const struct primitive_set *inside) {
    if ((only && !set_has(only, index)) || sets_overlap(&scene->hidden_by[index], inside)) {
        return false;
    }
    entry_number enclosure = scene->primitives[index].enclosure;
    return enclosure == ENCLOSURE_NONE || set_has(inside, enclosure) ||
           (only && !set_has(only, enclosure));
}

/* Finds the nearest crossing at or after `from`, and all the primitives that are crossed there. */
static bool next_crossing(struct search *search, const struct primitive_set *inside,
                          real_length from, struct crossing *best, crossed_set *toggled,
                          struct render_counts *counts) {
    const struct scene *scene = search->scene;
    const struct primitive_set *only =
        FEATURE_SHADOWS && search->shadows ? &scene->shadow_primitives : 0;
    const struct primitive_set here = *inside;
    const struct primitive_set *touched =
        search->surface == SURFACE_NONE ? 0 : &scene->surfaces[search->surface];
    best->t = LENGTH_FAR;
    best->surface = SURFACE_NONE;
    best->leaving = false;
    set_clear(toggled);
    for (entry_number i = 0; i < scene->primitive_count; i++) {
        struct crossing found;
        if (!may_be_next(scene, only, i, &here) ||
            !primitive_crossing(search, i, set_has(&here, i), touched && set_has(touched, i), from,
                                &found, counts)) {
            continue;
        }
        if (best->surface != SURFACE_NONE && crossings_coincide(&found, best)) {
            set_include(toggled, i);
        } else if (crossing_precedes(&found, best)) {
            found.primitive = i;
            set_clear(toggled);
            set_include(toggled, i);
            *best = found;
        }
    }
    return best->surface != SURFACE_NONE;
}

/* Tells whether a place is in an object. What is outside of all of an object's primitives is
 * outside of the object. */
static bool object_holds(const struct scene *scene, const struct object *object,
                         const struct primitive_set *inside) {
    bool overlaps = sets_overlap(&object->uses, inside);
    if (!FEATURE_CSG || !overlaps || object->length == 1) {
        return overlaps;
    }
    return program_holds(&scene->programs[object->program], object->length, inside);
}

/* Returns the object that fills a place: the last one that the place is in. With shadow_only, only
 * objects in the shadow test count. */
static entry_number object_at(const struct scene *scene, const struct primitive_set *inside,
                              bool shadow_only) {
    entry_number i = (entry_number)(scene->object_count - 1);
    for (; i > OBJECT_AIR; i--) {
        const struct object *object = &scene->objects[i];
        if ((!shadow_only || object->in_shadow_test) && object_holds(scene, object, inside)) {
            break;
        }
    }
    return i;
}

/* Returns the object that fills a place behind a crossing. Objects that have no part in the
 * crossing are what they were before. */
static entry_number object_behind(const struct scene *scene, entry_number before,
                                  const crossed_set *toggled, const struct primitive_set *inside) {
    const struct primitive_set changed = *toggled, here = *inside;
    entry_number i = (entry_number)(scene->object_count - 1);
    for (; i > OBJECT_AIR; i--) {
        const struct object *object = &scene->objects[i];
        if (i >= before && !sets_overlap(&object->uses, &changed)) {
            if (i == before) {
                break;
            }
        } else if (object_holds(scene, object, &here)) {
            break;
        }
    }
    return i;
}

/* Leaves the primitives alone that a search for shadows keeps account of. */
static void restrict_to_shadows(const struct scene *scene, struct primitive_set *inside) {
    set_restrict(inside, &scene->shadow_primitives);
}

#endif
