/* SPDX-License-Identifier: MIT */
/* Ambient light, the lights one by one, their fading. */
#include "stream/shading.h"

#include "optics.h"
#include "stream/interval.h"
#include "stream/objects.h"

/* Direction, cosine and distance from each lane's place to a light. */
struct way_lanes {
    struct direction_lanes towards;
    real_length distance[LANES];
    real_unit cosine[LANES];
    uint32_t lit[LANES]; /* 1: the light is in front of the surface, and nothing is between */
};

static void find_ways(const struct light *source, const struct hit_lanes *restrict hit,
                      struct way_lanes *restrict way) {
    const struct light light = *source;
    if (light.parallel) {
        for (int i = 0; i < LANES; i++) {
            way->towards.x[i] = light.towards.x;
            way->towards.y[i] = light.towards.y;
            way->towards.z[i] = light.towards.z;
            way->distance[i] = LENGTH_FAR;
        }
    } else {
        for (int i = 0; i < LANES; i++) {
            const struct point where = point_in(&hit->where, i);
            struct point gap = point_subtract(light.position, where);
            unit_normalise_lengths(gap.x, gap.y, gap.z, &way->towards.x[i], &way->towards.y[i],
                                   &way->towards.z[i], &way->distance[i]);
        }
    }
    for (int i = 0; i < LANES; i++) {
        const struct direction normal = direction_in(&hit->normal, i);
        const struct direction towards = direction_in(&way->towards, i);
        real_unit cosine = direction_dot(normal, towards);
        way->cosine[i] = cosine;
        way->lit[i] = unit_less(REAL_UNIT(0.0), cosine) ? hit->is[i] : 0;
    }
}

/* Ends the shadow rays that have come into shadow; false when no ray is left on its path. */
static bool step_shadows(struct search_lanes *restrict search, struct way_lanes *restrict way,
                         const uint32_t shadowed[restrict LANES]) {
    uint32_t active = 0;
    for (int i = 0; i < LANES; i++) {
        way->lit[i] = (search->active[i] & shadowed[i]) != 0 ? 0 : way->lit[i];
        search->active[i] = shadowed[i] != 0 ? 0 : search->active[i];
        active += search->active[i];
    }
    return active > 0;
}

static void cast_shadows(const struct scene *scene, const struct hit_lanes *restrict hit,
                         struct way_lanes *restrict way, struct search_lanes *restrict search,
                         struct set_memory *memory, struct render_counts *counts) {
    uint32_t shadowed[LANES], rays = 0;
    search->scene = scene;
    search->shadows = true;
    copy_points(&search->world.origin, &hit->where);
    copy_directions(&search->world.direction, &way->towards);
    for (int i = 0; i < LANES; i++) {
        search->surface[i] = hit->surface[i];
        search->from[i] = LENGTH_EPSILON;
        search->active[i] = way->lit[i];
        rays += way->lit[i];
    }
    sets_for_shadows(memory, scene, hit->inside_before, search->inside);
    counts->shadow_rays += rays;
    search_begin(search, memory);
    for (;;) {
        media_shadows(memory, scene, search->inside, shadowed);
        if (!step_shadows(search, way, shadowed)) {
            return;
        }
        search_next(search, &counts->solid_tests);
        for (int i = 0; i < LANES; i++) {
            bool found =
                (search->place[i] != PLACE_NONE) & length_less(search->t[i], way->distance[i]);
            search->active[i] = found ? search->active[i] : 0;
            search->inside[i] = found ? search_behind(search, i) : search->inside[i];
            search->from[i] = search->t[i];
        }
    }
}

static void find_beta(const struct direction_lanes *restrict direction,
                      const struct hit_lanes *restrict hit, const struct way_lanes *restrict way,
                      real_unit cosine[restrict LANES]) {
    for (int i = 0; i < LANES; i++) {
        const struct direction normal = direction_in(&hit->normal, i);
        struct direction half;
        unit_normalise_wide(wide_sum(way->towards.x[i], unit_negate(direction->x[i])),
                            wide_sum(way->towards.y[i], unit_negate(direction->y[i])),
                            wide_sum(way->towards.z[i], unit_negate(direction->z[i])), &half.x,
                            &half.y, &half.z);
        cosine[i] = direction_dot(normal, half);
    }
}

static void find_alpha(const struct hit_lanes *restrict hit, const struct way_lanes *restrict way,
                       real_unit cosine[restrict LANES]) {
    for (int i = 0; i < LANES; i++) {
        const struct direction light = direction_in(&way->towards, i);
        const struct direction mirrored = direction_in(&hit->mirrored, i);
        cosine[i] = direction_dot(mirrored, light);
    }
}

