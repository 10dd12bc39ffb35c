/* SPDX-License-Identifier: MIT */
/* Reads the members of each kind of leaf solid, and refuses those that enclose nothing. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "scene/values.h"

enum { PLANES_LEAST = 4, QUADRATIC_TERMS = 6, FORM_TERMS = 10 };

static const struct scene_range RANGE_BASE = {0, 1e9}; /* a cone's radius: 0 at its tip */

static double distance_between(const double a[3], const double b[3]) {
    double x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];
    return sqrt(x * x + y * y + z * z);
}

static bool read_box(struct scene_reader *reader, const struct scene_value *group,
                     struct solid_node *node) {
    static const char *const keys[] = {"min", "max", NULL};
    const struct scene_scope scope = {reader, group, "box"};
    if (!scope_check_keys(&scope, keys) ||
        !scope_numbers(&scope, "min", REQUIRED, RANGE_COORDINATE, 3, node->a) ||
        !scope_numbers(&scope, "max", REQUIRED, RANGE_COORDINATE, 3, node->b)) {
        return false;
    }
    for (int i = 0; i < 3; i++) {
        if (!(node->a[i] < node->b[i])) {
            return scene_fail(reader, scope_line(&scope, "max"),
                              "the box is empty: along %c its 'min' %.10g has to be less than its "
                              "'max' %.10g",
                              'x' + i, node->a[i], node->b[i]);
        }
    }
    return true;
}

static bool read_ball(struct scene_reader *reader, const struct scene_value *group,
                      struct solid_node *node) {
    static const char *const keys[] = {"centre", "radius", NULL};
    const struct scene_scope scope = {reader, group, "ball"};
    return scope_check_keys(&scope, keys) &&
           scope_numbers(&scope, "centre", OPTIONAL, RANGE_COORDINATE, 3, node->a) &&
           scope_number(&scope, "radius", REQUIRED, RANGE_LENGTH, &node->radius);
}

/* Reads the two ends of an axis, which have to differ. */
static bool read_axis(const struct scene_scope *scope, struct solid_node *node) {
    if (!scope_numbers(scope, "from", REQUIRED, RANGE_COORDINATE, 3, node->a) ||
        !scope_numbers(scope, "to", REQUIRED, RANGE_COORDINATE, 3, node->b)) {
        return false;
    }
    if (distance_between(node->a, node->b) < RANGE_LENGTH.least) {
        return scene_fail(scope->reader, scope_line(scope, "to"),
                          "'from' and 'to' of the %s are the same point: they are the two ends of "
                          "its axis, and have to differ",
                          scope->what);
    }
    return true;
}

static bool read_cylinder(struct scene_reader *reader, const struct scene_value *group,
                          struct solid_node *node) {
    static const char *const keys[] = {"from", "to", "radius", NULL};
    const struct scene_scope scope = {reader, group, "cylinder"};
    return scope_check_keys(&scope, keys) && read_axis(&scope, node) &&
           scope_number(&scope, "radius", REQUIRED, RANGE_LENGTH, &node->radius);
}

static bool read_cone(struct scene_reader *reader, const struct scene_value *group,
                      struct solid_node *node) {
    static const char *const keys[] = {"from", "to", "from_radius", "to_radius", NULL};
    const struct scene_scope scope = {reader, group, "cone"};
    if (!scope_check_keys(&scope, keys) || !read_axis(&scope, node) ||
        !scope_number(&scope, "from_radius", REQUIRED, RANGE_BASE, &node->radius) ||
        !scope_number(&scope, "to_radius", OPTIONAL, RANGE_BASE, &node->radius_b)) {
        return false;
    }
    double larger = fmax(node->radius, node->radius_b);
    double smaller = fmin(node->radius, node->radius_b);
    if (larger < RANGE_LENGTH.least) {
        return scene_fail(reader, scope_line(&scope, "from_radius"),
                          "both radii of the cone are 0: one of 'from_radius' and 'to_radius' has "
                          "to be %.10g or more",
                          RANGE_LENGTH.least);
    }
    if (smaller > 0 && smaller < RANGE_LENGTH.least) {
        return scene_fail(reader, scope_line(&scope, "from_radius"),
                          "a radius of the cone is %.10g: 0 (its tip), or %.10g to %.10g, is "
                          "allowed",
                          smaller, RANGE_LENGTH.least, RANGE_LENGTH.most);
    }
    if (larger - smaller < 1e-9 * larger) {
        return scene_fail(reader, scope_line(&scope, "to_radius"),
                          "both radii of the cone are %.10g: use a cylinder", larger);
    }
    return true;
}

