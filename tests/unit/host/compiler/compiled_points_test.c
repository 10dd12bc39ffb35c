/* SPDX-License-Identifier: MIT */
/* Point by point: what the scene compiler knows of pairs of solids is true of the solids in the
 * file.
 *
 * The oracle is the solids' definitions in this file's own words. Solids stand anywhere but in the
 * scene's middle; the second of a pair lies within the first one, across its face, or beside it. */
#include "compiled_points.h"
#include "compiler/affine.h"
#include "compiler/bounds.h"

enum { TEXT_SIZE = 4096, LEAF_SIZE = 512, PAIRS = 400, POINTS = 300, OBJECT = 2 };

enum kind {
    BALL,
    ELLIPSOID,
    EGG, /* an ellipsoid that is written as a quadric */
    CYLINDER,
    CONE,
    PARABOLOID,
    BOX,
    ROD,
    SLAB,
    KINDS,
    FINITE_KINDS = ROD
};

/* A solid: scaled to `half`, turned about z and put at `centre`. Before, it has the size of a ball
 * of radius 1, or of a cube around that, and is round about `axis`. */
struct leaf {
    enum kind kind;
    double centre[3], turn, half[3], axis[3];
    bool oblique; /* the axis is none of x, y and z */
    char text[LEAF_SIZE];
};

static const char scene_format[] =
    "version = 1; size = [8, 5]; depth = 2;\n"
    "camera = { eye = (%.17g, %.17g, %.17g); look_at = (0, 0, 0.3); };\n"
    "lights = ( { direction = (0.5, 0.6, -1.0); } );\n"
    "materials = { clay = { colour = [200, 90, 40]; specular = 0.5; }; };\n"
    "objects = (\n"
    "  { material = \"clay\"; solid = { box = { min = (-9, -9, -6); max = (9, 9, -5); }; }; },\n"
    "  { material = \"clay\"; solid = %s; } );\n";

/* From the file's axes to the leaf's, from its centre. */
static void to_leaf(const struct leaf *leaf, const double point[3], double own[3]) {
    double angle = leaf->turn * 3.14159265358979323846 / 180;
    double x = point[0] - leaf->centre[0], y = point[1] - leaf->centre[1];
    own[0] = cos(angle) * x + sin(angle) * y;
    own[1] = cos(angle) * y - sin(angle) * x;
    own[2] = point[2] - leaf->centre[2];
}

static void from_leaf(const struct leaf *leaf, const double own[3], double point[3]) {
    double angle = leaf->turn * 3.14159265358979323846 / 180;
    point[0] = leaf->centre[0] + cos(angle) * own[0] - sin(angle) * own[1];
    point[1] = leaf->centre[1] + cos(angle) * own[1] + sin(angle) * own[0];
    point[2] = leaf->centre[2] + own[2];
}

/* Says whether a solid holds a point, by the solid's definition in docs/scene-format.md. */
static bool leaf_holds(const struct leaf *leaf, const double point[3]) {
    double own[3], scaled[3], along = 0, square = 0;
    to_leaf(leaf, point, own);
    for (int i = 0; i < 3; i++) {
        scaled[i] = own[i] / leaf->half[i];
        along += scaled[i] * leaf->axis[i];
        square += scaled[i] * scaled[i];
    }
    square -= along * along; /* of the distance from the axis */
    switch (leaf->kind) {
    case BOX:
        return fabs(scaled[0]) < 1 && fabs(scaled[1]) < 1 && fabs(scaled[2]) < 1;
    case CYLINDER:
        return fabs(along) < 1 && square < 1;
    case CONE: /* its apex is at 1 */
        return fabs(along) < 1 && square < (1 - along) * (1 - along) / 4;
    case PARABOLOID: /* its apex is at -1 */
        return fabs(along) < 1 && square < (along + 1) / 2;
    case ROD:
        return square < 1;
    case SLAB:
        return fabs(along) < 1;
    case BALL:
    case ELLIPSOID:
    case EGG:
    default:
        return square + along * along < 1;
    }
}

