/* SPDX-License-Identifier: MIT */
/* Random scenes: what meets on purpose. */
#include "generate.h"

#include <string.h>

#include "chance.h"
#include "wording.h"

/* Where a motif stands, and the scene it goes to. */
struct site {
    struct syntax *syntax;
    uint64_t *random;
    double x, y;
    double scale[3], rotate[3];
};

static int any_material(const struct site *site) {
    return chance_pick(site->random, GENERATED_MATERIALS);
}

static int transparent(const struct site *site) {
    static const int materials[] = {GENERATED_GLASS, GENERATED_GLASS, GENERATED_TINTED,
                                    GENERATED_DISPERSING, GENERATED_SCREEN};
    return materials[chance_pick(site->random, 5)];
}

/* Adds an object that is placed as its site is. */
static void stand(const struct site *site, int material, int solid) {
    struct syntax *syntax = site->syntax;
    int placed = syntax_add(syntax, SYNTAX_UNION);
    struct syntax_solid *wrapper = &syntax->solids[placed];
    syntax_adopt(syntax, placed, solid);
    wrapper->translate[0] = site->x;
    wrapper->translate[1] = site->y;
    memcpy(wrapper->scale, site->scale, sizeof wrapper->scale);
    memcpy(wrapper->rotate, site->rotate, sizeof wrapper->rotate);
    syntax_add_object(syntax, material, placed);
}

static double some(const struct site *site) {
    return 0.5 + chance_step(site->random, 0, 1) / 2;
}

/* Adds a box with a smaller one in it that has a face in common, as a filling or a cavity. */
static void add_flush(const struct site *site) {
    struct syntax *syntax = site->syntax;
    double size = some(site);
    int outer = generate_box(syntax, -size, -size, 0.5, size, size, 2);
    int inner = generate_box(syntax, -size / 2, -size, 0.75, size / 2, size / 2, 2);
    if (chance_is(site->random, 50)) {
        int cavity = syntax_copy(syntax, inner);
        outer = syntax_combine(syntax, SYNTAX_DIFFERENCE, outer, cavity);
    }
    stand(site, any_material(site), outer);
    if (chance_is(site->random, 70)) {
        stand(site, any_material(site), inner);
    }
}

static void add_touching(const struct site *site) {
    struct syntax *syntax = site->syntax;
    if (chance_is(site->random, 40)) {
        add_flush(site);
        return;
    }
    double depth = some(site), height = some(site), left = some(site), right = some(site);
    stand(site, any_material(site),
          generate_box(syntax, -left, -depth, 0.25, 0, depth, height + 1));
    int other = generate_box(syntax, 0, -depth, 0.25, right, depth / 2, height + 1);
    if (chance_is(site->random, 30)) { /* the same box in other words */
        struct syntax_solid *box = &syntax->solids[other];
        box->scale[0] = 2;
        box->b[0] /= 2;
        box->translate[2] = 0.25;
        box->a[2] -= 0.25;
        box->b[2] -= 0.25;
    }
    stand(site, any_material(site), other);
}

static void add_standing(const struct site *site) {
    struct syntax *syntax = site->syntax;
    static const enum syntax_kind kinds[] = {SYNTAX_CYLINDER, SYNTAX_CONE, SYNTAX_BOX};
    enum syntax_kind kind = kinds[chance_pick(site->random, 3)];
    double radius = some(site), height = 2 * some(site);
    stand(site, any_material(site),
          kind == SYNTAX_BOX ? generate_box(syntax, -radius, -radius, 0, radius, radius / 2, height)
                             : generate_upright(syntax, kind, 0, 0, 0, height, radius));
}

/* Adds two halves of one solid, the second in other words; or what one leaves of the other. */
static void add_reworded(const struct site *site) {
    struct syntax *syntax = site->syntax;
    int first = generate_leaf(syntax, site->random);
    int second = syntax_copy(syntax, first);
    (void)wording_ends(&syntax->solids[second]);
    (void)wording_leaf(&syntax->solids[second], site->random);
    int cutter = generate_cutter(syntax, site->random);
    int halves[2] = {
        syntax_combine(syntax, SYNTAX_INTERSECTION, first, cutter),
        syntax_combine(syntax, SYNTAX_DIFFERENCE, second, syntax_copy(syntax, cutter))};
    if (chance_is(site->random, 20)) {
        halves[1] = syntax_combine(syntax, SYNTAX_DIFFERENCE, second, syntax_copy(syntax, first));
    }
    for (int i = 0; i < 2; i++) {
        int raised = syntax_add(syntax, SYNTAX_UNION);
        syntax_adopt(syntax, raised, halves[i]);
        syntax->solids[raised].translate[2] = 1.25;
        stand(site, any_material(site), raised);
    }
}

