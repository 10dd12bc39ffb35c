/* SPDX-License-Identifier: MIT */
/* Remarks on what a scene says, and perhaps does not mean. */
#include "render/remarks.h"

#include <inttypes.h>
#include <math.h>
#include <string.h>

#include "base/complain.h"
#include "compiler/affine.h"

/* Faces that are more than this many times the noise apart are told apart at any place and
 * angle. */
enum { NOISES_APART = 16 };

static bool tells_apart(const struct compiled_scene *scene, const struct arithmetic *arithmetic,
                        const struct compiled_near *near) {
    return ldexp(near->distance, scene->exponent) > NOISES_APART * arithmetic->noise;
}

/* Rounds a number above 0 up to two digits. */
static double round_up(double number) {
    double digit = pow(10, floor(log10(number)) - 1);
    return ceil(number / digit) * digit;
}

/* Returns the `weld` that makes all of the faces one. */
static double weld_of(const struct compiled_scene *scene) {
    double most = 0;
    for (uint32_t i = 0; i < scene->near_count && i < COMPILED_NEAR_MOST; i++) {
        most = fmax(most, scene->near[i].distance);
    }
    return most > 0 ? round_up(most) : 0;
}

static bool eye_is_in_opaque(const struct compiled_scene *scene) {
    return !scene->materials[scene->objects[scene->camera.object].material].transparent;
}

/* ---- Where a floor ends ---------------------------------------------------------------------- */

/* A plane that is seen to end before its horizon. */
struct short_floor {
    unsigned line;    /* of its object */
    double away;      /* from the eye to its end, in the file's unit */
    double pixels;    /* its end lies so far under the horizon */
    double far_world; /* the `world` that puts the end one pixel under it */
};

/* Finds the plane of an object that has no end and one face only; false: the object is none such.
 * The normal points out of the object. */
static bool floor_of(const struct compiled_scene *scene, const struct compiled_object *object,
                     double normal[3], double *offset) {
    int ends = 0;
    for (int i = 0; i < 3; i++) {
        const bool is_low = isfinite(object->bounds.low[i]),
                   is_high = isfinite(object->bounds.high[i]);
        ends += is_low + is_high;
        normal[i] = is_high - is_low;
        *offset = is_high ? object->bounds.high[i] : is_low ? -object->bounds.low[i] : *offset;
    }
    if (ends > 0) {
        return ends == 1;
    }
    const uint32_t code = scene->programs[object->program];
    if (object->length != 1 || scene->primitives[code].kind != PRIMITIVE_POLYHEDRON) {
        return false;
    }
    const struct compiled_polyhedron *solid = &scene->polyhedra[scene->primitives[code].index];
    for (uint32_t i = 0; i < solid->count; i++) {
        const struct compiled_plane *plane = &scene->planes[solid->first + i];
        if (plane->offset < COMPILED_WORLD) { /* others are the world's end */
            memcpy(normal, plane->normal, sizeof plane->normal);
            *offset = plane->offset;
            ends++;
        }
    }
    return ends == 1;
}

/* Computes the direction in which a place of the picture lies; -1 to 1 across and down. */
static void direction_of(const struct compiled_scene *scene, double across, double down,
                         double direction[3]) {
    const struct compiled_camera *camera = &scene->camera;
    for (int i = 0; i < 3; i++) {
        direction[i] = camera->forward[i] + ldexp(camera->column[i] * across * scene->width +
                                                      camera->row[i] * down * scene->height,
                                                  -camera->shift);
    }
}

/* Returns how far it is from the eye to the world's end, along a direction of length 1. */
static double distance_to_end(const struct compiled_scene *scene, const double direction[3]) {
    double away = INFINITY;
    for (int i = 0; i < 3; i++) {
        if (fabs(direction[i]) > 1e-9) {
            away = fmin(away, (copysign(COMPILED_WORLD, direction[i]) - scene->camera.eye[i]) /
                                  direction[i]);
        }
    }
    return away;
}

/* Looks where a plane is seen to end, ahead of the eye. Returns true if that is more than one pixel
 * under its horizon, and the picture reaches beyond that end. */
