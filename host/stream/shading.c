/* SPDX-License-Identifier: MIT */
/* Ambient light, patterns, the lights one by one, their fading. */
#include "shading.h"

#include "media.h"
#include "stretch.h"
#include "optics.h"

/* What Eq. (1) asks of each lane's surface. */
struct finish_lanes {
    struct colour_lanes colour;
    real_energy diffuse[LANES], specular[LANES];
    uint32_t gloss[LANES], gloss_most;
};

static void turn_points(struct point_lanes *restrict turned, const struct frame *frame,
                        const struct point_lanes *restrict world) {
    const struct frame f = *frame;
    for (int i = 0; i < LANES; i++) {
        const struct point there = {world->x[i], world->y[i], world->z[i]};
        struct point q = point_subtract(there, f.origin);
        turned->x[i] = point_dot(q, f.axis[0]);
        turned->y[i] = point_dot(q, f.axis[1]);
        turned->z[i] = point_dot(q, f.axis[2]);
    }
}

/* 1 where the pattern has its other colour: colour_at() of firmware/shade.c. */
static void find_cells(const struct scene *scene, const struct pattern *source,
                       const struct point_lanes *restrict where, uint32_t odd[restrict LANES]) {
    const struct pattern pattern = *source;
    const bool along_x = pattern.axes & 1, along_y = pattern.axes & 2, along_z = pattern.axes & 4;
    const struct point size = {along_x ? pattern.size.x : REAL_LENGTH(1.0),
                               along_y ? pattern.size.y : REAL_LENGTH(1.0),
                               along_z ? pattern.size.z : REAL_LENGTH(1.0)};
    struct point_lanes turned;
    const struct point_lanes *place = where;
    if (pattern.frame != FRAME_WORLD) {
        turn_points(&turned, &scene->frames[pattern.frame], where);
        place = &turned;
    }
    for (int i = 0; i < LANES; i++) {
        struct point p = {place->x[i], place->y[i], place->z[i]};
        p = point_subtract(p, pattern.origin);
        odd[i] = (along_x & length_cell_is_odd(p.x, size.x)) ^
                         (along_y & length_cell_is_odd(p.y, size.y)) ^
                         (along_z & length_cell_is_odd(p.z, size.z))
                     ? 1
                     : 0;
    }
}

/* Adds the lanes of one material to the finish, and their ambient light. */
static void apply_material(const struct scene *scene, uint32_t number,
                           const struct hit_lanes *restrict hit,
                           struct finish_lanes *restrict finish,
                           struct colour_lanes *restrict ambient) {
    const struct material material = scene->materials[number];
    uint32_t odd[LANES] = {0};
    struct colours other = material.colour;
    if (material.pattern != PATTERN_NONE) {
        const struct pattern *pattern = &scene->patterns[material.pattern];
        find_cells(scene, pattern, &hit->where, odd);
        other = pattern->colour;
    }
    const struct colours own = material.colour;
    const struct colours own_ambient =
        colours_add(material.ambient, colours_scaled(own, material.ambient_share));
    const struct colours other_ambient =
        colours_add(material.ambient, colours_scaled(other, material.ambient_share));
    for (int i = 0; i < LANES; i++) {
        bool here = hit->material[i] == number, is_odd = odd[i] != 0;
        finish->colour.red[i] = here ? (is_odd ? other.red : own.red) : finish->colour.red[i];
        finish->colour.green[i] =
            here ? (is_odd ? other.green : own.green) : finish->colour.green[i];
        finish->colour.blue[i] = here ? (is_odd ? other.blue : own.blue) : finish->colour.blue[i];
        ambient->red[i] =
            here ? (is_odd ? other_ambient.red : own_ambient.red) : ambient->red[i];
        ambient->green[i] =
            here ? (is_odd ? other_ambient.green : own_ambient.green) : ambient->green[i];
        ambient->blue[i] =
            here ? (is_odd ? other_ambient.blue : own_ambient.blue) : ambient->blue[i];
        finish->diffuse[i] = here ? material.diffuse : finish->diffuse[i];
        finish->specular[i] = here ? material.specular : finish->specular[i];
        finish->gloss[i] = here ? material.gloss : finish->gloss[i];
    }
    finish->gloss_most =
        material.gloss > finish->gloss_most ? material.gloss : finish->gloss_most;
}

static void find_finish(const struct scene *scene, const struct hit_lanes *hit,
                        struct finish_lanes *finish, struct colour_lanes *ambient) {
    bool present[256] = {false};
    for (int i = 0; i < LANES; i++) {
        present[hit->material[i]] = true;
    }
    finish->gloss_most = 0;
    for (uint32_t number = 0; number < 256; number++) {
        if (present[number]) {
            apply_material(scene, number, hit, finish, ambient);
        }
    }
}

/* Way, cosine and distance from each lane's place to a light. */
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
            const struct point where = {hit->where.x[i], hit->where.y[i], hit->where.z[i]};
            struct point gap = point_subtract(light.position, where);
            unit_normalise_lengths(gap.x, gap.y, gap.z, &way->towards.x[i], &way->towards.y[i],
                                   &way->towards.z[i], &way->distance[i]);
        }
    }
    for (int i = 0; i < LANES; i++) {
        const struct direction normal = {hit->normal.x[i], hit->normal.y[i], hit->normal.z[i]};
        const struct direction towards = {way->towards.x[i], way->towards.y[i], way->towards.z[i]};
        real_unit cosine = direction_dot(normal, towards);
        way->cosine[i] = cosine;
        way->lit[i] = unit_less(REAL_UNIT(0.0), cosine) ? hit->is[i] : 0;
    }
}