static bool read_ellipsoid(struct scene_reader *reader, const struct scene_value *group,
                           struct solid_node *node) {
    static const char *const keys[] = {"centre", "radii", NULL};
    const struct scene_scope scope = {reader, group, "ellipsoid"};
    return scope_check_keys(&scope, keys) &&
           scope_numbers(&scope, "centre", OPTIONAL, RANGE_COORDINATE, 3, node->a) &&
           scope_numbers(&scope, "radii", REQUIRED, RANGE_LENGTH, 3, node->b);
}

static bool read_paraboloid(struct scene_reader *reader, const struct scene_value *group,
                            struct solid_node *node) {
    static const char *const keys[] = {"from", "to", "radius", NULL};
    const struct scene_scope scope = {reader, group, "paraboloid"};
    return scope_check_keys(&scope, keys) && read_axis(&scope, node) &&
           scope_number(&scope, "radius", REQUIRED, RANGE_LENGTH, &node->radius_b);
}

/* Reads a hyperboloid: of one sheet if `waist` is given, of two if `gap` is. */
static bool read_hyperboloid(struct scene_reader *reader, const struct scene_value *group,
                             struct solid_node *node) {
    static const char *const keys[] = {"from", "to", "radius", "waist", "gap", NULL};
    const struct scene_scope scope = {reader, group, "hyperboloid"};
    if (!scope_check_keys(&scope, keys)) {
        return false;
    }
    bool one_sheet = scope_has(&scope, "waist");
    if (one_sheet == scope_has(&scope, "gap")) {
        return scene_fail(reader, node->line,
                          "a hyperboloid needs either 'waist' (one sheet: its radius in the "
                          "middle) or 'gap' (two sheets: the distance of their tips): this one "
                          "has %s",
                          one_sheet ? "both" : "none");
    }
    const char *key = one_sheet ? "waist" : "gap";
    node->sheets = one_sheet ? 1 : 2;
    if (!read_axis(&scope, node) ||
        !scope_number(&scope, "radius", REQUIRED, RANGE_LENGTH, &node->radius_b) ||
        !scope_number(&scope, key, REQUIRED, RANGE_LENGTH, &node->radius)) {
        return false;
    }
    double most = one_sheet ? node->radius_b : distance_between(node->a, node->b);
    if (node->radius > most * (1 - 1e-9)) {
        return scene_fail(
            reader, scope_line(&scope, key),
            "'%s' of the hyperboloid is %.10g: it has to be less than %s, %.10g", key, node->radius,
            one_sheet ? "'radius', that at its ends" : "its length from end to end", most);
    }
    return true;
}

static bool read_quadric(struct scene_reader *reader, const struct scene_value *group,
                         struct solid_node *node) {
    static const char *const keys[] = {"coefficients", NULL};
    const struct scene_scope scope = {reader, group, "quadric"};
    if (!scope_check_keys(&scope, keys) ||
        !scope_numbers(&scope, "coefficients", REQUIRED, RANGE_COORDINATE, FORM_TERMS,
                       node->form)) {
        return false;
    }
    double largest = 0, linear = 0;
    for (int i = 0; i < FORM_TERMS - 1; i++) {
        double *part = i < QUADRATIC_TERMS ? &largest : &linear;
        *part = fmax(*part, fabs(node->form[i]));
    }
    if (largest == 0) {
        return scene_fail(reader, scope_line(&scope, "coefficients"),
                          linear == 0 ? "all coefficients of the quadric but the last are 0: it "
                                        "has no surface; one of xx, yy, zz, xy, yz, zx has to "
                                        "differ from 0"
                                      : "the quadric has no quadratic term: use a half_space");
    }
    return true;
}