static bool ends_early(const struct compiled_scene *scene, const double normal[3], double offset,
                       struct short_floor *found) {
    const struct compiled_camera *camera = &scene->camera;
    double ahead[3];
    direction_of(scene, 0, 0, ahead);
    const double sunk = vector_dot(ahead, normal);
    for (int i = 0; i < 3; i++) {
        ahead[i] -= sunk * normal[i];
    }
    (void)vector_normalise(ahead);
    const double away = distance_to_end(scene, ahead);
    const double slope = (vector_dot(camera->eye, normal) - offset) / away;
    const double pitch =
        ldexp(2 * vector_length(camera->column), -camera->shift) / vector_length(camera->forward);
    bool is_seen = false, is_passed = false;
    for (int i = 0; i < 6; i++) {
        double edge[3];
        direction_of(scene, i % 3 - 1, i < 3 ? -1 : 1, edge);
        const double down = -vector_dot(edge, normal);
        const double sinks = down / sqrt(vector_dot(edge, edge) - down * down);
        is_seen = is_seen || sinks > slope;
        is_passed = is_passed || sinks < slope;
    }
    found->pixels = slope / pitch;
    found->away = ldexp(away, -scene->exponent);
    found->far_world = round_up(ldexp(COMPILED_WORLD * found->pixels, -scene->exponent));
    return is_seen && is_passed && slope > pitch;
}

static bool find_short_floor(const struct compiled_scene *scene, struct short_floor *found) {
    for (uint32_t i = 1; i < scene->object_count; i++) {
        const struct compiled_object *object = &scene->objects[i];
        double normal[3], offset = 0;
        if (floor_of(scene, object, normal, &offset) && ends_early(scene, normal, offset, found)) {
            found->line = object->line;
            return true;
        }
    }
    return false;
}

void remarks_complain(const struct compiled_scene *scene, const struct arithmetic *arithmetic) {
    const struct compiled_near *first = NULL;
    for (uint32_t i = 0; i < scene->near_count && i < COMPILED_NEAR_MOST && !first; i++) {
        first = tells_apart(scene, arithmetic, &scene->near[i]) ? NULL : &scene->near[i];
    }
    if (first != NULL) {
        complain(
            "%s:%u: a face %.2g from one of line %u, which %s may not tell apart: seams may "
            "show; 'weld = %.2g;' makes such faces one (`superframe check` names all %u pairs)",
            scene->path, first->other_line, first->distance, first->line, arithmetic->image->name,
            weld_of(scene), scene->near_count);
    }
    struct short_floor floor;
    if (scene->object_count == 1) {
        complain("%s: nothing is in view, the picture is all background; turn the camera's "
                 "'look_at' to the objects (`superframe check` names what is out of view)",
                 scene->path);
    }
    if (!scene->has_world && find_short_floor(scene, &floor)) {
        complain("%s:%u: this endless object is seen to end, %.3g units away and %.1f pixels under "
                 "its horizon; 'world = %.10g;' in the scene puts its end farther",
                 scene->path, floor.line, floor.away, floor.pixels, floor.far_world);
    }
    if (eye_is_in_opaque(scene)) {
        complain("%s:%u: the eye is inside this opaque object: all that is seen is its inner side; "
                 "move the eye if that is not meant",
                 scene->path, scene->objects[scene->camera.object].line);
    }
}

void remarks_complain_of_error(const struct compiled_scene *scene,
                               const struct render_totals *totals) {
    if (totals->unreached_pixels > 0) {
        complain("%s: %" PRIu64 " of %" PRIu64
                 " pixels did not reach --error %g; the worst is %u, %u, with an "
                 "estimated error of %.3g levels; a larger E or a lower --depth takes fewer rays",
                 scene->path, totals->unreached_pixels, (uint64_t)totals->rows * scene->width,
                 scene->error, totals->worst_x, totals->worst_y, totals->estimated_error / 65536.0);
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
    for (uint32_t i = 0; i < scene->near_count && i < COMPILED_NEAR_MOST; i++) {
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
    struct short_floor floor;
    if (scene->object_count == 1) {
        (void)fprintf(out, "view        nothing is in view: the picture is all background\n");
    }
    if (find_short_floor(scene, &floor)) {
        (void)fprintf(
            out,
            "horizon     the endless object of line %u is seen to end %.3g units away, "
            "%.1f pixels\n            under its horizon; 'world = %.10g;' in the scene puts "
            "its end farther\n",
            floor.line, floor.away, floor.pixels, floor.far_world);
    }
    if (scene->camera.object != 0) {
        (void)fprintf(out, "eye         inside the %s object of line %u\n",
                      eye_is_in_opaque(scene) ? "opaque" : "transparent",
                      scene->objects[scene->camera.object].line);
    }
}
