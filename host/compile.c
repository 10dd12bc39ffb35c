/* SPDX-License-Identifier: MIT */
/* The scene compiler: from a description to the firmware's tables, centred and scaled. */
#include "compile_internal.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

bool compile_fail(struct compiler *compiler, unsigned line, const char *format, ...) {
    char what[400];
    va_list arguments;
    va_start(arguments, format);
    vsnprintf(what, sizeof what, format, arguments);
    va_end(arguments);
    const char *path = compiler->description->path;
    if (line > 0) {
        snprintf(compiler->error->text, sizeof compiler->error->text, "%.90s:%u: %s", path, line,
                 what);
    } else {
        snprintf(compiler->error->text, sizeof compiler->error->text, "%.100s: %s", path, what);
    }
    return false;
}

/* The bounds of all that has an end: finite solids, the eye, the point lights. */
static struct bounds content_bounds(const struct scene_description *description) {
    struct bounds all = bounds_nothing;
    bounds_include(&all, description->camera.eye);
    for (size_t i = 0; i < description->light_count; i++) {
        if (!description->lights[i].parallel) {
            bounds_include(&all, description->lights[i].position);
        }
    }
    for (size_t i = 0; i < description->object_count; i++) {
        struct bounds solid =
            solid_bounds(description, description->objects[i].solid, &affine_identity);
        if (bounds_are_finite(&solid) && !bounds_are_empty(&solid)) {
            all = bounds_union(&all, &solid);
        }
    }
    return all;
}

/* Coordinates of a file that were rounded a few times on their way: relative to the farthest. */
#define FILE_ROUNDING 0x1p-50

bool compile_scaling(struct compiler *compiler) {
    struct compiled_scene *scene = compiler->scene;
    struct bounds all = content_bounds(compiler->description);
    double reach = 0;
    for (int i = 0; i < 3; i++) {
        scene->centre[i] = all.low[i] / 2 + all.high[i] / 2;
        reach = fmax(reach, all.high[i] / 2 - all.low[i] / 2);
    }
    if (!(reach <= 1e12 && reach >= 1e-12)) {
        return compile_fail(compiler, 0,
                            "solids, eye and lights lie within %g units; 1e-12 to 1e12 is allowed: "
                            "choose another unit of length",
                            reach);
    }
    scene->exponent = (int)floor(log2(COMPILE_EXTENT / reach));
    double farthest = 0;
    for (int i = 0; i < 3; i++) {
        farthest = fmax(farthest, fmax(fabs(all.low[i]), fabs(all.high[i])));
    }
    double weld = compiler->description->weld;
    compiler->same = fmax(COMPILE_SAME, ldexp(FILE_ROUNDING * farthest, scene->exponent));
    compiler->same = fmax(compiler->same, ldexp(weld, scene->exponent));
    if (compiler->same > COMPILE_WELD_MOST) {
        return compile_fail(compiler, 0,
                            weld > 0 ? "'weld' is %g; at most %g is allowed for this scene's size"
                                     : "the file's numbers are rounded to %g so far from the "
                                       "origin; at most %g is allowed: move the scene nearer to it",
                            weld > 0 ? weld : FILE_ROUNDING * farthest,
                            ldexp(COMPILE_WELD_MOST, -scene->exponent));
    }
    compiler->scaling = affine_identity;
    for (int i = 0; i < 3; i++) {
        compiler->scaling.m[i][i] = ldexp(1, scene->exponent);
        compiler->scaling.m[i][3] = -ldexp(scene->centre[i], scene->exponent);
    }
    return true;
}

struct compiled_scene *scene_compile(const struct scene_description *description,
                                     struct scene_error *error) {
    struct compiled_scene *scene = calloc(1, sizeof *scene);
    struct compiler *compiler = calloc(1, sizeof *compiler);
    bool good = scene && compiler;
    if (!good) {
        snprintf(error->text, sizeof error->text, "%.100s: out of memory", description->path);
    } else {
        compiler->description = description;
        memcpy(compiler->directions, (double[3][3]){{1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
               3 * sizeof compiler->directions[0]);
        compiler->direction_count = 3;
        compiler->scene = scene;
        compiler->error = error;
        snprintf(scene->path, sizeof scene->path, "%s", description->path);
        good = compile_scaling(compiler) && compile_materials(compiler) &&
               compile_objects(compiler) && compile_optimise(compiler) &&
               compile_pattern_faces(compiler) && compile_view(compiler) &&
               compile_colour(compiler);
    }
    if (good) {
        compile_lights(compiler);
        compile_brightest(compiler);
        compile_shadows(compiler);
        compile_enclosures(compiler);
        compile_near(compiler);
    }
    free(compiler);
    if (!good) {
        free(scene);
        return NULL;
    }
    return scene;
}
