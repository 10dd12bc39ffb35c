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
                     uint32_t surface, struct face *face) {
    const struct compiled_quadric *quadric =
        primitive->kind == PRIMITIVE_QUADRIC ? &scene->quadrics[primitive->index] : NULL;
    const unsigned faces = quadric != NULL ? quadric->cuts : 7;
    const struct compiled_box *box =
        quadric != NULL ? compiled_box_of(scene, quadric) : &scene->boxes[primitive->index];
    for (int i = 0; i < 6; i++) {
        if ((faces >> i % 3 & 1) == 0 || box->surface[i] != surface) {
            continue;
        }
        memcpy(face->normal, affine_identity.m[i % 3], sizeof face->normal);
        face->offset = i < 3 ? box->minimum[i] : box->maximum[i - 3];
        if (primitive->frame != COMPILED_FRAME_WORLD) {
            const struct compiled_frame *frame = &scene->frames[primitive->frame];
            memcpy(face->normal, frame->axis[i % 3], sizeof face->normal);
            face->offset += vector_dot(face->normal, frame->origin);
        }
        return true;
    }
    return false;
}

/* Finds the plane of a primitive's face; false if the surface is curved. */
static bool face_of(const struct compiled_scene *scene, uint32_t index, uint32_t surface,
                    struct face *face) {
    const struct compiled_primitive *primitive = &scene->primitives[index];
    if (primitive->kind == PRIMITIVE_BOX || primitive->kind == PRIMITIVE_QUADRIC) {
        return box_face(scene, primitive, surface, face);
    }
    if (primitive->kind == PRIMITIVE_POLYHEDRON) {
        const struct compiled_polyhedron *polyhedron = &scene->polyhedra[primitive->index];
        for (uint32_t i = polyhedron->first; i < polyhedron->first + polyhedron->count; i++) {
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
static bool is_crossed(const struct compiled_scene *scene, uint32_t primitive,
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
static bool lie_on_each_other(const struct compiled_scene *scene, uint32_t a, uint32_t b,
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

/* Tells whether a face of a primitive lies on one of a primitive of a set. The primitive itself is
 * none of the set where it is to be another one. */
static bool touches(const struct compiled_scene *scene, uint32_t a, uint32_t surface,
                    const struct compiled_set *set, bool another, const double low[3],
                    const double high[3]) {
    const struct compiled_set *bounded = &scene->surfaces[surface];
    const bool is_less = bounded->count < set->count;
    const struct compiled_set *few = is_less ? bounded : set, *many = is_less ? set : bounded;
    struct face face;
    bool is_flat = face_of(scene, a, surface, &face);
    for (uint32_t i = 0; i < few->count; i++) {
        const uint32_t b = few->members[i];
        if ((a != b || !another) && compiled_set_has(many, b) &&
            (!is_flat || lie_on_each_other(scene, a, b, &face, low, high))) {
            return true;
        }
    }
    return false;
}

/* Tells whether a primitive of one set and one of the other have a common face. A curved surface of
 * both counts as a common face, wherever it lies. Of a set and itself, two primitives are asked
 * for. */
static bool sets_touch(const struct compiled_scene *scene, const struct compiled_set *first,
                       const struct compiled_set *second, const double low[3],
                       const double high[3]) {
    for (uint32_t i = 0; i < first->count; i++) {
        const uint32_t a = first->members[i];
        struct compiled_face faces[COMPILED_FACES_MOST];
        int count = compiled_faces(scene, a, faces);
        if (compiled_curve(scene, a) != COMPILED_NONE) {
            faces[count++].surface = compiled_curve(scene, a);
        }
        for (int j = 0; j < count; j++) {
            if (touches(scene, a, faces[j].surface, second, first == second, low, high)) {
                return true;
            }
        }
    }
    return false;
}

bool export_pov_touch(const struct compiled_scene *scene, uint32_t a, uint32_t b,
                      const double low[3], const double high[3]) {
    return sets_touch(scene, &scene->objects[a].uses, &scene->objects[b].uses, low, high);
}

/* Tells whether an object is an opaque union, whose inner faces nobody sees. */
static bool seams_are_hidden(const struct compiled_scene *scene,
                             const struct compiled_object *object) {
    if (scene->materials[object->material].transparent) {
        return false;
    }
    for (uint32_t i = 0; i < object->length; i++) {
        if (scene->programs[object->program + i] > COMPILED_UNION) {
            return false;
        }
    }
    return true;
}

bool export_pov_has_seam(const struct compiled_scene *scene, uint32_t index) {
    const struct compiled_object *object = &scene->objects[index];
    double low[3], high[3];
    if (seams_are_hidden(scene, object)) {
        return false;
    }
    for (int i = 0; i < 3; i++) {
        low[i] = fmax(object->bounds.low[i], -WORLD_REACH);
        high[i] = fmin(object->bounds.high[i], WORLD_REACH);
    }
    return sets_touch(scene, &object->uses, &object->uses, low, high);
}
