/* SPDX-License-Identifier: MIT */
/* Axis-aligned bounds of solids. */
#include "bounds.h"

#include <math.h>

#include "affine.h"

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

/* The bounds of the eight corners' images. */
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

/* Exact for the ellipsoid that an affine map makes of a ball: the norm of each row. */
static struct bounds ball_bounds(const struct affine *map, const struct solid_node *node) {
    struct bounds bounds;
    double centre[3];
    affine_point(map, node->a, centre);
    for (int i = 0; i < 3; i++) {
        double reach = node->radius * vector_length(map->m[i]);
        bounds.low[i] = centre[i] - reach;
        bounds.high[i] = centre[i] + reach;
    }
    return bounds;
}

/* Bounded on one side of one axis, where the plane lies across it. */
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
        return ball_bounds(&placement, node);
    case SOLID_HALF_SPACE:
        return half_space_bounds(&placement, node);
    case SOLID_UNION:
    case SOLID_INTERSECTION:
    case SOLID_DIFFERENCE:
    case SOLID_PART:
        break;
    default:
        return bounds_everything;
    }
    struct bounds bounds = solid_bounds(description, node->children[0], &placement);
    for (size_t i = 1; i < node->child_count && node->kind != SOLID_DIFFERENCE; i++) {
        struct bounds child = solid_bounds(description, node->children[i], &placement);
        bounds = node->kind == SOLID_UNION ? bounds_union(&bounds, &child)
                                           : bounds_intersection(&bounds, &child);
    }
    return bounds;
}
