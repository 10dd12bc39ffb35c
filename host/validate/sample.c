/* SPDX-License-Identifier: MIT */
/* The validator: draws points and rays where faults may be, from the description alone. */
#include <math.h>

#include "splitmix64.h"
#include "validate/validate_internal.h"

double dice_between(struct dice *dice, double low, double high) {
    return low + (high - low) * (double)(splitmix64(&dice->state) >> 11) * 0x1p-53;
}

int dice_below(struct dice *dice, int count) {
    return (int)(splitmix64(&dice->state) % (uint64_t)count);
}

static double length_of(const double a[3]) {
    return sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
}

void dice_direction(struct dice *dice, double direction[3]) {
    double length;
    do {
        for (int i = 0; i < 3; i++) {
            direction[i] = dice_between(dice, -1, 1);
        }
        length = length_of(direction);
    } while (!(length > 0.1 && length < 1));
    for (int i = 0; i < 3; i++) {
        direction[i] /= length;
    }
}

/* ---- Bounds and corners of leaves ----------------------------------------------------------- */

static void include(struct shape *leaf, const long double q[3]) {
    for (int i = 0; i < 3; i++) {
        leaf->low[i] = leaf->finite ? fminl(leaf->low[i], q[i]) : q[i];
        leaf->high[i] = leaf->finite ? fmaxl(leaf->high[i], q[i]) : q[i];
    }
    leaf->finite = true;
}

static void add_corner(struct described *described, struct shape *leaf, const long double q[3]) {
    include(leaf, q);
    if (described->corner_count < described->corners_most) {
        for (int i = 0; i < 3; i++) {
            described->corners[described->corner_count][i] = q[i];
        }
        described->corner_count++;
        leaf->corners++;
    }
}

static long double determinant(const long double a[3], const long double b[3],
                               const long double c[3]) {
    return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
           a[2] * (b[0] * c[1] - b[1] * c[0]);
}

/* Solves three linear equations, row . q = right, by Cramer's rule; false if they are dependent. */
static bool solve(long double row[3][3], const long double right[3], long double q[3]) {
    const long double whole = determinant(row[0], row[1], row[2]);
    if (fabsl(whole) < 1e-9L) {
        return false;
    }
    for (int j = 0; j < 3; j++) {
        long double replaced[3][3];
        for (int i = 0; i < 3; i++) {
            for (int k = 0; k < 3; k++) {
                replaced[i][k] = k == j ? right[i] : row[i][k];
            }
        }
        q[j] = determinant(replaced[0], replaced[1], replaced[2]) / whole;
    }
    return true;
}

/* Checks that the point where three planes meet is behind all planes of their polyhedron. */
static bool is_corner(const struct solid_node *node, const long double q[3]) {
    for (size_t i = 0; i < node->plane_count; i++) {
        const struct scene_plane *plane = &node->planes[i];
        const long double beyond = plane->normal[0] * q[0] + plane->normal[1] * q[1] +
                                   plane->normal[2] * q[2] - plane->offset;
        if (beyond > 1e-9L * (1 + fabsl((long double)plane->offset))) {
            return false;
        }
    }
    return true;
}

static void measure_polyhedron(struct described *described, struct shape *leaf) {
    const struct solid_node *node = leaf->node;
    for (size_t i = 0; i < node->plane_count; i++) {
        for (size_t j = 0; j < i; j++) {
            for (size_t k = 0; k < j; k++) {
                const size_t plane[3] = {i, j, k};
                long double row[3][3], right[3], q[3];
                for (int m = 0; m < 3; m++) {
                    right[m] = node->planes[plane[m]].offset;
                    for (int n = 0; n < 3; n++) {
                        row[m][n] = node->planes[plane[m]].normal[n];
                    }
                }
                if (solve(row, right, q) && is_corner(node, q)) {
                    add_corner(described, leaf, q);
                }
            }
        }
    }
}

static void measure_box(struct described *described, struct shape *leaf) {
    for (int corner = 0; corner < 8; corner++) {
        long double q[3];
        for (int i = 0; i < 3; i++) {
            q[i] = (corner >> i & 1) != 0 ? leaf->node->b[i] : leaf->node->a[i];
        }
        add_corner(described, leaf, q);
    }
}

