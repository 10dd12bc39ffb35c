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

/* Tells whether all objects but one, and the light, lie on the far side of a plane. The plane has
 * all of that one object behind it. */
static bool is_clear_of(const struct compiler *compiler, uint32_t object,
                        const struct compiled_light *light, int axis, double side, double place) {
    const struct compiled_scene *scene = compiler->scene;
    if (light->parallel ? side * light->towards[axis] < 0
                        : side * (light->position[axis] - place) < 0) {
        return false;
    }
    for (uint32_t i = 1; i < scene->object_count; i++) {
        const struct bounds *bounds = &compiler->object_bounds[i];
        double nearest = side > 0 ? bounds->low[axis] : bounds->high[axis];
        if (i != object && !bounds_are_empty(bounds) && side * (nearest - place) < 0) {
            return false;
        }
    }
    return true;
}

/* Tells whether an object is proved to cast no shadow that is seen. An opaque convex body throws no
 * shadow on itself, nor on what lies, with the light, before one of its faces. A transparent body
 * throws one on its own far side. The proof is for boxes along the axes: the floors and boards of
 * most scenes. */
static bool is_harmless(const struct compiler *compiler, uint32_t object,
                        const struct compiled_light *light) {
    const struct compiled_scene *scene = compiler->scene;
    const struct compiled_primitive *primitive =
        &scene->primitives[scene->programs[scene->objects[object].program]];
    if (scene->objects[object].length != 1 || primitive->kind != PRIMITIVE_BOX ||
        primitive->frame != COMPILED_FRAME_WORLD ||
        scene->materials[scene->objects[object].material].transparent) {
        return false;
    }
    const struct compiled_box *box = &scene->boxes[primitive->index];
    for (int axis = 0; axis < 3; axis++) {
        if (is_clear_of(compiler, object, light, axis, 1, box->maximum[axis]) ||
            is_clear_of(compiler, object, light, axis, -1, box->minimum[axis])) {
            return true;
        }
    }
    return false;
}

/* Finds the objects that cast shadows for some light. */
static void find_casters(const struct compiler *compiler, bool harms[]) {
    struct compiled_scene *scene = compiler->scene;
    for (uint32_t i = 1; i < scene->object_count; i++) {
        for (uint32_t j = 0; j < scene->light_count; j++) {
            bool harm = casts(scene, i) && !is_harmless(compiler, i, &scene->lights[j]);
            scene->lights[j].casts_shadows = scene->lights[j].casts_shadows || harm;
            harms[i] = harms[i] || harm;
            scene->has_shadows = scene->has_shadows || harm;
        }
    }
}

/* Marks the objects that cast shadows, and the later objects that may fill some of their place. A
 * later object may put something there that casts no shadow. */
static void mark_shadow_test(const struct compiler *compiler, const bool harms[]) {
    struct compiled_scene *scene = compiler->scene;
    for (uint32_t i = 1; i < scene->object_count; i++) {
        struct compiled_object *object = &scene->objects[i];
        object->in_shadow_test = harms[i];
        for (uint32_t j = 1; j < i; j++) {
            object->in_shadow_test =
                object->in_shadow_test || (harms[j] && bounds_overlap(&compiler->object_bounds[i],
                                                                      &compiler->object_bounds[j]));
        }
    }
}

bool compile_shadows(struct compiler *compiler) {
    struct compiled_scene *scene = compiler->scene;
    bool *harms = calloc(scene->object_count, sizeof *harms);
    if (harms == NULL) {
        return compile_fail_memory(compiler);
    }
    find_casters(compiler, harms);
    mark_shadow_test(compiler, harms);
    free(harms);
    for (uint32_t i = 1; i < scene->object_count; i++) {
        struct compiled_object *object = &scene->objects[i];
        if (!collect_uses(scene, object, &object->uses) ||
            (object->in_shadow_test && !collect_uses(scene, object, &scene->shadow_primitives))) {
            return compile_fail_memory(compiler);
        }
    }
    return true;
}
