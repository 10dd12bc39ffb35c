/* SPDX-License-Identifier: MIT */
/* Remarks on what a scene says, and perhaps does not mean. */
#include "render/remarks.h"

#include <math.h>

#include "base/complain.h"

/* Faces that are more than this many times the noise apart are told apart at any place and
 * angle. */
enum { NOISES_APART = 16 };

static bool tells_apart(const struct compiled_scene *scene, const struct arithmetic *arithmetic,
                        const struct compiled_near *near) {
    return ldexp(near->distance, scene->exponent) > NOISES_APART * arithmetic->noise;
}

/* Returns the largest distance, rounded up to two digits: a `weld` of that length makes all of the
 * faces one. */
static double weld_of(const struct compiled_scene *scene) {
    double most = 0;
    for (unsigned i = 0; i < scene->near_count && i < COMPILED_NEAR_MOST; i++) {
        most = fmax(most, scene->near[i].distance);
    }
    double digit = most > 0 ? pow(10, floor(log10(most)) - 1) : 1;
    return ceil(most / digit) * digit;
}

static bool eye_is_in_opaque(const struct compiled_scene *scene) {
    return !scene->materials[scene->objects[scene->camera.object].material].transparent;
}

void remarks_complain(const struct compiled_scene *scene, const struct arithmetic *arithmetic) {
    const struct compiled_near *first = NULL;
    for (unsigned i = 0; i < scene->near_count && i < COMPILED_NEAR_MOST && !first; i++) {
        first = tells_apart(scene, arithmetic, &scene->near[i]) ? NULL : &scene->near[i];
    }
    if (first != NULL) {
        complain(
            "%s:%u: a face %.2g from one of line %u, which %s may not tell apart: seams may "
            "show; 'weld = %.2g;' makes such faces one (`superframe check` names all %u pairs)",
            scene->path, first->other_line, first->distance, first->line, arithmetic->image->name,
            weld_of(scene), scene->near_count);
    }
    if (eye_is_in_opaque(scene)) {
        complain("%s:%u: the eye is inside this opaque object: all that is seen is its inner side; "
                 "move the eye if that is not meant",
                 scene->path, scene->objects[scene->camera.object].line);
    }
}

/* Prints a pair of near faces, and the arithmetics that may take both for one at some places. */
static void print_near(FILE *out, const struct compiled_scene *scene,
                       const struct compiled_near *near) {
    static const char *const names[] = {"fx", "f32", "f64", "f128"};
    const char *separator = "; seams may show in ";
    (void)fprintf(out, "near        faces of lines %u and %u are %.2g apart", near->line,
                  near->other_line, near->distance);
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
        const struct arithmetic *arithmetic = arithmetic_find(names[i]);
        if (arithmetic != NULL && !tells_apart(scene, arithmetic, near)) {
            (void)fprintf(out, "%s%s", separator, names[i]);
            separator = ", ";
        }
    }
    (void)fprintf(out, "\n");
}

void remarks_print(FILE *out, const struct compiled_scene *scene) {
    for (unsigned i = 0; i < scene->near_count && i < COMPILED_NEAR_MOST; i++) {
        print_near(out, scene, &scene->near[i]);
    }
    if (scene->near_count > COMPILED_NEAR_MOST) {
        (void)fprintf(out, "near        %u more pairs of faces\n",
                      scene->near_count - COMPILED_NEAR_MOST);
    }
    if (scene->near_count > 0) {
        (void)fprintf(out, "near        'weld = %.2g;' in the scene makes such faces one\n",
                      weld_of(scene));
    }
    if (scene->camera.object != 0) {
        (void)fprintf(out, "eye         inside the %s object of line %u\n",
                      eye_is_in_opaque(scene) ? "opaque" : "transparent",
                      scene->objects[scene->camera.object].line);
    }
}
