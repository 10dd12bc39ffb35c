/* SPDX-License-Identifier: MIT */
/* One point set has one surface number, however a file writes it; what differs keeps its own. */
#include "scene_fixture.h"

enum { TEXT_SIZE = 16384, SOLID_SIZE = 4096, WIDTH = 32, HEIGHT = 20 };

/* A scene with one solid before a plain background. */
static const char scene_head[] =
    "version = 1; size = [32, 20]; depth = 4; background = [90, 110, 140];\n"
    "camera = { eye = (3.1, -7.3, 5.2); look_at = (0.1, 0.2, 0.1); field_of_view = 34; };\n"
    "materials = { clay = { colour = [200, 90, 40]; ambient = 1; ambient_is_own = true; }; };\n"
    "objects = ( ";

static void make_scene(char *text, const char *solid) {
    snprintf(text, TEXT_SIZE, "%s{ material = \"clay\"; solid = %s; } );\n", scene_head, solid);
}

static int surfaces_of(const char *solid) {
    char text[TEXT_SIZE];
    make_scene(text, solid);
    struct compiled_scene *compiled = compile_text(text);
    int count = (int)compiled->surface_count;
    compiled_scene_free(compiled);
    return count;
}

/* Counts the pixels of a solid that are not the background's. */
static int seen(const char *solid, const char *arithmetic) {
    char text[TEXT_SIZE];
    make_scene(text, solid);
    struct loaded_scene loaded = load_text(text, arithmetic);
    struct render_counts counts = {0};
    int count = 0;
    for (unsigned y = 0; y < HEIGHT; y++) {
        for (unsigned x = 0; x < WIDTH; x++) {
            int level[3];
            pixel_levels(&loaded, x, y, level, &counts);
            count += level[0] != 90 || level[1] != 110 || level[2] != 140;
        }
    }
    assert_int_equal(counts.leaked_rays, 0);
    unload(&loaded);
    return count;
}

/* Two ways to write one solid. */
static const char *const pairs[][2] = {
    {"cylinder = { from = (0.1, 0.2, -1); to = (0.3, 0, 1); radius = 0.5; };",
     "cylinder = { from = (0.3, 0, 1); to = (0.1, 0.2, -1); radius = 0.5; };"},
    {"cylinder = { from = (0, 0, -1); to = (0, 0, 1.5); radius = 0.6; };",
     "cylinder = { from = (0, 0, -0.5); to = (0, 0, 0.75); radius = 0.3; }; scale = 2;"},
    {"cylinder = { from = (0, 0, -1); to = (0, 0, 1); radius = 0.5; };",
     "cylinder = { from = (1, 0, 0); to = (-1, 0, 0); radius = 0.5; }; rotate = (0, 90, 0);"},
    {"cone = { from = (0, 0, -1); to = (0, 0.3, 1); from_radius = 0.9; to_radius = 0.2; };",
     "cone = { from = (0, 0.3, 1); to = (0, 0, -1); from_radius = 0.2; to_radius = 0.9; };"},
    {"ball = { centre = (0.2, 0.1, 0.3); radius = 0.8; };",
     "ellipsoid = { centre = (0.2, 0.1, 0.3); radii = (0.8, 0.8, 0.8); }; "},
    {"ball = { radius = 0.9; };", "ellipsoid = { radii = (0.3, 0.6, 1.8); }; scale = (3, 1.5, "
                                  "0.5);"},
    {"ball = { radius = 0.5; };",
     "quadric = { coefficients = (4, 4, 4, 0, 0, 0, 0, 0, 0, -1.0); };"},
    {"ellipsoid = { radii = (1, 0.5, 0.7); };",
     "ellipsoid = { radii = (0.7, 1, 0.5); }; rotate = (90, 90, 0);"},
    {"hyperboloid = { from = (0, 0, -1); to = (0.2, 0, 1); radius = 0.9; waist = 0.3; };",
     "hyperboloid = { from = (0.2, 0, 1); to = (0, 0, -1); radius = 0.9; waist = 0.3; };"},
    {"hyperboloid = { from = (0, 0, -1); to = (0.2, 0, 1); radius = 0.9; gap = 0.3; };",
     "hyperboloid = { from = (0.2, 0, 1); to = (0, 0, -1); radius = 0.9; gap = 0.3; };"},
    {"paraboloid = { from = (0, 0, -1); to = (0, 0, 1); radius = 0.9; };",
     "paraboloid = { from = (0, -1, 0); to = (0, 1, 0); radius = 0.9; }; rotate = (90, 0, 0);"},
    {"box = { min = (-0.7, -0.5, -0.3); max = (0.6, 0.4, 0.8); };",
     "box = { min = (-0.5, -0.6, -0.3); max = (0.4, 0.7, 0.8); }; rotate = (0, 0, 90);"},
    {"box = { min = (-0.7, -0.5, -0.3); max = (0.7, 0.5, 0.3); };",
     "polyhedron = { planes = ( { normal = (1, 0, 0); offset = 0.7; },"
     " { normal = (0, -2, 0); offset = 1; }, { normal = (0, 0, 1); offset = 0.3; },"
     " { normal = (-1, 0, 0); offset = 0.7; }, { normal = (0, 3, 0); offset = 1.5; },"
     " { normal = (0, 0, -1); offset = 0.3; } ); };"},
};
enum { PAIRS = sizeof pairs / sizeof pairs[0] };

