/* SPDX-License-Identifier: MIT */
/* Relations: laws of the operations of constructive solid geometry. */
#include "chance.h"
#include "extent.h"
#include "generate.h"
#include "relation.h"

/* Returns the first of an operation's children that may change their places. */
static int first_movable(const struct syntax *scene, int solid) {
    const struct syntax_solid *node = &scene->solids[solid];
    if (node->kind == SYNTAX_UNION) {
        return syntax_names_material(scene, solid) ? node->child_count : 0;
    }
    if (node->kind == SYNTAX_INTERSECTION) { /* the first has the material */
        return syntax_names_material(scene, solid) ? 1 : 0;
    }
    return node->kind == SYNTAX_DIFFERENCE ? 1 : node->child_count;
}

/* Turns the order of the movable children of every operation around. */
bool rewrite_child_order(struct syntax *scene, uint64_t *random) {
    (void)random;
    int list[SYNTAX_SOLIDS_MOST], count = syntax_list(scene, list);
    bool has_changed = false;
    for (int i = 0; i < count; i++) {
        struct syntax_solid *node = &scene->solids[list[i]];
        int low = first_movable(scene, list[i]), high = node->child_count - 1;
        for (; low < high; low++, high--) {
            int child = node->children[low];
            node->children[low] = node->children[high];
            node->children[high] = child;
            has_changed = true;
        }
    }
    return has_changed;
}

/* Makes A - (B | C ...) of A - B - C ..., and (A - B) & (A - C) of A - (B | C). */
static bool rewrite_difference(struct syntax *scene, int solid) {
    int below = syntax_push_down(scene, solid, SYNTAX_UNION);
    struct syntax_solid *node = &scene->solids[below];
    int cutter = node->children[1];
    enum syntax_kind kind = scene->solids[cutter].kind;
    bool is_plain = kind == SYNTAX_UNION || kind == SYNTAX_INTERSECTION;
    syntax_adopt(scene, solid, below);
    if (node->child_count > 2) {
        int all = syntax_add(scene, SYNTAX_UNION);
        for (int i = 1; i < node->child_count; i++) {
            syntax_adopt(scene, all, node->children[i]);
        }
        node->child_count = 1;
        syntax_adopt(scene, below, all);
        return true;
    }
    if (!is_plain || scene->solids[cutter].child_count < 2) {
        /* A - B = A - (A & B) */
        node->children[1] = syntax_combine(scene, SYNTAX_INTERSECTION,
                                           syntax_copy(scene, node->children[0]), cutter);
        return true;
    }
    /* The cutter's placement goes on to its children by a wrapper for each. */
    const struct syntax_solid old = scene->solids[cutter];
    node->kind = kind == SYNTAX_UNION ? SYNTAX_INTERSECTION : SYNTAX_UNION;
    const int body = node->children[0];
    node->child_count = 0;
    for (int i = 0; i < old.child_count; i++) {
        int wrapper = syntax_add(scene, SYNTAX_UNION);
        struct syntax_solid *placed = &scene->solids[wrapper];
        for (int j = 0; j < 3; j++) {
            placed->scale[j] = old.scale[j];
            placed->rotate[j] = old.rotate[j];
            placed->translate[j] = old.translate[j];
        }
        syntax_adopt(scene, wrapper, old.children[i]);
        syntax_adopt(scene, below,
                     syntax_combine(scene, SYNTAX_DIFFERENCE,
                                    i == 0 ? body : syntax_copy(scene, body), wrapper));
    }
    return true;
}

/* Makes A - (A - B) of A & B, A being one that has an end. */
static bool rewrite_intersection(struct syntax *scene, int solid) {
    struct syntax_solid *node = &scene->solids[solid];
    if (node->child_count != 2 || syntax_names_material(scene, node->children[0]) ||
        syntax_names_material(scene, node->children[1])) {
        return false;
    }
    struct extent first = extent_of(scene, node->children[0]);
    if (!extent_is_within(&first, 1e6)) {
        int kept = node->children[0];
        node->children[0] = node->children[1];
        node->children[1] = kept;
    }
    node->children[1] = syntax_combine(scene, SYNTAX_DIFFERENCE,
                                       syntax_copy(scene, node->children[0]), node->children[1]);
    node->kind = SYNTAX_DIFFERENCE;
    return true;
}

/* Makes W - ((W - A) & (W - B) ...) of A | B ..., W being a box around all. */
static bool rewrite_union(struct syntax *scene, int solid) {
    struct syntax_solid *node = &scene->solids[solid];
    double size = 24;
    if (node->child_count < 2 || syntax_names_material(scene, solid)) {
        return false;
    }
    for (int i = 0; i < node->child_count; i++) {
        struct extent extent = extent_of(scene, node->children[i]);
        if (!extent_is_within(&extent, size - 1)) {
            return false;
        }
    }
    int outsides = syntax_add(scene, SYNTAX_INTERSECTION);
    for (int i = 0; i < node->child_count; i++) {
        int world = generate_box(scene, -size, -size, -size, size, size, size);
        syntax_adopt(scene, outsides,
                     syntax_combine(scene, SYNTAX_DIFFERENCE, world, node->children[i]));
    }
    node->kind = SYNTAX_DIFFERENCE;
    node->child_count = 0;
    syntax_adopt(scene, solid, generate_box(scene, -size, -size, -size, size, size, size));
    syntax_adopt(scene, solid, outsides);
    return true;
}

