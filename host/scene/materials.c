/* SPDX-License-Identifier: MIT */
/* Reads the materials of a scene file. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/nearest.h"
#include "scene/keys.h"

/* The material that needs no description. */
static const char AIR[] = "air";

static const struct scene_range indices = {0.7, 4, NULL};
static const struct scene_range absorptions = {0, 1e9, "0..10⁹ per unit of length"};
static const struct scene_range cell_sizes = {0, 1e9, "length"};
static const struct scene_range cauchy_coefficients = {-10, 10, NULL};
static const struct scene_range glosses = {0, 65535, NULL};

/* Reads `specular`: a number, perhaps in parentheses, or a table over the angle of incidence. */
static void read_specular(const struct scene_scope *scope, const struct scene_value *value,
                          void *into) {
    struct scene_material *material = into;
    material->has_specular_table = value_is_sequence(value) && value->count != 1;
    if (material->has_specular_table) {
        (void)scene_read_numbers(scope, "specular", value, &RANGE_SHARE, SPECULAR_STEPS,
                                 material->specular_table);
    } else {
        (void)scene_read_number(scope, "specular", value, &RANGE_SHARE, &material->specular);
    }
}

/* Computes Cauchy's n = A + B / wavelength^2 at each channel's wavelength, in micrometres. */
static void read_cauchy(const struct scene_scope *scope, const struct scene_value *value,
                        void *into) {
    struct scene_material *material = into;
    double coefficients[2];
    if (!scene_read_numbers(scope, "cauchy", value, &cauchy_coefficients, 2, coefficients)) {
        return;
    }
    for (int i = 0; i < 3; i++) {
        double micrometres = scope->reader->wavelengths[i] / 1000;
        double ior = coefficients[0] + coefficients[1] / (micrometres * micrometres);
        if (!(ior >= indices.least && ior <= indices.most)) {
            (void)scene_fail(scope->reader, value->at,
                             "'cauchy' of the %s gives an index of %.6g at %.6g nm: %.10g to "
                             "%.10g is allowed",
                             scope->what, ior, scope->reader->wavelengths[i], indices.least,
                             indices.most);
            return;
        }
        material->ior_by_channel[i] = ior;
    }
}

static const struct scene_key pattern_rows[] = {
    {THREE_KEY("size", scene_pattern, size, cell_sizes), .is_required = true,
     .meaning = "of a cell along x, y, z. 0: no change along that axis; not 0 along all three"},
    {NUMBERS_KEY("origin", scene_pattern, origin, 3, RANGE_COORDINATE), .noun = "point",
     .meaning = "a corner of a cell"},
    {NUMBERS_KEY("colour", scene_pattern, colour, 3, RANGE_COLOUR), .noun = "colour",
     .is_required = true, .meaning = "of the odd cells"}};
const struct scene_keys scene_pattern_keys = SCENE_KEYS("pattern", pattern_rows, NULL);

static void read_pattern(const struct scene_scope *outer, const struct scene_value *value,
                         void *into) {
    struct scene_pattern *pattern = &((struct scene_material *)into)->pattern;
    const struct scene_scope scope = {outer->reader, value, scene_pattern_keys.what};
    bool changes = false;
    pattern->present = true;
    if (!scene_read_keys(&scope, &scene_pattern_keys, pattern)) {
        return;
    }
    for (int i = 0; i < 3; i++) {
        changes = changes || pattern->size[i] > 0;
        if (pattern->size[i] > 0 && pattern->size[i] < RANGE_LENGTH.least) {
            (void)scene_fail(outer->reader, scene_place_of(value, "size"),
                             "'size' of the pattern is %.10g: 0 (no change along that axis), or "
                             "%.10g to %.10g, is allowed",
                             pattern->size[i], RANGE_LENGTH.least, RANGE_LENGTH.most);
            return;
        }
    }
    if (!changes) {
        (void)scene_fail(outer->reader, scene_place_of(value, "size"),
                         "'size' of the pattern is 0 along all three axes: leave the pattern out "
                         "for one colour");
    }
}

static const struct scene_material material_defaults = {.gloss = 32,
                                                        .ior = 1,
                                                        .ior_by_channel = {1, 1, 1},
                                                        .reflectance_by_channel = {1, 1, 1},
                                                        .transmittance_by_channel = {1, 1, 1}};