/* Writes a solid around an axis, from one end to the other, as wide as 1 across. */
static int write_round(char *text, size_t room, const struct leaf *leaf) {
    static const char *const names[KINDS] = {
        [CYLINDER] = "cylinder", [CONE] = "cone", [PARABOLOID] = "paraboloid"};
    const double *axis = leaf->axis;
    return snprintf(text, room,
                    "%s = { from = (%.17g, %.17g, %.17g); to = (%.17g, %.17g, %.17g); %s = 1; };",
                    names[leaf->kind], -axis[0], -axis[1], -axis[2], axis[0], axis[1], axis[2],
                    leaf->kind == CONE ? "from_radius" : "radius");
}

/* Writes a quadric a - 1 <= 0, where a is the square of the distance from the axis, along it, or
 * the sum of the two. */
static int write_quadric(char *text, size_t room, const struct leaf *leaf) {
    const double *axis = leaf->axis;
    double every = leaf->kind == SLAB ? 0 : 1;
    double along = leaf->kind == SLAB ? 1 : leaf->kind == ROD ? -1 : 0;
    return snprintf(text, room,
                    "quadric = { coefficients = (%.17g, %.17g, %.17g, %.17g, %.17g, %.17g, 0, 0, 0,"
                    " -1); };",
                    every + along * axis[0] * axis[0], every + along * axis[1] * axis[1],
                    every + along * axis[2] * axis[2], 2 * along * axis[0] * axis[1],
                    2 * along * axis[1] * axis[2], 2 * along * axis[2] * axis[0]);
}

/* Writes the solid of the unit cube's size, and where it is put. */
static void write_leaf(struct leaf *leaf) {
    char *text = leaf->text;
    int at = snprintf(text, LEAF_SIZE, "{ ");
    size_t room = LEAF_SIZE - (size_t)at;
    switch (leaf->kind) {
    case BOX:
        at += snprintf(text + at, room, "box = { min = (-1, -1, -1); max = (1, 1, 1); };");
        break;
    case BALL:
    case ELLIPSOID:
        at += snprintf(text + at, room, "ball = { radius = 1; };");
        break;
    case EGG:
    case ROD:
    case SLAB:
        at += write_quadric(text + at, room, leaf);
        break;
    case CYLINDER:
    case CONE:
    case PARABOLOID:
    default:
        at += write_round(text + at, room, leaf);
    }
    (void)snprintf(text + at, LEAF_SIZE - (size_t)at,
                   " scale = (%.17g, %.17g, %.17g); rotate = (0, 0, %.17g);"
                   " translate = (%.17g, %.17g, %.17g); }",
                   leaf->half[0], leaf->half[1], leaf->half[2], leaf->turn, leaf->centre[0],
                   leaf->centre[1], leaf->centre[2]);
}

static void draw_axis(struct leaf *leaf, uint64_t *seed) {
    double length = 0;
    memset(leaf->axis, 0, sizeof leaf->axis);
    leaf->axis[next_random(seed) % 3] = next_random(seed) % 2 == 0 ? 1 : -1;
    leaf->oblique = next_random(seed) % 4 == 0;
    for (int i = 0; i < 3; i++) {
        leaf->axis[i] += leaf->oblique ? random_between(seed, -0.7, 0.7) : 0;
        length += leaf->axis[i] * leaf->axis[i];
    }
    for (int i = 0; i < 3; i++) {
        leaf->axis[i] /= sqrt(length);
    }
}

static void draw_leaf(struct leaf *leaf, uint64_t *seed, const struct leaf *about) {
    double size = about == NULL ? 1 : random_between(seed, 0.1, 0.8);
    leaf->kind =
        (enum kind)(next_random(seed) % (about == NULL ? (uint32_t)KINDS : (uint32_t)FINITE_KINDS));
    draw_axis(leaf, seed);
    leaf->turn = about == NULL ? random_between(seed, -180, 180) * (next_random(seed) % 2)
                 : next_random(seed) % 2 == 0 ? about->turn
                                              : random_between(seed, -180, 180);
    for (int i = 0; i < 3; i++) {
        double far = about == NULL ? 2.5 : 0.9 * about->half[i];
        leaf->centre[i] = random_between(seed, -far, far) + (about == NULL ? 0 : about->centre[i]);
        leaf->half[i] = leaf->kind == BALL && i > 0 ? leaf->half[0]
                        : about == NULL             ? random_between(seed, 0.5, 1.6)
                                                    : about->half[i] * size;
    }
    write_leaf(leaf);
}

static void draw_pair(struct leaf pair[2], uint64_t number) {
    uint64_t seed = 15485863 * (number + 1);
    draw_leaf(&pair[0], &seed, NULL);
    draw_leaf(&pair[1], &seed, &pair[0]);
}

