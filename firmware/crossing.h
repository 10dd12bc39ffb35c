/* SPDX-License-Identifier: MIT */
/* The next crossing of a ray with one primitive, and which of two crossings comes first. */
#ifndef SUPERFRAME_CROSSING_H
#define SUPERFRAME_CROSSING_H

#include "ray.h"
#include "solids.h"

/* Tells whether there can be solids other than boxes. */
enum { FEATURES_BEYOND_BOXES = FEATURE_BALL || FEATURE_POLYHEDRON || FEATURE_QUADRIC };

/* The nearest place where a primitive is entered or left. */
struct crossing {
    real_length t;
    surface_number surface;
    entry_number primitive;
    uint8_t face;
    bool leaving;
};

/* Holds what a search for the next crossing goes by. */
struct search {
    const struct scene *scene;
    struct local_ray views[VIEWS];
    bool shadows;           /* only what can keep off light is looked at */
    surface_number surface; /* that the ray starts on, or SURFACE_NONE */
};

static inline void start_search(struct search *search, const struct scene *scene,
                                const struct ray *ray, bool shadows) {
    search->scene = scene;
    search->shadows = shadows;
    search->surface = length_is_zero(LENGTH_EPSILON) ? ray->surface : SURFACE_NONE;
    views_start(search->views, &ray->origin, &ray->direction);
}

static inline void set_crossing(struct crossing *crossing, real_length t, uint8_t face) {
    crossing->t = t;
    crossing->face = face;
}

/* Finds where a ray that is inside leaves: at the end of the interval that it is in. Where rounding
 * has put that end before `from`, the ray leaves at `from`. */
static inline void leaving_crossing(const struct segment segments[2], uint8_t count,
                                    real_length from, struct crossing *crossing) {
    const struct segment *segment = &segments[0];
    if (count == 2 && !length_less(from, segments[0].out) &&
        !length_less(length_subtract(from, segments[0].out),
                     length_subtract(segments[1].in, from))) {
        segment = &segments[1];
    }
    set_crossing(crossing, length_less(from, segment->out) ? segment->out : from,
                 segment->out_face);
}

/* Finds where a ray that is outside enters an interval that ends ahead: where the interval begins.
 * An interval that has begun is entered at `from`. Then the result is false if only noise is left,
 * or if the ray starts on a surface of the primitive. */
static inline bool enter_ahead(real_length in, uint8_t face, real_length out, real_length from,
                               bool starts_there, struct crossing *crossing) {
    if (length_less(from, in)) {
        set_crossing(crossing, in, face);
        return true;
    }
    set_crossing(crossing, from, face);
    return !starts_there && length_less(LENGTH_NOISE, length_subtract(out, from));
}

static inline bool entering_crossing(const struct segment segments[2], uint8_t count,
                                     real_length from, bool starts_there,
                                     struct crossing *crossing) {
    for (uint8_t i = 0; i < count; i++) {
        const struct segment *segment = &segments[i];
        if (segment->hit && length_less(from, segment->out) &&
            enter_ahead(segment->in, segment->in_face, segment->out, from, starts_there,
                        crossing)) {
            return true;
        }
    }
    return false;
}

/* Tells whether `found` comes before `best`. At one distance exits come before entries. Entries are
 * in the order of the table, exits in the reverse order, as nested walls are crossed. */
static inline bool crossing_precedes(const struct crossing *found, const struct crossing *best) {
    return length_less(found->t, best->t) || (found->leaving && !length_less(best->t, found->t));
}

/* Tells whether two crossings are one event: on one surface, no farther apart than by rounding. */
static inline bool crossings_coincide(const struct crossing *a, const struct crossing *b) {
    return a->surface == b->surface && length_less(a->t, length_add(b->t, LENGTH_NOISE)) &&
           length_less(b->t, length_add(a->t, LENGTH_NOISE));
}

/* Finds the next crossing of a box. The exit is looked for first, for most rays outside of a box
 * have that box behind them. */
static inline bool box_crossing(struct search *search, const struct primitive *primitive,
                                struct start start, real_length from, struct crossing *crossing) {
    const struct box *box = &search->scene->boxes[primitive->index];
    const struct local_ray *ray = &search->views[VIEW_WORLD];
    if (FEATURE_ROTATION && primitive->frame != FRAME_WORLD) {
        ray = view_in(search->scene, primitive->frame, search->views);
    }
    struct box_end entry, end = box_exit(box, ray, start);
    bool ahead = length_less(from, end.t);
    if (start.inside) {
        set_crossing(crossing, ahead ? end.t : from, end.face);
    } else if (!ahead || !box_entry(box, ray, start.surface, &entry) ||
               !length_less(entry.t, end.t) ||
               !enter_ahead(entry.t, entry.face, end.t, from, start.surface != SURFACE_NONE,
                            crossing)) {
        return false;
    }
    crossing->surface = box->surface[crossing->face];
    return true;
}

/* Finds the next crossing of a solid that is no box. */
static inline bool solid_crossing(struct search *search, const struct primitive *primitive,
                                  struct start start, real_length from, struct crossing *crossing) {
    struct segment segments[2];
    uint8_t count = primitive_segments(search->scene, primitive, search->views, start, segments);
    if (start.inside) {
        leaving_crossing(segments, count, from, crossing);
    } else if (!entering_crossing(segments, count, from, start.surface != SURFACE_NONE, crossing)) {
        return false;
    }
    crossing->surface = primitive_surface(search->scene, primitive, crossing->face);
    return true;
}

/* Finds the next crossing of one primitive at or after `from`; false if there is none.
 * starts_there: the ray starts on a surface of the primitive. */
static inline bool primitive_crossing(struct search *search, entry_number index, bool inside,
                                      bool starts_there, real_length from,
                                      struct crossing *crossing, struct render_counts *counts) {
    const struct primitive *primitive = &search->scene->primitives[index];
    if (FEATURES_BEYOND_BOXES && starts_there && !inside && primitive->left_for_good) {
        return false;
    }
    counts->solid_tests++;
    const struct start start = {starts_there ? search->surface : SURFACE_NONE, inside};
    crossing->leaving = inside;
    bool found = !FEATURES_BEYOND_BOXES || primitive->kind == PRIMITIVE_BOX
                     ? box_crossing(search, primitive, start, from, crossing)
                     : solid_crossing(search, primitive, start, from, crossing);
    return found && length_less(crossing->t, LENGTH_FAR);
}

#endif