static const struct scene_key material_rows[] = {
    {NUMBERS_KEY("colour", scene_material, colour, 3, RANGE_COLOUR), .noun = "colour",
     .is_required = true,
     .meaning = "Ic, the own colour. Transparent materials have one too, and add it at every "
                "boundary as far as `ambient` and `diffuse` say; without these two it is not seen"},
    {NUMBER_KEY("ambient", scene_material, ambient, RANGE_SHARE),
     .meaning = "a, the share of the ambient light. 0: none"},
    {KEY_AT("ambient_is_own", KEY_TRUTH, scene_material, ambient_is_own),
     .meaning = "the ambient term is a·Ic, not a·Ia: the material shows its own colour where no "
                "light gets"},
    {NUMBER_KEY("diffuse", scene_material, diffuse, RANGE_SHARE),
     .meaning = "ρd, the diffuse reflectance"},
    {OTHER_KEY("specular", read_specular), .noun = "0..1, or 17 of them", .fallback = "0",
     .meaning = "ρs, the highlight's strength; of an opaque material also w, its mirror "
                "coefficient. 17 numbers: w(θ) at θ = 0°, 5.625°, ... 90° of incidence, straight "
                "lines in cos θ between"},
    {WHOLE_KEY("gloss", scene_material, gloss, glosses),
     .meaning = "g, the highlight's exponent: the larger, the smaller the highlight. 0: as wide as "
                "the lit side"},
    {OTHER_KEY("pattern", read_pattern), .noun = "group", .fallback = "left out",
     .meaning = "a second colour in cells, below"},
    {KEY_AT("casts_shadow", KEY_TRUTH, scene_material, casts_shadow),
     .fallback = "`false` if transparent",
     .meaning = "whether it keeps light off other surfaces; an opaque material always does"},
    {THREE_KEY("ior", scene_material, ior_by_channel, indices),
     .meaning = "n, the index of refraction, or n for R, G and B (model `wavelength`; the others "
                "take that of G). 1: rays go straight on and nothing is reflected"},
    {OTHER_KEY("cauchy", read_cauchy), .noun = "2 numbers, -10..10", .fallback = "",
     .meaning = "A and B (in µm²) of n = A + B/λ², in place of `ior`; the n at each of the scene's "
                "`wavelengths` has to be 0.7..4"},
    {NUMBER_KEY("transmittance", scene_material, transmittance, RANGE_SHARE),
     .fallback = "1 − ((n−1)/(n+1))²",
     .meaning = "τ of model `simple`; the default is what a surface lets through straight on"},
    {THREE_KEY("reflectance_factors", scene_material, reflectance_by_channel, RANGE_SHARE),
     .meaning = "model `wavelength`: Ks of R, G, B is multiplied by this"},
    {THREE_KEY("transmittance_factors", scene_material, transmittance_by_channel, RANGE_SHARE),
     .meaning = "the same for Kt"},
    {THREE_KEY("absorption", scene_material, absorption, absorptions),
     .meaning = "α of τ(x) = exp(−αx) along the way x in the medium, for R, G, B. 0.1 leaves 90 % "
                "after one unit. 0: none"}};
const struct scene_keys scene_material_keys =
    SCENE_KEYS("material", material_rows, &material_defaults);

/* Checks what goes for opaque materials alone. */
static void check_opaque(const struct scene_scope *scope, const struct scene_material *material) {
    for (size_t i = SCENE_TRANSPARENT_ROW; i < scene_material_keys.count; i++) {
        const char *key = material_rows[i].name;
        if (value_member(scope->group, key) != NULL) {
            (void)scene_fail(scope->reader, scene_place_of(scope->group, key),
                             "'%s' is for transparent materials, and the %s is opaque: give it "
                             "'ior', 'cauchy' or 'transmittance' as well",
                             key, scope->what);
        }
    }
    if (!material->casts_shadow) {
        (void)scene_fail(scope->reader, scene_place_of(scope->group, "casts_shadow"),
                         "'casts_shadow' of the %s is false: an opaque material always casts a "
                         "shadow",
                         scope->what);
    }
}