/* A solid that another one, of the same curved surface, holds to the last point. */
static const char *const within[][2] = {
    {"cylinder = { from = (0, 0, -1); to = (0, 0, 1); radius = 0.5; };",
     "cylinder = { from = (0, 0, -2); to = (0, 0, 2); radius = 0.5; };"},
    {"cylinder = { from = (0.1, 0.2, -1); to = (0.3, 0, 1); radius = 0.5; };",
     "cylinder = { from = (0.4, -0.1, 2); to = (0, 0.3, -2); radius = 0.5; };"},
    {"cone = { from = (0, 0, -0.5); to = (0, 0, 0.5); from_radius = 0.75; to_radius = 0.25; };",
     "cone = { from = (0, 0, 1); to = (0, 0, -1); from_radius = 0; to_radius = 1; };"},
    {"paraboloid = { from = (0, 0, -1); to = (0, 0, 0); radius = 0.5; };",
     "paraboloid = { from = (0, 0, -1); to = (0, 0, 3); radius = 1; };"},
    {"intersection = ( { half_space = { normal = (0, 1, 0); offset = 0.5; }; }, { half_space = {"
     " normal = (0, -1, 0); offset = 0.5; }; }, { ball = { radius = 0.9; }; } );",
     "intersection = ( { quadric = { coefficients = (0, 4, 0, 0, 0, 0, 0, 0, 0, -1.0); }; }, "
     "{ ball = { radius = 0.9; }; } );"},
    {"difference = ( { ball = { radius = 0.9; }; }, { quadric = { coefficients = (0, 0, -4, 0, 0, "
     "0, 0, 0, 0, 1.0); }; } );",
     "intersection = ( { ball = { radius = 0.9; }; }, { half_space = { normal = (0, 0, 1); offset "
     "= "
     "0.5; }; }, { half_space = { normal = (0, 0, -1); offset = 0.5; }; } );"},
};
enum { WITHIN = sizeof within / sizeof within[0] };

/* Placements of a pair as a whole. */
enum { PLACEMENTS = 12 };

static void draw_placement(char *text, size_t size, int number) {
    uint64_t seed = 7001 + (uint64_t)number;
    double v[9];
    for (int i = 0; i < 9; i++) {
        v[i] = random_between(&seed, 0, 1);
    }
    if (number == 0) {
        snprintf(text, size, "%s", "");
    } else {
        snprintf(text, size,
                 "scale = (%.3f, %.3f, %.3f); rotate = (%.17g, %.17g, %.17g); "
                 "translate = (%.3f, %.3f, %.3f);",
                 number % 3 == 0 ? 1 : 0.7 + v[0], number % 3 == 0 ? 1 : 0.7 + v[1],
                 number % 3 == 0 ? 1 : 0.7 + v[2], 360 * v[3], 360 * v[4], 360 * v[5], v[6] - 0.5,
                 v[7] - 0.5, v[8] - 0.5);
    }
}

static void write_pair(char *text, const char *operation, const char *const pair[2],
                       int placement) {
    char place[512];
    draw_placement(place, sizeof place, placement);
    snprintf(text, SOLID_SIZE, "{ %s = ( { %s }, { %s } ); %s }", operation, pair[0], pair[1],
             place);
}

static void write_one(char *text, const char *solid, int placement) {
    char place[512];
    draw_placement(place, sizeof place, placement);
    snprintf(text, SOLID_SIZE, "{ union = ( { %s } ); %s }", solid, place);
}

static void two_ways_to_write_a_solid_have_the_same_surfaces(void **state) {
    (void)state;
    for (int i = 0; i < PAIRS; i++) {
        for (int j = 0; j < PLACEMENTS; j++) {
            char both[SOLID_SIZE], one[SOLID_SIZE];
            write_pair(both, "union", pairs[i], j);
            write_one(one, pairs[i][0], j);
            if (surfaces_of(both) != surfaces_of(one)) {
                fail_msg("%d and %d surfaces of\n%s", surfaces_of(one), surfaces_of(both), both);
            }
        }
    }
}

static void a_solid_less_the_same_in_other_words_is_nothing(void **state) {
    (void)state;
    static const char *const arithmetics[] = {"fx", "f32", "f64", "f128"};
    for (int i = 0; i < PAIRS + WITHIN; i++) {
        const char *const *pair = i < PAIRS ? pairs[i] : within[i - PAIRS];
        for (int j = 0; j < PLACEMENTS; j++) {
            char less[SOLID_SIZE], one[SOLID_SIZE];
            const char *arithmetic = arithmetics[(i + j) % 4];
            write_pair(less, "difference", pair, j);
            write_one(one, pair[0], j);
            int count = seen(less, arithmetic);
            if (count != 0) {
                fail_msg("%d pixels in %s of\n%s", count, arithmetic, less);
            }
            assert_true(seen(one, arithmetic) > 5);
        }
    }
}

