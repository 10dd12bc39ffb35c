/* SPDX-License-Identifier: MIT */
/* The POV-Ray export: finds where faces lie on each other. The firmware takes such faces for one
 * boundary, POV-Ray for two at one place. */
#include <math.h>
#include <string.h>

#include "compiler/affine.h"
#include "export/pov_internal.h"

enum {
    SAMPLES = 48 /* points along a face's sides: a smaller common face may be missed */
};

/* How far before and behind a face a point is tested, in scaled units. */
#define BESIDE 1e-6

/* The world's end. */
#define WORLD_REACH 1024.0

/* A plane that bounds a primitive: normal . p = offset. */
struct face {
    double normal[3];
    double offset;
};

static bool box_face(const struct compiled_scene *scene, const struct compiled_primitive *primitive,
                     unsigned surface, struct face *face) {
    const struct compiled_quadric *quadric = &scene->quadrics[primitive->index];
    bool is_box = primitive->kind == PRIMITIVE_BOX;
    const struct compiled_box *box = &scene->boxes[is_box ? primitive->index : quadric->box];
    for (int i = 0; i < 6; i++) {
        if (box->surface[i] != surface || (!is_box && (quadric->cuts >> i % 3 & 1) == 0)) {
            continue;
        }
        memcpy(face->normal, affine_identity.m[i % 3], sizeof face->normal);
        face->offset = i < 3 ? box->minimum[i] : box->maximum[i - 3];
        if (primitive->frame != FRAME_WORLD) {
            const struct compiled_frame *frame = &scene->frames[primitive->frame];
            memcpy(face->normal, frame->axis[i % 3], sizeof face->normal);
            face->offset += vector_dot(face->normal, frame->origin);
        }
        return true;
    }
    return false;
}

/* Finds the plane of a primitive's face; false if the surface is curved. */
static bool face_of(const struct compiled_scene *scene, uint8_t index, unsigned surface,
                    struct face *face) {
    const struct compiled_primitive *primitive = &scene->primitives[index];
    if (primitive->kind == PRIMITIVE_BOX || primitive->kind == PRIMITIVE_QUADRIC) {
        return box_face(scene, primitive, surface, face);
    }
    if (primitive->kind == PRIMITIVE_POLYHEDRON) {
        const struct compiled_polyhedron *polyhedron = &scene->polyhedra[primitive->index];
        for (int i = polyhedron->first; i < polyhedron->first + polyhedron->count; i++) {
            if (scene->planes[i].surface == surface) {
                memcpy(face->normal, scene->planes[i].normal, sizeof face->normal);
                face->offset = scene->planes[i].offset;
                return true;
            }
        }
    }
    return false;
}

/* Tells whether a primitive is entered or left at a point of the plane. */
static bool is_crossed(const struct compiled_scene *scene, uint8_t primitive,
                       const struct face *face, const double point[3]) {
    double before[3], behind[3];
    for (int i = 0; i < 3; i++) {
        before[i] = point[i] + BESIDE * face->normal[i];
        behind[i] = point[i] - BESIDE * face->normal[i];
    }
    return compiled_primitive_holds(scene, primitive, before) !=
           compiled_primitive_holds(scene, primitive, behind);
}

/* Tells whether two primitives are both crossed at some point of the plane within the bounds. */
static bool lie_on_each_other(const struct compiled_scene *scene, uint8_t a, uint8_t b,
                              const struct face *face, const double low[3], const double high[3]) {
    int steep = 0;
    for (int i = 1; i < 3; i++) {
        steep = fabs(face->normal[i]) > fabs(face->normal[steep]) ? i : steep;
    }
    int u = (steep + 1) % 3, v = (steep + 2) % 3;
    for (int sample = 0; sample < SAMPLES * SAMPLES; sample++) {
        int across = sample % SAMPLES, along = sample / SAMPLES;
        double point[3];
        point[u] = low[u] + (high[u] - low[u]) * (across + 0.5) / SAMPLES;
        point[v] = low[v] + (high[v] - low[v]) * (along + 0.5) / SAMPLES;
        point[steep] = (face->offset - face->normal[u] * point[u] - face->normal[v] * point[v]) /
                       face->normal[steep];
        bool is_near = point[steep] >= low[steep] - BESIDE && point[steep] <= high[steep] + BESIDE;
        if (is_near && is_crossed(scene, a, face, point) && is_crossed(scene, b, face, point)) {
            return true;
        }
    }
    return false;
}

/* Returns the primitives of an object, each once. */
static struct compiled_set primitives_of(const struct compiled_scene *scene, uint8_t index) {
    const struct compiled_object *object = &scene->objects[index];
    struct compiled_set set;
    memset(&set, 0, sizeof set);
    for (uint8_t i = 0; i < object->length; i++) {
        uint8_t code = scene->programs[object->program + i];
        if (code < COMPILED_PRIMITIVES_MOST) {
            compiled_set_include(&set, code);
        }
    }
    return set;
}

/* Tells whether a primitive of one set and one of the other have a common face. A curved surface of
 * both counts as a common face, wherever it lies. */
static bool sets_touch(const struct compiled_scene *scene, const struct compiled_set *first,
                       const struct compiled_set *second, const double low[3],
                       const double high[3]) {
    struct face face;
    for (unsigned surface = 0; surface < scene->surface_count; surface++) {
        const struct compiled_set *bounded = &scene->surfaces[surface];
        for (uint8_t a = 0; a < scene->primitive_count; a++) {
            if (!compiled_set_has(first, a) || !compiled_set_has(bounded, a)) {
                continue;
            }
            bool is_flat = face_of(scene, a, surface, &face);
            for (uint8_t b = 0; b < scene->primitive_count; b++) {
                if (compiled_set_has(second, b) && compiled_set_has(bounded, b) &&
                    (!is_flat || lie_on_each_other(scene, a, b, &face, low, high))) {
                    return true;
                }
            }
        }
    }
    return false;
}

bool export_pov_touch(const struct compiled_scene *scene, uint8_t a, uint8_t b, const double low[3],
                      const double high[3]) {
    struct compiled_set first = primitives_of(scene, a), second = primitives_of(scene, b);
    return sets_touch(scene, &first, &second, low, high);
}

/* Tells whether an object is an opaque union, whose inner faces nobody sees. */
static bool seams_are_hidden(const struct compiled_scene *scene,
                             const struct compiled_object *object) {
    if (scene->materials[object->material].transparent) {
        return false;
    }
    for (uint8_t i = 0; i < object->length; i++) {
        if (scene->programs[object->program + i] > PROGRAM_UNION) {
            return false;
        }
    }
    return true;
}

bool export_pov_has_seam(const struct compiled_scene *scene, uint8_t index) {
    const struct compiled_object *object = &scene->objects[index];
    struct compiled_set all = primitives_of(scene, index);
    double low[3], high[3];
    if (seams_are_hidden(scene, object)) {
        return false;
    }
    for (int i = 0; i < 3; i++) {
        low[i] = fmax(object->low[i], -WORLD_REACH);
        high[i] = fmin(object->high[i], WORLD_REACH);
    }
    for (uint8_t i = 0; i < scene->primitive_count; i++) {
        struct compiled_set one, others = all;
        if (!compiled_set_has(&all, i)) {
            continue;
        }
        memset(&one, 0, sizeof one);
        compiled_set_include(&one, i);
        others.word[i / 32] &= ~one.word[i / 32];
        if (sets_touch(scene, &one, &others, low, high)) {
            return true;
        }
    }
    return false;
}