static void read_material(struct scene_reader *reader, const struct scene_value *group,
                          struct scene_material *material) {
    char what[64];
    (void)snprintf(what, sizeof what, "material '%.40s'", group->name);
    const struct scene_scope scope = {reader, group, what};
    const bool has_ior = value_member(group, "ior") != NULL;
    const bool has_cauchy = value_member(group, "cauchy") != NULL;
    const bool has_transmittance = value_member(group, "transmittance") != NULL;
    *material = material_defaults;
    material->name = scene_copy(reader, group->name);
    material->line = group->at.line;
    material->transparent = has_ior || has_cauchy || has_transmittance;
    material->casts_shadow = !material->transparent;
    if (!scene_read_keys(&scope, &scene_material_keys, material)) {
        return;
    }
    material->ior = material->ior_by_channel[1];
    if (material->transparent && !has_transmittance) {
        double amplitude = (material->ior - 1) / (material->ior + 1);
        material->transmittance = 1 - amplitude * amplitude; /* what enters at normal incidence */
    }
    if (has_ior && has_cauchy) {
        (void)scene_fail(reader, scene_place_of(group, "cauchy"),
                         "the %s has both 'ior' and 'cauchy': give one of them", what);
    }
    if (!material->transparent) {
        check_opaque(&scope, material);
    }
}

void scene_read_materials(struct scene_reader *reader, const struct scene_value *root) {
    struct scene_description *scene = reader->scene;
    const struct scene_value *group = scene_find_group(root, "materials");
    reader->knows_materials = group != NULL && !group->is_partial;
    if (group == NULL) {
        return;
    }
    if (group->count == 0 && !group->is_partial) {
        (void)scene_fail(reader, group->at, "the scene has no material: 1 or more are wanted");
    }
    /* One more, for air. */
    scene->materials = scene_allocate(reader, group->count + 1, sizeof *scene->materials);
    reader->knows_materials = reader->knows_materials && scene->materials != NULL;
    for (size_t i = 0; scene->materials != NULL && i < group->count; i++) {
        read_material(reader, &group->members[i], &scene->materials[i]);
        scene->material_count = i + 1;
    }
}

/* Adds the material "air", which the file does not describe. Rays go straight on in it, and nothing
 * is reflected, added or kept. Returns the material's index. */
static int add_air(struct scene_reader *reader, unsigned line) {
    struct scene_material *air = &reader->scene->materials[reader->scene->material_count];
    *air = material_defaults;
    air->name = AIR;
    air->line = line;
    air->transparent = true;
    air->transmittance = 1;
    for (int i = 0; i < 3; i++) {
        air->colour[i] = RANGE_COLOUR.most; /* which mixing = "filter" passes unchanged */
    }
    return (int)reader->scene->material_count++;
}

/* Refuses a material that the file does not have. */
static void refuse_material(struct scene_reader *reader, const char *name, struct scene_place at) {
    const struct scene_description *scene = reader->scene;
    const char **names = calloc(scene->material_count + 1, sizeof *names);
    for (size_t i = 0; names != NULL && i < scene->material_count; i++) {
        names[i] = scene->materials[i].name;
    }
    const char *nearest = names != NULL ? nearest_word(name, names) : NULL;
    free(names);
    if (nearest != NULL) {
        (void)scene_fail(reader, at, "unknown material '%.40s'; did you mean '%.40s'?", name,
                         nearest);
    } else {
        (void)scene_fail(reader, at,
                         "unknown material '%.40s': it has to be one of 'materials', or 'air'",
                         name);
    }
}

bool scene_find_material(struct scene_reader *reader, const char *name, struct scene_place at,
                         int *index) {
    const struct scene_description *scene = reader->scene;
    for (size_t i = 0; i < scene->material_count; i++) {
        const char *other = scene->materials[i].name;
        if (other != NULL && strcmp(other, name) == 0) {
            *index = (int)i;
            return true;
        }
    }
    if (!reader->knows_materials) {
        return false;
    }
    if (strcmp(name, AIR) == 0) {
        *index = add_air(reader, at.line);
        return true;
    }
    refuse_material(reader, name, at);
    return false;
}
