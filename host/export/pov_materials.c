/* SPDX-License-Identifier: MIT */
/* The POV-Ray export: materials, so that POV-Ray's shading is Eq. (1). */
#include <math.h>
#include <stdio.h>

#include "export/pov_internal.h"

/* What POV-Ray's transparent pigments do not let through: 1 - T, for T = 1 - 2^-20. POV-Ray scales
 * the pigment's own, opaque part of the light by 1 - T; the pigment is scaled up by as much. What
 * is lost in a path of 255 crossings is 1/16 of a level. Both factors are exact in POV-Ray's single
 * precision. */
#define OPACITY 0x1p-20

/* The colour of a surface with an ambient light, but no own colour to scale the light by. The
 * diffuse light that this colour adds is less than 1/60000 of a level. */
#define TRACE_OF_COLOUR 0x1p-24

/* POV-Ray does not count a ray as a new one where both indices are the same. The next number of
 * POV-Ray's single precision makes the ray count, and bends no ray by a pixel. */
#define INDEX_STEP 0x1p-23

/* What a second layer of texture hides of the first: 1/128 of a level in a path of 255 crossings.
 * POV-Ray's single precision holds 1 - LAYER_OPACITY and 1 / LAYER_OPACITY. */
#define LAYER_OPACITY 0x1p-23

/* The size of a cell along an axis without a pattern. The cell lies from -1/2 to 1/2 of its size,
 * and holds all of the world. */
#define WHOLE_CELL 8192.0

void export_pov_material_name(const struct scene_description *description,
                              const struct compiled_scene *scene, uint32_t material,
                              char name[POV_NAME_SIZE]) {
    (void)snprintf(name, POV_NAME_SIZE, "M%u_%.36s", material,
                   description->materials[scene->materials[material].file].name);
    for (char *letter = name; *letter != '\0'; letter++) {
        *letter = (char)(*letter == '-' ? '_' : *letter);
    }
}

/* Tells whether rays go straight on, and none is reflected. */
static bool is_straight(const struct compiled_scene *scene,
                        const struct compiled_material *material) {
    return scene->simple || fabs(material->ior[0] - 1) < INDEX_STEP / 2;
}

/* Returns what POV-Ray's single precision makes of 1 - T. */
static double opacity_of(const struct compiled_scene *scene,
                         const struct compiled_material *material) {
    if (!material->transparent) {
        return 1;
    }
    return scene->simple ? fmax(1 - (double)(float)material->transmittance, OPACITY) : OPACITY;
}

/* Writes a Ia or a Ic as POV-Ray's emission, which POV-Ray multiplies by the pigment. Where
 * `ambient` is not 0 the pigment has to be TRACE_OF_COLOUR at least. */
static void write_emission(FILE *out, const struct compiled_material *material,
                           const double pigment[3]) {
    double emission[3];
    for (int i = 0; i < 3; i++) {
        emission[i] = material->ambient_share;
        if (material->ambient[i] > 0) {
            emission[i] += material->ambient[i] / 255 / pigment[i];
        }
    }
    (void)fputs(" emission rgb ", out);
    export_pov_vector(out, emission[0], emission[1], emission[2]);
}

/* Tells whether the highlight is as wide as the lit side. POV-Ray's phong shows nothing where the
 * mirror direction turns away from the light, whatever its power is. */
static bool is_wide_highlight(const struct compiled_scene *scene,
                              const struct compiled_material *material) {
    return material->specular > 0 && material->gloss == 0 && !scene->blinn;
}

/* Writes a highlight: one by alpha is POV-Ray's phong, one by beta POV-Ray's specular. */
static void write_highlight(FILE *out, const struct compiled_scene *scene,
                            const struct compiled_material *material) {
    if (material->specular <= 0 || is_wide_highlight(scene, material)) {
        return;
    }
    if (scene->blinn) {
        (void)fprintf(out, "\n        specular %.17g roughness %.17g", material->specular,
                      1 / fmax(material->gloss, 1e-9));
    } else {
        (void)fprintf(out, "\n        phong %.17g phong_size %u", material->specular,
                      material->gloss);
    }
}

static void write_reflection(FILE *out, const struct compiled_scene *scene,
                             const struct compiled_material *material) {
    if (!material->transparent && material->specular > 0) {
        (void)fprintf(out, "\n        reflection { %.17g }", material->specular);
    } else if (material->transparent && !is_straight(scene, material)) {
        (void)fputs("\n        reflection { 0, 1 fresnel on } conserve_energy", out);
    }
}

