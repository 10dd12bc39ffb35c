/* SPDX-License-Identifier: MIT */
/* What the generated scenes covered. */
#include "coverage.h"

#include <string.h>

/* What the compiler did, and what materials and scenes have. */
enum feature {
    STEP_SHARED,
    STEP_SIMPLIFIED,
    STEP_FUSED,
    STEP_BOUNDED,
    STEP_HIDDEN,
    STEP_ENCLOSED,
    STEP_CUT_QUADRIC,
    STEP_TURNED,
    STEP_STRAIGHTENED,
    STEP_COMPACTED,
    STEP_NO_SHADOWS,
    OF_PATTERN,
    OF_TABLE,
    OF_ABSORPTION,
    OF_DISPERSION,
    OF_TINT,
    OF_MIRROR,
    OF_SHADOW_OF_GLASS,
    OF_LESS_THAN_AIR,
    OF_FADING,
    OF_FILTERS,
    OF_BLINN,
    OF_SIMPLE,
    OF_WAVELENGTH,
    OF_POINT_LIGHT,
    OF_PARALLEL_LIGHT,
    OF_ENDLESS,
    OF_PARTS,
    OF_MIRRORING,
    OF_NO_THRESHOLD,
    FEATURES
};

static const char *const names[SYNTAX_KINDS + MOTIFS + FEATURES] = {
    "box", "ball", "cylinder", "cone", "ellipsoid", "paraboloid", "hyperboloid of one sheet",
    "hyperboloid of two sheets", "quadric", "half-space", "polyhedron", "union", "intersection",
    "difference", "part",
    /* motifs */
    "touching", "standing", "reworded", "coaxial", "cut twice", "off centre", "nested", "overlap",
    "turned faces", "mixed materials", "mirror images", "tree", "around the eye", "eye amid",
    "crowd",
    /* features */
    "step: shared", "step: simplified", "step: fused", "step: bounded", "step: hidden",
    "step: enclosed", "step: cut quadrics", "step: turned frames", "step: straightened frames",
    "step: compacted", "step: lights without shadows", "pattern", "table w(theta)", "absorption",
    "dispersion", "tint", "mirror", "shadow of glass", "index below 1", "fading", "filters",
    "blinn", "simple model", "wavelength model", "point light", "parallel light",
    "half-space as object", "parts", "mirroring placement", "no threshold"};

static bool has_enclosure(const struct compiled_scene *compiled) {
    for (uint32_t i = 0; i < compiled->primitive_count; i++) {
        if (compiled->primitives[i].enclosure != COMPILED_ENCLOSURE_NONE) {
            return true;
        }
    }
    return false;
}

static bool has_cut_quadric(const struct compiled_scene *compiled) {
    for (uint32_t i = 0; i < compiled->quadric_count; i++) {
        if (compiled->quadrics[i].cuts != 0) {
            return true;
        }
    }
    return false;
}

static bool has_turned_frame(const struct compiled_scene *compiled) {
    for (uint32_t i = 0; i < compiled->primitive_count; i++) {
        if (compiled->primitives[i].frame != COMPILED_FRAME_WORLD) {
            return true;
        }
    }
    return false;
}

static bool is_shadowless(const struct compiled_scene *compiled) {
    for (uint32_t i = 0; i < compiled->light_count; i++) {
        if (!compiled->lights[i].casts_shadows) {
            return true;
        }
    }
    return false;
}

static void note_steps(const struct compiled_scene *compiled, bool *has) {
    const struct compiled_report *report = &compiled->report;
    has[STEP_SHARED] = report->shared > 0;
    has[STEP_SIMPLIFIED] = report->simplified > 0;
    has[STEP_FUSED] = report->fused > 0;
    has[STEP_BOUNDED] = report->bounded > 0;
    has[STEP_HIDDEN] = report->hidden > 0;
    has[STEP_ENCLOSED] = has_enclosure(compiled);
    has[STEP_CUT_QUADRIC] = has_cut_quadric(compiled);
    has[STEP_TURNED] = has_turned_frame(compiled);
    /* What is simplified or fused away leaves its place in a table to a polyhedron behind it. */
    has[STEP_COMPACTED] = report->simplified + report->fused > 0 && compiled->polyhedron_count > 0;
    has[STEP_NO_SHADOWS] = is_shadowless(compiled);
}

