/* SPDX-License-Identifier: MIT */
/* The validator: finds the solids that a point lies in, straight from the description. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "validate/validate_internal.h"

/* The share of its terms' magnitudes by which rounding may change a value. */
#define ROUNDING 0x1p-48L

/* The share of the magnitudes behind a place by which rounding of doubles may move it. */
#define PLACE_ROUNDING 0x1p-48L

/* ---- Maps ----------------------------------------------------------------------------------- */

static struct exact_map compose(const struct exact_map *outer, const struct exact_map *inner) {
    struct exact_map both;
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 4; j++) {
            both.m[i][j] = j == 3 ? outer->m[i][3] : 0;
            for (int k = 0; k < 3; k++) {
                both.m[i][j] += outer->m[i][k] * inner->m[k][j];
            }
        }
    }
    return both;
}

static void apply(const struct exact_map *map, const long double p[3], long double image[3]) {
    for (int i = 0; i < 3; i++) {
        image[i] = map->m[i][3];
        for (int j = 0; j < 3; j++) {
            image[i] += map->m[i][j] * p[j];
        }
    }
}

/* Inverts a map by cofactors. */
static struct exact_map invert(const struct exact_map *map) {
    struct exact_map inverse;
    long double determinant = 0;
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            const int a = (j + 1) % 3, b = (j + 2) % 3, c = (i + 1) % 3, d = (i + 2) % 3;
            inverse.m[i][j] = map->m[a][c] * map->m[b][d] - map->m[a][d] * map->m[b][c];
        }
    }
    for (int j = 0; j < 3; j++) {
        determinant += map->m[0][j] * inverse.m[j][0];
    }
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            inverse.m[i][j] /= determinant;
        }
        inverse.m[i][3] = 0;
        for (int j = 0; j < 3; j++) {
            inverse.m[i][3] -= inverse.m[i][j] * map->m[j][3];
        }
    }
    return inverse;
}

static struct exact_map placement_of(const struct solid_node *node) {
    struct exact_map map;
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 4; j++) {
            map.m[i][j] = node->placement.m[i][j];
        }
    }
    return map;
}

/* ---- Leaves --------------------------------------------------------------------------------- */

