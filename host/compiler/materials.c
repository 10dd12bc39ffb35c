/* SPDX-License-Identifier: MIT */
/* The scene compiler: materials, their patterns and their tables. */
#include <math.h>
#include <string.h>

#include "compiler/compiler_internal.h"

static bool same_indices(const struct compiled_material *a, const struct compiled_material *b) {
    for (int i = 0; i < 3; i++) {
        if (a->ior[i] < b->ior[i] || a->ior[i] > b->ior[i]) {
            return false;
        }
    }
    return true;
}

/* Returns the first material with the same indices of refraction. */
static uint8_t optical_class(const struct compiled_scene *scene, uint8_t material) {
    uint8_t i = 0;
    while (!same_indices(&scene->materials[i], &scene->materials[material])) {
        i++;
    }
    return i;
}

/* Compiles a material's specular constant, or its table of w(theta) by the cosine of theta. The
 * first entry of the table is that of theta = 0. */
static void compile_specular(struct compiler *compiler, const struct scene_material *from,
                             struct compiled_material *to) {
    struct compiled_scene *scene = compiler->scene;
    size_t index = (size_t)(from - compiler->description->materials);
    to->specular = from->specular;
    to->specular_table = SPECULAR_CONSTANT;
    if (compiler->dead->highlight[index] != NULL) {
        to->specular = 0;
        return;
    }
    if (compiler->dead->table[index] != NULL) {
        to->specular = from->specular_table[0];
        return;
    }
    if (!from->has_specular_table) {
        return;
    }
    to->specular_table = (uint8_t)scene->specular_table_count;
    struct compiled_specular_table *table = &scene->specular_tables[scene->specular_table_count++];
    for (int i = 0; i < SPECULAR_STEPS; i++) {
        double theta = i * 1.57079632679489661923 / (SPECULAR_STEPS - 1);
        table->cosine[i] = i + 1 < SPECULAR_STEPS ? cos(theta) : 0;
        table->specular[i] = from->specular_table[i];
    }
}

/* Sets the indices and factors of each channel, as the model that the scene asks for has them. */
static void compile_optics(const struct scene_description *description,
                           const struct scene_material *from, struct compiled_material *to) {
    bool by_channel = description->model == MODEL_WAVELENGTH;
    to->transmittance = from->transparent ? from->transmittance : 0;
    for (int i = 0; i < 3; i++) {
        to->ior[i] = !from->transparent ? 1 : by_channel ? from->ior_by_channel[i] : from->ior;
        to->inverse_ior[i] = 1 / to->ior[i];
        to->disperses = to->disperses || to->ior[i] < to->ior[0] || to->ior[i] > to->ior[0];
        to->reflects[i] = by_channel ? from->reflectance_by_channel[i] : 1;
        to->transmits[i] = by_channel ? from->transmittance_by_channel[i] : 1;
        to->tints = to->tints || to->reflects[i] < 1 || to->transmits[i] < 1;
        to->filter[i] = fmin(from->colour[i] / 255, 1);
    }
}

static bool compile_absorption(struct compiler *compiler, const struct scene_material *from,
                               struct compiled_material *to) {
    int exponent = compiler->scene->exponent;
    for (int i = 0; i < 3; i++) {
        to->absorption[i] = ldexp(from->absorption[i], -exponent);
        to->absorbs = to->absorbs || from->absorption[i] > 0;
        if (to->absorption[i] >= 8) {
            return compile_fail(compiler, from->line,
                                "absorption too strong for the size of the scene: at most %g is "
                                "allowed; an opaque material looks the same",
                                ldexp(7.99, exponent));
        }
    }
    return true;
}

/* Makes a material that is not seen and does not keep light off. */
static void compile_nothing(struct compiled_material *material) {
    material->pattern = PATTERN_NONE;
    material->specular_table = SPECULAR_CONSTANT;
    for (int i = 0; i < 3; i++) {
        material->ior[i] = material->inverse_ior[i] = 1;
        material->reflects[i] = material->transmits[i] = material->filter[i] = 1;
    }
}

static bool compile_look(struct compiler *compiler, size_t index, struct compiled_material *to) {
    const struct scene_description *description = compiler->description;
    const struct scene_material *from = &description->materials[index];
    const struct compile_dead *dead = compiler->dead;
    to->diffuse = from->diffuse;
    to->gloss = (uint16_t)from->gloss;
    to->transparent = from->transparent;
    to->ambient_share = from->ambient_is_own ? from->ambient : 0;
    for (int i = 0; i < 3; i++) {
        to->colour[i] = from->colour[i];
        to->ambient[i] = from->ambient_is_own ? 0 : from->ambient * description->ambient[i];
    }
    compile_specular(compiler, from, to);
    compile_optics(description, from, to);
    return (dead->pattern[index] != NULL || compile_pattern(compiler, from, to)) &&
           (dead->absorption[index] != NULL || compile_absorption(compiler, from, to));
}

bool compile_materials(struct compiler *compiler) {
    const struct scene_description *description = compiler->description;
    struct compiled_scene *scene = compiler->scene;
    compile_nothing(&scene->materials[0]);
    scene->materials[0].transparent = true;
    scene->materials[0].transmittance = 1;
    scene->material_count = 1;
    for (size_t i = 0; i < description->material_count; i++) {
        if (compiler->dead->material[i] != NULL) {
            continue;
        }
        uint8_t number = (uint8_t)scene->material_count++;
        struct compiled_material *to = &scene->materials[number];
        compiler->material_of[i] = number;
        to->file = (uint8_t)i;
        compile_nothing(to);
        if (compiler->dead->look[i] == NULL && !compile_look(compiler, i, to)) {
            return false;
        }
        to->casts_shadow =
            description->materials[i].casts_shadow || !description->materials[i].transparent;
        to->optical = optical_class(scene, number);
    }
    return true;
}
