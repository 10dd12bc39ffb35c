/* SPDX-License-Identifier: MIT */
/* The scene compiler: the camera and the solids that the eye is inside of, lights, and the largest
 * intensity. */
#include "compiler/compiler_internal.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

/* A pixel that traps light ends after so many rays: where an accuracy is asked for, and where none
 * is. */
enum { RAYS_FOR_ACCURACY_MOST = 100000, RAYS_OF_A_PIXEL_MOST = 1000000 };

static void scaled_point(const struct compiler *compiler, const double point[3], double out[3]) {
    affine_point(&compiler->scaling, point, out);
}

static bool is_inside_ball(const struct compiled_ball *ball, const double point[3]) {
    const double p[3] = {point[0] - ball->centre[0], point[1] - ball->centre[1],
                         point[2] - ball->centre[2]};
    return vector_dot(p, p) < ball->radius * ball->radius;
}

static bool is_inside_box(const struct compiled_box *box, const double p[3]) {
    return p[0] > box->minimum[0] && p[0] < box->maximum[0] && p[1] > box->minimum[1] &&
           p[1] < box->maximum[1] && p[2] > box->minimum[2] && p[2] < box->maximum[2];
}

static bool is_inside_polyhedron(const struct compiled_scene *scene,
                                 const struct compiled_polyhedron *polyhedron,
                                 const double point[3]) {
    for (int i = 0; i < polyhedron->count; i++) {
        const struct compiled_plane *plane = &scene->planes[polyhedron->first + i];
        if (vector_dot(plane->normal, point) >= plane->offset) {
            return false;
        }
    }
    return true;
}

/* Tells whether a point is strictly inside a quadric. p: the point in the frame's coordinates,
 * which the box shares. q: the same from the quadric's centre. */
static bool is_inside_quadric(const struct compiled_scene *scene,
                              const struct compiled_quadric *quadric, const double p[3],
                              const double q[3]) {
    const double squares[3] = {q[0] * q[0], q[1] * q[1], q[2] * q[2]};
    const struct compiled_box *box = &scene->boxes[quadric->box];
    for (int i = 0; i < 3; i++) {
        if ((quadric->cuts >> i & 1) != 0 && (p[i] <= box->minimum[i] || p[i] >= box->maximum[i])) {
            return false;
        }
    }
    return vector_dot(quadric->square, squares) + 2 * quadric->linear * q[2] + quadric->constant <
           0;
}

/* Turns a point into the axes of a frame; the frames of solids have no origin of their own. */
static void to_frame(const struct compiled_scene *scene, uint8_t frame, const double point[3],
                     double turned[3]) {
    const double from[3] = {point[0], point[1], point[2]};
    for (int i = 0; i < 3; i++) {
        turned[i] = frame == WORLD_FRAME ? from[i] : vector_dot(from, scene->frames[frame].axis[i]);
    }
}

bool compiled_primitive_holds(const struct compiled_scene *scene, uint8_t index,
                              const double point[3]) {
    const struct compiled_primitive *primitive = &scene->primitives[index];
    const struct compiled_quadric *quadric;
    double p[3], q[3] = {0, 0, 0};
    to_frame(scene, primitive->frame, point, p);
    switch (primitive->kind) {
    case KIND_BALL:
        return is_inside_ball(&scene->balls[primitive->index], p);
    case KIND_POLYHEDRON:
        return is_inside_polyhedron(scene, &scene->polyhedra[primitive->index], p);
    case KIND_QUADRIC:
        quadric = &scene->quadrics[primitive->index];
        for (int i = 0; i < 3; i++) {
            q[i] = point[i] - quadric->centre[i];
        }
        to_frame(scene, primitive->frame, q, q);
        return is_inside_quadric(scene, quadric, p, q);
    default:
        return is_inside_box(&scene->boxes[primitive->index], p);
    }
}