static long double dot(const long double a[3], const long double b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* Judges by a leaf's function, negative inside, on which side a point lies. Given are the
 * function's value, its gradient in the leaf's coordinates, and the magnitude of its terms. */
static enum side side_of(const struct shape *leaf, long double value, const long double gradient[3],
                         long double terms) {
    long double square = 0;
    for (int j = 0; j < 3; j++) {
        long double along = 0;
        for (int i = 0; i < 3; i++) {
            along += leaf->to_local.m[i][j] * gradient[i];
        }
        square += along * along;
    }
    const long double uncertainty = leaf->slack * sqrtl(square) + ROUNDING * terms;
    return value < -uncertainty ? SIDE_INSIDE : value > uncertainty ? SIDE_OUTSIDE : SIDE_NEAR;
}

static enum side least(enum side a, enum side b) {
    return a < b ? a : b;
}

/* Judges a point against the plane normal . q <= offset. */
static enum side plane_side(const struct shape *leaf, const long double normal[3],
                            long double offset, const long double q[3]) {
    return side_of(leaf, dot(normal, q) - offset, normal, 0);
}

static enum side box_side(const struct shape *leaf, const long double q[3]) {
    enum side side = SIDE_INSIDE;
    for (int i = 0; i < 3; i++) {
        const long double up[3] = {i == 0, i == 1, i == 2}, down[3] = {-up[0], -up[1], -up[2]};
        side = least(side, plane_side(leaf, up, leaf->node->b[i], q));
        side = least(side, plane_side(leaf, down, -(long double)leaf->node->a[i], q));
    }
    return side;
}

static enum side planes_side(const struct shape *leaf, const long double q[3]) {
    enum side side = SIDE_INSIDE;
    for (size_t i = 0; i < leaf->node->plane_count; i++) {
        const struct scene_plane *plane = &leaf->node->planes[i];
        const long double normal[3] = {plane->normal[0], plane->normal[1], plane->normal[2]};
        side = least(side, plane_side(leaf, normal, plane->offset, q));
    }
    return side;
}

/* Judges a point against the ellipsoid sum ((q - a) / radii)^2 <= 1. */
static enum side ellipsoid_side(const struct shape *leaf, const long double radii[3],
                                const long double q[3]) {
    long double gradient[3], value = -1;
    for (int i = 0; i < 3; i++) {
        long double x = (q[i] - leaf->node->a[i]) / radii[i];
        value += x * x;
        gradient[i] = 2 * x / radii[i];
    }
    return side_of(leaf, value, gradient, value + 2);
}

/* Computes the square of a round solid's radius at t, 0 .. length, along its axis, and how the
 * square grows with t. */
static void round_radius(const struct solid_node *node, long double t, long double length,
                         long double *square, long double *growth) {
    const long double r = node->radius, end = node->radius_b, s = 2 * t / length - 1;
    const long double q = r / length, slope = (end - r) / length, radius = r + slope * t;
    switch (node->kind) {
    case SOLID_CYLINDER:
        *square = r * r;
        *growth = 0;
        break;
    case SOLID_CONE:
        *square = radius * radius;
        *growth = 2 * radius * slope;
        break;
    case SOLID_PARABOLOID:
        *square = end * end * t / length;
        *growth = end * end / length;
        break;
    case SOLID_HYPERBOLOID:
        *square = node->sheets == 1 ? r * r + (end * end - r * r) * s * s
                                    : end * end * (s * s - q * q) / (1 - q * q);
        *growth =
            (node->sheets == 1 ? end * end - r * r : end * end / (1 - q * q)) * 4 * s / length;
        break;
    case SOLID_BOX:
    case SOLID_BALL:
    case SOLID_ELLIPSOID:
    case SOLID_QUADRIC:
    case SOLID_HALF_SPACE:
    case SOLID_POLYHEDRON:
    case SOLID_UNION:
    case SOLID_INTERSECTION:
    case SOLID_DIFFERENCE:
    case SOLID_PART:
        *square = *growth = 0; /* not round about an axis */
        break;
    }
}

static enum side round_side(const struct shape *leaf, const long double q[3]) {
    const struct solid_node *node = leaf->node;
    long double axis[3], back[3], from[3], length = 0, square, growth, gradient[3];
    for (int i = 0; i < 3; i++) {
        axis[i] = (long double)node->b[i] - node->a[i];
        from[i] = q[i] - node->a[i];
    }
    length = sqrtl(dot(axis, axis));
    for (int i = 0; i < 3; i++) {
        axis[i] /= length;
        back[i] = -axis[i];
    }
    const long double t = dot(from, axis);
    enum side side = least(plane_side(leaf, axis, length, from), plane_side(leaf, back, 0, from));
    round_radius(node, t, length, &square, &growth);
    for (int i = 0; i < 3; i++) {
        from[i] -= t * axis[i];
        gradient[i] = 2 * from[i] - growth * axis[i];
    }
    /* The form is worked out from one end: at a tip, its rounding goes by the radii at the ends. */
    const long double ends =
        (long double)node->radius * node->radius + (long double)node->radius_b * node->radius_b;
    const long double radial = dot(from, from);
    return least(side, side_of(leaf, radial - square, gradient, radial + fabsl(square) + ends));
}

static enum side quadric_side(const struct shape *leaf, const long double q[3]) {
    const double *f = leaf->node->form;
    const long double x = q[0], y = q[1], z = q[2];
    const long double terms[10] = {f[0] * x * x, f[1] * y * y, f[2] * z * z, f[3] * x * y,
                                   f[4] * y * z, f[5] * z * x, f[6] * x,     f[7] * y,
                                   f[8] * z,     f[9]};
    const long double gradient[3] = {2 * f[0] * x + f[3] * y + f[5] * z + f[6],
                                     2 * f[1] * y + f[3] * x + f[4] * z + f[7],
                                     2 * f[2] * z + f[4] * y + f[5] * x + f[8]};
    long double value = 0, magnitude = 0;
    for (int i = 0; i < 10; i++) {
        value += terms[i];
        magnitude += fabsl(terms[i]);
    }
    return side_of(leaf, value, gradient, magnitude);
}

enum side leaf_side(const struct shape *leaf, const double point[3]) {
    const struct solid_node *node = leaf->node;
    const long double p[3] = {point[0], point[1], point[2]};
    const long double radii[3] = {node->b[0], node->b[1], node->b[2]};
    const long double radius[3] = {node->radius, node->radius, node->radius};
    long double q[3];
    apply(&leaf->to_local, p, q);
    switch (node->kind) {
    case SOLID_BOX:
        return box_side(leaf, q);
    case SOLID_BALL:
        return ellipsoid_side(leaf, radius, q);
    case SOLID_ELLIPSOID:
        return ellipsoid_side(leaf, radii, q);
    case SOLID_QUADRIC:
        return quadric_side(leaf, q);
    case SOLID_HALF_SPACE:
    case SOLID_POLYHEDRON:
        return planes_side(leaf, q);
    case SOLID_CYLINDER:
    case SOLID_CONE:
    case SOLID_PARABOLOID:
    case SOLID_HYPERBOLOID:
        return round_side(leaf, q);
    case SOLID_UNION:
    case SOLID_INTERSECTION:
    case SOLID_DIFFERENCE:
    case SOLID_PART:
        break; /* no leaf */
    }
    return SIDE_NEAR;
}

void leaf_place(const struct shape *leaf, const long double local[3], double point[3]) {
    long double image[3];
    apply(&leaf->from_local, local, image);
    for (int i = 0; i < 3; i++) {
        point[i] = (double)image[i];
    }
}

/* ---- Trees ---------------------------------------------------------------------------------- */

static enum side shape_side(const struct described *described, int index, const double point[3]) {
    const struct shape *shape = &described->shapes[index];
    if (shape->child < 0) {
        return leaf_side(shape, point);
    }
    enum side side = shape_side(described, shape->child, point);
    for (int i = described->shapes[shape->child].sibling; i >= 0;
         i = described->shapes[i].sibling) {
        const enum side other = shape_side(described, i, point);
        switch (shape->node->kind) {
        case SOLID_UNION:
            side = side > other ? side : other;
            break;
        case SOLID_DIFFERENCE:
            side = least(side, (enum side)(SIDE_INSIDE - other));
            break;
        case SOLID_INTERSECTION:
        case SOLID_PART: /* has one child */
        case SOLID_BOX:  /* leaves have none */
        case SOLID_BALL:
        case SOLID_CYLINDER:
        case SOLID_CONE:
        case SOLID_ELLIPSOID:
        case SOLID_PARABOLOID:
        case SOLID_HYPERBOLOID:
        case SOLID_QUADRIC:
        case SOLID_HALF_SPACE:
        case SOLID_POLYHEDRON:
            side = least(side, other);
            break;
        }
    }
    return side;
}

enum side part_side(const struct described *described, int index, const double point[3]) {
    const struct part *part = &described->parts[index];
    enum side side = shape_side(described, part->shape, point);
    for (int i = part->trim; i >= 0 && side != SIDE_OUTSIDE; i = described->trims[i].next) {
        const struct trim *trim = &described->trims[i];
        const enum side other = shape_side(described, trim->shape, point);
        side = least(side, trim->outside ? (enum side)(SIDE_INSIDE - other) : other);
    }
    return side;
}

int described_filler(const struct described *described, const double point[3]) {
    for (int i = described->part_count - 1; i >= 0; i--) {
        const enum side side =
            described->parts[i].is_left_out ? SIDE_OUTSIDE : part_side(described, i, point);
        if (side != SIDE_OUTSIDE) {
            return side == SIDE_INSIDE ? i : -2;
        }
    }
    return -1;
}

/* ---- Unfolding ------------------------------------------------------------------------------ */

/* The place of a node: the maps of all placements around it, and the map of magnitudes, for
 * rounding. */
struct stand {
    struct exact_map to_local, from_local, magnitudes;
};

static struct stand stand_of(const struct stand *outer, const struct solid_node *node) {
    struct stand stand;
    struct exact_map placement = placement_of(node), inverse = invert(&placement);
    stand.to_local = compose(&inverse, &outer->to_local);
    stand.from_local = compose(&outer->from_local, &placement);
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 4; j++) {
            placement.m[i][j] = fabsl(placement.m[i][j]);
        }
    }
    stand.magnitudes = compose(&outer->magnitudes, &placement);
    return stand;
}

