/* SPDX-License-Identifier: MIT */
/* Axis-aligned bounds of solids. */
#include "compiler/bounds.h"

#include <math.h>

#include "compiler/affine.h"
#include "compiler/quadric_form.h"

const struct bounds bounds_nothing = {{HUGE_VAL, HUGE_VAL, HUGE_VAL},
                                      {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}};
const struct bounds bounds_everything = {{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL},
                                         {HUGE_VAL, HUGE_VAL, HUGE_VAL}};

void bounds_include(struct bounds *bounds, const double point[3]) {
    for (int i = 0; i < 3; i++) {
        bounds->low[i] = fmin(bounds->low[i], point[i]);
        bounds->high[i] = fmax(bounds->high[i], point[i]);
    }
}

struct bounds bounds_union(const struct bounds *a, const struct bounds *b) {
    struct bounds both;
    for (int i = 0; i < 3; i++) {
        both.low[i] = fmin(a->low[i], b->low[i]);
        both.high[i] = fmax(a->high[i], b->high[i]);
    }
    return both;
}

struct bounds bounds_intersection(const struct bounds *a, const struct bounds *b) {
    struct bounds both;
    for (int i = 0; i < 3; i++) {
        both.low[i] = fmax(a->low[i], b->low[i]);
        both.high[i] = fmin(a->high[i], b->high[i]);
    }
    return both;
}

bool bounds_are_finite(const struct bounds *bounds) {
    for (int i = 0; i < 3; i++) {
        if (!isfinite(bounds->low[i]) || !isfinite(bounds->high[i])) {
            return false;
        }
    }
    return true;
}

bool bounds_are_empty(const struct bounds *bounds) {
    return bounds->low[0] > bounds->high[0] || bounds->low[1] > bounds->high[1] ||
           bounds->low[2] > bounds->high[2];
}

bool bounds_overlap(const struct bounds *a, const struct bounds *b) {
    struct bounds common = bounds_intersection(a, b);
    return !bounds_are_empty(&common);
}

bool bounds_are_apart(const struct bounds *a, const struct bounds *b, double gap) {
    for (int i = 0; i < 3; i++) {
        if (a->high[i] < b->low[i] - gap || b->high[i] < a->low[i] - gap) {
            return true;
        }
    }
    return false;
}

/* Returns the bounds of the images of a box's eight corners. */
static struct bounds corners(const struct affine *map, const double low[3], const double high[3]) {
    struct bounds bounds = bounds_nothing;
    for (int corner = 0; corner < 8; corner++) {
        double point[3], image[3];
        for (int i = 0; i < 3; i++) {
            point[i] = corner >> i & 1 ? high[i] : low[i];
        }
        affine_point(map, point, image);
        bounds_include(&bounds, image);
    }
    return bounds;
}

/* Returns the exact bounds of an ellipsoid's image under an affine map: the norm of each row is the
 * reach. */
static struct bounds ellipsoid_bounds(const struct affine *map, const double at[3],
                                      const double radii[3]) {
    struct bounds bounds;
    double centre[3];
    affine_point(map, at, centre);
    for (int i = 0; i < 3; i++) {
        const double row[3] = {map->m[i][0] * radii[0], map->m[i][1] * radii[1],
                               map->m[i][2] * radii[2]};
        double reach = vector_length(row);
        bounds.low[i] = centre[i] - reach;
        bounds.high[i] = centre[i] + reach;
    }
    return bounds;
}

/* Bounds a solid around an axis by discs at the axis's ends. None of these solids is wider between
 * the ends. */
static struct bounds round_bounds(const struct affine *map, const struct solid_node *node) {
    struct bounds own = bounds_nothing;
    double u[3], v[3], w[3];
    double radius = fmax(node->radius_b, node->kind == SOLID_HYPERBOLOID ? 0 : node->radius);
    leaf_axes(node, u, v, w);
    for (int end = 0; end < 2; end++) {
        for (int side = -1; side <= 1; side += 2) {
            double point[3];
            for (int i = 0; i < 3; i++) {
                double reach = radius * sqrt(fmax(0, 1 - w[i] * w[i]));
                point[i] = (end ? node->b[i] : node->a[i]) + side * reach;
            }
            bounds_include(&own, point);
        }
    }
    return corners(map, own.low, own.high);
}

/* Returns the bounds of a general quadric; everything unless it is an ellipsoid, as no other one
 * has an end. */
static struct bounds quadric_bounds(const struct affine *map, const struct solid_node *node) {
    struct quadric_axes axes;
    struct bounds bounds;
    if (!quadric_axes_of_leaf(node, map, &axes) || axes.square[0] <= 0 || axes.square[1] <= 0 ||
        axes.square[2] <= 0 || axes.constant >= 0) {
        return bounds_everything;
    }
    for (int i = 0; i < 3; i++) {
        double reach = 0;
        for (int j = 0; j < 3; j++) {
            reach -= axes.axis[j][i] * axes.axis[j][i] * axes.constant / axes.square[j];
        }
        bounds.low[i] = axes.origin[i] - sqrt(reach);
        bounds.high[i] = axes.origin[i] + sqrt(reach);
    }
    return bounds;
}

