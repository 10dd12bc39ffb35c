/* SPDX-License-Identifier: MIT */
/* The POV-Ray export: refuses by name what POV-Ray 3.7 can't show as it is. */
#include <math.h>
#include <stdarg.h>

#include "compiler/neighbours.h"
#include "export/pov_internal.h"

/* Points along each axis where two objects are tested for an overlap. The bounds of the two have a
 * part in common: an overlap thinner than 1/SAMPLES of this part may be missed. */
enum { SAMPLES = 40 };

static bool refuse(struct scene_error *error, const struct scene_description *description,
                   unsigned line, const char *format, ...)
#if defined(__GNUC__)
    __attribute__((format(printf, 4, 5)))
#endif
    ;

static bool refuse(struct scene_error *error, const struct scene_description *description,
                   unsigned line, const char *format, ...) {
    char what[400], where[24] = "";
    va_list arguments;
    va_start(arguments, format);
    (void)vsnprintf(what, sizeof what, format, arguments);
    va_end(arguments);
    if (line > 0) {
        (void)snprintf(where, sizeof where, ":%u", line);
    }
    (void)snprintf(error->text, sizeof error->text, "%.80s%s: %s", description->path, where, what);
    return false;
}

static bool check_scene(const struct scene_description *description, struct scene_error *error) {
    if (description->model == MODEL_WAVELENGTH) {
        return refuse(
            error, description, 0,
            "model wavelength: POV-Ray's dispersion is another one; allowed is: fresnel or simple");
    }
    if (description->mixing == MIXING_FILTER) {
        return refuse(error, description, 0,
                      "mixing filter: POV-Ray adds up a path's light otherwise; allowed is: "
                      "additive");
    }
    if (description->has_attenuation) {
        return refuse(error, description, 0,
                      "attenuation: POV-Ray's light fades with the way from the light, not from "
                      "the eye; allowed is: to leave it out");
    }
    if (description->estimates || description->error > 0) {
        return refuse(error, description, 0,
                      "an estimate for pruned branches: POV-Ray counts them as black; "
                      "allowed is: a threshold, and tail black");
    }
    return true;
}

static bool check_material(const struct scene_description *description,
                           const struct scene_material *material, struct scene_error *error) {
    if (material->has_specular_table) {
        return refuse(error, description, material->line,
                      "material \"%.40s\": POV-Ray has no w(theta) from a table; allowed is: one "
                      "number as specular",
                      material->name);
    }
    return true;
}

/* Finds the part of space that the bounds of two objects have in common; false if there is none. */
static bool common_bounds(const struct compiled_object *a, const struct compiled_object *b,
                          double low[3], double high[3]) {
    for (int i = 0; i < 3; i++) {
        low[i] = fmax(a->bounds.low[i], b->bounds.low[i]);
        high[i] = fmin(a->bounds.high[i], b->bounds.high[i]);
        if (low[i] > high[i]) {
            return false;
        }
    }
    return true;
}

static bool both_hold(const struct compiled_scene *scene, uint32_t a, uint32_t b,
                      const double point[3]) {
    return compiled_object_holds(scene, a, point) && compiled_object_holds(scene, b, point);
}

static bool overlap(const struct compiled_scene *scene, uint32_t a, uint32_t b) {
    double low[3], high[3];
    if (!common_bounds(&scene->objects[a], &scene->objects[b], low, high)) {
        return false;
    }
    for (int sample = 0; sample < SAMPLES * SAMPLES * SAMPLES; sample++) {
        const int step[3] = {sample % SAMPLES, sample / SAMPLES % SAMPLES,
                             sample / (SAMPLES * SAMPLES)};
        double point[3];
        for (int i = 0; i < 3; i++) {
            point[i] = low[i] + (high[i] - low[i]) * (step[i] + 0.5) / SAMPLES;
        }
        if (both_hold(scene, a, b, point)) {
            return true;
        }
    }
    return false;
}

/* Refuses two opaque objects that fill one place up to the same face: POV-Ray shows either. */
static bool check_opaque_pair(const struct scene_description *description,
                              const struct compiled_scene *scene, uint32_t earlier, uint32_t later,
                              struct scene_error *error) {
    const struct compiled_object *a = &scene->objects[earlier], *b = &scene->objects[later];
    double low[3], high[3];
    if (a->material == b->material || !common_bounds(a, b, low, high) ||
        !export_pov_touch(scene, earlier, later, low, high) || !overlap(scene, earlier, later)) {
        return true;
    }
    return refuse(error, description, b->line,
                  "object \"%s\" overlaps \"%s\" and has a face in common: POV-Ray shows either "
                  "there; allowed is: to cut one out of the other, or a gap",
                  scene->object_names[later], scene->object_names[earlier]);
}

