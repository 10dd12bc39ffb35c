/* SPDX-License-Identifier: MIT */
/* The scene compiler: what can keep light off a surface, and what is proved not to. */
#include <math.h>
#include <stdlib.h>

#include "compiler/compiler_internal.h"

/* Puts the primitives of an object's program into a set; false if memory is out. */
static bool collect_uses(const struct compiled_scene *scene, const struct compiled_object *object,
                         struct compiled_set *uses) {
    for (uint32_t i = 0; i < object->length; i++) {
        uint32_t code = scene->programs[object->program + i];
        if (code < COMPILED_UNION && !compiled_set_include(uses, code)) {
            return false;
        }
    }
    return true;
}

static bool casts(const struct compiled_scene *scene, uint32_t object) {
    return scene->materials[scene->objects[object].material].casts_shadow;
}

/* The two objects that reach farthest along an axis, one way. */
struct farthest {
    uint32_t object;
    double first, second; /* how far they reach; the second one is any other object */
};

/* By axis: the farthest down, and up; places up are counted with a minus sign. */
struct reaches {
    struct farthest low[3], high[3];
};

static void reach_to(struct farthest *farthest, uint32_t object, double place) {
    if (place < farthest->first) {
        farthest->second = farthest->first;
        farthest->first = place;
        farthest->object = object;
    } else {
        farthest->second = fmin(farthest->second, place);
    }
}

static struct reaches find_reaches(const struct compiled_scene *scene) {
    struct reaches reaches;
    const struct farthest none = {COMPILED_NONE, HUGE_VAL, HUGE_VAL};
    for (int axis = 0; axis < 3; axis++) {
        reaches.low[axis] = reaches.high[axis] = none;
    }
    for (uint32_t i = 1; i < scene->object_count; i++) {
        const struct bounds *bounds = &scene->objects[i].bounds;
        for (int axis = 0; axis < 3 && !bounds_are_empty(bounds); axis++) {
            reach_to(&reaches.low[axis], i, bounds->low[axis]);
            reach_to(&reaches.high[axis], i, -bounds->high[axis]);
        }
    }
    return reaches;
}

/* Tells whether all objects but one, and the light, lie on the far side of a plane. The plane has
 * all of that one object behind it. */
static bool is_clear_of(const struct reaches *reaches, uint32_t object,
                        const struct compiled_light *light, int axis, double side, double place) {
    if (light->parallel ? side * light->towards[axis] < 0
                        : side * (light->position[axis] - place) < 0) {
        return false;
    }
    const struct farthest *farthest = side > 0 ? &reaches->low[axis] : &reaches->high[axis];
    const double nearest = farthest->object == object ? farthest->second : farthest->first;
    return !(nearest - side * place < 0);
}

/* Tells whether an object is proved to cast no shadow that is seen. An opaque convex body throws no
 * shadow on itself, nor on what lies, with the light, before one of its faces. A transparent body
 * throws one on its own far side. The proof is for boxes along the axes: the floors and boards of
 * most scenes. */
static bool is_harmless(const struct compiled_scene *scene, const struct reaches *reaches,
                        uint32_t object, const struct compiled_light *light) {
    const struct compiled_primitive *primitive =
        &scene->primitives[scene->programs[scene->objects[object].program]];
    if (scene->objects[object].length != 1 || primitive->kind != PRIMITIVE_BOX ||
        primitive->frame != COMPILED_FRAME_WORLD ||
        scene->materials[scene->objects[object].material].transparent) {
        return false;
    }
    const struct compiled_box *box = &scene->boxes[primitive->index];
    for (int axis = 0; axis < 3; axis++) {
        if (is_clear_of(reaches, object, light, axis, 1, box->maximum[axis]) ||
            is_clear_of(reaches, object, light, axis, -1, box->minimum[axis])) {
            return true;
        }
    }
    return false;
}

/* Finds the objects that cast shadows for some light. */
static void find_casters(struct compiled_scene *scene, bool harms[]) {
    const struct reaches reaches = find_reaches(scene);
    for (uint32_t i = 1; i < scene->object_count; i++) {
        for (uint32_t j = 0; j < scene->light_count && casts(scene, i); j++) {
            struct compiled_light *light = &scene->lights[j];
            const bool is_known = harms[i] && light->casts_shadows;
            const bool harm = !is_known && !is_harmless(scene, &reaches, i, light);
            light->casts_shadows = light->casts_shadows || harm;
            harms[i] = harms[i] || harm;
            scene->has_shadows = scene->has_shadows || harm;
        }
    }
}

/* Marks the objects that cast shadows, and the later objects that may fill some of their place. A
 * later object may put something there that casts no shadow. Returns false if memory is out. */
static bool mark_shadow_test(struct compiled_scene *scene, const bool harms[]) {
    struct neighbours casters = {.count = 0};
    struct compiled_set found = {NULL, 0};
    bool has_memory = true;
    for (uint32_t i = 1; i < scene->object_count && has_memory; i++) {
        const struct bounds *bounds = &scene->objects[i].bounds;
        bool *is_tested = &scene->objects[i].in_shadow_test;
        *is_tested = harms[i];
        if (harms[i]) {
            has_memory = neighbours_add(&casters, bounds, i);
            continue;
        }
        has_memory = neighbours_find(&casters, bounds, 0, &found);
        for (uint32_t k = 0; k < found.count && has_memory; k++) {
            *is_tested =
                *is_tested || bounds_overlap(bounds, &scene->objects[found.members[k]].bounds);
        }
    }
    neighbours_clear(&casters);
    compiled_set_clear(&found);
    return has_memory;
}

bool compile_shadows(struct compiler *compiler) {
    struct compiled_scene *scene = compiler->scene;
    bool *harms = calloc(scene->object_count, sizeof *harms);
    if (harms == NULL) {
        return compile_fail_memory(compiler);
    }
    find_casters(scene, harms);
    const bool is_marked = mark_shadow_test(scene, harms);
    free(harms);
    if (!is_marked) {
        return compile_fail_memory(compiler);
    }
    for (uint32_t i = 1; i < scene->object_count; i++) {
        struct compiled_object *object = &scene->objects[i];
        if (!collect_uses(scene, object, &object->uses) ||
            (object->in_shadow_test && !collect_uses(scene, object, &scene->shadow_primitives))) {
            return compile_fail_memory(compiler);
        }
    }
    return true;
}
