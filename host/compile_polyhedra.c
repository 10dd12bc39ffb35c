/* SPDX-License-Identifier: MIT */
/* The scene compiler: half-spaces, slabs and convex polyhedra. */
#include <math.h>
#include <string.h>

#include "compile_internal.h"

/* A normal goes by the inverse transpose; the matrix of cofactors is that times the determinant. */
struct scene_plane compile_placed_plane(const struct scene_plane *plane,
                                        const struct affine *placement) {
    double column[3][3], cofactor[3][3], on_plane[3], image[3];
    struct scene_plane placed = {{0, 0, 0}, 0};
    for (int i = 0; i < 3; i++) {
        affine_axis(placement, i, column[i]);
        on_plane[i] = plane->normal[i] * plane->offset;
    }
    for (int i = 0; i < 3; i++) {
        vector_cross(column[(i + 1) % 3], column[(i + 2) % 3], cofactor[i]);
        for (int j = 0; j < 3; j++) {
            placed.normal[j] += plane->normal[i] * cofactor[i][j];
        }
    }
    if (vector_dot(cofactor[0], column[0]) < 0) {
        for (int j = 0; j < 3; j++) {
            placed.normal[j] = -placed.normal[j]; /* the placement mirrors */
        }
    }
    vector_normalise(placed.normal);
    affine_point(placement, on_plane, image);
    placed.offset = vector_dot(placed.normal, image);
    return placed;
}

/* The same surfaces, each with its inside on the same side: the halves of a solid have the plane
 * between them in common. */
static bool same_planes(const struct compiled_scene *scene,
                        const struct compiled_polyhedron *polyhedron,
                        const struct scene_plane *planes, const int *surfaces, size_t count) {
    if (polyhedron->count != count) {
        return false;
    }
    for (size_t i = 0; i < count; i++) {
        const struct compiled_plane *plane = &scene->planes[polyhedron->first + i];
        if (plane->surface != surfaces[i] || vector_dot(planes[i].normal, plane->normal) < 0) {
            return false;
        }
    }
    return true;
}

/* Everything for a slab, which has no end. */
static void set_bounds(struct compiled_polyhedron *polyhedron, const struct scene_plane *planes,
                       size_t count) {
    struct scene_plane copy[SCENE_PLANES_MOST];
    memcpy(copy, planes, count * sizeof *planes);
    const struct solid_node node = {.planes = copy, .plane_count = count};
    const struct bounds bounds = polyhedron_bounds(&affine_identity, &node);
    memcpy(polyhedron->low, bounds.low, sizeof polyhedron->low);
    memcpy(polyhedron->high, bounds.high, sizeof polyhedron->high);
}

/* A polyhedron of planes in scaled coordinates. */
static int add_polyhedron(struct compiler *compiler, const struct scene_plane *planes,
                          size_t count) {
    struct compiled_scene *scene = compiler->scene;
    int surfaces[SCENE_PLANES_MOST];
    for (size_t i = 0; i < count; i++) {
        surfaces[i] = compile_plane_surface(compiler, planes[i].normal, planes[i].offset);
        if (surfaces[i] < 0) {
            return -1;
        }
    }
    for (int i = 0; i < scene->primitive_count; i++) {
        const struct compiled_primitive *other = &scene->primitives[i];
        if (other->kind == KIND_POLYHEDRON &&
            same_planes(scene, &scene->polyhedra[other->index], planes, surfaces, count)) {
            return i;
        }
    }
    if (scene->plane_count + count > COMPILED_PLANES_MOST) {
        compile_fail(compiler, compiler->line, "more than %d faces of polyhedra",
                     COMPILED_PLANES_MOST);
        return -1;
    }
    int primitive = compile_new_primitive(compiler, KIND_POLYHEDRON, scene->polyhedron_count,
                                          WORLD_FRAME, false);
    if (primitive < 0) {
        return -1;
    }
    struct compiled_polyhedron *polyhedron = &scene->polyhedra[scene->polyhedron_count++];
    polyhedron->first = scene->plane_count;
    polyhedron->count = (uint8_t)count;
    set_bounds(polyhedron, planes, count);
    for (size_t i = 0; i < count; i++) {
        struct compiled_plane *plane = &scene->planes[scene->plane_count++];
        memcpy(plane->normal, planes[i].normal, sizeof plane->normal);
        plane->offset = planes[i].offset;
        plane->surface = (uint16_t)surfaces[i];
    }
    return primitive;
}

int compile_polyhedron(struct compiler *compiler, const struct scene_plane *planes, size_t count,
                       const struct affine *placement) {
    struct scene_plane placed[SCENE_PLANES_MOST];
    if (count > SCENE_PLANES_MOST) {
        count = SCENE_PLANES_MOST; /* the reader lets no more through */
    }
    for (size_t i = 0; i < count; i++) {
        placed[i] = compile_placed_plane(&planes[i], placement);
    }
    return add_polyhedron(compiler, placed, count);
}

/* Whether no point of the world lies behind the plane. */
static bool misses_world(const struct scene_plane *plane) {
    double reach = 0;
    for (int i = 0; i < 3; i++) {
        reach += COMPILE_WORLD * fabs(plane->normal[i]);
    }
    return plane->offset <= -reach;
}

/* Half of the world: the firmware's world ends, so that a ray's way to it is a number that every
 * arithmetic holds. */
int compile_half_space(struct compiler *compiler, const struct scene_plane *plane,
                       const struct affine *placement) {
    struct scene_plane planes[7] = {{{0, 0, 0}, 0}};
    planes[0] = compile_placed_plane(plane, placement);
    size_t count = 1;
    if (misses_world(&planes[0])) {
        compiler->lost_line = compiler->line;
    }
    for (int i = 0; i < 3; i++) {
        double along = planes[0].normal[i];
        if (compile_same(fabs(along), 1)) {
            double low[3] = {-COMPILE_WORLD, -COMPILE_WORLD, -COMPILE_WORLD};
            double high[3] = {COMPILE_WORLD, COMPILE_WORLD, COMPILE_WORLD};
            *(along > 0 ? &high[i] : &low[i]) = planes[0].offset * along;
            return compile_world_box(compiler, low, high);
        }
    }
    for (int i = 0; i < 6; i++) {
        double side = i < 3 ? -1 : 1;
        planes[count].normal[i % 3] = side;
        planes[count++].offset = COMPILE_WORLD;
    }
    return add_polyhedron(compiler, planes, count);
}