/* Evaluates an object's program in the host's words; the program means the same as in ray_hit(). */
bool compiled_object_holds(const struct compiled_scene *scene, uint8_t index,
                           const struct compiled_set *inside) {
    const struct compiled_object *object = &scene->objects[index];
    uint32_t stack = 0;
    for (uint8_t i = 0; i < object->length; i++) {
        uint8_t code = scene->programs[object->program + i];
        uint32_t right = stack & 1, left = stack >> 1 & 1;
        if (code < CODE_UNION) {
            stack = stack << 1 | (inside->word[code / 32] >> code % 32 & 1);
        } else {
            uint32_t value = code == CODE_UNION          ? left | right
                             : code == CODE_INTERSECTION ? left & right
                                                         : left & ~right & 1;
            stack = (stack >> 2) << 1 | value;
        }
    }
    return (stack & 1) != 0;
}

/* Returns the object that the eye is in; 0 is the air. */
static uint8_t object_of(const struct compiled_scene *scene, const struct compiled_set *inside) {
    uint8_t i = (uint8_t)(scene->object_count - 1);
    while (i > 0 && !compiled_object_holds(scene, i, inside)) {
        i--;
    }
    return i;
}

/* Finds an object of a material that has no end; returns 0 if there is none. */
static int endless_object(const struct compiler *compiler, uint8_t material) {
    int i = compiler->scene->object_count - 1;
    while (i > 0 && (compiler->scene->objects[i].material != material ||
                     bounds_are_finite(&compiler->object_bounds[i]))) {
        i--;
    }
    return i;
}

/* Refuses an eye in an opaque material that goes on without an end. Where the world ends for the
 * firmware, such a material has no surface. */
static bool check_eye(struct compiler *compiler) {
    const struct compiled_scene *scene = compiler->scene;
    uint8_t material = scene->objects[scene->camera.object].material;
    int endless = scene->materials[material].transparent ? 0 : endless_object(compiler, material);
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

static void compile_camera(struct compiler *compiler, const double right[3], const double up[3],
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
    for (uint8_t i = 0; i < scene->primitive_count; i++) {
        if (compiled_primitive_holds(scene, i, camera->eye)) {
            camera->inside.word[i / 32] |= (uint32_t)1 << i % 32;
        }
    }
    camera->object = object_of(scene, &camera->inside);
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
    compile_camera(compiler, right, up, 2 * half_width / description->width);
    return check_eye(compiler);
}

void compile_lights(struct compiler *compiler) {
    const struct scene_description *description = compiler->description;
    struct compiled_scene *scene = compiler->scene;
    for (size_t i = 0; i < description->light_count; i++) {
        const struct scene_light *light = &description->lights[i];
        if (compiler->dead->light[i] != NULL) {
            continue;
        }
        struct compiled_light *compiled = &scene->lights[scene->light_count++];
        compiled->file = (uint8_t)i;
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
}

/* Finds an intensity that no surface's own exceeds: Eq. (1) with every cosine and A at 1. The
 * distance may make C + D as small as C. */
void compile_brightest(struct compiler *compiler) {
    const struct scene_description *description = compiler->description;
    struct compiled_scene *scene = compiler->scene;
    double most = 0;
    for (int j = 0; j < 3; j++) {
        most = fmax(most, scene->background[j]);
        for (int i = 1; i < scene->material_count; i++) {
            const struct compiled_material *material = &scene->materials[i];
            double colour = compiled_colour_most(scene, material, j);
            double specular = material->specular_table != NO_TABLE ? 1 : material->specular;
            double direct = 0;
            for (int k = 0; k < scene->light_count; k++) {
                double light = scene->lights[k].colour[j];
                direct += material->diffuse * colour * light / 255 + specular * light;
            }
            if (scene->fades) {
                direct /= fmax(description->attenuation_constant, 1e-3);
            }
            most = fmax(most, material->ambient_share * colour + material->ambient[j] + direct);
        }
    }
    scene->brightest = (uint16_t)fmin(ceil(most), 32767);
}
