/* SPDX-License-Identifier: MIT */
/* The walk of a ray from crossing to crossing. CSG is a Boolean function of the primitives that the
 * ray is inside of. */
#include "ray.h"

#include "crossing.h"
#include SETS_WALK

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
    crossed_set toggled;
    start_search(&search, scene, ray, false);
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
    struct primitive_set inside = ray->inside;
    crossed_set toggled;
    real_length from = LENGTH_EPSILON;
    struct crossing crossing;
    start_search(&search, scene, ray, true);
    restrict_to_shadows(scene, &inside);
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