/* Adds a tube, what fills it, and what goes on above it; each cylinder with its own ends. */
static void add_coaxial(const struct site *site) {
    struct syntax *syntax = site->syntax;
    double radius = some(site), height = 1 + some(site);
    int tube = syntax_combine(
        syntax, SYNTAX_DIFFERENCE,
        generate_upright(syntax, SYNTAX_CYLINDER, 0, 0, 0.5, height, radius),
        generate_upright(syntax, SYNTAX_CYLINDER, 0, 0, height + 0.5, 0.25, radius / 2));
    stand(site, any_material(site), tube);
    if (chance_is(site->random, 70)) {
        stand(site, any_material(site),
              generate_upright(syntax, SYNTAX_CYLINDER, 0, 0, height, 0.5, radius / 2));
    }
    if (chance_is(site->random, 50)) {
        stand(site, any_material(site),
              generate_upright(syntax, SYNTAX_CYLINDER, 0, 0, height + 0.75, height, radius));
    }
    if (chance_is(site->random, 30)) {
        int empty = syntax_combine(
            syntax, SYNTAX_DIFFERENCE,
            generate_upright(syntax, SYNTAX_CYLINDER, 1, 0, 0.5, height, radius),
            generate_upright(syntax, SYNTAX_CYLINDER, 1, 0, height + 0.25, 0.25, radius));
        stand(site, GENERATED_CLAY, empty);
    }
}

static int use(struct syntax *syntax, int part) {
    int solid = syntax_add(syntax, SYNTAX_PART);
    syntax->solids[solid].part = part;
    return solid;
}

/* Adds a solid with a flat cut, as it is and where it cuts another one. */
static void add_cut_twice(const struct site *site) {
    struct syntax *syntax = site->syntax;
    static const enum syntax_kind kinds[] = {SYNTAX_CYLINDER, SYNTAX_CONE, SYNTAX_PARABOLOID,
                                             SYNTAX_BALL, SYNTAX_ONE_SHEET};
    enum syntax_kind kind = kinds[chance_pick(site->random, 5)];
    double radius = some(site);
    int solid = kind == SYNTAX_BALL ? generate_ball(syntax, 0, 0, 1.25, radius)
                                    : generate_upright(syntax, kind, 0, 0, 0.25, 2.25, radius);
    syntax->solids[solid].radius_b = kind == SYNTAX_ONE_SHEET ? radius / 2 : 0;
    int cut = syntax_add(syntax, SYNTAX_HALF_SPACE);
    int axis = chance_pick(site->random, 3);
    syntax_plane(syntax, cut, axis == 0, axis == 1, axis == 2, axis == 2 ? 1.5 : 0.25);
    int part = syntax_add_part(syntax, syntax_combine(syntax, SYNTAX_INTERSECTION, solid, cut));
    if (chance_is(site->random, 60)) {
        stand(site, any_material(site), use(syntax, part));
    }
    int block = generate_box(syntax, -0.75, -1, 0.5, 1, 1, 1.25 + some(site));
    stand(site, any_material(site),
          syntax_combine(syntax, SYNTAX_DIFFERENCE, block, use(syntax, part)));
}

static void add_off_centre(const struct site *site) {
    struct syntax *syntax = site->syntax;
    int cutter = generate_quadric(syntax, site->random);
    if (chance_is(site->random, 40)) {
        generate_placement(syntax, site->random, cutter);
    }
    if (chance_is(site->random, 40)) { /* with something small, to either side of what it cuts */
        static const enum syntax_kind kinds[] = {SYNTAX_UNION, SYNTAX_UNION, SYNTAX_INTERSECTION,
                                                 SYNTAX_DIFFERENCE};
        double x = chance_step(site->random, -1, 1), size = 0.25 + some(site) / 4;
        cutter = syntax_combine(syntax, kinds[chance_pick(site->random, 4)], cutter,
                                generate_ball(syntax, x, -x, 0, size));
    }
    syntax->solids[cutter].translate[2] = 1.25;
    int box = generate_box(syntax, -1, -0.75, 0.25, 0.75, 1, 2.25);
    static const enum syntax_kind kinds[] = {SYNTAX_INTERSECTION, SYNTAX_DIFFERENCE};
    int choice = chance_pick(site->random, 3);
    int solid = choice == 2 ? syntax_combine(syntax, SYNTAX_INTERSECTION, cutter, box)
                            : syntax_combine(syntax, kinds[choice], box, cutter);
    stand(site, any_material(site), solid);
    if (chance_is(site->random, 40)) {
        stand(site, any_material(site),
              generate_ball(syntax, 0, 0.25, 1.25, 0.25 + some(site) / 4));
    }
}

