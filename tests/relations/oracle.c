/* SPDX-License-Identifier: MIT */
/* An independent oracle: constructive solid geometry by point membership, in doubles. */
#include "oracle.h"

#include <math.h>
#include <string.h>

#include "place.h"

/* ---- Limits of leaves ----------------------------------------------------------------------- */

/* Puts a limit of own coordinates into the scene's: q = inverse p. */
static void add_limit(struct oracle *oracle, const struct place *inverse,
                      const struct oracle_limit *own) {
    if (oracle->limit_count == ORACLE_LIMITS_MOST) {
        oracle->is_full = true;
        return;
    }
    struct oracle_limit *limit = &oracle->limits[oracle->limit_count++];
    double slope[3]; /* of the own form at inverse->move, halved squares apart */
    limit->constant = own->constant;
    for (int i = 0; i < 3; i++) {
        slope[i] = own->linear[i];
        limit->constant += own->linear[i] * inverse->move[i];
        for (int j = 0; j < 3; j++) {
            slope[i] += 2 * own->square[i][j] * inverse->move[j];
            limit->constant += inverse->move[i] * own->square[i][j] * inverse->move[j];
        }
    }
    limit->bend = 0;
    for (int i = 0; i < 3; i++) {
        limit->linear[i] = 0;
        for (int k = 0; k < 3; k++) {
            limit->linear[i] += slope[k] * inverse->map[k][i];
        }
        for (int j = 0; j < 3; j++) {
            limit->square[i][j] = 0;
            for (int k = 0; k < 9; k++) {
                limit->square[i][j] +=
                    inverse->map[k / 3][i] * own->square[k / 3][k % 3] * inverse->map[k % 3][j];
            }
            limit->bend = fmax(limit->bend, fabs(limit->square[i][j]));
        }
    }
}

static void add_plane(struct oracle *oracle, const struct place *inverse, const double normal[3],
                      double offset) {
    struct oracle_limit plane;
    memset(&plane, 0, sizeof plane);
    memcpy(plane.linear, normal, sizeof plane.linear);
    plane.constant = -offset;
    add_limit(oracle, inverse, &plane);
}

/* Adds the ends of what has an axis, and its curve: with h the height above `from` as a share of
 * the whole, radius^2 <= bend[0] + bend[1] h + bend[2] h^2. */
static void add_round(struct oracle *oracle, const struct place *inverse,
                      const struct syntax_solid *solid, const double bend[3]) {
    struct oracle_limit curve;
    double axis[3], square = 0, start = 0;
    for (int i = 0; i < 3; i++) {
        axis[i] = solid->b[i] - solid->a[i];
        square += axis[i] * axis[i];
        start += solid->a[i] * axis[i];
    }
    /* h = (q . axis - start) / square; radius^2 = |q - a|^2 - h^2 square. */
    double h0 = -start / square, bent = square + bend[2];
    curve.constant = -bend[0] - bend[1] * h0 - bent * h0 * h0;
    for (int i = 0; i < 3; i++) {
        double hi = axis[i] / square;
        curve.constant += solid->a[i] * solid->a[i];
        curve.linear[i] = -2 * solid->a[i] - bend[1] * hi - 2 * bent * h0 * hi;
        for (int j = 0; j < 3; j++) {
            curve.square[i][j] = (i == j ? 1 : 0) - bent * hi * axis[j] / square;
        }
    }
    add_limit(oracle, inverse, &curve);
    add_plane(oracle, inverse, axis, start + square);
    double back[3] = {-axis[0], -axis[1], -axis[2]};
    add_plane(oracle, inverse, back, -start);
}

static void add_axial(struct oracle *oracle, const struct place *inverse,
                      const struct syntax_solid *solid) {
    double r = solid->radius, s = solid->radius_b, length = 0;
    double bend[3] = {r * r, 0, 0}; /* of a cylinder */
    for (int i = 0; i < 3; i++) {
        length += (solid->b[i] - solid->a[i]) * (solid->b[i] - solid->a[i]);
    }
    if (solid->kind == SYNTAX_CONE) {
        bend[1] = 2 * r * (s - r);
        bend[2] = (s - r) * (s - r);
    } else if (solid->kind == SYNTAX_PARABOLOID) {
        bend[0] = 0;
        bend[1] = r * r;
    } else if (solid->kind == SYNTAX_ONE_SHEET || solid->kind == SYNTAX_TWO_SHEETS) {
        /* s = 2 h - 1: radius^2 = low + grow s^2. */
        double q = s * s / length;
        bool is_one = solid->kind == SYNTAX_ONE_SHEET;
        double low = is_one ? s * s : -r * r * q / (1 - q);
        double grow = is_one ? r * r - s * s : r * r / (1 - q);
        bend[0] = low + grow;
        bend[1] = -4 * grow;
        bend[2] = 4 * grow;
    }
    add_round(oracle, inverse, solid, bend);
}

