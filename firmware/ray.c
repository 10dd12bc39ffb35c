/* SPDX-License-Identifier: MIT */
/* The walk of a ray from crossing to crossing. CSG is a Boolean function of the primitives that the
 * ray is inside of. */
#include "ray.h"

#include "solids.h"

/* Whether there can be solids other than boxes. */
enum { FEATURES_BEYOND_BOXES = FEATURE_BALL || FEATURE_POLYHEDRON || FEATURE_QUADRIC };

/* The nearest place where a primitive is entered or left. */
struct crossing {
    real_length t;
    uint16_t surface;
    uint8_t primitive, face;
    bool leaving;
};

/* What a search for the next crossing goes by. */
struct search {
    const struct scene *scene;
    struct local_ray views[VIEWS];
    const struct primitive_set *only;  /* the primitives to look at; NULL: all that matter */
    uint16_t surface;                  /* that the ray starts on */
    const struct primitive_set *touch; /* what that surface bounds; NULL: none */
};

static void start_search(struct search *search, const struct scene *scene, const struct ray *ray,
                         const struct primitive_set *only) {
    search->scene = scene;
    search->only = only;
    search->surface = length_is_zero(LENGTH_EPSILON) ? ray->surface : SURFACE_NONE;
    search->touch = search->surface == SURFACE_NONE ? 0 : &scene->surfaces[search->surface];
    views_start(search->views, &ray->origin, &ray->direction);
}

static void set_crossing(struct crossing *crossing, real_length t, uint8_t face) {
    crossing->t = t;
    crossing->face = face;
}

/* Finds where a ray that is inside leaves: at the end of the interval that it is in. Where rounding
 * has put that end before `from`, the ray leaves at `from`. */
