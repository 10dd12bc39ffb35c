/* SPDX-License-Identifier: MIT */
/* Views, placements and numbers of solids at the ends of what a scene file may say. */
#include "extremes_fixture.h"

static const char head[] =
    "version = 1; size = [%d, %d]; depth = 6; background = [30, 60, 90];\n"
    "camera = { eye = (0, -12, 3); look_at = (0, 0, 0.4); field_of_view = %g; };\n"
    "lights = ( { direction = (1, 2, -3); } );\n"
    "materials = { glass = { colour = [20, 40, 30]; diffuse = 0.4; ior = 1.5; };\n"
    "  chalk = { colour = [200, 190, 180]; diffuse = 0.7; ambient = 0.2; };\n"
    "  floor = { colour = [180, 180, 180]; diffuse = 0.8;\n"
    "            pattern = { size = (1.3, 1.7, 0); colour = [40, 20, 60]; }; }; };\n"
    "objects = ( { material = \"floor\"; solid = { box = { min = (-9, -9, -2); max = (9, 9, -1.5); "
    "}; }; },\n";

static void make_scene(char *text, int width, int height, double view, const char *objects) {
    int used = snprintf(text, EXTREME_TEXT_SIZE, head, width, height, view);
    (void)snprintf(text + used, EXTREME_TEXT_SIZE - (size_t)used, "%s );\n", objects);
}

static void the_narrowest_and_the_widest_view_are_f128s(void **state) {
    (void)state;
    static const double views[] = {1, 40, 170};
    for (size_t i = 0; i < sizeof views / sizeof views[0]; i++) {
        char text[EXTREME_TEXT_SIZE];
        make_scene(text, 40, 25, views[i],
                   "{ material = \"glass\"; solid = { ball = { centre = (0, 0, 0.4); radius = 0.1; "
                   "}; }; },\n{ material = \"chalk\"; solid = { box = { min = (1, -1, -1); max = "
                   "(3, 2, 1); }; rotate = [10, 20, 30]; }; }");
        check_against_f128(text);
    }
}

/* The pitch of pixels is up to 23 times the way to the picture's middle. */
static void few_pixels_in_a_wide_view_are_f128s(void **state) {
    (void)state;
    static const int sizes[][2] = {{1, 1}, {2, 2}, {4, 4}, {3, 40}, {9, 2}};
    for (size_t i = 0; i < sizeof sizes / sizeof sizes[0]; i++) {
        char text[EXTREME_TEXT_SIZE];
        make_scene(text, sizes[i][0], sizes[i][1], 170,
                   "{ material = \"chalk\"; solid = { box = { min = (-8, -15, -7); max = (8, 9, "
                   "-6); }; }; },\n{ material = \"glass\"; solid = { ball = { centre = (1, -8, 7); "
                   "radius = 3; }; }; }");
        check_against_f128(text);
    }
}

/* Up to 1,000 times as long as wide. The coefficients of a quadric are of its shortest axis' size:
 * of the longest one's there are few bits left, and its edge is a little off. */
static void squeezed_solids_are_f128s(void **state) {
    (void)state;
    static const char *const scales[] = {"(1, 1, 0.001)", "(0.002, 1, 2)", "(2, 0.01, 0.5)"};
    static const char *const kinds[] = {
        "ball = { radius = 1; }", "box = { min = (-1, -1, -1); max = (1, 1, 1); }",
        "cylinder = { from = (0, 0, -1); to = (0, 0, 1); radius = 1; }",
        "cone = { from = (0, 0, -1); to = (0, 0, 1); from_radius = 1; }"};
    static struct picture expected, found;
    for (size_t i = 0; i < 12; i++) {
        char text[EXTREME_TEXT_SIZE], object[512];
        (void)snprintf(object, sizeof object,
                       "{ material = \"glass\"; solid = { %s; scale = %s; rotate = [20, 30, 40]; "
                       "translate = (0, 0, 0.5); }; }",
                       kinds[i % 4], scales[i / 4]);
        make_scene(text, 40, 25, 25, object);
        render_text(&expected, text, "f128");
        for (int j = 0; j < EXTREME_ARITHMETICS; j++) {
            render_text(&found, text, extreme_arithmetics[j]);
            assert_pictures_agree(&found, &expected, j == F64 ? 0 : 3, extreme_arithmetics[j]);
        }
    }
}