static void the_other_side_of_a_surface_has_nothing_in_common_with_it(void **state) {
    (void)state;
    static const char *const sides[][2] = {
        {"ball = { radius = 0.5; };",
         "quadric = { coefficients = (-4, -4, -4, 0, 0, 0, 0, 0, 0, 1.0); };"},
        {"quadric = { coefficients = (-4, -4, -4, 0, 0, 0, 0, 0, 0, 1.0); };",
         "ellipsoid = { radii = (0.5, 0.5, 0.5); };"},
        {"cylinder = { from = (0, 0, -1); to = (0, 0, 1); radius = 0.5; };",
         "quadric = { coefficients = (-4, -4, 0, 0, 0, 0, 0, 0, 0, 1.0); };"},
    };
    for (size_t i = 0; i < sizeof sides / sizeof sides[0]; i++) {
        for (int j = 0; j < PLACEMENTS; j++) {
            char both[SOLID_SIZE];
            write_pair(both, "intersection", sides[i], j);
            assert_int_equal(seen(both, (i + (size_t)j) % 2 ? "fx" : "f128"), 0);
        }
    }
}

/* Glass that goes on beyond a face has no face there: a beam through it keeps its way. */
static void a_seam_between_solids_written_differently_is_no_boundary(void **state) {
    (void)state;
    static const char *const joined[][2] = {
        {"cylinder = { from = (0, 0, 0); to = (0, 0, -1); radius = 0.4; };",
         "box = { min = (-0.6, -0.6, 0); max = (0.6, 0.6, 0.5); };"},
        {"cone = { from = (0, 0, 0.5); to = (0, 0, -1); from_radius = 0.2; to_radius = 0.5; };",
         "polyhedron = { planes = ( { normal = (0, 0, -1); offset = -0.5; },"
         " { normal = (0, 0, 1); offset = 0.9; }, { normal = (1, 0, 0); offset = 0.5; },"
         " { normal = (-1, 0, 0); offset = 0.5; }, { normal = (0, 1, 0); offset = 0.5; },"
         " { normal = (0, -1, 0); offset = 0.5; } ); };"}};
    for (size_t i = 0; i < 2; i++) {
        for (int j = 0; j < PLACEMENTS; j++) {
            char both[SOLID_SIZE], upper[SOLID_SIZE], lower[SOLID_SIZE];
            write_pair(both, "union", joined[i], j);
            write_one(upper, joined[i][0], j);
            write_one(lower, joined[i][1], j);
            assert_int_equal(surfaces_of(both), surfaces_of(upper) + surfaces_of(lower) - 1);
        }
    }
}

static void surfaces_that_differ_by_little_stay_two(void **state) {
    (void)state;
    static const char *const near[][2] = {
        {"cylinder = { from = (0, 0, -1); to = (0, 0, 1); radius = 0.5; };",
         "cylinder = { from = (0, 0, -1); to = (0, 0, 1); radius = 0.50000000001; };"},
        {"cylinder = { from = (0, 0, -1); to = (0, 0, 1); radius = 0.5; };",
         "cylinder = { from = (0, 0, -1); to = (0.0000000001, 0, 1); radius = 0.5; };"},
        {"cone = { from = (0, 0, -1); to = (0, 0, 1); from_radius = 1; to_radius = 0.5; };",
         "cone = { from = (0, 0, -1); to = (0, 0, 1); from_radius = 1; to_radius = 0.5000000001; "
         "};"},
        {"ellipsoid = { radii = (1, 0.5, 0.7); };",
         "ellipsoid = { radii = (1, 0.5, 0.7000000001); };"},
        {"ball = { radius = 0.5; };", "ball = { centre = (0.0000000001, 0, 0); radius = 0.5; };"},
        {"box = { min = (-1, -1, -1); max = (1, 1, 1); };",
         "box = { min = (-1, -1, -1); max = (1, 1, 1); }; rotate = (0, 0, 0.00000001);"},
    };
    for (size_t i = 0; i < sizeof near / sizeof near[0]; i++) {
        for (int j = 0; j < PLACEMENTS; j++) {
            char both[SOLID_SIZE], one[SOLID_SIZE];
            write_pair(both, "union", near[i], j);
            write_one(one, near[i][0], j);
            assert_true(surfaces_of(both) > surfaces_of(one));
        }
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(two_ways_to_write_a_solid_have_the_same_surfaces),
        cmocka_unit_test(a_solid_less_the_same_in_other_words_is_nothing),
        cmocka_unit_test(the_other_side_of_a_surface_has_nothing_in_common_with_it),
        cmocka_unit_test(a_seam_between_solids_written_differently_is_no_boundary),
        cmocka_unit_test(surfaces_that_differ_by_little_stay_two),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