static int shell(const struct site *site, double size) {
    struct syntax *syntax = site->syntax;
    int kind = chance_pick(site->random, 4);
    if (kind == 0) {
        return generate_box(syntax, -size, -size, 1.5 - size, size, size, 1.5 + size);
    }
    if (kind == 1) {
        return generate_upright(syntax, SYNTAX_CYLINDER, 0, 0, 1.5 - size, 1.5 + size, size);
    }
    if (kind == 2) {
        int ellipsoid = syntax_add(syntax, SYNTAX_ELLIPSOID);
        struct syntax_solid *solid = &syntax->solids[ellipsoid];
        solid->a[2] = 1.5;
        solid->b[0] = solid->b[1] = size;
        solid->b[2] = size * 0.75;
        return ellipsoid;
    }
    return generate_ball(syntax, 0, 0, 1.5, size);
}

static void add_nested(const struct site *site) {
    double size = 1.25;
    int count = 2 + chance_pick(site->random, 2);
    for (int i = 0; i < count; i++) {
        bool is_last = i + 1 == count;
        int solid = shell(site, size);
        if (i == 0 && chance_is(site->random, 30)) { /* a cavity instead of a filling */
            solid = syntax_combine(site->syntax, SYNTAX_DIFFERENCE, solid, shell(site, size / 2));
        }
        stand(site, is_last ? any_material(site) : transparent(site), solid);
        size *= 0.5 + 0.0625 * chance_pick(site->random, 2);
    }
}

static void add_overlap(const struct site *site) {
    for (int i = 0; i < 3; i++) {
        int solid = generate_leaf(site->syntax, site->random);
        int placed = syntax_add(site->syntax, SYNTAX_UNION);
        syntax_adopt(site->syntax, placed, solid);
        for (int j = 0; j < 3; j++) {
            site->syntax->solids[placed].translate[j] =
                chance_step(site->random, -1, 1) / 2 + (j == 2 ? 1.5 : 0);
        }
        stand(site, any_material(site), placed);
    }
}

/* Adds what touches below one rotation, as one object or as two. */
static void add_turned(const struct site *site) {
    struct syntax *syntax = site->syntax;
    double turn[3] = {0, 0, 0};
    turn[chance_pick(site->random, 3)] = 10 * (1 + chance_pick(site->random, 35));
    if (chance_is(site->random, 40)) {
        turn[2] = chance_step(site->random, -90, 90);
    }
    int stem = generate_upright(syntax, SYNTAX_CYLINDER, 0, 0, 0, -1, some(site));
    int head = generate_box(syntax, -0.75, -0.75, 0, 0.75, 0.75, some(site));
    bool is_one = chance_is(site->random, 50);
    int solids[2] = {stem, head};
    if (is_one) {
        solids[0] = syntax_combine(syntax, SYNTAX_UNION, stem, head);
    }
    for (int i = 0; i < (is_one ? 1 : 2); i++) {
        int placed = syntax_add(syntax, SYNTAX_UNION);
        syntax_adopt(syntax, placed, solids[i]);
        memcpy(syntax->solids[placed].rotate, turn, sizeof turn);
        syntax->solids[placed].translate[2] = 1.5;
        stand(site, any_material(site), placed);
    }
}

static void add_mixed(const struct site *site) {
    struct syntax *syntax = site->syntax;
    int lower = generate_box(syntax, -1, -0.75, 0.25, 1, 0.75, 1);
    int upper = generate_box(syntax, -0.75, -0.75, 1, 0.5, 0.5, 2);
    syntax->solids[upper].material = any_material(site);
    int both = syntax_combine(syntax, SYNTAX_UNION, lower, upper);
    int hole = generate_upright(syntax, SYNTAX_CYLINDER, 0, 0, -1, 3, some(site) / 2);
    stand(site, any_material(site), syntax_combine(syntax, SYNTAX_DIFFERENCE, both, hole));
}

static void add_mirrored(const struct site *site) {
    struct syntax *syntax = site->syntax;
    int part = syntax_add_part(syntax, generate_tree(syntax, site->random, 1));
    int left = use(syntax, part), right = use(syntax, part);
    syntax->solids[left].scale[0] = -1;
    syntax->solids[left].translate[0] = -1.25;
    syntax->solids[right].translate[0] = 1.25;
    syntax->solids[left].translate[2] = syntax->solids[right].translate[2] = 1.5;
    if (chance_is(site->random, 50)) {
        stand(site, any_material(site), syntax_combine(syntax, SYNTAX_UNION, left, right));
    } else {
        stand(site, any_material(site), left);
        stand(site, any_material(site), right);
    }
}