/* One step of all shadow rays: false when none is on its way any more. */
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
                         struct render_counts *counts) {
    uint32_t shadowed[LANES];
    search->scene = scene;
    search->shadows = true;
    search->world.origin = hit->where;
    search->world.direction = way->towards;
    for (int i = 0; i < LANES; i++) {
        search->surface[i] = hit->surface[i];
        search->inside[i] = hit->inside_before[i];
        search->from[i] = LENGTH_EPSILON;
        search->active[i] = way->lit[i];
        counts->shadow_rays += way->lit[i];
    }
    search_begin(search);
    for (;;) {
        media_shadows(scene, search->inside, shadowed);
        if (!step_shadows(search, way, shadowed)) {
            return;
        }
        search_next(search, &counts->solid_tests);
        for (int i = 0; i < LANES; i++) {
            bool found = (search->place[i] != PLACE_NONE) &
                         length_less(search->t[i], way->distance[i]);
            search->active[i] = found ? search->active[i] : 0;
            search->inside[i] ^= found ? search->toggled[i] : 0;
            search->from[i] = search->t[i];
        }
    }
}

/* The cosine of the highlight's angle, raised to the gloss: highlight() of firmware/shade.c. */
static void find_glints(const struct scene *scene, const struct direction_lanes *restrict direction,
                        const struct hit_lanes *restrict hit, const struct way_lanes *restrict way,
                        const struct finish_lanes *restrict finish,
                        real_energy glint[restrict LANES]) {
    real_energy square[LANES];
    const bool blinn = scene->blinn;
    for (int i = 0; i < LANES; i++) {
        const struct direction light = {way->towards.x[i], way->towards.y[i], way->towards.z[i]};
        const struct direction mirrored = {hit->mirrored.x[i], hit->mirrored.y[i],
                                           hit->mirrored.z[i]};
        real_unit cosine = direction_dot(mirrored, light);
        if (blinn) {
            const struct direction normal = {hit->normal.x[i], hit->normal.y[i], hit->normal.z[i]};
            const struct direction view = {unit_negate(direction->x[i]),
                                           unit_negate(direction->y[i]),
                                           unit_negate(direction->z[i])};
            struct direction half;
            unit_normalise_wide(wide_sum(light.x, view.x), wide_sum(light.y, view.y),
                                wide_sum(light.z, view.z), &half.x, &half.y, &half.z);
            cosine = direction_dot(normal, half);
        }
        square[i] = energy_of_cosine(unit_is_negative(cosine) ? REAL_UNIT(0.0) : cosine);
        glint[i] = REAL_ENERGY(1.0);
    }
    for (uint32_t bit = 1; bit <= finish->gloss_most; bit <<= 1) {
        for (int i = 0; i < LANES; i++) {
            real_energy product = energy_product(glint[i], square[i]);
            glint[i] = (finish->gloss[i] & bit) != 0 ? product : glint[i];
            square[i] = energy_product(square[i], square[i]);
        }
    }
}

static void add_light(const struct light *source, const struct way_lanes *restrict way,
                      const struct finish_lanes *restrict finish,
                      const real_energy glint[restrict LANES],
                      struct colour_lanes *restrict direct) {
    const struct colours light = source->colour;
    for (int i = 0; i < LANES; i++) {
        const struct colours tinted = {colour_lit(finish->colour.red[i], light.red),
                                       colour_lit(finish->colour.green[i], light.green),
                                       colour_lit(finish->colour.blue[i], light.blue)};
        struct colours sum = colours_scaled(
            tinted, energy_product(finish->diffuse[i], energy_of_cosine(way->cosine[i])));
        real_energy share = energy_product(glint[i], finish->specular[i]);
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
        const struct point where = {hit->where.x[i], hit->where.y[i], hit->where.z[i]};
        struct point way = point_subtract(where, scene->camera.eye);
        real_length distance = length_add(scene->fade_start, length_root(point_norm(way)));
        direct->red[i] = colour_faded(direct->red[i], distance, scene->fade_exponent);
        direct->green[i] = colour_faded(direct->green[i], distance, scene->fade_exponent);
        direct->blue[i] = colour_faded(direct->blue[i], distance, scene->fade_exponent);
    }
}

void shading_local(const struct scene *scene, const struct direction_lanes *direction,
                   const struct hit_lanes *hit, struct colour_lanes *local,
                   struct search_lanes *scratch, struct render_counts *counts) {
    struct finish_lanes finish;
    struct way_lanes way;
    struct colour_lanes direct;
    real_energy glint[LANES];
    find_finish(scene, hit, &finish, local);
    if (scene->light_count == 0) {
        return;
    }
    for (int i = 0; i < LANES; i++) {
        direct.red[i] = direct.green[i] = direct.blue[i] = REAL_COLOUR(0.0);
    }
    for (uint8_t i = 0; i < scene->light_count; i++) {
        const struct light *light = &scene->lights[i];
        find_ways(light, hit, &way);
        if (light->casts_shadows) {
            cast_shadows(scene, hit, &way, scratch, counts);
        }
        find_glints(scene, direction, hit, &way, &finish, glint);
        add_light(light, &way, &finish, glint, &direct);
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