static void add_form(struct oracle *oracle, const struct place *inverse, const double form[10]) {
    struct oracle_limit limit;
    for (int i = 0; i < 3; i++) {
        limit.square[i][i] = form[i];
        limit.square[i][(i + 1) % 3] = limit.square[(i + 1) % 3][i] = form[3 + i] / 2;
        limit.linear[i] = form[6 + i];
    }
    limit.constant = form[9];
    add_limit(oracle, inverse, &limit);
}

static void add_leaf(struct oracle *oracle, const struct place *place,
                     const struct syntax_solid *solid) {
    struct place inverse;
    double form[10] = {1, 1, 1, 0, 0, 0, 0, 0, 0, -1};
    place_invert(place, &inverse);
    switch (solid->kind) {
    case SYNTAX_BOX:
        for (int i = 0; i < 6; i++) {
            double normal[3] = {0, 0, 0};
            normal[i % 3] = i < 3 ? -1 : 1;
            add_plane(oracle, &inverse, normal, i < 3 ? -solid->a[i] : solid->b[i - 3]);
        }
        break;
    case SYNTAX_BALL:
    case SYNTAX_ELLIPSOID:
        for (int i = 0; i < 3; i++) {
            double radius = solid->kind == SYNTAX_BALL ? solid->radius : solid->b[i];
            form[i] = 1 / (radius * radius);
            form[6 + i] = -2 * solid->a[i] * form[i];
            form[9] += solid->a[i] * solid->a[i] * form[i];
        }
        add_form(oracle, &inverse, form);
        break;
    case SYNTAX_QUADRIC:
        add_form(oracle, &inverse, solid->form);
        break;
    case SYNTAX_HALF_SPACE:
    case SYNTAX_POLYHEDRON:
        for (int i = 0; i < solid->plane_count; i++) {
            add_plane(oracle, &inverse, solid->planes[i].normal, solid->planes[i].offset);
        }
        break;
    default: /* what has an axis */
        add_axial(oracle, &inverse, solid);
        break;
    }
}

/* ---- Trees ---------------------------------------------------------------------------------- */

static int add_tree(struct oracle *oracle, const struct syntax *syntax, int index,
                    const struct place *outer, int material) {
    const struct syntax_solid *solid = &syntax->solids[index];
    if (oracle->node_count == ORACLE_NODES_MOST) {
        oracle->is_full = true;
        return 0;
    }
    int number = oracle->node_count++;
    struct oracle_node *node = &oracle->nodes[number];
    struct place place = place_inner(outer, solid);
    node->kind = solid->kind;
    node->material = solid->material >= 0 ? solid->material : material;
    node->first = oracle->limit_count;
    node->child_count = 0;
    if (syntax_is_leaf(solid->kind)) {
        add_leaf(oracle, &place, solid);
    } else if (solid->kind == SYNTAX_PART) {
        node->children[node->child_count++] =
            add_tree(oracle, syntax, syntax->parts[solid->part], &place, node->material);
    }
    for (int i = 0; i < solid->child_count; i++) {
        node->children[node->child_count++] =
            add_tree(oracle, syntax, solid->children[i], &place, node->material);
    }
    node->count = oracle->limit_count - node->first;
    return number;
}

bool oracle_start(struct oracle *oracle, const struct syntax *syntax, const double centre[3],
                  int exponent) {
    struct place scaling;
    oracle->node_count = oracle->limit_count = 0;
    oracle->is_full = false;
    memset(&scaling, 0, sizeof scaling);
    for (int i = 0; i < 3; i++) {
        scaling.map[i][i] = ldexp(1, exponent);
        scaling.move[i] = -ldexp(centre[i], exponent);
    }
    oracle->object_count = syntax->object_count;
    for (int i = 0; i < syntax->object_count; i++) {
        oracle->objects[i] = add_tree(oracle, syntax, syntax->objects[i].solid, &scaling,
                                      syntax->objects[i].material);
    }
    return !oracle->is_full;
}

/* ---- Membership ----------------------------------------------------------------------------- */

enum belongs { OUT, NEAR, IN };

/* How a limit looks from a point: its value and its slope there. */
struct view {
    double value, slope[3], length;
};

