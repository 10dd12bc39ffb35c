/* SPDX-License-Identifier: MIT */
/* How far solids of the abstract syntax reach along the axes. */
#include "extent.h"

#include <math.h>
#include <string.h>

#include "place.h"

static const struct extent everything = {{-HUGE_VAL, -HUGE_VAL, -HUGE_VAL},
                                         {HUGE_VAL, HUGE_VAL, HUGE_VAL}};

/* Reckons a leaf's extent in its own coordinates. */
static struct extent leaf_extent(const struct syntax_solid *solid) {
    struct extent extent = everything;
    for (int i = 0; i < 3; i++) {
        double radius = fmax(solid->radius, solid->radius_b);
        switch (solid->kind) {
        case SYNTAX_BOX:
            extent.low[i] = solid->a[i];
            extent.high[i] = solid->b[i];
            break;
        case SYNTAX_ELLIPSOID:
            extent.low[i] = solid->a[i] - solid->b[i];
            extent.high[i] = solid->a[i] + solid->b[i];
            break;
        case SYNTAX_BALL:
            extent.low[i] = solid->a[i] - radius;
            extent.high[i] = solid->a[i] + radius;
            break;
        case SYNTAX_POLYHEDRON: /* the generator's own ones reach less far */
            extent.low[i] = -8;
            extent.high[i] = 8;
            break;
        case SYNTAX_HALF_SPACE:
        case SYNTAX_QUADRIC:
            break;
        default: /* what has an axis */
            extent.low[i] = fmin(solid->a[i], solid->b[i]) - radius;
            extent.high[i] = fmax(solid->a[i], solid->b[i]) + radius;
            break;
        }
    }
    return extent;
}

static struct extent placed(const struct place *place, const struct extent *own) {
    struct extent extent = {{HUGE_VAL, HUGE_VAL, HUGE_VAL}, {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL}};
    for (int i = 0; i < 3; i++) {
        if (isinf(own->low[i]) || isinf(own->high[i])) {
            return everything;
        }
    }
    for (int corner = 0; corner < 8; corner++) {
        double p[3], q[3];
        for (int i = 0; i < 3; i++) {
            p[i] = (corner >> i & 1) != 0 ? own->high[i] : own->low[i];
        }
        place_point(place, p, q);
        for (int i = 0; i < 3; i++) {
            extent.low[i] = fmin(extent.low[i], q[i]);
            extent.high[i] = fmax(extent.high[i], q[i]);
        }
    }
    return extent;
}

static void join(struct extent *extent, const struct extent *other, bool is_union) {
    for (int i = 0; i < 3; i++) {
        double low = other->low[i], high = other->high[i];
        extent->low[i] = is_union ? fmin(extent->low[i], low) : fmax(extent->low[i], low);
        extent->high[i] = is_union ? fmax(extent->high[i], high) : fmin(extent->high[i], high);
    }
}

static struct extent tree_extent(const struct syntax *syntax, int index,
                                 const struct place *outer) {
    const struct syntax_solid *solid = &syntax->solids[index];
    struct place place = place_inner(outer, solid);
    if (syntax_is_leaf(solid->kind)) {
        struct extent own = leaf_extent(solid);
        return placed(&place, &own);
    }
    if (solid->kind == SYNTAX_PART) {
        return tree_extent(syntax, syntax->parts[solid->part], &place);
    }
    struct extent extent = tree_extent(syntax, solid->children[0], &place);
    for (int i = 1; i < solid->child_count && solid->kind != SYNTAX_DIFFERENCE; i++) {
        struct extent child = tree_extent(syntax, solid->children[i], &place);
        join(&extent, &child, solid->kind == SYNTAX_UNION);
    }
    return extent;
}

struct extent extent_of(const struct syntax *syntax, int solid) {
    static const struct place nowhere = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 0, 0}};
    return tree_extent(syntax, solid, &nowhere);
}

bool extent_are_apart(const struct extent *a, const struct extent *b, double gap) {
    for (int i = 0; i < 3; i++) {
        if (a->low[i] > b->high[i] + gap || b->low[i] > a->high[i] + gap) {
            return true;
        }
    }
    return false;
}

bool extent_is_within(const struct extent *extent, double most) {
    for (int i = 0; i < 3; i++) {
        if (extent->low[i] < -most || extent->high[i] > most) {
            return false;
        }
    }
    return true;
}
