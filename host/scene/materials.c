/* SPDX-License-Identifier: MIT */
/* Reads the materials of a scene file. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "base/nearest.h"
#include "scene/values.h"

enum { GLOSS_MOST = 65535, GLOSS_DEFAULT = 32 };

static const struct scene_range RANGE_IOR = {0.7, 4};
static const struct scene_range RANGE_ABSORPTION = {0, 1e9};
static const struct scene_range RANGE_PATTERN_SIZE = {0, 1e9};
static const struct scene_range RANGE_CAUCHY = {-10, 10};

/* Reads `specular`: a number, or a table over the angle of incidence. */
static bool read_specular(const struct scene_scope *scope, struct scene_material *material) {
    const struct scene_value *setting = value_member(scope->group, "specular");
    if (!setting || !value_is_sequence(setting)) {
        return scope_number(scope, "specular", OPTIONAL, RANGE_SHARE, &material->specular);
    }
    material->has_specular_table = true;
    return scope_numbers(scope, "specular", OPTIONAL, RANGE_SHARE, SPECULAR_STEPS,
                         material->specular_table);
}

/* Computes Cauchy's n = A + B / wavelength^2 at each channel's wavelength, in micrometres. */
static bool read_cauchy(const struct scene_scope *scope, struct scene_material *material) {
    double coefficients[2] = {1, 0};
    if (!scope_numbers(scope, "cauchy", OPTIONAL, RANGE_CAUCHY, 2, coefficients)) {
        return false;
    }
    for (int i = 0; i < 3; i++) {
        double micrometres = scope->reader->wavelengths[i] / 1000;
        double ior = coefficients[0] + coefficients[1] / (micrometres * micrometres);
        if (!(ior >= RANGE_IOR.least && ior <= RANGE_IOR.most)) {
            return scene_fail(scope->reader, scope_line(scope, "cauchy"),
                              "'cauchy' of the %s gives an index of %.6g at %.6g nm: %.10g to "
                              "%.10g is allowed",
                              scope->what, ior, scope->reader->wavelengths[i], RANGE_IOR.least,
                              RANGE_IOR.most);
        }
        material->ior_by_channel[i] = ior;
    }
    return true;
}

/* Reads the optical members of a transparent material, and whether the material casts a shadow. */
static bool read_optics(const struct scene_scope *scope, struct scene_material *material) {
    if (scope_has(scope, "ior") && scope_has(scope, "cauchy")) {
        return scene_fail(scope->reader, scope_line(scope, "cauchy"),
                          "the %s has both 'ior' and 'cauchy': give one of them", scope->what);
    }
    if (!scope_three(scope, "ior", OPTIONAL, RANGE_IOR, material->ior_by_channel) ||
        (scope_has(scope, "cauchy") && !read_cauchy(scope, material))) {
        return false;
    }
    material->ior = material->ior_by_channel[1];
    double amplitude = (material->ior - 1) / (material->ior + 1);
    material->transmittance = 1 - amplitude * amplitude; /* what enters at normal incidence */
    return scope_number(scope, "transmittance", OPTIONAL, RANGE_SHARE, &material->transmittance) &&
           scope_three(scope, "reflectance_factors", OPTIONAL, RANGE_SHARE,
                       material->reflectance_by_channel) &&
           scope_three(scope, "transmittance_factors", OPTIONAL, RANGE_SHARE,
                       material->transmittance_by_channel) &&
           scope_three(scope, "absorption", OPTIONAL, RANGE_ABSORPTION, material->absorption) &&
           scope_boolean(scope, "casts_shadow", &material->casts_shadow);
}

static bool check_opaque(const struct scene_scope *scope, struct scene_material *material) {
    static const char *const keys[] = {"reflectance_factors", "transmittance_factors",
                                       "absorption"};
    for (size_t i = 0; i < sizeof keys / sizeof *keys; i++) {
        if (scope_has(scope, keys[i])) {
            return scene_fail(scope->reader, scope_line(scope, keys[i]),
                              "'%s' is for transparent materials, and the %s is opaque: give it "
                              "'ior', 'cauchy' or 'transmittance' as well",
                              keys[i], scope->what);
        }
    }
    if (!scope_boolean(scope, "casts_shadow", &material->casts_shadow)) {
        return false;
    }
    if (!material->casts_shadow) {
        return scene_fail(scope->reader, scope_line(scope, "casts_shadow"),
                          "'casts_shadow' of the %s is false: an opaque material always casts a "
                          "shadow",
                          scope->what);
    }
    return true;
}

