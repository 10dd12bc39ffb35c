/* SPDX-License-Identifier: MIT */
/* Eq. (1): ambient light, diffuse light, highlights, shadows, attenuation with distance. */
#include "shade.h"

#include "optics.h"
#include "solids.h"

/* Finds the face that a boundary lies on, if cells end in it; NULL if none do. */
static const struct pattern_face *face_of(const struct scene *scene, const struct pattern *pattern,
                                          surface_number surface) {
    const struct pattern_face *face = &scene->pattern_faces[pattern->first_face];
    for (run_count i = 0; i < pattern->face_count; i++) {
        if (face[i].surface == surface) {
            return &face[i];
        }
    }
    return 0;
}

/* Tells whether the cell across a face is odd, on the side where the material is. The normal points
 * to the side that the ray comes from. */
static bool face_is_odd(const struct scene *scene, const struct pattern_face *face,
                        const struct material *material, const struct hit *hit) {
    const struct direction *normal = &hit->normal;
    bool comes_from_below = unit_is_negative(face->axis == 0   ? normal->x
                                             : face->axis == 1 ? normal->y
                                                               : normal->z);
    bool is_behind = material != &scene->materials[scene->objects[hit->before].material];
    return comes_from_below == is_behind ? face->odd_above : face->odd_below;
}

/* Returns Ic at a boundary: the material's own colour, or that of the pattern's odd cells. */
static struct colours colour_at(const struct scene *scene, const struct material *material,
                                const struct hit *hit) {
    if (!FEATURE_PATTERN || material->pattern == PATTERN_NONE) {
        return material->colour;
    }
    const struct pattern *pattern = &scene->patterns[material->pattern];
    const struct point p = point_subtract(hit->where, pattern->origin);
    uint8_t axes = pattern->axes;
    bool odd = false;
    if (FEATURE_PATTERN_FACES && pattern->face_count > 0) {
        const struct pattern_face *face = face_of(scene, pattern, hit->surface);
        if (face) {
            axes = (uint8_t)(axes & ~(1u << face->axis));
            odd = face_is_odd(scene, face, material, hit);
        }
    }
    odd = odd != ((axes & 1) && length_cell_is_odd(p.x, pattern->size.x));
    odd = odd != ((axes & 2) && length_cell_is_odd(p.y, pattern->size.y));
    odd = odd != ((axes & 4) && length_cell_is_odd(p.z, pattern->size.z));
    return odd ? pattern->colour : material->colour;
}

/* Returns the unit vector halfway between the light and the viewer (Blinn). */
static struct direction halfway(struct direction light, struct direction view) {
    struct direction half;
    unit_normalise_wide(wide_sum(light.x, view.x), wide_sum(light.y, view.y),
                        wide_sum(light.z, view.z), &half.x, &half.y, &half.z);
    return half;
}

static real_energy highlight(const struct scene *scene, const struct material *material,
                             real_unit incidence, const struct ray *ray, const struct hit *hit,
                             const struct direction *mirrored, struct direction light) {
    real_unit cosine;
    if (FEATURE_HIGHLIGHT_BLINN && scene->blinn) {
        struct direction view = direction_negate(ray->direction);
        cosine = direction_dot(hit->normal, halfway(light, view));
    } else {
        cosine = direction_dot(*mirrored, light);
    }
    if (unit_is_negative(cosine)) {
        cosine = REAL_UNIT(0.0);
    }
    return energy_product(energy_power(energy_of_cosine(cosine), material->gloss),
                          specular_at(scene, material, incidence));
}

/* Returns the second term of Eq. (1) for one light, before the division by C + D. */
static struct colours lit_by(const struct scene *scene, const struct material *material,
                             struct colours colour, const struct light *light,
                             const struct ray *ray, const struct hit *hit,
                             const struct direction *mirrored, struct render_counts *counts) {
    const struct colours none = {REAL_COLOUR(0.0), REAL_COLOUR(0.0), REAL_COLOUR(0.0)};
    struct direction towards = light->towards;
    real_length distance = LENGTH_FAR;
    if (FEATURE_POINT_LIGHTS && !light->parallel) {
        struct point way = point_subtract(light->position, hit->where);
        unit_normalise_lengths(way.x, way.y, way.z, &towards.x, &towards.y, &towards.z, &distance);
    }
    real_unit cosine = direction_dot(hit->normal, towards);
    if (!unit_less(REAL_UNIT(0.0), cosine)) {
        return none;
    }
    if (FEATURE_SHADOWS && light->casts_shadows) {
        const struct ray shadow = {hit->where, towards, hit->inside_before, hit->surface,
                                   hit->before};
        if (ray_is_shadowed(scene, &shadow, distance, counts)) {
            return none;
        }
    }
    struct colours tinted = {colour_lit(colour.red, light->colour.red),
                             colour_lit(colour.green, light->colour.green),
                             colour_lit(colour.blue, light->colour.blue)};
    struct colours sum =
        colours_scaled(tinted, energy_product(material->diffuse, energy_of_cosine(cosine)));
    if (material->specular_table == SPECULAR_CONSTANT && energy_is_zero(material->specular)) {
        return sum;
    }
    real_energy glint = highlight(scene, material, cosine, ray, hit, mirrored, towards);
    return colours_add(sum, colours_scaled(light->colour, glint));
}

static struct colours faded(const struct scene *scene, struct colours colour, struct point where) {
    struct point way = point_subtract(where, scene->camera.eye);
    real_length distance = length_add(scene->fade_start, length_root(point_norm(way)));
    struct colours result = {colour_faded(colour.red, distance, scene->fade_exponent),
                             colour_faded(colour.green, distance, scene->fade_exponent),
                             colour_faded(colour.blue, distance, scene->fade_exponent)};
    return result;
}

struct colours shade(const struct scene *scene, const struct material *material,
                     const struct ray *ray, const struct hit *hit, const struct direction *mirrored,
                     struct render_counts *counts) {
    struct colours colour = colour_at(scene, material, hit);
    struct colours ambient =
        colours_add(material->ambient, colours_scaled(colour, material->ambient_share));
    if (!FEATURE_LIGHTS || scene->light_count == 0) {
        return ambient;
    }
    struct colours direct = {REAL_COLOUR(0.0), REAL_COLOUR(0.0), REAL_COLOUR(0.0)};
    for (entry_number i = 0; i < scene->light_count; i++) {
        direct = colours_add(
            direct, lit_by(scene, material, colour, &scene->lights[i], ray, hit, mirrored, counts));
    }
    if (FEATURE_FADING && scene->fades) {
        direct = faded(scene, direct, hit->where);
    }
    return colours_add(ambient, direct);
}