static void add_tree(const struct site *site) {
    struct syntax *syntax = site->syntax;
    int tree = generate_tree(syntax, site->random, 2 + chance_pick(site->random, 3));
    int placed = syntax_add(syntax, SYNTAX_UNION);
    syntax_adopt(syntax, placed, tree);
    if (chance_is(site->random, 60)) {
        generate_placement(syntax, site->random, placed);
    }
    syntax->solids[placed].translate[2] += 1.5;
    stand(site, any_material(site), placed);
}

static void add_around_eye(const struct site *site) {
    double size = 20;
    syntax_insert_object(site->syntax, 0, GENERATED_SCREEN,
                         generate_box(site->syntax, -size, -size, -size, size, size, size));
}

/* Adds a crowd, of 50 to 180 solids, as one object: a handful of leaves that a part makes a row of,
 * and another part a field. */
static void add_crowd(const struct site *site) {
    struct syntax *syntax = site->syntax;
    int handful = syntax_add(syntax, SYNTAX_UNION), row = syntax_add(syntax, SYNTAX_UNION);
    int field = syntax_add(syntax, SYNTAX_UNION);
    for (int i = 3 + chance_pick(site->random, 3); i > 0; i--) {
        int placed = syntax_add(syntax, SYNTAX_UNION);
        syntax_adopt(syntax, placed, generate_leaf(syntax, site->random));
        for (int j = 0; j < 3; j++) {
            syntax->solids[placed].scale[j] = 0.25;
            syntax->solids[placed].translate[j] = chance_step(site->random, -1, 1) / 2;
        }
        syntax_adopt(syntax, handful, placed);
    }
    int few = syntax_add_part(syntax, handful);
    for (int i = 0; i < 6; i++) {
        int placed = use(syntax, few);
        syntax->solids[placed].translate[0] = 1.375 * i - 3.5;
        syntax_adopt(syntax, row, placed);
    }
    int many = syntax_add_part(syntax, row);
    for (int i = 3 + chance_pick(site->random, 4); i > 0; i--) {
        int placed = use(syntax, many);
        syntax->solids[placed].translate[1] = 1.375 * i - 4;
        syntax->solids[placed].translate[2] = 0.5 + 0.25 * chance_pick(site->random, 8);
        syntax_adopt(syntax, field, placed);
    }
    stand(site, any_material(site), field);
}

/* On no grid that the solids' own places are on. */
static void add_eye_amid(const struct site *site) {
    struct syntax *syntax = site->syntax;
    for (int i = 0; i < 3; i++) {
        double share = (chance_pick(site->random, 1000) + 0.5) / 1000;
        syntax->eye[i] = i < 2 ? 6 * share - 3 : 3 * share;
    }
    syntax->field_of_view += 40;
}

void generate_motif(struct syntax *syntax, uint64_t *random, enum motif motif) {
    static void (*const adders[MOTIFS])(const struct site *) = {
        [MOTIF_TOUCHING] = add_touching,     [MOTIF_STANDING] = add_standing,
        [MOTIF_REWORDED] = add_reworded,     [MOTIF_COAXIAL] = add_coaxial,
        [MOTIF_CUT_TWICE] = add_cut_twice,   [MOTIF_OFF_CENTRE] = add_off_centre,
        [MOTIF_NESTED] = add_nested,         [MOTIF_OVERLAP] = add_overlap,
        [MOTIF_TURNED] = add_turned,         [MOTIF_MIXED] = add_mixed,
        [MOTIF_MIRRORED] = add_mirrored,     [MOTIF_TREE] = add_tree,
        [MOTIF_AROUND_EYE] = add_around_eye, [MOTIF_EYE_AMID] = add_eye_amid,
        [MOTIF_CROWD] = add_crowd,
    };
    struct site site = {syntax,    random,   chance_step(random, -2, 2), chance_step(random, -2, 2),
                        {1, 1, 1}, {0, 0, 0}};
    if (chance_is(random, 12)) {
        site.rotate[chance_pick(random, 3)] = 10 * (1 + chance_pick(random, 35));
        syntax->motifs |= 1u << MOTIF_TURNED;
    }
    if (chance_is(random, 12)) {
        static const double factors[] = {-1, 0.75, 1.25, 2};
        site.scale[chance_pick(random, 3)] = factors[chance_pick(random, 4)];
    }
    adders[motif](&site);
    syntax->motifs |= 1u << motif;
}