/* Scaled by -1 along x, a solid is its own mirror image: the same as turned and mirrored by hand.
 */
static void a_mirrored_solid_is_the_mirror_image(void **state) {
    (void)state;
    static struct picture mirrored, expected;
    char text[EXTREME_TEXT_SIZE];
    for (int i = 0; i < EXTREME_ARITHMETICS; i++) {
        make_scene(text, 40, 25, 25,
                   "{ material = \"chalk\"; solid = { union = ( { box = { min = (0, 0, 0); max = "
                   "(2, 1, 0.5); }; }, { cone = { from = (1, 0, 0); to = (2, 0, 2); from_radius = "
                   "0.6; }; } ); scale = [-1, 1, 1]; }; }");
        render_text(&mirrored, text, extreme_arithmetics[i]);
        make_scene(text, 40, 25, 25,
                   "{ material = \"chalk\"; solid = { union = ( { box = { min = (-2, 0, 0); max = "
                   "(0, 1, 0.5); }; }, { cone = { from = (-1, 0, 0); to = (-2, 0, 2); from_radius "
                   "= 0.6; }; } ); }; }");
        render_text(&expected, text, extreme_arithmetics[i]);
        assert_pictures_agree(&mirrored, &expected, 0, extreme_arithmetics[i]);
        assert_true(pixels_unlike_first(&mirrored) > 50);
    }
}

/* Solids that hold no point: they are seen nowhere, and no ray stays in them. */
static void what_is_empty_is_not_seen(void **state) {
    (void)state;
    static const char *const empty[] = {
        "intersection = ( { ball = { radius = 1; }; }, { ball = { centre = (0, 0, 3); radius = 1; "
        "}; } )",
        "difference = ( { ball = { radius = 1; }; }, { ball = { radius = 1.5; }; } )",
        "intersection = ( { box = { min = (-1, -1, -1); max = (0, 1, 1); }; }, { box = { min = "
        "(0, -1, -1); max = (1, 1, 1); }; } )"};
    static struct picture with, without;
    for (size_t i = 0; i < sizeof empty / sizeof empty[0]; i++) {
        for (int j = 0; j < EXTREME_ARITHMETICS; j++) {
            char text[EXTREME_TEXT_SIZE], object[512];
            (void)snprintf(object, sizeof object, "{ material = \"glass\"; solid = { %s; }; }",
                           empty[i]);
            make_scene(text, 40, 25, 40, object);
            render_text(&with, text, extreme_arithmetics[j]);
            make_scene(text, 40, 25, 40,
                       "{ material = \"chalk\"; solid = { box = { min = (8, 8, -1.9); max = (8.5, "
                       "8.5, -1.8); }; }; }");
            render_text(&without, text, extreme_arithmetics[j]);
            assert_pictures_agree(&with, &without, 0, extreme_arithmetics[j]);
        }
    }
}

/* Writes so many balls over a floor. */
static void make_many(char *text, int balls) {
    char objects[EXTREME_TEXT_SIZE / 2];
    size_t used = 0;
    for (int i = 0; i < balls; i++) {
        used += (size_t)snprintf(objects + used, sizeof objects - used,
                                 "%s{ material = \"%s\"; solid = { ball = { centre = (%d, %d, 0); "
                                 "radius = 0.45; }; }; }",
                                 i ? ",\n" : "", i % 2 ? "glass" : "chalk", i % 8 - 4, i / 8 - 4);
    }
    make_scene(text, 32, 20, 50, objects);
}

static void a_crowd_is_f128s_whether_sets_are_bits_or_lists(void **state) {
    (void)state;
    static const int balls[] = {31, 32, COMPILED_BITS_MOST - 1, COMPILED_BITS_MOST, 80};
    char text[EXTREME_TEXT_SIZE];
    for (size_t i = 0; i < sizeof balls / sizeof balls[0]; i++) {
        make_many(text, balls[i]);
        check_against_f128(text);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_narrowest_and_the_widest_view_are_f128s),
        cmocka_unit_test(few_pixels_in_a_wide_view_are_f128s),
        cmocka_unit_test(squeezed_solids_are_f128s),
        cmocka_unit_test(a_mirrored_solid_is_the_mirror_image),
        cmocka_unit_test(what_is_empty_is_not_seen),
        cmocka_unit_test(a_crowd_is_f128s_whether_sets_are_bits_or_lists),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
