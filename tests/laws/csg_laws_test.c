/* SPDX-License-Identifier: MIT */
/* Laws of constructive solid geometry, held on pictures: what is the same solid looks the same. */
#include "scene_fixture.h"

/* Every scene is seen by the same camera and light, over a striped board; one object of glass or of
 * an opaque material is put in. With the light as high as the board is deep the scene's middle is
 * the origin. */
static const char scene_head[] =
    "version = 1; size = [40, 25]; depth = 8;\n"
    "camera = { eye = (3.1, -7.3, 5.2); look_at = (0.0, 0.0, 0.7); field_of_view = 34; "
    "};\n" SCENE_LIGHT_AND_MATERIALS "objects = (\n"
    "  { material = \"board\"; solid = { box = { min = (-9, -9, -9); max = (9, 9, -1.7); }; }; }";

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

/* Solids of which the scene lies wholly within, or wholly outside: radius, and how far away. */
static void a_curve_that_does_not_come_near_holds_all_or_nothing(void **state) {
    static const char *const kinds[] = {
        "{ ball = { centre = (%g, 0, 0); radius = %g; }; }",
        "{ ellipsoid = { centre = (%g, 0, 0); radii = (%g, 9999, 7777); }; }",
        "{ cylinder = { from = (%1$g, 0, -5000); to = (%1$g, 0, 6000); radius = %2$g; }; }",
        "{ cone = { from = (%1$g, 0, -5000); to = (%1$g, 0, 25000); from_radius = %2$g; to_radius "
        "= "
        "3; }; }",
    };
    static const struct {
        double away, radius;
        bool holds_all;
    } cases[] = {{0, 300, true},     {0, 2e4, true},     {77, 300, true},  {-1e5, 2e5, true},
                 {1000, 400, false}, {-2e4, 400, false}, {1e5, 4e4, false}};
    (void)state;
    for (unsigned k = 0; k < sizeof kinds / sizeof kinds[0]; k++) {
        for (unsigned i = 0; i < sizeof cases / sizeof cases[0]; i++) {
            char plain[TEXT_SIZE], cut[TEXT_SIZE], far[512], solid[1024];
            const char *near = solids[(k + i) % 4];
            (void)snprintf(far, sizeof far, kinds[k], cases[i].away, cases[i].radius);
            (void)snprintf(solid, sizeof solid, "{ %s = ( %s, %s ); }",
                           cases[i].holds_all ? "intersection" : "difference", near, far);
            make_scene(plain, "glass", near);
            make_scene(cut, "glass", solid);
            for (int j = 0; j < ARITHMETICS; j++) {
                assert_true(same_picture(plain, cut, arithmetics[j], 0) > 20);
            }
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

/* ---- Quadrics without an end ----------------------------------------------------------------- */

/* Rods and slabs along each axis: as a quadric, and as a solid that ends beyond whatever cuts it.
 */
static const char *const endless[][2] = {
    {"{ quadric = { coefficients = (0, 1, 1, 0, 0, 0, 0, 0, 0, -0.25); }; }",
     "{ cylinder = { from = (-12, 0, 0); to = (12, 0, 0); radius = 0.5; }; }"},
    {"{ quadric = { coefficients = (1, 0, 1, 0, 0, 0, 0, 0, 0, -0.25); }; }",
     "{ cylinder = { from = (0, -12, 0); to = (0, 12, 0); radius = 0.5; }; }"},
    {"{ quadric = { coefficients = (1, 1, 0, 0, 0, 0, 0, 0, 0, -0.25); }; }",
     "{ cylinder = { from = (0, 0, -12); to = (0, 0, 12); radius = 0.5; }; }"},
    {"{ quadric = { coefficients = (1, 0, 0, 0, 0, 0, 0, 0, 0, -0.16); }; }",
     "{ box = { min = (-0.4, -12, -12); max = (0.4, 12, 12); }; }"},
    {"{ quadric = { coefficients = (0, 1, 0, 0, 0, 0, 0, 0, 0, -0.16); }; }",
     "{ box = { min = (-12, -0.4, -12); max = (12, 0.4, 12); }; }"},
    {"{ quadric = { coefficients = (0, 0, 1, 0, 0, 0, 0, 0, 0, -0.16); }; }",
     "{ box = { min = (-12, -12, -0.4); max = (12, 12, 0.4); }; }"},
};
enum { ENDLESS = sizeof endless / sizeof endless[0] };

/* Walls around all that is looked at, eye and light among it: a second object. */
#define ROOM                                                                                       \
    "; }, { material = \"board\"; solid = { difference = ("                                        \
    " { box = { min = (-11, -11, -11); max = (11, 11, 11); }; },"                                  \
    " { box = { min = (-10, -10, -10); max = (10, 10, 10); }; } ); }"

/* Each operation of one with a box or a ball, in each place: before, the rod or slab; behind it,
 * what is done with it. What has no end has to be opaque, and is seen up to the walls. */
static const struct use {
    const char *material, *before, *behind;
} uses[] = {
    {"glass", "{ intersection = ( " BOX ", ", " ); }"},
    {"glass", "{ intersection = ( ", ", " BALL " ); }"},
    {"glass", "{ difference = ( " BOX ", ", " ); }"},
    {"glass", "{ difference = ( { intersection = ( " WORLD ", ", " ); }, " BALL " ); }"},
    {"glass", "{ union = ( " BALL ", { intersection = ( ", ", " BOX " ); } ); }"},
    {"clay", "{ union = ( " BOX ", ", " ); }" ROOM},
    {"clay", "{ union = ( ", ", " BALL " ); }" ROOM},
    {"clay", "{ difference = ( ", ", " BALL " ); }" ROOM},
    {"clay", "{ intersection = ( ",
     ", { union = ( " BOX ", { half_space = { normal = (1, 2, 2);"
     " offset = 0.1; }; } ); } ); }" ROOM},
};
enum { USES = sizeof uses / sizeof uses[0] };

static const char *const places[] = {"", "rotate = (20, 30, 40); translate = (0.2, 0.1, 0.3);",
                                     "scale = (0.7, 1.2, 0.9); translate = (-0.3, 0.2, 0.1);"};
enum { PLACES = sizeof places / sizeof places[0] };

static void a_quadric_without_an_end_looks_like_a_solid_that_ends_far_away(void **state) {
    (void)state;
    for (int i = 0; i < ENDLESS * USES * PLACES; i++) {
        const struct use *use = &uses[i / PLACES % USES];
        char text[2][TEXT_SIZE];
        for (int j = 0; j < 2; j++) {
            char placed[512], solid[2048];
            snprintf(placed, sizeof placed, "{ union = ( %s ); %s }", endless[i / PLACES / USES][j],
                     places[i % PLACES]);
            snprintf(solid, sizeof solid, "%s%s%s", use->before, placed, use->behind);
            make_scene(text[j], use->material, solid);
        }
        assert_true(same_picture(text[0], text[1], "f64", 1e-6) > 20);
    }
}

/* ---- Within and across convex quadrics ------------------------------------------------------- */

static const char *const convex[] = {
    "{ ellipsoid = { radii = (1.1, 0.7, 0.9); }; }",
    "{ cylinder = { from = (0, -1, 0); to = (0, 1, 0); radius = 0.8; }; }",
    "{ paraboloid = { from = (0, 0, 1.3); to = (0, 0, -0.7); radius = 1.1; }; }",
    "{ quadric = { coefficients = (1.0, 2.0, 1.5, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -1.0); }; }",
};
enum { CONVEX = sizeof convex / sizeof convex[0] };

/* A small box and its halves, in the unit of the quadric's own radii. */
#define SMALL_BOX "{ box = { min = (-0.3, -0.3, -0.2); max = (0.3, 0.3, 0.2); }; }"
#define SMALL_HALVES                                                                               \
    "{ union = ( { box = { min = (-0.3, -0.3, -0.2); max = (0.1, 0.3, 0.2); }; },"                 \
    " { box = { min = (0.1, -0.3, -0.2); max = (0.3, 0.3, 0.2); }; } ); }"

/* Within, across each face, and beside. */
static const double offsets[][3] = {{0, 0, 0.1},    {0.9, 0, 0},  {-0.9, 0, 0},   {0, 0.7, 0.1},
                                    {0, -0.7, 0.1}, {0, 0, 0.85}, {0.2, 0, -0.8}, {1.3, 1.1, 0}};
enum { OFFSETS = sizeof offsets / sizeof offsets[0] };

#define OUTSIDE(solid) "{ difference = ( " WORLD ", " solid " ); }"

/* What two solids make of each other, and the same by De Morgan's laws; %s is the one that comes
 * first in both. */
static const struct law {
    const char *plain, *inverted;
    bool quadric_first;
} laws[] = {
    {"{ union = ( %s, %s ); }",
     OUTSIDE("{ intersection = ( " OUTSIDE("%s") ", " OUTSIDE("%s") " ); }"), true},
    {"{ union = ( %s, %s ); }",
     OUTSIDE("{ intersection = ( " OUTSIDE("%s") ", " OUTSIDE("%s") " ); }"), false},
    {"{ intersection = ( %s, %s ); }",
     OUTSIDE("{ union = ( " OUTSIDE("%s") ", " OUTSIDE("%s") " ); }"), true},
    {"{ difference = ( %s, %s ); }", "{ intersection = ( %s, " OUTSIDE("%s") " ); }", true},
    {"{ difference = ( %s, %s ); }", "{ intersection = ( %s, " OUTSIDE("%s") " ); }", false},
};
enum { LAWS = sizeof laws / sizeof laws[0] };

/* The quadric at one of some places, none of which is the scene's middle. */
static void write_law(char text[TEXT_SIZE], int number, bool inverted) {
    static const double centres[][3] = {{0.4, 0.1, 0.2}, {-0.2, 0.3, 0.1}, {0.1, -0.3, 0.4}};
    const struct law *law = &laws[number % LAWS];
    const double *offset = offsets[number / LAWS % OFFSETS], *centre = centres[number % 3];
    char outer[512], inner[1024], solid[TEXT_SIZE - 2048];
    snprintf(outer, sizeof outer, "{ union = ( %s ); translate = (%g, %g, %g); }",
             convex[number / LAWS / OFFSETS], centre[0], centre[1], centre[2]);
    snprintf(inner, sizeof inner, "{ union = ( %s ); translate = (%g, %g, %g); }",
             inverted ? SMALL_HALVES : SMALL_BOX, centre[0] + offset[0], centre[1] + offset[1],
             centre[2] + offset[2]);
    snprintf(solid, sizeof solid, inverted ? law->inverted : law->plain,
             law->quadric_first ? outer : inner, law->quadric_first ? inner : outer);
    make_scene(text, "glass", solid);
}

static void solids_around_a_convex_quadric_obey_the_laws_wherever_it_is(void **state) {
    (void)state;
    int seen = 0;
    for (int i = 0; i < CONVEX * OFFSETS * LAWS; i++) {
        char plain[TEXT_SIZE], inverted[TEXT_SIZE];
        write_law(plain, i, false);
        write_law(inverted, i, true);
        seen += same_picture(plain, inverted, "f64", 1e-6) > 5;
    }
    assert_true(seen > CONVEX * OFFSETS * LAWS / 2);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_solid_less_itself_is_empty),
        cmocka_unit_test(union_and_intersection_with_itself_change_nothing),
        cmocka_unit_test(de_morgan_holds_for_random_trees),
        cmocka_unit_test(a_seam_between_coplanar_parts_of_a_union_does_not_show),
        cmocka_unit_test(the_halves_of_a_polyhedron_are_the_whole),
        cmocka_unit_test(a_curve_that_does_not_come_near_holds_all_or_nothing),
        cmocka_unit_test(a_placement_can_be_said_in_two_ways),
        cmocka_unit_test(a_quadric_without_an_end_looks_like_a_solid_that_ends_far_away),
        cmocka_unit_test(solids_around_a_convex_quadric_obey_the_laws_wherever_it_is),
        cmocka_unit_test(a_later_object_fills_the_place_of_an_earlier_one),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
