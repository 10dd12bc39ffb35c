/* SPDX-License-Identifier: MIT */
/* Laws of constructive solid geometry, held on pictures: what is the same solid looks the same. */
#include "scene_fixture.h"

/* Every scene is seen by the same camera and light, over a striped board; one object of glass or of
 * an opaque material is put in. */
static const char scene_head[] =
    "version = 1; size = [40, 25]; depth = 8;\n"
    "camera = { eye = (3.1, -7.3, 5.2); look_at = (0.0, 0.0, 0.7); field_of_view = 34; "
    "};\n" SCENE_LIGHT_AND_MATERIALS "objects = (\n"
    "  { material = \"board\"; solid = { box = { min = (-9, -9, -2); max = (9, 9, -1.7); }; }; }";

enum { TEXT_SIZE = 16384 };

static void make_scene(char *text, const char *material, const char *solid) {
    if (solid[0]) {
        snprintf(text, TEXT_SIZE, "%s,\n  { material = \"%s\"; solid = %s; }\n);\n", scene_head,
                 material, solid);
    } else {
        snprintf(text, TEXT_SIZE, "%s\n);\n", scene_head);
    }
}

/* Fails unless two scenes give the same intensities, to the last bit, at every pixel. The number of
 * pixels that differ from the bare board, so that a test can tell that it saw something. */
static int same_picture(const char *text_a, const char *text_b, const char *arithmetic,
                        double tolerance) {
    char bare[TEXT_SIZE];
    make_scene(bare, "", "");
    struct loaded_scene a = load_text(text_a, arithmetic), b = load_text(text_b, arithmetic);
    struct loaded_scene board = load_text(bare, arithmetic);
    struct render_counts counts = {0};
    int seen = 0;
    for (int y = 0; y < 25; y++) {
        for (int x = 0; x < 40; x++) {
            double left[3], right[3], empty[3];
            bool differs = false;
            a.arithmetic->pixel(a.scene, (uint16_t)x, (uint16_t)y, left, &counts, NULL);
            b.arithmetic->pixel(b.scene, (uint16_t)x, (uint16_t)y, right, &counts, NULL);
            board.arithmetic->pixel(board.scene, (uint16_t)x, (uint16_t)y, empty, &counts, NULL);
            for (int i = 0; i < 3; i++) {
                if (fabs(left[i] - right[i]) > tolerance) {
                    fail_msg("%s: pixel %d %d, channel %d: %.9g and %.9g of\n%s\n%s", arithmetic, x,
                             y, i, left[i], right[i], text_a, text_b);
                }
                differs = differs || fabs(left[i] - empty[i]) > 1;
            }
            seen += differs;
        }
    }
    assert_int_equal(counts.leaked_rays, 0);
    unload(&a);
    unload(&b);
    unload(&board);
    return seen;
}

static const char *const arithmetics[] = {"fx", "f32", "f64"};
enum { ARITHMETICS = 3 };

#define BALL "{ ball = { centre = (0.3, 0.1, 0.5); radius = 1.1; }; }"
#define BOX  "{ box = { min = (-0.9, -0.8, -0.6); max = (1.0, 0.7, 0.9); }; }"
#define CONE "{ cone = { from = (0, 0, -1); to = (0.2, 0.1, 1.6); from_radius = 1.2; }; }"
#define TURNED                                                                                     \
    "{ box = { min = (-0.7, -0.7, -0.7); max = (0.7, 0.7, 0.7); }; rotate = (30, 20, 10);"         \
    " translate = (0.1, 0.2, 0.6); }"
#define WORLD "{ box = { min = (-3, -3, -1.6); max = (3, 3, 3.5); }; }"

static const char *const solids[] = {
    BALL,
    BOX,
    CONE,
    TURNED,
    "{ ellipsoid = { centre = (-0.2, 0.3, 0.6); radii = (1.3, 0.6, 0.9); }; }",
    "{ cylinder = { from = (-1, -0.5, 0); to = (1.1, 0.4, 1.2); radius = 0.6; }; }",
    "{ paraboloid = { from = (0, 0, -0.8); to = (0, 0, 1.4); radius = 1.0; }; }",
    "{ hyperboloid = { from = (0, 0, -1); to = (0, 0, 1.8); radius = 1.0; waist = 0.4; }; }",
    "{ hyperboloid = { from = (0, 0, -1.2); to = (0, 0, 2); radius = 1.0; gap = 0.5; }; }",
    "{ polyhedron = { planes = ( { normal = (0, 0, -1); offset = 0.9; },"
    " { normal = (1, 0, 0.5); offset = 0.8; }, { normal = (-1, 0, 0.5); offset = 0.8; },"
    " { normal = (0, 1, 0.5); offset = 0.8; }, { normal = (0, -1, 0.5); offset = 0.8; } ); }; }",
};
enum { SOLIDS = sizeof solids / sizeof solids[0] };