static void leaving_crossing(const struct segment segments[2], uint8_t count, real_length from,
                             struct crossing *crossing) {
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
static bool enter_ahead(real_length in, uint8_t face, real_length out, real_length from,
                        bool starts_there, struct crossing *crossing) {
    if (length_less(from, in)) {
        set_crossing(crossing, in, face);
        return true;
    }
    set_crossing(crossing, from, face);
    return !starts_there && length_less(LENGTH_NOISE, length_subtract(out, from));
}

static bool entering_crossing(const struct segment segments[2], uint8_t count, real_length from,
                              bool starts_there, struct crossing *crossing) {
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
static bool crossing_precedes(const struct crossing *found, const struct crossing *best) {
    return length_less(found->t, best->t) || (found->leaving && !length_less(best->t, found->t));
}

/* Tells whether two crossings are one event: on one surface, no farther apart than by rounding. */
static bool crossings_coincide(const struct crossing *a, const struct crossing *b) {
    return a->surface == b->surface && length_less(a->t, length_add(b->t, LENGTH_NOISE)) &&
           length_less(b->t, length_add(a->t, LENGTH_NOISE));
}

/* Finds the next crossing of a box. The exit is looked for first, for most rays outside of a box
 * have that box behind them. */
static bool box_crossing(struct search *search, const struct primitive *primitive,
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
static bool solid_crossing(struct search *search, const struct primitive *primitive,
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

/* Finds the next crossing of one primitive at or after `from`; false if there is none. */
static bool primitive_crossing(struct search *search, uint8_t index, bool inside, real_length from,
                               struct crossing *crossing, struct render_counts *counts) {
    const struct primitive *primitive = &search->scene->primitives[index];
    bool starts_there = search->touch && set_has(search->touch, index);
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

/* Tells whether the next crossing can be one of a primitive. A primitive strictly within another
 * can only be entered from inside of the other. A ray leaves a primitive before it crosses one that
 * lies around that primitive or elsewhere. The search for shadows keeps account of its own
 * primitives only. */
static bool may_be_next(const struct scene *scene, const struct primitive_set *only, uint8_t index,
                        const struct primitive_set *inside) {
    if ((only && !set_has(only, index)) || sets_overlap(&scene->hidden_by[index], inside)) {
        return false;
    }
    uint8_t enclosure = scene->primitives[index].enclosure;
    return enclosure == ENCLOSURE_NONE || set_has(inside, enclosure) ||
           (only && !set_has(only, enclosure));
}

/* Finds the nearest crossing at or after `from`, and all the primitives that are crossed there. */
static bool next_crossing(struct search *search, const struct primitive_set *inside,
                          real_length from, struct crossing *best, struct primitive_set *toggled,
                          struct render_counts *counts) {
    const struct scene *scene = search->scene;
    const struct primitive_set *only = FEATURE_SHADOWS ? search->only : 0;
    const struct primitive_set here = *inside;
    best->t = LENGTH_FAR;
    best->surface = SURFACE_NONE;
    best->leaving = false;
    set_clear(toggled);
    for (uint8_t i = 0; i < scene->primitive_count; i++) {
        struct crossing found;
        if (!may_be_next(scene, only, i, &here) ||
            !primitive_crossing(search, i, set_has(&here, i), from, &found, counts)) {
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

/* Runs an object's postfix program on the bits of the set; the stack of Booleans is one word. */
static bool program_holds(const uint8_t *program, uint8_t length,
                          const struct primitive_set *inside) {
    uint32_t stack = 0;
    for (uint8_t i = 0; i < length; i++) {
        uint8_t code = program[i];
        if (code < PROGRAM_UNION) {
            stack = stack << 1 | (uint32_t)set_has(inside, code);
            continue;
        }
        uint32_t right = stack & 1;
        stack >>= 1;
        if (code == PROGRAM_UNION) {
            stack |= right;
        } else if (code == PROGRAM_DIFFERENCE) {
            stack &= ~right;
        } else {
            stack &= right | ~(uint32_t)1;
        }
    }
    return (stack & 1) != 0;
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
static uint8_t object_at(const struct scene *scene, const struct primitive_set *inside,
                         bool shadow_only) {
    uint8_t i = (uint8_t)(scene->object_count - 1);
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
static uint8_t object_behind(const struct scene *scene, uint8_t before,
                             const struct primitive_set *toggled,
                             const struct primitive_set *inside) {
    const struct primitive_set changed = *toggled, here = *inside;
    uint8_t i = (uint8_t)(scene->object_count - 1);
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

static void describe_hit(const struct scene *scene, const struct ray *ray,
                         const struct crossing *crossing, struct hit *hit) {
    const struct primitive *primitive = &scene->primitives[crossing->primitive];
    hit->t = crossing->t;
    hit->surface = crossing->surface;
    hit->primitive = crossing->primitive;
    hit->face = crossing->face;
    hit->leaving = crossing->leaving;
    hit->where = point_along(ray->origin, crossing->t, ray->direction);
    struct direction outward = primitive_normal(scene, primitive, crossing->face, &hit->where);
    hit->normal = crossing->leaving ? direction_negate(outward) : outward;
}

bool ray_hit(const struct scene *scene, const struct ray *ray, struct hit *hit,
             struct render_counts *counts) {
    struct search search;
    real_length from = LENGTH_EPSILON;
    struct crossing crossing;
    struct primitive_set toggled;
    start_search(&search, scene, ray, 0);
    hit->inside_before = ray->inside;
    hit->before = ray->object;
    while (next_crossing(&search, &hit->inside_before, from, &crossing, &toggled, counts)) {
        hit->inside_after = hit->inside_before;
        set_toggle(&hit->inside_after, &toggled);
        hit->after = object_behind(scene, hit->before, &toggled, &hit->inside_after);
        if (scene->objects[hit->after].material != scene->objects[hit->before].material) {
            describe_hit(scene, ray, &crossing, hit);
            return true;
        }
        hit->inside_before = hit->inside_after;
        hit->before = hit->after;
        from = crossing.t;
    }
    return false;
}

static bool throws_shadow(const struct scene *scene, const struct primitive_set *inside) {
    return scene->materials[scene->objects[object_at(scene, inside, true)].material].casts_shadow;
}

bool ray_is_shadowed(const struct scene *scene, const struct ray *ray, real_length distance,
                     struct render_counts *counts) {
    struct search search;
    struct primitive_set inside = ray->inside, toggled;
    real_length from = LENGTH_EPSILON;
    struct crossing crossing;
    start_search(&search, scene, ray, &scene->shadow_primitives);
    set_restrict(&inside, &scene->shadow_primitives);
    counts->shadow_rays++;
    while (!throws_shadow(scene, &inside)) {
        if (!next_crossing(&search, &inside, from, &crossing, &toggled, counts) ||
            !length_less(crossing.t, distance)) {
            return false;
        }
        set_toggle(&inside, &toggled);
        from = crossing.t;
    }
    return true;
}