bool rewrite_de_morgan(struct syntax *scene, uint64_t *random) {
    int list[SYNTAX_SOLIDS_MOST], count = syntax_list(scene, list);
    int first = chance_pick(random, count);
    for (int i = 0; i < count; i++) {
        int solid = list[(first + i) % count];
        const struct syntax_solid *node = &scene->solids[solid];
        if ((node->kind == SYNTAX_DIFFERENCE && rewrite_difference(scene, solid)) ||
            (node->kind == SYNTAX_INTERSECTION && rewrite_intersection(scene, solid)) ||
            (node->kind == SYNTAX_UNION && rewrite_union(scene, solid))) {
            return true;
        }
    }
    return false;
}

static bool split(struct syntax *scene, uint64_t *random, int solid) {
    if (scene->solids[solid].kind == SYNTAX_HALF_SPACE) {
        return false;
    }
    int below = syntax_push_down(scene, solid, SYNTAX_UNION);
    int cutter = generate_any_cutter(scene, random);
    syntax_adopt(scene, solid, syntax_combine(scene, SYNTAX_INTERSECTION, below, cutter));
    syntax_adopt(scene, solid,
                 syntax_combine(scene, SYNTAX_DIFFERENCE, syntax_copy(scene, below),
                                syntax_copy(scene, cutter)));
    return true;
}

/* Makes (A & H) | (A - H) of every object, or of one solid somewhere. */
bool rewrite_split(struct syntax *scene, uint64_t *random) {
    bool has_split = false;
    if (chance_is(random, 50)) {
        int list[SYNTAX_SOLIDS_MOST], count = syntax_list(scene, list);
        return split(scene, random, list[chance_pick(random, count)]);
    }
    for (int i = 0; i < scene->object_count; i++) {
        if (i == 0 || chance_is(random, 60)) {
            has_split = split(scene, random, scene->objects[i].solid) || has_split;
        }
    }
    return has_split;
}

/* Cuts an object by a cylinder or a box that is longer than the object. */
bool prepare_cutter(struct syntax *scene, uint64_t *random) {
    int object = chance_pick(random, scene->object_count);
    int solid = scene->objects[object].solid;
    struct extent extent = extent_of(scene, solid);
    if (!extent_is_within(&extent, 15)) {
        return false;
    }
    double x = chance_step(random, -2, 2), y = chance_step(random, -2, 2);
    double half = 0.25 + chance_step(random, 0, 1) / 2;
    int cutter = chance_is(random, 50)
                     ? generate_upright(scene, SYNTAX_CYLINDER, x, y, -16, 16, half)
                     : generate_box(scene, x - half, y - half, -16, x + half, y + half, 16);
    scene->objects[object].solid = syntax_combine(scene, SYNTAX_DIFFERENCE, solid, cutter);
    return true;
}

/* Makes prepare_cutter()'s cutter longer still, within something larger: the last difference is the
 * one that was put in. */
bool rewrite_cutter(struct syntax *scene, uint64_t *random) {
    int last = scene->solid_count - 1, cutter = scene->solids[last].children[1];
    scene->solids[cutter].a[2] = -40 - chance_step(random, 0, 4);
    scene->solids[cutter].b[2] = 40 + chance_step(random, 0, 4);
    int around = chance_is(random, 50) ? generate_upright(scene, SYNTAX_CYLINDER, 0, 0, -45, 46, 8)
                                       : generate_box(scene, -50, -50, -44.5, 50, 50, 45);
    scene->solids[last].children[1] = syntax_combine(scene, SYNTAX_INTERSECTION, cutter, around);
    return scene->solids[last].kind == SYNTAX_DIFFERENCE;
}

/* Makes unions and intersections of one child each of solids and operations. */
bool rewrite_alone(struct syntax *scene, uint64_t *random) {
    static const enum syntax_kind kinds[] = {SYNTAX_UNION, SYNTAX_INTERSECTION};
    int list[SYNTAX_SOLIDS_MOST], count = syntax_list(scene, list);
    for (int i = 0; i < count && !scene->is_full; i++) {
        if (chance_is(random, 50)) {
            int below = syntax_push_down(scene, list[i], kinds[chance_pick(random, 2)]);
            syntax_adopt(scene, list[i], below);
        }
    }
    return true;
}

/* Cuts objects by curves whose surfaces are far from the scene: intersects with what holds all of
 * the scene, and takes away what holds nothing. */
bool rewrite_beyond(struct syntax *scene, uint64_t *random) {
    static const double radii[] = {500, 1e4, 1e6};
    if (syntax_has_endless(scene)) {
        return false; /* with an end, the scene's own end would be elsewhere */
    }
    for (int i = 0; i < scene->object_count && !scene->is_full; i++) {
        int solid = scene->objects[i].solid;
        double radius = radii[chance_pick(random, 3)];
        bool holds_all = chance_is(random, 50);
        double away = holds_all ? radius / 4 : 3 * radius;
        int below =
            syntax_push_down(scene, solid, holds_all ? SYNTAX_INTERSECTION : SYNTAX_DIFFERENCE);
        int curve = chance_is(random, 50) ? generate_ball(scene, away, 0, 0, radius)
                                          : generate_upright(scene, SYNTAX_CYLINDER, away, 0,
                                                             -radius, radius, radius);
        syntax_adopt(scene, solid, below);
        syntax_adopt(scene, solid, curve);
    }
    return true;
}