static void a_solid_less_itself_is_empty(void **state) {
    (void)state;
    for (int i = 0; i < SOLIDS; i++) {
        for (int j = 0; j < ARITHMETICS; j++) {
            char solid[2048], text[TEXT_SIZE], bare[TEXT_SIZE];
            snprintf(solid, sizeof solid, "{ difference = ( %s, %s ); }", solids[i], solids[i]);
            make_scene(text, "glass", solid);
            make_scene(bare, "glass", "");
            same_picture(text, bare, arithmetics[j], 0);
            assert_int_equal(same_picture(text, text, arithmetics[j], 0) > 0, 0);
        }
    }
}

static void union_and_intersection_with_itself_change_nothing(void **state) {
    (void)state;
    for (int i = 0; i < SOLIDS; i++) {
        for (int j = 0; j < ARITHMETICS; j++) {
            char solid[2048], text[TEXT_SIZE], plain[TEXT_SIZE];
            make_scene(plain, "glass", solids[i]);
            snprintf(solid, sizeof solid, "{ union = ( %s, %s ); }", solids[i], solids[i]);
            make_scene(text, "glass", solid);
            assert_true(same_picture(text, plain, arithmetics[j], 0) > 20);
            snprintf(solid, sizeof solid, "{ intersection = ( %s, %s ); }", solids[i], solids[i]);
            make_scene(text, "glass", solid);
            same_picture(text, plain, arithmetics[j], 0);
        }
    }
}

/* A random tree of unions, intersections and differences, and the same within WORLD by De Morgan's
 * laws: where `inverted`, it says WORLD less the tree, with the complements pushed to the leaves.
 */
static size_t random_tree(char *text, size_t size, uint64_t *seed, int depth, bool inverted) {
    uint32_t choice = next_random(seed);
    if (depth == 0) {
        const char *leaf = solids[choice % SOLIDS];
        return (size_t)snprintf(text, size, inverted ? "{ difference = ( " WORLD ", %s ); }" : "%s",
                                leaf);
    }
    const char *names[2] = {"union", "intersection"};
    bool is_union = (choice & 1) != 0;
    size_t used = (size_t)snprintf(text, size, "{ %s = ( ", names[is_union == inverted]);
    used += random_tree(text + used, size - used, seed, depth - 1, inverted);
    used += (size_t)snprintf(text + used, size - used, ", ");
    used += random_tree(text + used, size - used, seed, depth - 1, inverted);
    return used + (size_t)snprintf(text + used, size - used, " ); }");
}

static void de_morgan_holds_for_random_trees(void **state) {
    (void)state;
    int seen = 0;
    for (uint64_t i = 1; i <= 12; i++) {
        char tree[6000], solid[TEXT_SIZE - 2048], plain[TEXT_SIZE], twice[TEXT_SIZE];
        uint64_t seed = 7919 * i;
        random_tree(tree, sizeof tree, &seed, 2, false);
        snprintf(solid, sizeof solid, "{ difference = ( " WORLD ", %s ); }", tree);
        make_scene(plain, "clay", solid);
        seed = 7919 * i;
        random_tree(tree, sizeof tree, &seed, 2, true);
        snprintf(solid, sizeof solid, "{ intersection = ( " WORLD ", %s ); }", tree);
        make_scene(twice, "clay", solid);
        /* The same primitives in another order: ties at edges may go the other way, so f64, where
         * there are none. */
        seen += same_picture(plain, twice, "f64", 1e-9) > 50;
    }
    assert_int_equal(seen, 12);
}

static void a_seam_between_coplanar_parts_of_a_union_does_not_show(void **state) {
    (void)state;
    static const char *const halves[] = {
        "{ union = ( { box = { min = (-1, -1, -1); max = (0.3, 1, 1); }; },"
        " { box = { min = (0.3, -1, -1); max = (1, 1, 1); }; } ); }",
        "{ union = ( { box = { min = (-1, -1, -1); max = (1, 1, 0.1); }; },"
        " { box = { min = (-1, -1, 0.1); max = (1, 1, 1); }; } ); }"};
    for (int i = 0; i < 2; i++) {
        for (int j = 0; j < ARITHMETICS; j++) {
            char text[TEXT_SIZE], whole[TEXT_SIZE];
            make_scene(text, "glass", halves[i]);
            make_scene(whole, "glass", "{ box = { min = (-1, -1, -1); max = (1, 1, 1); }; }");
            assert_true(same_picture(text, whole, arithmetics[j], 0) > 100);
        }
    }
}