/* Returns the largest magnitude among a leaf's coordinates, radii and offsets, by which its
 * rounding is judged. */
static long double leaf_size(const struct solid_node *node) {
    long double size = fmax(node->radius, node->radius_b);
    for (int i = 0; i < 3; i++) {
        size = fmaxl(size, fmaxl(fabsl((long double)node->a[i]), fabsl((long double)node->b[i])));
    }
    for (size_t i = 0; i < node->plane_count; i++) {
        size = fmaxl(size, fabsl((long double)node->planes[i].offset));
    }
    return size;
}

static void set_slack(struct shape *leaf, const struct exact_map *magnitudes) {
    const long double size = leaf_size(leaf->node);
    long double most = 0;
    for (int i = 0; i < 3; i++) {
        const long double *row = magnitudes->m[i];
        most = fmaxl(most, (row[0] + row[1] + row[2]) * size + row[3]);
    }
    leaf->slack = VALIDATE_NEAR + PLACE_ROUNDING * most;
}

static int add_shape(struct described *described, int node, const struct stand *outer) {
    const int index = described->shape_count;
    if (index == described->shapes_most) {
        return -1;
    }
    described->shape_count++;
    struct shape *shape = &described->shapes[index];
    shape->node = &described->description->nodes[node];
    const struct stand stand = stand_of(outer, shape->node);
    shape->to_local = stand.to_local;
    shape->from_local = stand.from_local;
    shape->child = shape->sibling = -1;
    if (shape->node->child_count == 0) {
        set_slack(shape, &stand.magnitudes);
        described->leaves[described->leaf_count++] = index;
    }
    int *link = &shape->child;
    for (size_t i = 0; i < shape->node->child_count; i++) {
        *link = add_shape(described, shape->node->children[i], &stand);
        link = *link < 0 ? link : &described->shapes[*link].sibling;
    }
    return index;
}

