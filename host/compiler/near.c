/* SPDX-License-Identifier: MIT */
/* The scene compiler: faces that do not count as one, though they are nearer to each other than
 * anybody means. */
#include <math.h>

#include "compiler/compiler_internal.h"

/* In scaled units, of which a scene has 1,024: less than any arithmetic's noise for fine pictures.
 */
#define NEAR_MOST 0x1p-10

static void note(struct compiled_scene *scene, uint32_t one, uint32_t other, double distance) {
    if (scene->near_count < COMPILED_NEAR_MOST) {
        scene->near[scene->near_count] = (struct compiled_near){
            scene->primitives[one].line, scene->primitives[other].line, distance};
    }
    scene->near_count++;
}

/* Tells whether two primitives come so near that a ray may meet both at one place. */
static bool meet(const struct compiled_scene *scene, uint32_t one, uint32_t other) {
    struct bounds a = primitive_bounds(scene, one), b = primitive_bounds(scene, other);
    for (int i = 0; i < 3; i++) {
        a.low[i] -= NEAR_MOST;
        a.high[i] += NEAR_MOST;
    }
    return bounds_overlap(&a, &b);
}

/* Returns about how far two planes are apart within the scene; large where the planes are not
 * nearly parallel. */
static double plane_distance(const struct compiled_face *a, const struct compiled_face *b) {
    double sign = vector_dot(a->normal, b->normal) < 0 ? -1 : 1, lean = 0;
    for (int i = 0; i < 3; i++) {
        lean = fmax(lean, fabs(a->normal[i] - sign * b->normal[i]));
    }
    return fabs(a->offset - sign * b->offset) + lean * COMPILE_EXTENT;
}

/* Returns the distance of the nearest two faces of different surfaces; infinite where there are no
 * such faces. */
static double face_distance(const struct compiled_scene *scene, uint32_t one, uint32_t other) {
    struct compiled_face faces[COMPILED_FACES_MOST], others[COMPILED_FACES_MOST];
    int count = compiled_faces(scene, one, faces), more = compiled_faces(scene, other, others);
    double least = HUGE_VAL;
    for (int i = 0; i < count; i++) {
        for (int j = 0; j < more; j++) {
            if (faces[i].surface != others[j].surface) {
                least = fmin(least, plane_distance(&faces[i], &others[j]));
            }
        }
    }
    return least;
}

/* Notes whether two primitives, or faces of one, are nearer to each other than meant. */
static void check_pair(struct compiled_scene *scene, struct curve_sample *sample, uint32_t other) {
    const uint32_t one = sample->primitive;
    if (!meet(scene, one, other)) {
        return;
    }
    double distance = face_distance(scene, one, other);
    if (one != other) {
        distance = fmin(distance, compile_curve_distance(scene, sample, other));
    }
    if (distance <= NEAR_MOST) {
        note(scene, other, one, ldexp(distance, -scene->exponent));
    }
}

bool compile_near(struct compiler *compiler) {
    struct compiled_scene *scene = compiler->scene;
    struct compiled_set found = {NULL, 0};
    bool is_found = true;
    for (uint32_t i = 0; i < scene->primitive_count && is_found; i++) {
        const struct bounds *bounds = &compiler->solids.entries[i].bounds;
        is_found = neighbours_find(&compiler->solids, bounds, NEAR_MOST, &found);
        struct curve_sample sample = {.count = 0, .primitive = i};
        if (is_found && found.count > 1) { /* not by itself */
            compile_sample_curve(scene, i, &sample);
        }
        for (uint32_t k = 0; k < found.count && is_found && found.members[k] <= i; k++) {
            check_pair(scene, &sample, found.members[k]);
        }
    }
    compiled_set_clear(&found);
    return is_found || compile_fail_memory(compiler);
}
