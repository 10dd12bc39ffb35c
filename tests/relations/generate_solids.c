/* SPDX-License-Identifier: MIT */
/* Random scenes: leaves, trees of operations, placements. */
#include "generate.h"

#include <string.h>

#include "chance.h"

static void set_three(double three[3], double x, double y, double z) {
    three[0] = x;
    three[1] = y;
    three[2] = z;
}

int generate_box(struct syntax *syntax, double x0, double y0, double z0, double x1, double y1,
                 double z1) {
    int box = syntax_add(syntax, SYNTAX_BOX);
    set_three(syntax->solids[box].a, x0, y0, z0);
    set_three(syntax->solids[box].b, x1, y1, z1);
    return box;
}

int generate_ball(struct syntax *syntax, double x, double y, double z, double radius) {
    int ball = syntax_add(syntax, SYNTAX_BALL);
    set_three(syntax->solids[ball].a, x, y, z);
    syntax->solids[ball].radius = radius;
    return ball;
}

int generate_upright(struct syntax *syntax, enum syntax_kind kind, double x, double y, double z0,
                     double z1, double radius) {
    int solid = syntax_add(syntax, kind);
    set_three(syntax->solids[solid].a, x, y, z0);
    set_three(syntax->solids[solid].b, x, y, z1);
    syntax->solids[solid].radius = radius;
    return solid;
}

static int round_solid(struct syntax *syntax, uint64_t *random, enum syntax_kind kind) {
    int index = syntax_add(syntax, kind);
    struct syntax_solid *solid = &syntax->solids[index];
    int axis = chance_pick(random, 3);
    for (int i = 0; i < 3; i++) {
        solid->a[i] = chance_step(random, -1, 1) / 2;
        solid->b[i] = solid->a[i];
    }
    solid->a[axis] = -0.5 - chance_step(random, 0, 1);
    solid->b[axis] = 0.5 + chance_step(random, 0, 1);
    if (chance_is(random, 30)) { /* slanted */
        solid->b[(axis + 1) % 3] += 0.25 + chance_step(random, 0, 1);
    }
    solid->radius = 0.5 + chance_step(random, 0, 1) / 2;
    if (kind == SYNTAX_CONE) {
        solid->radius_b = chance_is(random, 50) ? 0 : solid->radius / 2;
    } else if (kind == SYNTAX_ONE_SHEET) {
        solid->radius_b = solid->radius * 0.5;
    } else if (kind == SYNTAX_TWO_SHEETS) {
        solid->radius_b = 0.25;
    }
    return index;
}

/* Appends a prism, a pyramid's frustum or a wedge. */
static int polyhedron(struct syntax *syntax, uint64_t *random) {
    int solid = syntax_add(syntax, SYNTAX_POLYHEDRON);
    double lean = chance_pick(random, 3) / 2.0;
    double half = 0.5 + chance_step(random, 0, 1) / 2;
    syntax_plane(syntax, solid, 0, 0, -1, half);
    syntax_plane(syntax, solid, 1, 0, lean, half);
    syntax_plane(syntax, solid, -1, 0, lean, half);
    syntax_plane(syntax, solid, 0, 1, lean / 2, half);
    syntax_plane(syntax, solid, 0, -1, lean / 2, half);
    syntax_plane(syntax, solid, chance_pick(random, 2), 0, 2, half);
    return solid;
}

int generate_leaf(struct syntax *syntax, uint64_t *random) {
    static const enum syntax_kind kinds[] = {
        SYNTAX_BOX,        SYNTAX_BALL,      SYNTAX_CYLINDER,   SYNTAX_CONE,      SYNTAX_ELLIPSOID,
        SYNTAX_PARABOLOID, SYNTAX_ONE_SHEET, SYNTAX_TWO_SHEETS, SYNTAX_POLYHEDRON};
    enum syntax_kind kind = kinds[chance_pick(random, 9)];
    double half[3], at[3];
    for (int i = 0; i < 3; i++) {
        half[i] = 0.5 + chance_step(random, 0, 1) / 2;
        at[i] = chance_step(random, -1, 1) / 2;
    }
    switch (kind) {
    case SYNTAX_BOX:
        return generate_box(syntax, at[0] - half[0], at[1] - half[1], at[2] - half[2],
                            at[0] + half[0], at[1] + half[1], at[2] + half[2]);
    case SYNTAX_BALL:
        return generate_ball(syntax, at[0], at[1], at[2], half[0]);
    case SYNTAX_ELLIPSOID: {
        int ellipsoid = syntax_add(syntax, kind);
        memcpy(syntax->solids[ellipsoid].a, at, sizeof at);
        memcpy(syntax->solids[ellipsoid].b, half, sizeof half);
        return ellipsoid;
    }
    case SYNTAX_POLYHEDRON:
        return polyhedron(syntax, random);
    default: /* what has an axis */
        return round_solid(syntax, random, kind);
    }
}

