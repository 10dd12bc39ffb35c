/* SPDX-License-Identifier: MIT */
/* The scene compiler: half-spaces, slabs and convex polyhedra. */
#include <math.h>
#include <string.h>

#include "base/grow.h"
#include "compiler/compiler_internal.h"

/* Places a plane by its normal and one of its points. A normal is placed by the inverse transpose;
 * the matrix of cofactors is the inverse transpose times the determinant. */
bool compile_placed_plane(struct compiler *compiler, const double normal[3], const double point[3],
                          const struct affine *placement, struct scene_plane *placed) {
    double column[3][3], cofactor[3][3], image[3];
    memset(placed, 0, sizeof *placed);
    for (int i = 0; i < 3; i++) {
        affine_axis(placement, i, column[i]);
    }
    for (int i = 0; i < 3; i++) {
        vector_cross(column[(i + 1) % 3], column[(i + 2) % 3], cofactor[i]);
        for (int j = 0; j < 3; j++) {
            placed->normal[j] += normal[i] * cofactor[i][j];
        }
    }
    if (vector_dot(cofactor[0], column[0]) < 0) {
        for (int j = 0; j < 3; j++) {
            placed->normal[j] = -placed->normal[j]; /* the placement mirrors */
        }
    }
    vector_normalise(placed->normal);
    affine_point(placement, point, image);
    if (!compile_direction(compiler, placed->normal)) {
        return false;
    }
    placed->offset = vector_dot(placed->normal, image);
    return true;
}

/* Places a plane that is given by its offset. */
static bool place_plane(struct compiler *compiler, const struct scene_plane *plane,
                        const struct affine *placement, struct scene_plane *placed) {
    const double foot[3] = {plane->normal[0] * plane->offset, plane->normal[1] * plane->offset,
                            plane->normal[2] * plane->offset};
    return compile_placed_plane(compiler, plane->normal, foot, placement, placed);
}

/* Tells whether a polyhedron has these surfaces in this order, each with its inside on the same
 * side. The surfaces alone do not tell: the halves of a solid have the plane between them in
 * common. */
static bool same_planes(const struct compiled_scene *scene,
                        const struct compiled_polyhedron *polyhedron,
                        const struct scene_plane *planes, const uint32_t *surfaces, size_t count) {
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

static uint64_t polyhedron_key(const uint32_t *surfaces, size_t count) {
    uint64_t key = bucket_key(compile_key(KNOWN_POLYHEDRON), count);
    for (size_t i = 0; i < count; i++) {
        key = bucket_key(key, surfaces[i]);
    }
    return key;
}

/* Sets the bounds of a polyhedron: everything for a slab, which has no end. */
static void set_bounds(struct compiled_polyhedron *polyhedron, const struct scene_plane *planes,
                       size_t count) {
    struct scene_plane copy[SCENE_PLANES_MOST];
    memcpy(copy, planes, count * sizeof *planes);
    const struct solid_node node = {.planes = copy, .plane_count = count};
    const struct bounds bounds = polyhedron_bounds(&affine_identity, &node);
    memcpy(polyhedron->low, bounds.low, sizeof polyhedron->low);
    memcpy(polyhedron->high, bounds.high, sizeof polyhedron->high);
}

uint32_t compile_placed_polyhedron(struct compiler *compiler, const struct scene_plane *planes,
                                   size_t count) {
    struct compiled_scene *scene = compiler->scene;
    uint32_t surfaces[SCENE_PLANES_MOST];
    for (size_t i = 0; i < count; i++) {
        surfaces[i] = compile_plane_surface(compiler, planes[i].normal, planes[i].offset);
        if (surfaces[i] == COMPILED_NONE) {
            return COMPILED_NONE;
        }
        for (size_t j = 0; j < i; j++) {
            if (surfaces[j] == surfaces[i] &&
                vector_parallel(planes[i].normal, planes[j].normal) < 0) {
                return compile_fail_thin(compiler);
            }
        }
    }
    const uint64_t key = polyhedron_key(surfaces, count);
    uint32_t slot = buckets_first(&compiler->known, key);
    for (; slot != COMPILED_NONE; slot = buckets_next(&compiler->known, slot)) {
        const uint32_t known = compiler->known.slots[slot].entry;
        const struct compiled_primitive *other = &scene->primitives[known];
        if (other->kind == PRIMITIVE_POLYHEDRON &&
            same_planes(scene, &scene->polyhedra[other->index], planes, surfaces, count)) {
            return known;
        }
    }
    if (!GROW(scene->polyhedra, scene->polyhedron_count)) {
        return compile_fail_room(compiler);
    }
    struct compiled_polyhedron *polyhedron = &scene->polyhedra[scene->polyhedron_count++];
    polyhedron->first = scene->plane_count;
    polyhedron->count = (uint8_t)count;
    set_bounds(polyhedron, planes, count);
    for (size_t i = 0; i < count; i++) {
        if (!GROW(scene->planes, scene->plane_count)) {
            return compile_fail_room(compiler);
        }
        struct compiled_plane *plane = &scene->planes[scene->plane_count++];
        memcpy(plane->normal, planes[i].normal, sizeof plane->normal);
        plane->offset = compile_place_of_plane(compiler, surfaces[i], plane->normal);
        plane->surface = surfaces[i];
    }
    return compile_note(compiler, key,
                        compile_new_primitive(compiler, PRIMITIVE_POLYHEDRON,
                                              scene->polyhedron_count - 1, COMPILED_FRAME_WORLD,
                                              false));
}

uint32_t compile_polyhedron(struct compiler *compiler, const struct scene_plane *planes,
                            size_t count, const struct affine *placement) {
    struct scene_plane placed[SCENE_PLANES_MOST];
    if (count > SCENE_PLANES_MOST) {
        count = SCENE_PLANES_MOST; /* the reader lets no more through */
    }
    for (size_t i = 0; i < count; i++) {
        if (!place_plane(compiler, &planes[i], placement, &placed[i])) {
            return COMPILED_NONE;
        }
    }
    return compile_placed_polyhedron(compiler, placed, count);
}

/* Tells whether no point of the world lies behind the plane. */
static bool misses_world(const struct scene_plane *plane) {
    double reach = 0;
    for (int i = 0; i < 3; i++) {
        reach += COMPILE_WORLD * fabs(plane->normal[i]);
    }
    return plane->offset <= -reach;
}

/* Compiles the half of the world behind a plane. The firmware's world ends, so that a ray's path to
 * the world's end is a number that every arithmetic holds. */
uint32_t compile_placed_half_space(struct compiler *compiler, const struct scene_plane *plane) {
    struct scene_plane planes[7] = {*plane};
    size_t count = 1;
    if (misses_world(&planes[0])) {
        compiler->lost_line = compiler->line;
    }
    for (int i = 0; i < 3; i++) {
        double along = planes[0].normal[i];
        if (fabs(along) == 1) {
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
    return compile_placed_polyhedron(compiler, planes, count);
}

uint32_t compile_half_space(struct compiler *compiler, const struct scene_plane *plane,
                            const struct affine *placement) {
    struct scene_plane placed;
    return place_plane(compiler, plane, placement, &placed)
               ? compile_placed_half_space(compiler, &placed)
               : COMPILED_NONE;
}