/* Raises the cosine of the highlight's angle to the gloss: highlight() of firmware/shade.c. */
static void find_glints(const struct scene *scene, const struct direction_lanes *restrict direction,
                        const struct hit_lanes *restrict hit, const struct way_lanes *restrict way,
                        const struct boundary_lanes *restrict boundary,
                        real_energy glint[restrict LANES]) {
    real_unit cosine[LANES];
    real_power square[LANES], power[LANES];
    if (scene->blinn) {
        find_beta(direction, hit, way, cosine);
    } else {
        find_alpha(hit, way, cosine);
    }
    for (int i = 0; i < LANES; i++) {
        square[i] =
            power_of(energy_of_cosine(unit_is_negative(cosine[i]) ? REAL_UNIT(0.0) : cosine[i]));
        power[i] = POWER_ONE;
    }
    for (uint32_t bit = 1; bit <= boundary->gloss_most; bit <<= 1) {
        for (int i = 0; i < LANES; i++) {
            real_power product = power_product(power[i], square[i]);
            power[i] = (boundary->gloss[i] & bit) != 0 ? product : power[i];
            square[i] = power_product(square[i], square[i]);
        }
    }
    for (int i = 0; i < LANES; i++) {
        glint[i] = energy_of_power(power[i]);
    }
}

static void add_light(const struct light *source, const struct way_lanes *restrict way,
                      const struct boundary_lanes *restrict boundary,
                      const real_energy glint[restrict LANES],
                      struct colour_lanes *restrict direct) {
    const struct colours light = source->colour;
    for (int i = 0; i < LANES; i++) {
        const struct colours tinted = {colour_lit(boundary->colour.red[i], light.red),
                                       colour_lit(boundary->colour.green[i], light.green),
                                       colour_lit(boundary->colour.blue[i], light.blue)};
        struct colours sum = colours_scaled(
            tinted, energy_product(boundary->diffuse[i], energy_of_cosine(way->cosine[i])));
        real_energy share = energy_product(glint[i], boundary->specular[i]);
        sum = colours_add(sum, colours_scaled(light, share));
        bool lit = way->lit[i] != 0;
        direct->red[i] = lit ? colour_add(direct->red[i], sum.red) : direct->red[i];
        direct->green[i] = lit ? colour_add(direct->green[i], sum.green) : direct->green[i];
        direct->blue[i] = lit ? colour_add(direct->blue[i], sum.blue) : direct->blue[i];
    }
}

static void fade(const struct scene *scene, const struct hit_lanes *hit,
                 struct colour_lanes *direct) {
    for (int i = 0; i < LANES; i++) {
        const struct point where = point_in(&hit->where, i);
        struct point way = point_subtract(where, scene->camera.eye);
        real_length distance = length_add(scene->fade_start, length_root(point_norm(way)));
        direct->red[i] = colour_faded(direct->red[i], distance, scene->fade_exponent);
        direct->green[i] = colour_faded(direct->green[i], distance, scene->fade_exponent);
        direct->blue[i] = colour_faded(direct->blue[i], distance, scene->fade_exponent);
    }
}

void shading_local(const struct scene *scene, const struct direction_lanes *direction,
                   const struct hit_lanes *hit, const struct boundary_lanes *boundary,
                   struct colour_lanes *local, struct search_lanes *scratch,
                   struct set_memory *memory, struct render_counts *counts) {
    struct way_lanes way;
    struct colour_lanes direct;
    real_energy glint[LANES];
    *local = boundary->ambient;
    if (scene->light_count == 0) {
        return;
    }
    for (int i = 0; i < LANES; i++) {
        direct.red[i] = direct.green[i] = direct.blue[i] = REAL_COLOUR(0.0);
    }
    for (entry_number i = 0; i < scene->light_count; i++) {
        const struct light *light = &scene->lights[i];
        find_ways(light, hit, &way);
        if (light->casts_shadows) {
            cast_shadows(scene, hit, &way, scratch, memory, counts);
        }
        if (!lanes_any(way.lit)) {
            continue;
        }
        find_glints(scene, direction, hit, &way, boundary, glint);
        add_light(light, &way, boundary, glint, &direct);
    }
    if (scene->fades) {
        fade(scene, hit, &direct);
    }
    for (int i = 0; i < LANES; i++) {
        local->red[i] = colour_add(local->red[i], direct.red[i]);
        local->green[i] = colour_add(local->green[i], direct.green[i]);
        local->blue[i] = colour_add(local->blue[i], direct.blue[i]);
    }
}