/* Checks that POV-Ray shows two objects as they are. A transparent object may have nothing in
 * common with another one, which POV-Ray would show otherwise. But a later opaque object may fill a
 * part of a transparent one: no ray gets there. */
static bool check_pair(const struct scene_description *description,
                       const struct compiled_scene *scene, uint32_t earlier, uint32_t later,
                       struct scene_error *error) {
    const struct compiled_object *a = &scene->objects[earlier], *b = &scene->objects[later];
    bool a_transparent = scene->materials[a->material].transparent;
    bool b_transparent = scene->materials[b->material].transparent;
    if (!a_transparent && !b_transparent) {
        return check_opaque_pair(description, scene, earlier, later, error);
    }
    double low[3], high[3];
    if (common_bounds(a, b, low, high) && export_pov_touch(scene, earlier, later, low, high)) {
        return refuse(error, description, b->line,
                      "object \"%s\" touches \"%s\" with a face: POV-Ray loses a boundary there; "
                      "allowed is: a gap",
                      scene->object_names[later], scene->object_names[earlier]);
    }
    if (b_transparent && overlap(scene, earlier, later)) {
        return refuse(error, description, b->line, "object \"%s\" overlaps \"%s\": %s",
                      scene->object_names[later], scene->object_names[earlier],
                      a_transparent
                          ? "POV-Ray 3.7 knows no boundary of two media (its Fresnel has n = "
                            "1 there); allowed is: to cut one out of the other, with a "
                            "gap"
                          : "POV-Ray would see the opaque one in it; allowed is: the "
                            "opaque one after it");
    }
    return true;
}

/* Refuses an eye within glass that casts shadows: all rays would end at its opaque twin. */
static bool check_eye(const struct scene_description *description,
                      const struct compiled_scene *scene, uint32_t index,
                      struct scene_error *error) {
    const struct compiled_object *object = &scene->objects[index];
    const struct compiled_material *material = &scene->materials[object->material];
    if (!material->transparent || !material->casts_shadow ||
        !compiled_object_holds(scene, index, scene->camera.eye)) {
        return true;
    }
    return refuse(error, description, object->line,
                  "the eye is in object \"%s\", which casts shadows: POV-Ray sees the caster from "
                  "within; allowed is: casts_shadow = false, or another eye",
                  scene->object_names[index]);
}

static bool check_object(const struct scene_description *description,
                         const struct compiled_scene *scene, uint32_t index,
                         struct scene_error *error) {
    const uint8_t material = scene->objects[index].material;
    if (!check_material(description, &description->materials[scene->materials[material].file],
                        error) ||
        !check_eye(description, scene, index, error)) {
        return false;
    }
    return !export_pov_has_seam(scene, index) ||
           refuse(error, description, scene->objects[index].line,
                  "object \"%s\" is made of solids with a common face: POV-Ray takes noise "
                  "for its inside there; allowed is: solids that reach over each other",
                  scene->object_names[index]);
}

/* Checks an object with each earlier one that it may meet, and adds it to those. */
static bool check_with_earlier(const struct scene_description *description,
                               const struct compiled_scene *scene, uint32_t index,
                               struct neighbours *earlier, struct scene_error *error) {
    struct compiled_set found = {NULL, 0};
    const struct bounds *bounds = &scene->objects[index].bounds;
    bool is_good =
        (neighbours_find(earlier, bounds, 0, &found) && neighbours_add(earlier, bounds, index)) ||
        refuse(error, description, 0, "out of memory");
    for (uint32_t k = 0; k < found.count && is_good; k++) {
        is_good = check_pair(description, scene, found.members[k], index, error);
    }
    compiled_set_clear(&found);
    return is_good;
}

bool export_pov_check(const struct scene_description *description,
                      const struct compiled_scene *scene, struct scene_error *error) {
    struct neighbours earlier = {.count = 0};
    bool is_good = check_scene(description, error);
    for (uint32_t i = 1; i < scene->object_count && is_good; i++) {
        is_good = check_object(description, scene, i, error) &&
                  check_with_earlier(description, scene, i, &earlier, error);
    }
    neighbours_clear(&earlier);
    return is_good;
}