/* Tells whether no plane of a polyhedron ends it along a direction. */
static bool goes_on(const struct solid_node *node, const double direction[3]) {
    for (size_t i = 0; i < node->plane_count; i++) {
        if (vector_dot(node->planes[i].normal, direction) > 1e-12) {
            return false;
        }
    }
    return true;
}

bool polyhedron_is_bounded(const struct solid_node *node) {
    bool spans = false;
    for (size_t i = 0; i < node->plane_count; i++) {
        for (size_t j = 0; j < i; j++) {
            double along[3], back[3];
            vector_cross(node->planes[i].normal, node->planes[j].normal, along);
            if (vector_length(along) < 1e-12) {
                continue;
            }
            spans = true;
            for (int k = 0; k < 3; k++) {
                back[k] = -along[k];
            }
            if (goes_on(node, along) || goes_on(node, back)) {
                return false;
            }
        }
    }
    return spans;
}

/* Finds the point that three planes have in common; false if they have none, or more than one. */
static bool meeting_point(const struct scene_plane *a, const struct scene_plane *b,
                          const struct scene_plane *c, double point[3]) {
    double bc[3], ca[3], ab[3];
    vector_cross(b->normal, c->normal, bc);
    vector_cross(c->normal, a->normal, ca);
    vector_cross(a->normal, b->normal, ab);
    double determinant = vector_dot(a->normal, bc);
    if (fabs(determinant) < 1e-12) {
        return false;
    }
    for (int i = 0; i < 3; i++) {
        point[i] = (a->offset * bc[i] + b->offset * ca[i] + c->offset * ab[i]) / determinant;
    }
    return true;
}

static bool is_within(const struct solid_node *node, const double point[3]) {
    for (size_t i = 0; i < node->plane_count; i++) {
        const struct scene_plane *plane = &node->planes[i];
        double slack = 1e-9 * (1 + fabs(plane->offset));
        if (vector_dot(plane->normal, point) > plane->offset + slack) {
            return false;
        }
    }
    return true;
}

struct bounds polyhedron_bounds(const struct affine *map, const struct solid_node *node) {
    struct bounds bounds = bounds_nothing;
    const struct scene_plane *planes = node->planes;
    for (size_t i = 0; i < node->plane_count; i++) {
        for (size_t j = 0; j < i; j++) {
            for (size_t k = 0; k < j; k++) {
                double vertex[3], image[3];
                if (meeting_point(&planes[i], &planes[j], &planes[k], vertex) &&
                    is_within(node, vertex)) {
                    affine_point(map, vertex, image);
                    bounds_include(&bounds, image);
                }
            }
        }
    }
    return polyhedron_is_bounded(node) ? bounds : bounds_everything;
}

/* Returns the bounds of a half-space: on one side of one axis where its plane lies across that
 * axis, else everything. */
static struct bounds half_space_bounds(const struct affine *map, const struct solid_node *node) {
    struct bounds bounds = bounds_everything;
    for (int i = 0; i < 3; i++) {
        bool across = map->m[i][(i + 1) % 3] == 0 && map->m[i][(i + 2) % 3] == 0 &&
                      map->m[(i + 1) % 3][i] == 0 && map->m[(i + 2) % 3][i] == 0;
        double normal = node->planes[0].normal[i];
        if (across && fabs(normal) == 1) {
            double end = map->m[i][i] * node->planes[0].offset * normal + map->m[i][3];
            if (normal * map->m[i][i] > 0) {
                bounds.high[i] = end;
            } else {
                bounds.low[i] = end;
            }
        }
    }
    return bounds;
}

struct bounds solid_bounds(const struct scene_description *description, int index,
                           const struct affine *outer) {
    const struct solid_node *node = &description->nodes[index];
    struct affine placement = affine_compose(outer, &node->placement);
    switch (node->kind) {
    case SOLID_BOX:
        return corners(&placement, node->a, node->b);
    case SOLID_BALL:
        return ellipsoid_bounds(&placement, node->a,
                                (double[3]){node->radius, node->radius, node->radius});
    case SOLID_ELLIPSOID:
        return ellipsoid_bounds(&placement, node->a, node->b);
    case SOLID_QUADRIC:
        return quadric_bounds(&placement, node);
    case SOLID_POLYHEDRON:
        return polyhedron_bounds(&placement, node);
    case SOLID_HALF_SPACE:
        return half_space_bounds(&placement, node);
    case SOLID_CYLINDER:
    case SOLID_CONE:
    case SOLID_PARABOLOID:
    case SOLID_HYPERBOLOID:
        return round_bounds(&placement, node);
    case SOLID_UNION:
    case SOLID_INTERSECTION:
    case SOLID_DIFFERENCE:
    case SOLID_PART:
        break;
    }
    struct bounds bounds = solid_bounds(description, node->children[0], &placement);
    for (size_t i = 1; i < node->child_count && node->kind != SOLID_DIFFERENCE; i++) {
        struct bounds child = solid_bounds(description, node->children[i], &placement);
        bounds = node->kind == SOLID_UNION ? bounds_union(&bounds, &child)
                                           : bounds_intersection(&bounds, &child);
    }
    return bounds;
}