/* A point around both solids of a pair, most often near the smaller one. */
static void draw_point(const struct leaf pair[2], uint64_t *seed, double point[3]) {
    double far = next_random(seed) % 3 == 0 ? 2.5 : 1.2;
    for (int i = 0; i < 3; i++) {
        double half = fmax(fmax(pair[1].half[0], pair[1].half[1]), pair[1].half[2]);
        point[i] = pair[1].centre[i] + random_between(seed, -far, far) * half;
    }
}

/* Loads a scene of the solid over a board. Both are mirrors, so that rays go everywhere, and the
 * eye is outside of the pair: what nobody could see would not be in the tables. */
static struct loaded_scene load_solid(const char *solid, const struct leaf pair[2]) {
    static const double eyes[][3] = {{3.1, -7.3, 5.2}, {-7, 3, 6}, {6, 7, 9},  {-9, -8, 1},
                                     {1, 12, 3},       {30, 2, 9}, {2, 3, 40}, {-40, 20, 8}};
    char text[TEXT_SIZE];
    size_t i = 0, count = sizeof eyes / sizeof eyes[0];
    while (i + 1 < count && (leaf_holds(&pair[0], eyes[i]) || leaf_holds(&pair[1], eyes[i]))) {
        i++;
    }
    (void)snprintf(text, sizeof text, scene_format, eyes[i][0], eyes[i][1], eyes[i][2], solid);
    return load_text(text, "f64");
}

/* ---- Operations ------------------------------------------------------------------------------ */

static const struct operation {
    const char *name;
    bool swapped;
    bool result[2][2]; /* by what the first solid holds, and the second one */
} operations[] = {
    {"union", false, {{false, true}, {true, true}}},
    {"union", true, {{false, true}, {true, true}}},
    {"intersection", false, {{false, false}, {false, true}}},
    {"intersection", true, {{false, false}, {false, true}}},
    {"difference", false, {{false, false}, {true, false}}},
    {"difference", true, {{false, true}, {false, false}}},
};
enum { OPERATIONS = sizeof operations / sizeof operations[0] };

/* Returns how many of the points the object holds. */
static int check_operation(const struct leaf pair[2], const struct operation *operation,
                           uint64_t seed) {
    char solid[3 * LEAF_SIZE];
    int held = 0;
    (void)snprintf(solid, sizeof solid, "{ %s = ( %s, %s ); }", operation->name,
                   pair[operation->swapped].text, pair[!operation->swapped].text);
    struct loaded_scene loaded = load_solid(solid, pair);
    for (int i = 0; i < POINTS; i++) {
        double point[3];
        draw_point(pair, &seed, point);
        bool expected = operation->result[leaf_holds(&pair[0], point)][leaf_holds(&pair[1], point)];
        bool has =
            loaded.compiled->object_count > OBJECT && object_has(loaded.compiled, OBJECT, point);
        if (has != expected) {
            fail_msg("(%g, %g, %g) of %s", point[0], point[1], point[2], solid);
        }
        held += has;
    }
    unload(&loaded);
    return held;
}

static void an_operation_holds_what_its_two_solids_say(void **state) {
    (void)state;
    int full = 0, empty = 0;
    for (uint64_t i = 0; i < PAIRS; i++) {
        struct leaf pair[2];
        draw_pair(pair, i);
        for (int j = 0; j < OPERATIONS; j++) {
            int held = check_operation(pair, &operations[j], 7 * i + 1);
            full += held > POINTS / 20 && held < POINTS - POINTS / 20;
            empty += held == 0;
        }
    }
    assert_true(full > PAIRS * OPERATIONS / 2 && empty > PAIRS / 10);
}

/* ---- Pairs of primitives --------------------------------------------------------------------- */

/* What of one primitive's points another one holds. */
struct overlap {
    bool some, all;
};

static struct overlap overlap_of(const struct compiled_scene *scene, uint32_t one, uint32_t other,
                                 const struct leaf pair[2]) {
    struct overlap overlap = {false, true};
    uint64_t seed = 424243;
    for (int i = 0; i < POINTS; i++) {
        double point[3], scaled[3];
        draw_point(pair, &seed, point);
        scale_point(scene, point, scaled);
        if (compiled_primitive_holds(scene, one, scaled)) {
            bool is_held = compiled_primitive_holds(scene, other, scaled);
            overlap.some = overlap.some || is_held;
            overlap.all = overlap.all && is_held;
        }
    }
    return overlap;
}

