/* SPDX-License-Identifier: MIT */
/* The scene compiler: camera, the solids that the eye is inside of, lights, the largest intensity,
 * and how colours are shown. */
#include "base/grow.h"
#include "compiler/compiler_internal.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "board_ports.h"

/* A pixel that traps light ends after so many rays: where an accuracy is asked for, and where none
 * is. */
enum { RAYS_FOR_ACCURACY_MOST = 100000, RAYS_OF_A_PIXEL_MOST = 1000000 };

static void scaled_point(const struct compiler *compiler, const double point[3], double out[3]) {
    affine_point(&compiler->scaling, point, out);
}

/* Returns the object that the eye is in; 0 is the air. */
static uint32_t object_at_eye(const struct compiled_scene *scene) {
    uint32_t i = scene->object_count - 1;
    while (i > 0 && !compiled_object_holds(scene, i, scene->camera.eye)) {
        i--;
    }
    return i;
}

/* Finds an object of a material that has no end; returns 0 if there is none. */
static uint32_t endless_object(const struct compiler *compiler, uint8_t material) {
    uint32_t i = compiler->scene->object_count - 1;
    while (i > 0 && (compiler->scene->objects[i].material != material ||
                     bounds_are_finite(&compiler->scene->objects[i].bounds))) {
        i--;
    }
    return i;
}

/* Refuses an eye in an opaque material that goes on without an end. Where the world ends for the
 * firmware, such a material has no surface. */
static bool check_eye(struct compiler *compiler) {
    const struct compiled_scene *scene = compiler->scene;
    uint8_t material = scene->objects[scene->camera.object].material;
    uint32_t endless =
        scene->materials[material].transparent ? 0 : endless_object(compiler, material);
    if (endless == 0) {
        return true;
    }
    char reason[64] = "which has no end";
    if (endless != scene->camera.object) {
        (void)snprintf(reason, sizeof reason, "and that of line %u has its material and no end",
                       scene->objects[endless].line);
    }
    return compile_fail(compiler, compiler->description->camera.line,
                        "the eye is inside the opaque object of line %u, %s: nothing can be seen "
                        "from there; move the eye out of it, or intersect the endless one with a "
                        "bounded solid",
                        scene->objects[scene->camera.object].line, reason);
}

static bool compile_camera(struct compiler *compiler, const double right[3], const double up[3],
                           double pitch) {
    struct compiled_scene *scene = compiler->scene;
    struct compiled_camera *camera = &scene->camera;
    double largest = 0;
    for (int i = 0; i < 3; i++) {
        camera->column[i] = right[i] * pitch / 2;
        camera->row[i] = -up[i] * pitch / 2;
        largest = fmax(largest, fmax(fabs(camera->column[i]), fabs(camera->row[i])));
    }
    while (camera->shift < 16 && ldexp(largest, camera->shift + 1) < 1) {
        camera->shift++;
    }
    /* Few pixels in a wide view are far apart: forward, which need not have length 1, gets shorter.
     */
    int less = 0;
    while (ldexp(largest, -less) >= 1) {
        less++;
    }
    for (int i = 0; i < 3; i++) {
        camera->forward[i] = ldexp(camera->forward[i], -less);
        camera->column[i] = ldexp(camera->column[i], camera->shift - less);
        camera->row[i] = ldexp(camera->row[i], camera->shift - less);
    }
    for (uint32_t i = 0; i < scene->primitive_count; i++) {
        if (compiled_primitive_holds(scene, i, camera->eye) &&
            !compiled_set_include(&camera->inside, i)) {
            return compile_fail_memory(compiler);
        }
    }
    camera->object = object_at_eye(scene);
    return true;
}

bool compile_view(struct compiler *compiler) {
    const struct scene_description *description = compiler->description;
    const struct scene_camera *view = &description->camera;
    struct compiled_scene *scene = compiler->scene;
    double right[3], up[3];
    for (int i = 0; i < 3; i++) {
        scene->camera.forward[i] = view->look_at[i] - view->eye[i];
        scene->camera.up[i] = view->up[i];
        scene->background[i] = description->background[i];
    }
    vector_cross(scene->camera.forward, view->up, right);
    if (!vector_normalise(scene->camera.forward) || !vector_normalise(right) ||
        !vector_normalise(scene->camera.up)) {
        return compile_fail(
            compiler, view->line,
            "the camera looks along `up`, or at itself: give another look_at or up");
    }
    vector_cross(right, scene->camera.forward, up);
    scaled_point(compiler, view->eye, scene->camera.eye);
    scene->width = (uint16_t)description->width;
    scene->height = (uint16_t)description->height;
    scene->depth = (uint8_t)description->depth;
    scene->threshold = description->threshold;
    scene->estimates = description->estimates || description->error > 0;
    scene->error = description->error;
    if (scene->error > 0) {
        scene->threshold = 1.0 / 16; /* where the search for a lower one begins */
    }
    scene->ray_budget = scene->error > 0 ? RAYS_FOR_ACCURACY_MOST : RAYS_OF_A_PIXEL_MOST;
    scene->simple = description->model == MODEL_SIMPLE;
    scene->filters = description->mixing == MIXING_FILTER;
    scene->blinn = description->highlight == HIGHLIGHT_BLINN;
    scene->fades = description->has_attenuation;
    scene->fade_start = ldexp(description->attenuation_constant, scene->exponent);
    scene->fade_exponent = (int8_t)scene->exponent;
    if (scene->fades && scene->fade_start >= COMPILE_WORLD) {
        return compile_fail(compiler, 0,
                            "the constant C of C + D is too large for the scene: at "
                            "most %g is allowed",
                            ldexp(COMPILE_WORLD, -scene->exponent));
    }
    const double half_width = tan(view->field_of_view * 3.14159265358979323846 / 360);
    return compile_camera(compiler, right, up, 2 * half_width / description->width) &&
           check_eye(compiler);
}