/* Includes in a leaf's bounds a box about one of its ends or its centre. */
static void measure_about(struct shape *leaf, const double end[3], const double reach[3]) {
    for (int side = -1; side <= 1; side += 2) {
        long double q[3];
        for (int i = 0; i < 3; i++) {
            q[i] = (long double)end[i] + side * (long double)reach[i];
        }
        include(leaf, q);
    }
}

/* Bounds a quadric that has a centre, by the form's value there: a guess, only to draw samples
 * about the quadric. */
static void measure_quadric(struct shape *leaf) {
    const double *f = leaf->node->form;
    long double row[3][3] = {
        {2 * f[0], f[3], f[5]}, {f[3], 2 * f[1], f[4]}, {f[5], f[4], 2 * f[2]}};
    const long double right[3] = {-f[6], -f[7], -f[8]};
    long double q[3];
    double centre[3], reach[3];
    if (!solve(row, right, q)) {
        return;
    }
    const long double there = f[9] - (right[0] * q[0] + right[1] * q[1] + right[2] * q[2]) / 2;
    for (int i = 0; i < 3; i++) {
        centre[i] = (double)q[i];
        reach[i] = 1.2 * (double)sqrtl(fabsl(there / fmaxl(fabsl((long double)f[i]), 1e-9L)));
    }
    measure_about(leaf, centre, reach);
}

void described_measure(struct described *described) {
    for (int i = 0; i < described->leaf_count; i++) {
        struct shape *leaf = &described->shapes[described->leaves[i]];
        const struct solid_node *node = leaf->node;
        const double wide = fmax(node->radius, node->radius_b), round[3] = {wide, wide, wide};
        leaf->corner = described->corner_count;
        switch (node->kind) {
        case SOLID_BOX:
            measure_box(described, leaf);
            break;
        case SOLID_POLYHEDRON:
            measure_polyhedron(described, leaf);
            break;
        case SOLID_ELLIPSOID:
            measure_about(leaf, node->a, node->b);
            break;
        case SOLID_QUADRIC:
            measure_quadric(leaf);
            break;
        case SOLID_BALL:
            measure_about(leaf, node->a, round);
            break;
        case SOLID_CYLINDER:
        case SOLID_CONE:
        case SOLID_PARABOLOID:
        case SOLID_HYPERBOLOID:
            measure_about(leaf, node->a, round);
            measure_about(leaf, node->b, round);
            break;
        case SOLID_HALF_SPACE:
        case SOLID_UNION:
        case SOLID_INTERSECTION:
        case SOLID_DIFFERENCE:
        case SOLID_PART:
            break;
        }
    }
}

/* ---- Points --------------------------------------------------------------------------------- */

static void anywhere(struct dice *dice, double reach, double point[3]) {
    for (int i = 0; i < 3; i++) {
        point[i] = dice_between(dice, -reach, reach);
    }
}

static const struct shape *leaf_of(const struct described *described, int leaf) {
    return &described->shapes[described->leaves[leaf]];
}

/* Makes a point in or about a leaf. */
static void anchor(const struct described *described, struct dice *dice, int leaf,
                   double point[3]) {
    const struct shape *shape = leaf_of(described, leaf);
    long double q[3];
    if (!shape->finite) {
        anywhere(dice, 512, point);
        return;
    }
    for (int i = 0; i < 3; i++) {
        q[i] = shape->low[i] +
               (shape->high[i] - shape->low[i]) * (long double)dice_between(dice, -0.1, 1.1);
    }
    leaf_place(shape, q, point);
}

/* Moves a point by a distance of any size. */
static void stray(struct dice *dice, double point[3]) {
    const double distance = ldexp(1, -dice_below(dice, 27)) * dice_between(dice, 4, 8);
    double direction[3];
    dice_direction(dice, direction);
    for (int i = 0; i < 3; i++) {
        point[i] += distance * direction[i];
    }
}

/* Finds a point of a leaf's surface between two points on either side of the surface. Where no such
 * pair is found, the point is on no surface. */