/* From within a primitive a ray does not look for those that it hides: their faces are not in it.
 */
static void what_a_primitive_hides_has_no_face_in_it(void **state) {
    (void)state;
    unsigned within = 0, apart = 0;
    for (uint64_t i = 0; i < PAIRS; i++) {
        struct leaf pair[2];
        char solid[3 * LEAF_SIZE];
        draw_pair(pair, i);
        /* Two objects that are apart, for of an operation one would be left; a difference where one
         * is within the other, for two objects would be sealed. */
        (void)snprintf(solid, sizeof solid,
                       i % 2 == 0 ? "%s; }, { material = \"clay\"; solid = %s"
                                  : "{ difference = ( %s, %s ); }",
                       pair[0].text, pair[1].text);
        struct loaded_scene loaded = load_solid(solid, pair);
        const struct compiled_scene *scene = loaded.compiled;
        for (uint8_t j = 0; j < scene->primitive_count; j++) {
            for (uint8_t k = 0; k < scene->primitive_count; k++) {
                bool hides = compiled_set_has(&scene->hidden_by[k], j);
                bool encloses = scene->primitives[j].enclosure == k;
                struct overlap overlap = overlap_of(scene, j, k, pair);
                if (j != k && ((hides && overlap.some && !overlap.all) ||
                               (encloses && !(overlap.all && hides)))) {
                    fail_msg("primitive %d, %s of %s", k, encloses ? "an enclosure" : "hidden",
                             solid);
                }
                within += encloses;
                apart += hides && !encloses;
            }
        }
        unload(&loaded);
    }
    assert_true(within > PAIRS / 20 && apart > PAIRS);
}

/* A box along a quadric's axes lies within it where its corners do: that is found, and no more. */
static void a_box_within_a_quadric_is_found_wherever_that_is(void **state) {
    (void)state;
    int within = 0, across = 0;
    for (uint64_t i = 0; i < PAIRS; i++) {
        struct leaf pair[2];
        char solid[3 * LEAF_SIZE];
        int corners = 0;
        draw_pair(pair, i);
        bool has_axes = pair[0].kind <= EGG || !pair[0].oblique;
        /* A cone is one of two that meet at the apex, a slab two half-spaces. */
        if (pair[0].kind == BOX || pair[0].kind == CONE || pair[0].kind == SLAB || !has_axes) {
            continue;
        }
        pair[1].kind = BOX;
        pair[1].turn = pair[0].turn;
        write_leaf(&pair[1]);
        for (int j = 0; j < 8; j++) {
            double own[3], point[3];
            for (int k = 0; k < 3; k++) {
                own[k] = (j >> k & 1 ? 1.001 : -1.001) * pair[1].half[k];
            }
            from_leaf(&pair[1], own, point);
            corners += leaf_holds(&pair[0], point);
        }
        (void)snprintf(solid, sizeof solid, "{ union = ( %s, %s ); }", pair[0].text, pair[1].text);
        struct loaded_scene loaded = load_solid(solid, pair);
        if ((loaded.compiled->report.simplified == 1) != (corners == 8)) {
            fail_msg("%d corners within, %u simplified of %s", corners,
                     loaded.compiled->report.simplified, solid);
        }
        within += corners == 8;
        across += corners > 0 && corners < 8;
        unload(&loaded);
    }
    assert_true(within > PAIRS / 32 && across > PAIRS / 16);
}

/* Between two balls there is a plane, and from within either nobody looks for the other one. */
static void balls_that_lie_apart_are_found_to_whatever_the_direction(void **state) {
    (void)state;
    static const double gaps[] = {-0.05, 0.05};
    for (uint64_t i = 0; i < PAIRS; i++) {
        struct leaf pair[2];
        char solid[3 * LEAF_SIZE];
        double gap = gaps[i % 2];
        draw_pair(pair, i);
        for (int j = 0; j < 3; j++) {
            double distance = pair[0].half[0] + pair[1].half[0] + gap;
            pair[1].centre[j] = pair[0].centre[j] + pair[0].axis[j] * distance;
            pair[0].half[j] = pair[0].half[0];
            pair[1].half[j] = pair[1].half[0];
        }
        for (int j = 0; j < 2; j++) {
            pair[j].kind = BALL;
            write_leaf(&pair[j]);
        }
        (void)snprintf(solid, sizeof solid, "{ union = ( %s, %s ); }", pair[0].text, pair[1].text);
        struct loaded_scene loaded = load_solid(solid, pair);
        assert_int_equal(compiled_set_has(&loaded.compiled->hidden_by[1], 2), gap > 0);
        assert_int_equal(compiled_set_has(&loaded.compiled->hidden_by[2], 1), gap > 0);
        unload(&loaded);
    }
}