/* Reads a plane: its normal, of any length, and an offset or a point that the plane holds. */
static bool read_plane(const struct scene_scope *scope, struct scene_plane *plane) {
    static const char *const keys[] = {"normal", "offset", "through", NULL};
    double through[3] = {0};
    if (!scope_check_keys(scope, keys) ||
        !scope_numbers(scope, "normal", REQUIRED, RANGE_COORDINATE, 3, plane->normal)) {
        return false;
    }
    unsigned line = scope->group->line;
    bool has_point = scope_has(scope, "through");
    if (has_point == scope_has(scope, "offset")) {
        return scene_fail(scope->reader, line,
                          "a %s needs either 'offset' (normal . p <= offset) or 'through' (a point "
                          "of its plane): this one has %s",
                          scope->what, has_point ? "both" : "none");
    }
    if (!scope_number(scope, "offset", OPTIONAL, RANGE_COORDINATE, &plane->offset) ||
        !scope_numbers(scope, "through", OPTIONAL, RANGE_COORDINATE, 3, through)) {
        return false;
    }
    static const double origin[3] = {0};
    double length = distance_between(plane->normal, origin);
    if (length < RANGE_LENGTH.least) {
        return scene_fail(scope->reader, scope_line(scope, "normal"),
                          "'normal' of the %s is zero: it needs a direction, such as [0, 0, 1]",
                          scope->what);
    }
    plane->offset /= length;
    for (int i = 0; i < 3; i++) {
        plane->normal[i] /= length;
        plane->offset += plane->normal[i] * through[i];
    }
    return true;
}

static bool read_half_space(struct scene_reader *reader, const struct scene_value *group,
                            struct solid_node *node) {
    const struct scene_scope scope = {reader, group, "half_space"};
    node->planes = scene_allocate(reader, 1, sizeof *node->planes);
    node->plane_count = 1;
    return node->planes && read_plane(&scope, node->planes);
}

static bool read_polyhedron(struct scene_reader *reader, const struct scene_value *group,
                            struct solid_node *node) {
    static const char *const keys[] = {"planes", NULL};
    const struct scene_scope scope = {reader, group, "polyhedron"};
    const struct scene_value *list;
    if (!scope_check_keys(&scope, keys) ||
        !scope_list(&scope, "planes", REQUIRED, PLANES_LEAST, SCENE_PLANES_MOST, &list)) {
        return false;
    }
    node->plane_count = list->count;
    node->planes = scene_allocate(reader, node->plane_count, sizeof *node->planes);
    for (size_t i = 0; node->planes && i < node->plane_count; i++) {
        const struct scene_scope plane = {reader, &list->members[i], "plane"};
        if (!scene_is_group(reader, plane.group, "plane") ||
            !read_plane(&plane, &node->planes[i])) {
            return false;
        }
    }
    return node->planes != NULL;
}

const struct scene_leaf scene_leaves[] = {
    [SOLID_BOX] = {"box", read_box},
    [SOLID_BALL] = {"ball", read_ball},
    [SOLID_CYLINDER] = {"cylinder", read_cylinder},
    [SOLID_CONE] = {"cone", read_cone},
    [SOLID_ELLIPSOID] = {"ellipsoid", read_ellipsoid},
    [SOLID_PARABOLOID] = {"paraboloid", read_paraboloid},
    [SOLID_HYPERBOLOID] = {"hyperboloid", read_hyperboloid},
    [SOLID_QUADRIC] = {"quadric", read_quadric},
    [SOLID_HALF_SPACE] = {"half_space", read_half_space},
    [SOLID_POLYHEDRON] = {"polyhedron", read_polyhedron},
};

const size_t scene_leaf_count = sizeof scene_leaves / sizeof *scene_leaves;
