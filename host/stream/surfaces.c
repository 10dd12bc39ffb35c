/* SPDX-License-Identifier: MIT */
/* The surfaces of a scene, which its own tables do not count. */
#include "stream/surfaces.h"

static uint32_t larger(uint32_t a, uint32_t b) {
    return a > b ? a : b;
}

static uint32_t last_of_box(const struct box *box) {
    uint32_t last = 0;
    for (int face = 0; face < 6; face++) {
        last = larger(last, box->surface[face]);
    }
    return last;
}

static uint32_t last_of_polyhedron(const struct scene *scene, const struct polyhedron *polyhedron) {
    uint32_t last = 0;
    for (uint32_t face = 0; face < polyhedron->count; face++) {
        last = larger(last, scene->planes[polyhedron->first + face].surface);
    }
    return last;
}

static uint32_t last_of_quadric(const struct scene *scene, const struct quadric *quadric) {
    uint32_t flat = quadric->cuts != 0 ? last_of_box(&scene->boxes[quadric->box]) : 0;
    return larger(quadric->surface, flat);
}

static uint32_t last_of_primitive(const struct scene *scene, const struct primitive *primitive) {
    switch ((enum primitive_kind)primitive->kind) {
    case PRIMITIVE_BOX:
        return last_of_box(&scene->boxes[primitive->index]);
    case PRIMITIVE_BALL:
        return scene->balls[primitive->index].surface;
    case PRIMITIVE_POLYHEDRON:
        return last_of_polyhedron(scene, &scene->polyhedra[primitive->index]);
    case PRIMITIVE_QUADRIC:
        break;
    }
    return last_of_quadric(scene, &scene->quadrics[primitive->index]);
}

/* Returns the number of the scene's last surface. */
uint32_t surface_last(const struct scene *scene) {
    uint32_t last = 0;
    for (entry_number i = 0; i < scene->primitive_count; i++) {
        last = larger(last, last_of_primitive(scene, &scene->primitives[i]));
    }
    return last;
}