static struct view view_limit(const struct oracle_limit *limit, const double p[3]) {
    struct view view = {limit->constant, {0, 0, 0}, 0};
    for (int i = 0; i < 3; i++) {
        double along = 0;
        for (int j = 0; j < 3 && limit->bend > 0; j++) {
            along += limit->square[i][j] * p[j];
        }
        view.value += (along + limit->linear[i]) * p[i];
        view.slope[i] = 2 * along + limit->linear[i];
        view.length += view.slope[i] * view.slope[i];
    }
    view.length = sqrt(view.length);
    return view;
}

/* Asks a leaf: how far a limit's surface is follows from its value and its slope. */
static enum belongs leaf_holds(const struct oracle *oracle, const struct oracle_node *node,
                               const double p[3]) {
    enum belongs belongs = IN;
    for (int k = node->first; k < node->first + node->count; k++) {
        const struct oracle_limit *limit = &oracle->limits[k];
        const struct view view = view_limit(limit, p);
        double near = oracle->tolerance * (view.length + limit->bend * oracle->tolerance);
        if (view.value > near) {
            return OUT;
        }
        belongs = view.value > -near ? NEAR : belongs;
    }
    return belongs;
}

/* Compares the bends of two limits that touch in a point, either side of each being the inner one.
 */
static bool bend_alike(const struct oracle_limit *a, double a_slope, const struct oracle_limit *b,
                       double b_slope, double least) {
    for (int i = 0; i < 9; i++) {
        double off = a->square[i / 3][i % 3] / a_slope - b->square[i / 3][i % 3] / b_slope;
        if (fabs(off) > least) {
            return false;
        }
    }
    return true;
}

bool oracle_is_smooth(const struct oracle *oracle, const double point[3], const double normal[3]) {
    const double reach = 4 * oracle->tolerance, touch = oracle->tolerance / 50;
    const struct oracle_limit *first = NULL;
    double first_slope = 1;
    for (int k = 0; k < oracle->limit_count; k++) {
        const struct oracle_limit *limit = &oracle->limits[k];
        const struct view view = view_limit(limit, point);
        double distance = fabs(view.value), along = 0;
        if (distance > reach * (view.length + limit->bend * reach)) {
            continue;
        }
        for (int i = 0; i < 3; i++) {
            along += view.slope[i] * normal[i];
        }
        if (distance > touch * view.length || fabs(along) < 0.9999 * view.length ||
            limit->bend * reach > 0.05 * view.length ||
            (first != NULL && !bend_alike(first, first_slope, limit, along, 1e-6))) {
            return false;
        }
        first = limit;
        first_slope = along;
    }
    return true;
}

static enum belongs holds(const struct oracle *oracle, int index, const double p[3], int *material);

/* Asks solids from the last to the first: a later one fills the place. Seams between solids of one
 * material are none. */
static enum belongs union_holds(const struct oracle *oracle, const int *solids, int count,
                                const double p[3], int *material) {
    bool is_near = false;
    int near_material = ORACLE_AIR;
    for (int i = count - 1; i >= 0; i--) {
        int own = ORACLE_AIR;
        enum belongs belongs = holds(oracle, solids[i], p, &own);
        if (belongs == IN) {
            *material = own;
            return is_near && near_material != own ? NEAR : IN;
        }
        if (belongs == NEAR) {
            if (is_near && near_material != own) {
                *material = ORACLE_UNKNOWN; /* it is none that a solid below could have too */
                return NEAR;
            }
            is_near = true;
            near_material = own;
        }
    }
    *material = near_material;
    return is_near ? NEAR : OUT;
}

static enum belongs holds(const struct oracle *oracle, int index, const double p[3],
                          int *material) {
    const struct oracle_node *node = &oracle->nodes[index];
    *material = node->material;
    if (syntax_is_leaf(node->kind)) {
        return leaf_holds(oracle, node, p);
    }
    if (node->kind == SYNTAX_UNION || node->kind == SYNTAX_PART) {
        return union_holds(oracle, node->children, node->child_count, p, material);
    }
    enum belongs belongs = holds(oracle, node->children[0], p, material);
    for (int i = 1; i < node->child_count && belongs != OUT; i++) {
        int ignored;
        enum belongs other = holds(oracle, node->children[i], p, &ignored);
        if (node->kind == SYNTAX_DIFFERENCE) {
            other = other == IN ? OUT : other == OUT ? IN : NEAR;
        }
        belongs = other < belongs ? other : belongs;
    }
    return belongs;
}

int oracle_material(const struct oracle *oracle, const double point[3]) {
    int material = ORACLE_AIR;
    enum belongs belongs =
        union_holds(oracle, oracle->objects, oracle->object_count, point, &material);
    return belongs == IN ? material : belongs == OUT ? ORACLE_AIR : ORACLE_UNKNOWN;
}