static bool read_pattern(const struct scene_scope *outer, struct scene_material *material) {
    static const char *const keys[] = {"size", "origin", "colour", NULL};
    struct scene_pattern *pattern = &material->pattern;
    struct scene_scope scope = {outer->reader, NULL, "pattern"};
    if (!scope_group(outer, "pattern", OPTIONAL, &scope.group)) {
        return false;
    }
    pattern->present = scope.group != NULL;
    if (!pattern->present) {
        return true;
    }
    if (!scope_check_keys(&scope, keys) ||
        !scope_three(&scope, "size", REQUIRED, RANGE_PATTERN_SIZE, pattern->size) ||
        !scope_numbers(&scope, "origin", OPTIONAL, RANGE_COORDINATE, 3, pattern->origin) ||
        !scope_numbers(&scope, "colour", REQUIRED, RANGE_COLOUR, 3, pattern->colour)) {
        return false;
    }
    bool changes = false;
    for (int i = 0; i < 3; i++) {
        if (pattern->size[i] > 0 && pattern->size[i] < RANGE_LENGTH.least) {
            return scene_fail(outer->reader, scope_line(&scope, "size"),
                              "'size' of the pattern is %.10g: 0 (no change along that axis), or "
                              "%.10g to %.10g, is allowed",
                              pattern->size[i], RANGE_LENGTH.least, RANGE_LENGTH.most);
        }
        changes = changes || pattern->size[i] > 0;
    }
    if (!changes) {
        return scene_fail(outer->reader, scope_line(&scope, "size"),
                          "'size' of the pattern is 0 along all three axes: leave the pattern out "
                          "for one colour");
    }
    return true;
}

static bool read_material(struct scene_reader *reader, const struct scene_value *group,
                          struct scene_material *material) {
    static const char *const keys[] = {"colour",
                                       "ambient",
                                       "ambient_is_own",
                                       "diffuse",
                                       "specular",
                                       "gloss",
                                       "ior",
                                       "cauchy",
                                       "transmittance",
                                       "reflectance_factors",
                                       "transmittance_factors",
                                       "absorption",
                                       "casts_shadow",
                                       "pattern",
                                       NULL};
    const char *name = group->name;
    char what[64];
    snprintf(what, sizeof what, "material '%.40s'", name);
    const struct scene_scope scope = {reader, group, what};
    if (!scene_is_group(reader, group, "material") || !scope_check_keys(&scope, keys)) {
        return false;
    }
    *material = (struct scene_material){.name = material->name,
                                        .line = group->line,
                                        .gloss = GLOSS_DEFAULT,
                                        .ior = 1,
                                        .ior_by_channel = {1, 1, 1},
                                        .reflectance_by_channel = {1, 1, 1},
                                        .transmittance_by_channel = {1, 1, 1}};
    material->transparent = scope_has(&scope, "ior") || scope_has(&scope, "cauchy") ||
                            scope_has(&scope, "transmittance");
    material->casts_shadow = !material->transparent;
    return scope_numbers(&scope, "colour", REQUIRED, RANGE_COLOUR, 3, material->colour) &&
           scope_number(&scope, "ambient", OPTIONAL, RANGE_SHARE, &material->ambient) &&
           scope_boolean(&scope, "ambient_is_own", &material->ambient_is_own) &&
           scope_number(&scope, "diffuse", OPTIONAL, RANGE_SHARE, &material->diffuse) &&
           read_specular(&scope, material) &&
           scope_integer(&scope, "gloss", OPTIONAL, 0, GLOSS_MOST, &material->gloss) &&
           (material->transparent ? read_optics(&scope, material)
                                  : check_opaque(&scope, material)) &&
           read_pattern(&scope, material);
}

bool scene_read_materials(struct scene_reader *reader, const struct scene_value *root) {
    const struct scene_scope top = {reader, root, "scene"};
    struct scene_description *scene = reader->scene;
    const struct scene_value *group;
    if (!scope_group(&top, "materials", REQUIRED, &group)) {
        return false;
    }
    int count = (int)group->count;
    if (count < 1 || count > SCENE_MATERIALS_MOST) {
        return scene_fail(reader, group->line, "the scene has %d materials: 1 to %d are allowed",
                          count, SCENE_MATERIALS_MOST);
    }
    scene->materials = scene_allocate(reader, (size_t)count, sizeof *scene->materials);
    if (!scene->materials) {
        return false;
    }
    for (int i = 0; i < count; i++) {
        const struct scene_value *element = &group->members[i];
        struct scene_material *material = &scene->materials[i];
        material->name = scene_copy(reader, element->name);
        scene->material_count++;
        if (!material->name || !read_material(reader, element, material)) {
            return false;
        }
    }
    return true;
}

bool scene_find_material(struct scene_reader *reader, const char *name, unsigned line, int *index) {
    const struct scene_description *scene = reader->scene;
    const char *names[SCENE_MATERIALS_MOST + 1] = {NULL};
    for (size_t i = 0; i < scene->material_count; i++) {
        names[i] = scene->materials[i].name;
        if (strcmp(names[i], name) == 0) {
            *index = (int)i;
            return true;
        }
    }
    const char *nearest = nearest_word(name, names);
    if (nearest) {
        return scene_fail(reader, line, "unknown material '%.40s'; did you mean '%.40s'?", name,
                          nearest);
    }
    return scene_fail(reader, line, "unknown material '%.40s': it has to be one of 'materials'",
                      name);
}
