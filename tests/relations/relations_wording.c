/* SPDX-License-Identifier: MIT */
/* Relations: leaves and placements in other words. */
#include <math.h>
#include <string.h>

#include "chance.h"
#include "relation.h"
#include "wording.h"

bool rewrite_ends(struct syntax *scene, uint64_t *random) {
    int list[SYNTAX_SOLIDS_MOST], count = syntax_list(scene, list);
    bool has_changed = false;
    for (int i = 0; i < count; i++) {
        if (chance_is(random, 70)) {
            has_changed = wording_ends(&scene->solids[list[i]]) || has_changed;
        }
    }
    return has_changed;
}

bool rewrite_leaves(struct syntax *scene, uint64_t *random) {
    int list[SYNTAX_SOLIDS_MOST], count = syntax_list(scene, list);
    bool has_changed = false;
    for (int i = 0; i < count; i++) {
        if (chance_is(random, 60)) {
            has_changed = wording_leaf(&scene->solids[list[i]], random) || has_changed;
        }
    }
    return has_changed && !syntax_has_endless(scene);
}

/* Says a placement by one wrapper for each of its steps, or mirrors twice what is turned half. */
static void reword_placement(struct syntax *scene, int solid, uint64_t *random) {
    int below = syntax_push_down(scene, solid, SYNTAX_UNION);
    struct syntax_solid *inner = &scene->solids[below], *outer = &scene->solids[solid];
    memcpy(outer->translate, inner->translate, sizeof outer->translate);
    memset(inner->translate, 0, sizeof inner->translate);
    outer->rotate[2] = inner->rotate[2];
    inner->rotate[2] = 0;
    if (chance_is(random, 40)) { /* a half turn about z and its mirrors */
        outer->rotate[2] += outer->rotate[2] > 0 ? -180 : 180;
        outer->scale[0] = outer->scale[1] = -1;
    }
    syntax_adopt(scene, solid, below);
}

bool rewrite_placements(struct syntax *scene, uint64_t *random) {
    int list[SYNTAX_SOLIDS_MOST], count = syntax_list(scene, list);
    bool has_changed = false;
    for (int i = 0; i < count && !scene->is_full; i++) {
        const struct syntax_solid *solid = &scene->solids[list[i]];
        bool is_placed = fabs(solid->translate[0]) + fabs(solid->translate[2]) > 0;
        if (is_placed && chance_is(random, 60) && solid->kind != SYNTAX_HALF_SPACE) {
            reword_placement(scene, list[i], random);
            has_changed = true;
        }
    }
    return has_changed;
}

/* Says a round solid's curve by its coefficients: with h the height above `from` as a share of the
 * whole, radius^2 = bend[0] + bend[1] h + bend[2] h^2. */
static void find_bend(const struct syntax_solid *solid, double square, double bend[3]) {
    double r = solid->radius, s = solid->radius_b;
    bend[0] = r * r;
    bend[1] = bend[2] = 0;
    if (solid->kind == SYNTAX_CONE) {
        bend[1] = 2 * r * (s - r);
        bend[2] = (s - r) * (s - r);
    } else if (solid->kind == SYNTAX_PARABOLOID) {
        bend[0] = 0;
        bend[1] = r * r;
    } else if (solid->kind == SYNTAX_ONE_SHEET) {
        bend[1] = -4 * (r * r - s * s);
        bend[2] = -bend[1];
    } else if (solid->kind == SYNTAX_TWO_SHEETS) {
        double grow = r * r / (1 - s * s / square);
        bend[1] = -4 * grow;
        bend[2] = 4 * grow;
    }
}

/* Fills in the form about the solid's `from`, to which the placement moves the quadric. */
static void fill_form(const struct syntax_solid *solid, const double axis[3], double square,
                      double form[10]) {
    double bend[3];
    find_bend(solid, square, bend);
    double bent = (square + bend[2]) / (square * square);
    for (int i = 0; i < 3; i++) {
        int j = (i + 1) % 3;
        form[i] = 1 - bent * axis[i] * axis[i];
        form[3 + i] = -2 * bent * axis[i] * axis[j];
        form[6 + i] = -bend[1] / square * axis[i];
    }
    form[9] = -bend[0];
}

/* Writes a round solid as a quadric between two planes, in a box that gives it an end. */
static void say_form(struct syntax *scene, int solid) {
    int below = syntax_push_down(scene, solid, SYNTAX_INTERSECTION);
    const struct syntax_solid old = scene->solids[below];
    double axis[3], reach = 0.5 + old.radius + old.radius_b, square = 0;
    for (int i = 0; i < 3; i++) {
        axis[i] = old.b[i] - old.a[i];
        square += axis[i] * axis[i];
        reach += fabs(axis[i]);
    }
    int quadric = syntax_add(scene, SYNTAX_QUADRIC);
    int top = syntax_add(scene, SYNTAX_HALF_SPACE), bottom = syntax_add(scene, SYNTAX_HALF_SPACE);
    int box = syntax_add(scene, SYNTAX_BOX);
    fill_form(&old, axis, square, scene->solids[quadric].form);
    syntax_plane(scene, top, axis[0], axis[1], axis[2], square);
    syntax_plane(scene, bottom, -axis[0], -axis[1], -axis[2], 0);
    for (int i = 0; i < 3; i++) {
        scene->solids[box].a[i] = -reach;
        scene->solids[box].b[i] = reach;
    }
    scene->solids[below] = scene->solids[solid]; /* an intersection without a placement */
    scene->solids[below].child_count = 0;
    memcpy(scene->solids[below].translate, old.a, sizeof old.a);
    syntax_adopt(scene, below, quadric);
    syntax_adopt(scene, below, top);
    syntax_adopt(scene, below, bottom);
    syntax_adopt(scene, below, box);
    struct syntax_solid *outer = &scene->solids[solid];
    outer->kind = SYNTAX_UNION;
    outer->material = old.material;
    memcpy(outer->scale, old.scale, sizeof old.scale);
    memcpy(outer->rotate, old.rotate, sizeof old.rotate);
    memcpy(outer->translate, old.translate, sizeof old.translate);
    syntax_adopt(scene, solid, below);
}

/* Rewrites all that have an axis. Coefficients are rounded: the same solid in two wordings would
 * get two surfaces, farther from each other than what the compiler takes for one. Of a crowd, more
 * slabs without an end would overlap at one place than lists have room for. */
bool rewrite_forms(struct syntax *scene, uint64_t *random) {
    int list[SYNTAX_SOLIDS_MOST], count = syntax_list(scene, list);
    bool has_changed = false;
    (void)random;
    for (int i = 0; i < count && scene->solid_count + 5 < SYNTAX_SOLIDS_MOST; i++) {
        enum syntax_kind kind = scene->solids[list[i]].kind;
        if (kind == SYNTAX_CYLINDER || kind == SYNTAX_CONE || kind == SYNTAX_PARABOLOID ||
            kind == SYNTAX_ONE_SHEET || kind == SYNTAX_TWO_SHEETS) {
            say_form(scene, list[i]);
            has_changed = true;
        }
    }
    return has_changed && (scene->motifs & (1u << MOTIF_REWORDED | 1u << MOTIF_CROWD)) == 0;
}