/* Writes the highlight of gloss 0 as a layer of its own. POV-Ray's diffuse light of a white surface
 * is the light on the whole lit side where brilliance, the cosine's power, is 0. */
static void write_wide_highlight(FILE *out, const struct compiled_material *material) {
    double white = 1 / LAYER_OPACITY;
    (void)fputs("    texture {\n        pigment { rgb ", out);
    export_pov_vector(out, white, white, white);
    (void)fprintf(out,
                  " transmit %.17g }\n        finish { ambient 0 diffuse %.17g brilliance 0 }\n"
                  "    }\n",
                  1 - LAYER_OPACITY, material->specular);
}

static void write_texture(FILE *out, const struct compiled_scene *scene,
                          const struct compiled_material *material, const double colour[3]) {
    double pigment[3];
    double opacity = opacity_of(scene, material);
    for (int i = 0; i < 3; i++) {
        pigment[i] = colour[i] / 255;
        if (material->ambient[i] > 0) {
            pigment[i] = fmax(pigment[i], TRACE_OF_COLOUR);
        }
    }
    (void)fputs("    texture {\n        pigment { rgb ", out);
    export_pov_vector(out, pigment[0] / opacity, pigment[1] / opacity, pigment[2] / opacity);
    if (material->transparent) {
        (void)fprintf(out, " transmit %.17g", 1 - opacity);
    }
    (void)fprintf(out, " }\n        finish { ambient 0 diffuse %.17g", material->diffuse);
    write_emission(out, material, pigment);
    write_highlight(out, scene, material);
    write_reflection(out, scene, material);
    (void)fputs(" }\n    }\n", out);
    if (is_wide_highlight(scene, material)) {
        write_wide_highlight(out, material);
    }
}

/* Declares the textures of both colours: only a declared one may have layers within a pattern. */
static void declare_cells(FILE *out, const struct compiled_scene *scene,
                          const struct compiled_material *material, const char *name) {
    (void)fprintf(out, "#declare %s_even =\n", name);
    write_texture(out, scene, material, material->colour);
    (void)fprintf(out, "#declare %s_odd =\n", name);
    write_texture(out, scene, material, scene->patterns[material->pattern].colour);
}

/* Writes cells of two textures: POV-Ray's checker has cells of size 1, the even ones first. */
static void write_pattern(FILE *out, const struct compiled_scene *scene,
                          const struct compiled_material *material, const char *name) {
    const struct compiled_pattern *pattern = &scene->patterns[material->pattern];
    double size[3], origin[3];
    for (int i = 0; i < 3; i++) {
        bool changes = (pattern->axes >> i & 1) != 0;
        size[i] = changes ? pattern->size[i] : WHOLE_CELL;
        origin[i] = changes ? pattern->origin[i] : -WHOLE_CELL / 2;
    }
    (void)fprintf(out,
                  "    texture {\n        checker texture { %s_even } texture { %s_odd }\n"
                  "        scale ",
                  name, name);
    export_pov_vector(out, size[0], size[1], size[2]);
    (void)fputs("\n        translate ", out);
    export_pov_vector(out, origin[0], origin[1], origin[2]);
    (void)fputs("\n    }\n", out);
}

static void write_interior(FILE *out, const struct compiled_scene *scene,
                           const struct compiled_material *material) {
    double ior = is_straight(scene, material) ? 1 + INDEX_STEP : material->ior[0];
    (void)fprintf(out, "    interior {\n        ior %.17g\n", ior);
    if (material->absorbs) {
        (void)fputs("        media { absorption rgb ", out);
        export_pov_vector(out, material->absorption[0], material->absorption[1],
                          material->absorption[2]);
        (void)fputs(" }\n", out);
    }
    (void)fputs("    }\n", out);
}

void export_pov_materials(FILE *out, const struct scene_description *description,
                          const struct compiled_scene *scene) {
    char name[POV_NAME_SIZE];
    for (uint32_t i = 1; i < scene->material_count; i++) {
        const struct compiled_material *material = &scene->materials[i];
        export_pov_material_name(description, scene, i, name);
        if (material->pattern != PATTERN_NONE) {
            declare_cells(out, scene, material, name);
        }
        (void)fprintf(out, "#declare %s = material {\n", name);
        if (material->pattern == PATTERN_NONE) {
            write_texture(out, scene, material, material->colour);
        } else {
            write_pattern(out, scene, material, name);
        }
        if (material->transparent) {
            write_interior(out, scene, material);
        }
        (void)fputs("}\n\n", out);
    }
}
