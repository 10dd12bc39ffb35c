/* SPDX-License-Identifier: MIT */
/* The kinds of leaf solids: their keys, and the refusal of those that enclose nothing. */
#include <math.h>
#include <string.h>

#include "scene/keys.h"

enum { PLANES_LEAST = 4, QUADRATIC_TERMS = 6, FORM_TERMS = 10 };

static const struct scene_range bases = {0, 1e9, "length, or 0"}; /* a cone's radius */
static const struct scene_range plane_counts = {PLANES_LEAST, SCENE_PLANES_MOST, NULL};

/* The rows that several kinds have. */
#define POINT_ROW(key, into)                                                                       \
    NUMBERS_KEY(key, solid_node, into, 3, RANGE_COORDINATE), .noun = "point"
#define LENGTH_ROW(key, into) NUMBER_KEY(key, solid_node, into, RANGE_LENGTH)
#define CENTRE                                                                                     \
    { POINT_ROW("centre", a), .fallback = "the origin" }
#define FROM                                                                                       \
    { POINT_ROW("from", a), .is_required = true }
#define TO                                                                                         \
    { POINT_ROW("to", b), .is_required = true }

static double distance_between(const double a[3], const double b[3]) {
    double x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];
    return sqrt(x * x + y * y + z * z);
}

static struct scene_place place_of(const struct scene_scope *scope, const char *key) {
    return scene_place_of(scope->group, key);
}

static bool has_key(const struct scene_scope *scope, const char *key) {
    return value_member(scope->group, key) != NULL;
}

static const struct scene_key box_rows[] = {{POINT_ROW("min", a), .is_required = true},
                                            {POINT_ROW("max", b), .is_required = true}};

static void check_box(const struct scene_scope *scope, struct solid_node *node) {
    for (int i = 0; i < 3; i++) {
        if (!(node->a[i] < node->b[i])) {
            (void)scene_fail(scope->reader, place_of(scope, "max"),
                             "the box is empty: along %c its 'min' %.10g has to be less than its "
                             "'max' %.10g",
                             'x' + i, node->a[i], node->b[i]);
            return;
        }
    }
}

static const struct scene_key ball_rows[] = {CENTRE,
                                             {LENGTH_ROW("radius", radius), .is_required = true}};

/* Checks that the two ends of an axis differ. */
static void check_axis(const struct scene_scope *scope, struct solid_node *node) {
    if (distance_between(node->a, node->b) < RANGE_LENGTH.least) {
        (void)scene_fail(scope->reader, place_of(scope, "to"),
                         "'from' and 'to' of the %s are the same point: they are the two ends of "
                         "its axis, and have to differ",
                         scope->what);
    }
}

static const struct scene_key cylinder_rows[] = {
    FROM, TO, {LENGTH_ROW("radius", radius), .is_required = true}};

static const struct scene_key cone_rows[] = {
    FROM,
    TO,
    {NUMBER_KEY("from_radius", solid_node, radius, bases), .is_required = true},
    {NUMBER_KEY("to_radius", solid_node, radius_b, bases)}};

static void check_cone(const struct scene_scope *scope, struct solid_node *node) {
    double larger = fmax(node->radius, node->radius_b);
    double smaller = fmin(node->radius, node->radius_b);
    check_axis(scope, node);
    if (larger < RANGE_LENGTH.least) {
        (void)scene_fail(scope->reader, place_of(scope, "from_radius"),
                         "both radii of the cone are 0: one of 'from_radius' and 'to_radius' has "
                         "to be %.10g or more",
                         RANGE_LENGTH.least);
    } else if (smaller > 0 && smaller < RANGE_LENGTH.least) {
        (void)scene_fail(scope->reader, place_of(scope, "from_radius"),
                         "a radius of the cone is %.10g: 0 (its tip), or %.10g to %.10g, is "
                         "allowed",
                         smaller, RANGE_LENGTH.least, RANGE_LENGTH.most);
    } else if (larger - smaller < 1e-9 * larger) {
        (void)scene_fail(scope->reader, place_of(scope, "to_radius"),
                         "both radii of the cone are %.10g: use a cylinder", larger);
    }
}

static const struct scene_key ellipsoid_rows[] = {
    CENTRE, {NUMBERS_KEY("radii", solid_node, b, 3, RANGE_LENGTH), .is_required = true}};

static const struct scene_key paraboloid_rows[] = {
    FROM, TO, {LENGTH_ROW("radius", radius_b), .is_required = true}};

static const struct scene_key hyperboloid_rows[] = {
    FROM,
    TO,
    {LENGTH_ROW("radius", radius_b), .is_required = true},
    {LENGTH_ROW("waist", radius), .fallback = "that or `gap`"},
    {LENGTH_ROW("gap", radius), .fallback = "that or `waist`"}};

/* Makes a hyperboloid one of one sheet if `waist` is given, of two if `gap` is. */
static void check_hyperboloid(const struct scene_scope *scope, struct solid_node *node) {
    const bool has_waist = has_key(scope, "waist");
    const char *key = has_waist ? "waist" : "gap";
    const double most = has_waist ? node->radius_b : distance_between(node->a, node->b);
    node->sheets = has_waist ? 1 : 2;
    check_axis(scope, node);
    if (has_waist == has_key(scope, "gap")) {
        (void)scene_fail(scope->reader, scope->group->at,
                         "a hyperboloid needs either 'waist' (one sheet: its radius in the "
                         "middle) or 'gap' (two sheets: the distance of their tips): this one "
                         "has %s",
                         has_waist ? "both" : "none");
    } else if (node->radius > most * (1 - 1e-9)) {
        (void)scene_fail(
            scope->reader, place_of(scope, key),
            "'%s' of the hyperboloid is %.10g: it has to be less than %s, %.10g", key, node->radius,
            has_waist ? "'radius', that at its ends" : "its length from end to end", most);
    }
}