/* Appends (x - c)^2 s_x + ... <= r^2 written out, some of the squares 0 or negative. */
int generate_quadric(struct syntax *syntax, uint64_t *random) {
    static const double squares[][3] = {{1, 1, 2}, {1, 0.5, 0}, {1, 1, -1}, {0, 2, 1}, {1, -1, 0},
                                        {2, 1, 1}, {-1, 1, 1},  {0, 0, 1},  {1, 0, 0}, {0.5, 1, 1}};
    int index = syntax_add(syntax, SYNTAX_QUADRIC);
    const double *square = squares[chance_pick(random, 10)];
    double *form = syntax->solids[index].form;
    form[9] = -0.25 - chance_step(random, 0, 1) / 2;
    for (int i = 0; i < 3; i++) {
        double centre = chance_step(random, -1, 1) / 2;
        form[i] = square[i];
        form[6 + i] = -2 * square[i] * centre;
        form[9] += square[i] * centre * centre;
    }
    if (chance_is(random, 25)) { /* what ends a paraboloid, or shears it */
        form[6 + chance_pick(random, 3)] += 0.5;
        form[3 + chance_pick(random, 3)] += 0.25;
    }
    return index;
}

static int half_space(struct syntax *syntax, uint64_t *random) {
    int solid = syntax_add(syntax, SYNTAX_HALF_SPACE);
    int axis = chance_pick(random, 3);
    double normal[3] = {0, 0, 0};
    normal[axis] = chance_is(random, 50) ? 1 : -1;
    if (chance_is(random, 40)) {
        normal[(axis + 1) % 3] = chance_step(random, -1, 1);
    }
    syntax_plane(syntax, solid, normal[0], normal[1], normal[2], chance_step(random, -1, 1) / 2);
    return solid;
}

int generate_cutter(struct syntax *syntax, uint64_t *random) {
    int choice = chance_pick(random, 16);
    if (choice == 0) { /* two without an end */
        int first = generate_cutter(syntax, random);
        return syntax_combine(syntax, SYNTAX_UNION, first, generate_cutter(syntax, random));
    }
    int solid = choice < 5    ? generate_quadric(syntax, random)
                : choice < 11 ? half_space(syntax, random)
                              : generate_leaf(syntax, random);
    if (chance_is(random, 25)) {
        generate_placement(syntax, random, solid);
    }
    return solid;
}

int generate_any_cutter(struct syntax *scene, uint64_t *random) {
    int cutter = generate_cutter(scene, random);
    scene->solids[cutter].translate[0] += chance_step(random, -2, 2);
    scene->solids[cutter].translate[1] += chance_step(random, -2, 2);
    scene->solids[cutter].translate[2] += 1.25;
    return cutter;
}

int generate_tree(struct syntax *syntax, uint64_t *random, int levels) {
    if (levels == 0 || chance_is(random, 15)) {
        int leaf = generate_leaf(syntax, random);
        if (chance_is(random, 35)) {
            generate_placement(syntax, random, leaf);
        }
        return leaf;
    }
    static const enum syntax_kind kinds[] = {SYNTAX_UNION, SYNTAX_INTERSECTION, SYNTAX_DIFFERENCE,
                                             SYNTAX_DIFFERENCE};
    enum syntax_kind kind = kinds[chance_pick(random, 4)];
    int solid = syntax_add(syntax, kind);
    syntax_adopt(syntax, solid, generate_tree(syntax, random, levels - 1));
    int others = chance_is(random, 30) ? 2 : 1;
    if (chance_is(random, 8)) { /* the first once more */
        syntax_adopt(syntax, solid, syntax_copy(syntax, syntax->solids[solid].children[0]));
    }
    for (int i = 0; i < others; i++) {
        bool is_endless = kind != SYNTAX_UNION && chance_is(random, 40);
        syntax_adopt(syntax, solid,
                     is_endless ? generate_cutter(syntax, random)
                                : generate_tree(syntax, random, levels - 1));
    }
    if (kind == SYNTAX_INTERSECTION && chance_is(random, 30)) { /* the one with an end not first */
        int *children = syntax->solids[solid].children, first = children[0];
        children[0] = children[1];
        children[1] = first;
    }
    if (chance_is(random, 15)) {
        generate_placement(syntax, random, solid);
    }
    return solid;
}

void generate_placement(struct syntax *syntax, uint64_t *random, int solid) {
    struct syntax_solid *placed = &syntax->solids[solid];
    int turn = chance_pick(random, 6), stretch = chance_pick(random, 6);
    for (int i = 0; i < 3; i++) {
        if (turn == 0) {
            placed->rotate[i] = 90 * chance_pick(random, 4);
        } else if (turn == 1) {
            placed->rotate[i] = chance_step(random, -90, 90);
        } else if (turn == 2) {
            placed->rotate[i] = i == 1 ? 10 * chance_pick(random, 36) : 0;
        }
        if (stretch == 0) {
            placed->scale[i] = 0.5 + chance_step(random, 0, 1);
        } else if (stretch == 1) {
            placed->scale[i] = i == 0 ? -1 : 1;
        } else if (stretch == 2) {
            placed->scale[i] = 0.75;
        }
        placed->translate[i] = chance_step(random, -1, 1) / 2;
    }
}