/* An object that is being unfolded. */
struct unfolding {
    struct described *described;
    int object;
};

/* Returns the one material of the leaves that fill a node, or -2 where there are several. `known`
 * is the material of the leaves before these, or -1. */
static int sole_of(const struct scene_description *description, int index, int inherited,
                   int known) {
    const struct solid_node *node = &description->nodes[index];
    const int material = node->material >= 0 ? node->material : inherited;
    if (node->child_count == 0) {
        return known == -1 || known == material ? material : -2;
    }
    const size_t count = node->kind == SOLID_UNION ? node->child_count : 1;
    for (size_t i = 0; i < count; i++) {
        known = sole_of(description, node->children[i], material, known);
    }
    return known;
}

/* Adds the parts of a node: one, or those of several materials, with what cuts them. */
static void add_parts(struct unfolding *unfolding, int index, const struct stand *outer,
                      int inherited, int trim) {
    struct described *described = unfolding->described;
    const struct solid_node *node = &described->description->nodes[index];
    const int material = node->material >= 0 ? node->material : inherited;
    const int sole = sole_of(described->description, index, inherited, -1);
    if (sole >= 0) {
        struct part *part = &described->parts[described->part_count++];
        part->object = unfolding->object;
        part->material = sole;
        part->shape = add_shape(described, index, outer);
        part->trim = trim;
        return;
    }
    const struct stand stand = stand_of(outer, node);
    const bool cuts = node->kind == SOLID_DIFFERENCE || node->kind == SOLID_INTERSECTION;
    for (size_t i = 1; cuts && i < node->child_count; i++) {
        struct trim *next = &described->trims[described->trim_count];
        next->outside = node->kind == SOLID_DIFFERENCE;
        next->shape = add_shape(described, node->children[i], &stand);
        next->next = trim;
        trim = described->trim_count++;
    }
    for (size_t i = 0; i < (cuts ? 1 : node->child_count); i++) {
        add_parts(unfolding, node->children[i], &stand, material, trim);
    }
}

bool described_unfold(struct described *described, const struct scene_description *description,
                      const double centre[3], int exponent) {
    struct stand world;
    memset(described, 0, sizeof *described);
    memset(&world, 0, sizeof world);
    for (int i = 0; i < 3; i++) {
        world.to_local.m[i][i] = ldexpl(1, -exponent);
        world.to_local.m[i][3] = centre[i];
        world.from_local.m[i][i] = world.magnitudes.m[i][i] = ldexpl(1, exponent);
        world.from_local.m[i][3] = -ldexpl(centre[i], exponent);
        world.magnitudes.m[i][3] = fabsl(world.from_local.m[i][3]);
    }
    described->description = description;
    described->shapes_most = 2 * (int)description->instances;
    described->corners_most = CORNERS_OF_NODE * (int)description->instances;
    const size_t most = (size_t)described->shapes_most;
    described->shapes = calloc(most, sizeof *described->shapes);
    described->trims = calloc(most, sizeof *described->trims);
    described->parts = calloc(most, sizeof *described->parts);
    described->leaves = calloc(most, sizeof *described->leaves);
    described->corners = calloc((size_t)described->corners_most, sizeof *described->corners);
    if (described->shapes == NULL || described->trims == NULL || described->parts == NULL ||
        described->leaves == NULL || described->corners == NULL) {
        return false;
    }
    for (size_t i = 0; i < description->object_count; i++) {
        struct unfolding unfolding = {described, (int)i};
        add_parts(&unfolding, description->objects[i].solid, &world, -1, -1);
    }
    return true;
}

void described_free(struct described *described) {
    free(described->shapes);
    free(described->trims);
    free(described->parts);
    free(described->leaves);
    free(described->corners);
}