static void note_materials(const struct syntax *scene, bool *has) {
    for (int i = 0; i < scene->material_count; i++) {
        const struct syntax_material *material = &scene->materials[i];
        if (!syntax_uses_material(scene, i)) {
            continue;
        }
        has[OF_PATTERN] = has[OF_PATTERN] || material->pattern.present;
        has[OF_TABLE] = has[OF_TABLE] || material->has_table;
        has[OF_MIRROR] = has[OF_MIRROR] || (!material->transparent && material->specular > 0);
        has[OF_ABSORPTION] = has[OF_ABSORPTION] || material->absorption[0] > 0;
        has[OF_DISPERSION] = has[OF_DISPERSION] || material->disperses;
        has[OF_TINT] = has[OF_TINT] || material->reflects[1] < 1 || material->transmits[2] < 1;
        has[OF_SHADOW_OF_GLASS] = has[OF_SHADOW_OF_GLASS] || material->casts_shadow;
        has[OF_LESS_THAN_AIR] = has[OF_LESS_THAN_AIR] || material->ior[0] < 1;
    }
}

/* Checks for a placement by right angles, not all 0: its frame becomes the world's again. */
static bool is_straightened(const struct syntax_solid *solid) {
    bool is_turned = false;
    for (int i = 0; i < 3; i++) {
        int degrees = (int)solid->rotate[i];
        if (degrees < solid->rotate[i] || degrees > solid->rotate[i] || degrees % 90 != 0) {
            return false;
        }
        is_turned = is_turned || degrees != 0;
    }
    return is_turned;
}

static void note_scene(const struct syntax *scene, bool *has) {
    has[OF_FADING] = scene->fades;
    has[OF_FILTERS] = scene->filters;
    has[OF_BLINN] = scene->blinn;
    has[OF_SIMPLE] = scene->model == SYNTAX_SIMPLE;
    has[OF_WAVELENGTH] = scene->model == SYNTAX_WAVELENGTH;
    has[OF_ENDLESS] = syntax_has_endless(scene);
    has[OF_PARTS] = scene->part_count > 0;
    has[OF_NO_THRESHOLD] = scene->threshold <= 0;
    for (int i = 0; i < scene->light_count; i++) {
        has[scene->lights[i].parallel ? OF_PARALLEL_LIGHT : OF_POINT_LIGHT] = true;
    }
}

void coverage_add(struct coverage *coverage, const struct syntax *scene,
                  const struct compiled_scene *compiled) {
    int list[SYNTAX_SOLIDS_MOST], count = syntax_list(scene, list);
    bool has[SYNTAX_KINDS + MOTIFS + FEATURES];
    bool *features = has + SYNTAX_KINDS + MOTIFS;
    memset(has, 0, sizeof has);
    for (int i = 0; i < count; i++) {
        const struct syntax_solid *solid = &scene->solids[list[i]];
        has[solid->kind] = true;
        features[OF_MIRRORING] = features[OF_MIRRORING] || solid->scale[0] < 0;
        features[STEP_STRAIGHTENED] = features[STEP_STRAIGHTENED] || is_straightened(solid);
    }
    for (int i = 0; i < MOTIFS; i++) {
        has[SYNTAX_KINDS + i] = (scene->motifs >> i & 1) != 0;
    }
    note_steps(compiled, features);
    note_materials(scene, features);
    note_scene(scene, features);
    for (int i = 0; i < SYNTAX_KINDS + MOTIFS + FEATURES; i++) {
        coverage->scenes[i] += has[i];
    }
}

int coverage_print(const struct coverage *coverage, FILE *file) {
    int missing = 0;
    for (int i = 0; i < SYNTAX_KINDS + MOTIFS + FEATURES; i++) {
        (void)fprintf(file, "%s%s %lu", i % 6 == 0 ? "\n  " : ", ", names[i], coverage->scenes[i]);
        missing += coverage->scenes[i] == 0;
    }
    (void)fprintf(file, "\n");
    return missing;
}