static const struct scene_key quadric_rows[] = {
    {NUMBERS_KEY("coefficients", solid_node, form, FORM_TERMS, RANGE_COORDINATE),
     .is_required = true}};

static void check_quadric(const struct scene_scope *scope, struct solid_node *node) {
    double largest = 0, linear = 0;
    for (int i = 0; i < FORM_TERMS - 1; i++) {
        double *part = i < QUADRATIC_TERMS ? &largest : &linear;
        *part = fmax(*part, fabs(node->form[i]));
    }
    if (largest <= 0) {
        (void)scene_fail(scope->reader, place_of(scope, "coefficients"),
                         linear <= 0 ? "all coefficients of the quadric but the last are 0: it "
                                       "has no surface; one of xx, yy, zz, xy, yz, zx has to "
                                       "differ from 0"
                                     : "the quadric has no quadratic term: use a half_space");
    }
}

/* A plane is read as a node with a normal in `a`, a point in `b` and an offset in `radius`. */
static const struct scene_key plane_rows[] = {
    {NUMBERS_KEY("normal", solid_node, a, 3, RANGE_COORDINATE), .is_required = true,
     .noun = "direction of any length, not 0", .meaning = "out of the solid"},
    {NUMBER_KEY("offset", solid_node, radius, RANGE_COORDINATE), .fallback = "that or `through`",
     .meaning = "the points with normal·p ≤ offset are inside"},
    {POINT_ROW("through", b), .fallback = "that or `offset`", .meaning = "a point of the plane"}};
const struct scene_keys scene_plane_keys = SCENE_KEYS("plane", plane_rows, NULL);

/* Makes a plane of what was read: its normal, of any length, and an offset or a point that the
 * plane holds. */
static void make_plane(const struct scene_scope *scope, const struct solid_node *read,
                       struct scene_plane *plane) {
    static const double origin[3] = {0};
    const bool has_point = has_key(scope, "through");
    const double length = distance_between(read->a, origin);
    if (has_point == has_key(scope, "offset")) {
        (void)scene_fail(scope->reader, scope->group->at,
                         "a %s needs either 'offset' (normal . p <= offset) or 'through' (a point "
                         "of its plane): this one has %s",
                         scope->what, has_point ? "both" : "none");
    } else if (length < RANGE_LENGTH.least) {
        (void)scene_fail(scope->reader, place_of(scope, "normal"),
                         "'normal' of the %s is zero: it needs a direction, such as [0, 0, 1]",
                         scope->what);
    }
    plane->offset = read->radius / length;
    for (int i = 0; i < 3; i++) {
        plane->normal[i] = read->a[i] / length;
        plane->offset += plane->normal[i] * read->b[i];
    }
}

/* Takes memory for the planes of a node. */
static bool make_planes(const struct scene_scope *scope, struct solid_node *node, size_t count) {
    node->planes = scene_allocate(scope->reader, count, sizeof *node->planes);
    node->plane_count = node->planes != NULL ? count : 0;
    return node->planes != NULL;
}

static void check_half_space(const struct scene_scope *scope, struct solid_node *node) {
    if (make_planes(scope, node, 1)) {
        make_plane(scope, node, node->planes);
        memset(node->a, 0, sizeof node->a);
        memset(node->b, 0, sizeof node->b);
        node->radius = 0;
    }
}

static const struct scene_key polyhedron_rows[] = {{.name = "planes",
                                                    .type = KEY_LIST,
                                                    .range = &plane_counts,
                                                    .is_required = true,
                                                    .noun = "list of planes"}};

static void check_polyhedron(const struct scene_scope *scope, struct solid_node *node) {
    const struct scene_value *list = scene_find_list(scope->group, "planes");
    if (list == NULL || !make_planes(scope, node, list->count)) {
        return;
    }
    for (size_t i = 0; i < list->count; i++) {
        const struct scene_scope plane = {scope->reader, &list->members[i], scene_plane_keys.what};
        struct solid_node read = {.kind = SOLID_HALF_SPACE};
        if (scene_read_keys(&plane, &scene_plane_keys, &read)) {
            make_plane(&plane, &read, &node->planes[i]);
        }
    }
}

const struct scene_leaf scene_leaves[] = {
    [SOLID_BOX] = {SCENE_KEYS("box", box_rows, NULL), check_box},
    [SOLID_BALL] = {SCENE_KEYS("ball", ball_rows, NULL), NULL},
    [SOLID_CYLINDER] = {SCENE_KEYS("cylinder", cylinder_rows, NULL), check_axis},
    [SOLID_CONE] = {SCENE_KEYS("cone", cone_rows, NULL), check_cone},
    [SOLID_ELLIPSOID] = {SCENE_KEYS("ellipsoid", ellipsoid_rows, NULL), NULL},
    [SOLID_PARABOLOID] = {SCENE_KEYS("paraboloid", paraboloid_rows, NULL), check_axis},
    [SOLID_HYPERBOLOID] = {SCENE_KEYS("hyperboloid", hyperboloid_rows, NULL), check_hyperboloid},
    [SOLID_QUADRIC] = {SCENE_KEYS("quadric", quadric_rows, NULL), check_quadric},
    [SOLID_HALF_SPACE] = {SCENE_KEYS("half_space", plane_rows, NULL), check_half_space},
    [SOLID_POLYHEDRON] = {SCENE_KEYS("polyhedron", polyhedron_rows, NULL), check_polyhedron},
};

const size_t scene_leaf_count = sizeof scene_leaves / sizeof *scene_leaves;