/* ---- Bounds ---------------------------------------------------------------------------------- */

static bool bounds_hold(const struct bounds *bounds, const double point[3]) {
    bool hold = true;
    for (int i = 0; i < 3; i++) {
        hold = hold && bounds->low[i] <= point[i] && point[i] <= bounds->high[i];
    }
    return hold;
}

static struct bounds bounds_of(const struct leaf *leaf) {
    char text[TEXT_SIZE];
    (void)snprintf(text, sizeof text, scene_format, 3.1, -7.3, 5.2, leaf->text);
    struct scene_description *description = read_text(text);
    struct bounds bounds =
        solid_bounds(description, description->objects[1].solid, &affine_identity);
    scene_description_free(description);
    return bounds;
}

/* Draws a point of one solid, or around it: far away, near, or just within the rim of an end. */
static void draw_far_point(const struct leaf *leaf, int number, uint64_t *seed, double point[3]) {
    const double *axis = leaf->axis;
    double far = number % 3 == 0 ? 30 : 2, own[3], away[3], side[3];
    for (int i = 0; i < 3; i++) {
        point[i] = leaf->centre[i] + random_between(seed, -far, far);
        away[i] = random_between(seed, -1, 1);
    }
    vector_cross(axis, away, side);
    if (number % 3 != 2 || !vector_normalise(side)) {
        return;
    }
    for (int i = 0; i < 3; i++) {
        own[i] = 0.999 * leaf->half[i] * (side[i] + (number % 2 == 0 ? axis[i] : -axis[i]));
    }
    from_leaf(leaf, own, point);
}

/* Whatever has no end has no bounds either: rods and slabs along any axis, turned and scaled. */
static void bounds_hold_every_point_of_a_solid(void **state) {
    (void)state;
    int held = 0;
    for (uint64_t i = 0; i < PAIRS; i++) {
        struct leaf pair[2];
        uint64_t seed = 7919 * i + 1;
        draw_pair(pair, i);
        struct bounds bounds = bounds_of(&pair[0]);
        assert_int_equal(bounds_are_finite(&bounds), pair[0].kind < FINITE_KINDS);
        for (int j = 0; j < POINTS; j++) {
            double point[3];
            draw_far_point(&pair[0], j, &seed, point);
            bool is_in = leaf_holds(&pair[0], point);
            if (is_in && !bounds_hold(&bounds, point)) {
                fail_msg("(%g, %g, %g) is out of the bounds of %s", point[0], point[1], point[2],
                         pair[0].text);
            }
            held += is_in;
        }
    }
    assert_true(held > PAIRS * POINTS / 20);
}

static void an_ellipsoid_has_the_same_bounds_as_a_quadric(void **state) {
    (void)state;
    for (uint64_t i = 0; i < PAIRS; i++) {
        struct leaf pair[2];
        draw_pair(pair, i);
        pair[0].kind = ELLIPSOID;
        write_leaf(&pair[0]);
        struct bounds ball = bounds_of(&pair[0]);
        pair[0].kind = EGG;
        write_leaf(&pair[0]);
        struct bounds quadric = bounds_of(&pair[0]);
        for (int j = 0; j < 3; j++) {
            assert_true(fabs(ball.low[j] - quadric.low[j]) < 1e-9);
            assert_true(fabs(ball.high[j] - quadric.high[j]) < 1e-9);
        }
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_operation_holds_what_its_two_solids_say),
        cmocka_unit_test(what_a_primitive_hides_has_no_face_in_it),
        cmocka_unit_test(a_box_within_a_quadric_is_found_wherever_that_is),
        cmocka_unit_test(balls_that_lie_apart_are_found_to_whatever_the_direction),
        cmocka_unit_test(bounds_hold_every_point_of_a_solid),
        cmocka_unit_test(an_ellipsoid_has_the_same_bounds_as_a_quadric),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