bool compile_lights(struct compiler *compiler) {
    const struct scene_description *description = compiler->description;
    struct compiled_scene *scene = compiler->scene;
    for (size_t i = 0; i < description->light_count; i++) {
        const struct scene_light *light = &description->lights[i];
        if (compiler->dead->light[i] != NULL) {
            continue;
        }
        if (!GROW(scene->lights, scene->light_count)) {
            return compile_fail_memory(compiler);
        }
        struct compiled_light *compiled = &scene->lights[scene->light_count++];
        compiled->file = (uint32_t)i;
        compiled->parallel = light->parallel;
        memcpy(compiled->colour, light->colour, sizeof compiled->colour);
        if (light->parallel) {
            for (int j = 0; j < 3; j++) {
                compiled->towards[j] = -light->direction[j];
            }
            vector_normalise(compiled->towards);
        } else {
            scaled_point(compiler, light->position, compiled->position);
        }
    }
    return true;
}

/* In levels: colour_most() of firmware/real/floating.h, and the end of fixed point. */
#define LIGHT_MOST 32768.0

/* In units of the scaled world: steps of lengths in fixed point are not coarser. */
#define LENGTH_STEP (1.0 / 65536)

/* The levels between which a material's own intensity is, in one channel. */
struct own_range {
    double least, most;
};

/* Returns what is left of direct light at most. C + D may be as small as C, and C is rounded to
 * what lengths hold. No arithmetic has brighter light than LIGHT_MOST. */
static double faded_most(const struct compiler *compiler, double direct) {
    const double constant = compiler->description->attenuation_constant -
                            ldexp(LENGTH_STEP, -compiler->scene->exponent);
    return constant > direct / LIGHT_MOST ? direct / constant : LIGHT_MOST;
}

/* Returns the most that w can be: of highlights, and of an opaque mirror. */
static double specular_most(const struct compiled_material *material) {
    return material->specular_table != SPECULAR_CONSTANT ? 1 : material->specular;
}

/* Finds what a material sends by itself: Eq. (1) with every cosine and A at 1, and in the dark. */
static struct own_range own_range(const struct compiler *compiler,
                                  const struct compiled_material *material, int channel) {
    const struct compiled_scene *scene = compiler->scene;
    const struct own_range nothing = {0, 0};
    if (scene->filters && material->transparent) {
        return nothing;
    }
    double colour = compiled_colour_most(scene, material, channel);
    double specular = specular_most(material), direct = 0;
    for (uint32_t i = 0; i < scene->light_count; i++) {
        double light = scene->lights[i].colour[channel];
        direct += material->diffuse * colour * light / 255 + specular * light;
    }
    if (scene->fades) {
        direct = faded_most(compiler, direct);
    }
    const struct own_range range = {
        material->ambient_share * compiled_colour_least(scene, material, channel) +
            material->ambient[channel],
        material->ambient_share * colour + material->ambient[channel] + direct};
    return range;
}

/* Finds what a branch gathers at least and at most. The most are B + (n - 1) E levels for n
 * boundaries. Transparent surfaces send at most E levels each, and what ends a branch at most B. A
 * mirror of coefficient w sends at most B (1 - w). The shares of a boundary's branches are 1
 * together at most, and w for a mirror. So the bound for n - 1 boundaries gives that for n. */
void compile_light_bounds(struct compiler *compiler) {
    const double most = 8388607, nearly_one = 1 - 1e-6;
    struct compiled_scene *scene = compiler->scene;
    double least = 65535, each = 0, end = 0;
    for (int j = 0; j < 3; j++) {
        least = fmin(least, scene->background[j]);
        end = fmax(end, scene->background[j]);
        for (uint32_t i = 1; i < scene->material_count; i++) {
            const struct compiled_material *material = &scene->materials[i];
            const struct own_range own = own_range(compiler, material, j);
            double mirrors = specular_most(material);
            least = material->absorbs ? 0 : fmin(least, own.least);
            end = fmax(end, own.most);
            if (material->transparent || mirrors > nearly_one) {
                each = fmax(each, own.most);
            } else {
                end = fmax(end, own.most / (1 - mirrors));
            }
        }
    }
    scene->darkest = (uint16_t)fmin(floor(least), 65535);
    scene->brightest = (uint32_t)fmin(ceil(end), most);
    scene->brightest_each = (uint32_t)fmin(ceil(each), most);
}

bool compile_colour(struct compiler *compiler) {
    const struct scene_description *description = compiler->description;
    struct compiled_scene *scene = compiler->scene;
    static const enum show shows[] = {[COLOUR_FULL] = SHOW_FULL,
                                      [COLOUR_BITS] = SHOW_BITS,
                                      [COLOUR_DITHER] = SHOW_DITHER,
                                      [COLOUR_EXPOSURES] = SHOW_EXPOSURES};
    scene->show = (uint8_t)shows[description->colour];
    scene->show_bits = (uint8_t)(description->colour == COLOUR_BITS ? description->colour_bits : 8);
    scene->seed = description->seed;
    if (description->colour == COLOUR_DITHER &&
        board_dots_a_pixel((unsigned)description->width, (unsigned)description->height) != 2) {
        return compile_fail(compiler, 0,
                            "colour \"dither\" with %d x %d pixels, each of 2 x 2 dots; allowed "
                            "is: up to %d x %d, or another colour",
                            description->width, description->height, BOARD_WIDTH / 2,
                            BOARD_HEIGHT / 2);
    }
    return true;
}