static void surface_point(const struct described *described, struct dice *dice, int leaf,
                          double point[3]) {
    const struct shape *shape = leaf_of(described, leaf);
    double inside[3] = {0, 0, 0}, outside[3] = {0, 0, 0};
    bool has_inside = false, has_outside = false;
    for (int i = 0; i < 12 && !(has_inside && has_outside); i++) {
        anchor(described, dice, leaf, point);
        bool holds = leaf_side(shape, point) == SIDE_INSIDE;
        for (int j = 0; j < 3; j++) {
            *(holds ? &inside[j] : &outside[j]) = point[j];
        }
        has_inside = has_inside || holds;
        has_outside = has_outside || !holds;
    }
    for (int i = 0; i < 36 && has_inside && has_outside; i++) {
        for (int j = 0; j < 3; j++) {
            point[j] = inside[j] / 2 + outside[j] / 2;
        }
        const bool holds = leaf_side(shape, point) == SIDE_INSIDE;
        for (int j = 0; j < 3; j++) {
            *(holds ? &inside[j] : &outside[j]) = point[j];
        }
    }
}

/* Finds a corner of a leaf, or a point of its rim, or else a point of its surface. */
static void corner_point(const struct described *described, struct dice *dice, int leaf,
                         double point[3]) {
    const struct shape *shape = leaf_of(described, leaf);
    const struct solid_node *node = shape->node;
    if (shape->corners > 0) {
        leaf_place(shape, described->corners[shape->corner + dice_below(dice, shape->corners)],
                   point);
        return;
    }
    if (node->kind < SOLID_CYLINDER || node->kind > SOLID_HYPERBOLOID ||
        node->kind == SOLID_ELLIPSOID) {
        surface_point(described, dice, leaf, point);
        return;
    }
    const bool far = dice_below(dice, 2) == 1;
    const double radius = far || node->kind == SOLID_HYPERBOLOID ? node->radius_b : node->radius;
    double axis[3], across[3], along = 0, square = 0;
    long double q[3];
    dice_direction(dice, across);
    for (int i = 0; i < 3; i++) {
        axis[i] = node->b[i] - node->a[i];
        along += axis[i] * across[i];
        square += axis[i] * axis[i];
    }
    for (int i = 0; i < 3; i++) {
        across[i] -= along / square * axis[i];
    }
    const double width = length_of(across);
    for (int i = 0; i < 3; i++) {
        const double rim = node->kind == SOLID_CYLINDER ? node->radius : radius;
        q[i] =
            (long double)(far ? node->b[i] : node->a[i]) + (long double)(rim / width * across[i]);
    }
    leaf_place(shape, q, point);
}

static void middle_of(const struct described *described, int leaf, double point[3]) {
    const struct shape *shape = leaf_of(described, leaf);
    long double q[3];
    for (int i = 0; i < 3; i++) {
        q[i] = shape->finite ? (shape->low[i] + shape->high[i]) / 2 : 0;
    }
    leaf_place(shape, q, point);
}

void described_sample(const struct described *described, struct dice *dice, unsigned number,
                      double point[3]) {
    const int leaf = (int)(number / 8 % (unsigned)described->leaf_count);
    switch (number % 8) {
    case 0:
        anywhere(dice, number % 16 == 0 ? 512 : VALIDATE_WORLD, point);
        break;
    case 1:
        middle_of(described, leaf, point);
        point[dice_below(dice, 3)] = dice_between(dice, -VALIDATE_WORLD, VALIDATE_WORLD);
        break;
    case 2:
    case 3:
        anchor(described, dice, leaf, point);
        break;
    case 4:
    case 5:
        corner_point(described, dice, leaf, point);
        stray(dice, point);
        break;
    default: /* 6 and 7 */
        surface_point(described, dice, leaf, point);
        stray(dice, point);
        break;
    }
}

/* ---- Rays ----------------------------------------------------------------------------------- */

void described_ray(const struct described *described, struct dice *dice, unsigned number,
                   struct sight_line *ray) {
    const int leaf = (int)(number / 4 % (unsigned)described->leaf_count);
    double other[3];
    ray->random = number % 4 != 0;
    if (!ray->random) {
        middle_of(described, leaf, ray->origin);
        const int axis = dice_below(dice, 3);
        for (int i = 0; i < 3; i++) {
            ray->direction[i] = i == axis;
        }
        return;
    }
    anchor(described, dice, leaf, ray->origin);
    dice_direction(dice, ray->direction);
    anchor(described, dice, dice_below(dice, described->leaf_count), other);
    for (int i = 0; i < 3; i++) {
        other[i] -= ray->origin[i];
    }
    const double length = length_of(other);
    for (int i = 0; i < 3 && number % 4 == 1 && length > 1e-6; i++) {
        ray->direction[i] = other[i] / length;
    }
}