/* A cube of planes, and one that cuts it across. */
#define CUBE_PLANES                                                                                \
    "{ normal = (1, 0, 0); offset = 1; }, { normal = (-1, 0, 0); offset = 1; },"                   \
    " { normal = (0, 1, 0); offset = 1; }, { normal = (0, -1, 0); offset = 1; },"                  \
    " { normal = (0, 0, 1); offset = 1; }, { normal = (0, 0, -1); offset = 1; }"
#define POLYHEDRON(planes)   "{ polyhedron = { planes = ( " planes " ); }; }"
#define ACROSS(sign, offset) "{ normal = (" sign "1, " sign "2, " sign "3); offset = " offset "; }"

static void the_halves_of_a_polyhedron_are_the_whole(void **state) {
    (void)state;
    static const char *const halves[] = {
        "{ union = ( " POLYHEDRON(CUBE_PLANES ", " ACROSS("", "0.5")) ", " POLYHEDRON(
            CUBE_PLANES ", " ACROSS("-", "-0.5")) " ); }",
        "{ union = ( " POLYHEDRON(ACROSS("", "0.5") ", " CUBE_PLANES) ", " POLYHEDRON(
            ACROSS("-", "-0.5") ", " CUBE_PLANES) " ); }"};
    for (int i = 0; i < 2; i++) {
        for (int j = 0; j < ARITHMETICS; j++) {
            char text[TEXT_SIZE], whole[TEXT_SIZE];
            make_scene(text, "clay", halves[i]);
            make_scene(whole, "clay", POLYHEDRON(CUBE_PLANES));
            assert_true(same_picture(text, whole, arithmetics[j], j == 2 ? 1e-6 : 1) > 100);
        }
    }
}

static void a_placement_can_be_said_in_two_ways(void **state) {
    (void)state;
    static const char *const pairs[][2] = {
        {"{ box = { min = (-1, -1, -1); max = (1, 1, 1); }; scale = (1, 0.5, 0.7);"
         " translate = (0.2, 0, 0.3); }",
         "{ box = { min = (-0.8, -0.5, -0.4); max = (1.2, 0.5, 1.0); }; }"},
        {"{ ball = { radius = 1; }; scale = (1.2, 0.6, 0.8); translate = (0.1, 0.2, 0.5); }",
         "{ ellipsoid = { centre = (0.1, 0.2, 0.5); radii = (1.2, 0.6, 0.8); }; }"},
        {"{ cylinder = { from = (0, 0, -1); to = (0, 0, 1); radius = 0.5; }; rotate = (0, 90, 0); "
         "}",
         "{ cylinder = { from = (-1, 0, 0); to = (1, 0, 0); radius = 0.5; }; }"},
        {"{ quadric = { coefficients = [1.0, 1.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0, -0.75]; }; }",
         "{ ball = { centre = (0, 0, 0.5); radius = 1; }; }"},
        {"{ box = { min = (-1, -0.6, -0.4); max = (1, 0.6, 0.4); }; rotate = (0, 0, 90); }",
         "{ box = { min = (-0.6, -1, -0.4); max = (0.6, 1, 0.4); }; }"},
    };
    for (size_t i = 0; i < sizeof pairs / sizeof pairs[0]; i++) {
        char left[TEXT_SIZE], right[TEXT_SIZE];
        make_scene(left, "clay", pairs[i][0]);
        make_scene(right, "clay", pairs[i][1]);
        assert_true(same_picture(left, right, "f64", 1e-6) > 50);
    }
}

static void a_later_object_fills_the_place_of_an_earlier_one(void **state) {
    (void)state;
    char inside[TEXT_SIZE], carved[TEXT_SIZE];
    snprintf(inside, sizeof inside,
             "%s,\n { material = \"clay\"; solid = " BOX
             "; }, { material = \"glass\"; solid = " BALL "; } );\n",
             scene_head);
    snprintf(carved, sizeof carved,
             "%s,\n { material = \"clay\"; solid = { difference = ( " BOX ", " BALL
             " ); }; }, { material = \"glass\"; solid = " BALL "; } );\n",
             scene_head);
    for (int j = 0; j < ARITHMETICS; j++) {
        assert_true(same_picture(inside, carved, arithmetics[j], 0) > 50);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_solid_less_itself_is_empty),
        cmocka_unit_test(union_and_intersection_with_itself_change_nothing),
        cmocka_unit_test(de_morgan_holds_for_random_trees),
        cmocka_unit_test(a_seam_between_coplanar_parts_of_a_union_does_not_show),
        cmocka_unit_test(the_halves_of_a_polyhedron_are_the_whole),
        cmocka_unit_test(a_placement_can_be_said_in_two_ways),
        cmocka_unit_test(a_later_object_fills_the_place_of_an_earlier_one),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
