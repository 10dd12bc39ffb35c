/* SPDX-License-Identifier: MIT */
/* Extremes of place: far away, tiny and huge, and eyes where no eye should be. */
#include "extremes_fixture.h"

#include "transformed_scene.h"

#define HEAD(size, camera)                                                                         \
    "version = 1; size = " size "; depth = 8;\n"                                                   \
    "camera = { " camera " };\n"                                                                   \
    "lights = ( { position = (-4.0, -6.0, 9.0); } );\n"                                            \
    "materials = {\n"                                                                              \
    "  board = { colour = [200, 200, 200]; ambient = 0.3; ambient_is_own = true; diffuse = 0.6;\n" \
    "            pattern = { size = (0.7, 0.7, 0); colour = [40, 20, 60]; }; };\n"                 \
    "  glass = { colour = [10, 30, 20]; ambient = 0.4; ambient_is_own = true; diffuse = 0.3;\n"    \
    "            specular = 0.4; gloss = 50; ior = 1.5; absorption = (0.3, 0.1, 0.2); };\n"        \
    "  amber = { colour = [60, 30, 0]; ambient = 0.3; ambient_is_own = true; ior = 1.3; };\n"      \
    "  clay = { colour = [200, 90, 40]; ambient = 0.3; ambient_is_own = true; diffuse = 0.7; };\n" \
    "};\n"

#define BOARD                                                                                      \
    "{ material = \"board\"; solid = { box = { min = (-9, -9, -2); max = (9, 9, -1.7); }; }; }"

static const char everything[] =
    HEAD("[40, 25]", "eye = (3.1, -7.3, 5.2); look_at = (0.0, 0.0, 0.7); field_of_view = "
                     "34;") "objects = ( " BOARD ",\n"
                            "{ material = \"glass\"; solid = { difference = (\n"
                            "  { box = { min = (-1.2, -1.2, -1); max = (1.2, 1.2, 1.4); }; "
                            "},\n"
                            "  { box = { min = (-1, -1, -0.8); max = (1, 1, 1.2); }; } ); "
                            "}; },\n"
                            "{ material = \"amber\"; solid = { ball = { centre = (0, 0.1, "
                            "0.2); radius = 0.6; }; }; },\n"
                            "{ material = \"amber\"; solid = { cone = { from = (2, 0, -1); "
                            "to = (2.1, 0.2, 1);\n"
                            "  from_radius = 0.6; }; }; },\n"
                            "{ material = \"clay\"; solid = { box = { min = (-0.5, -0.5, "
                            "-0.5); max = (0.5, 0.5, 0.5); };\n"
                            "  rotate = (30, 20, 10); translate = (-2.1, 0.3, 0); }; } );\n";

static void the_picture_is_the_same_however_large_and_far(void **state) {
    (void)state;
    static const double places[][2] = {{1e-3, 0}, {1e4, 0}, {1, 1e4}, {1, -1e4}, {1e-3, 10}};
    static struct picture expected, found;
    render_text(&expected, everything, "f128");
    assert_true(pixels_unlike_first(&expected) > 300);
    for (size_t i = 0; i < sizeof places / sizeof places[0]; i++) {
        struct scene_description *description = read_text(everything);
        transform_scene(description, places[i][0], places[i][1]);
        for (int j = 0; j < EXTREME_ARITHMETICS; j++) {
            render_description(&found, description, extreme_arithmetics[j]);
            /* Moved by 1e4 the file's own numbers have lost 13 bits: one pixel may fall to the
             * other side of an edge. */
            assert_pictures_agree(&found, &expected, 1, extreme_arithmetics[j]);
        }
        scene_description_free(description);
    }
}

/* The same numbers written at another place: curved solids have no terms of the file's origin. */
static void solids_written_far_from_the_origin_keep_their_shape(void **state) {
    (void)state;
    static const char format[] =
        "version = 1; size = [40, 25]; depth = 8;\n"
        "camera = { eye = (%.17g, %.17g, %.17g); look_at = (%.17g, %.17g, %.17g);"
        " field_of_view = 34; };\n"
        "materials = { glass = { colour = [10, 30, 20]; ambient = 1; ambient_is_own = true;"
        " ior = 1.5; };\n"
        "board = { colour = [200, 200, 200]; ambient = 1; ambient_is_own = true;"
        " pattern = { size = (0.7, 0.7, 0); origin = (%.17g, %.17g, %.17g);"
        " colour = [40, 20, 60]; }; }; };\n"
        "objects = ( { material = \"board\"; solid = { box = { min = (%.17g, %.17g, %.17g);"
        " max = (%.17g, %.17g, %.17g); }; }; },\n"
        "{ material = \"glass\"; solid = { union = (\n"
        "{ ball = { centre = (%.17g, %.17g, %.17g); radius = 0.7; }; },\n"
        "{ ellipsoid = { centre = (%.17g, %.17g, %.17g); radii = (0.5, 0.7, 0.9); }; },\n"
        "{ cone = { from = (%.17g, %.17g, %.17g); to = (%.17g, %.17g, %.17g); from_radius = 0.8; };"
        " },\n"
        "{ paraboloid = { from = (%.17g, %.17g, %.17g); to = (%.17g, %.17g, %.17g); radius = 0.5; "
        "};"
        " } ); }; } );\n";
    static const double offsets[] = {1e4, -1e6, 1e8};
    static struct picture expected, found;
    for (int i = -1; i < 3; i++) {
        double d = i < 0 ? 0 : offsets[i];
        char text[EXTREME_TEXT_SIZE];
        snprintf(text, sizeof text, format, d + 3, d - 7, d + 5, d, d, d, d, d, d, d - 9, d - 9,
                 d - 2, d + 9, d + 9, d - 1, d - 2, d, d, d - 0.5, d - 0.5, d, d + 1.5, d, d - 1,
                 d + 1.5, d + 0.5, d + 1, d, d + 1, d + 1, d, d + 1, d - 1);
        if (i < 0) {
            render_text(&expected, text, "f128");
            assert_true(pixels_unlike_first(&expected) > 300);
            continue;
        }
        for (int j = 0; j < EXTREME_ARITHMETICS; j++) {
            render_text(&found, text, extreme_arithmetics[j]);
            assert_pictures_agree(&found, &expected, 1, extreme_arithmetics[j]);
        }
    }
}

/* An eye on a face sees what one just in front of it or just behind it sees, and every arithmetic
 * decides alike. */
static void check_eye_at(const char *format, const char *solid, const double on[3],
                         const double out[3]) {
    static struct picture at[EXTREME_ARITHMETICS], before, behind;
    char text[EXTREME_TEXT_SIZE];
    for (int i = 0; i < EXTREME_ARITHMETICS; i++) {
        snprintf(text, sizeof text, format, on[0], on[1], on[2], solid);
        render_text(&at[i], text, extreme_arithmetics[i]);
        assert_pictures_agree(&at[i], &at[0], pixels_allowed(FX, &at[i]), extreme_arithmetics[i]);
    }
    snprintf(text, sizeof text, format, on[0] + 1e-6 * out[0], on[1] + 1e-6 * out[1],
             on[2] + 1e-6 * out[2], solid);
    render_text(&before, text, "f64");
    snprintf(text, sizeof text, format, on[0] - 1e-6 * out[0], on[1] - 1e-6 * out[1],
             on[2] - 1e-6 * out[2], solid);
    render_text(&behind, text, "f64");
    assert_true(pixels_apart(&before, &behind, 1) > 100);
    if (pixels_apart(&at[F64], &before, 1) > 2) {
        assert_pictures_agree(&at[F64], &behind, 2, "f64, as from behind the face");
    }
}

static void an_eye_on_a_face_is_on_one_side_of_it(void **state) {
    (void)state;
    static const char format[] =
        HEAD("[36, 24]", "eye = (%.17g, %.17g, %.17g); look_at = (0.1, 0.2, -0.3); "
                         "field_of_view = 60;") "objects = ( " BOARD
                                                ", { material = \"glass\"; solid = %s; } );\n";
    static const double top[3] = {0.3, -0.2, 1}, up[3] = {0, 0, 1};
    check_eye_at(format, "{ box = { min = (-1, -1, -1); max = (1, 1, 1); }; }", top, up);
    static const double pole[3] = {0.6, 0, 0.8};
    check_eye_at(format, "{ ball = { radius = 1; }; }", pole, pole);
    /* The box turned by 30 degrees about y: its face x = 1 is at (cos, 0, -sin). */
    static const double turned[3] = {0.86602540378443865, 0, -0.5};
    static const char looking_back[] =
        HEAD("[36, 24]", "eye = (%.17g, %.17g, %.17g); look_at = (-1.0, 0.2, -0.5); "
                         "field_of_view = 60;") "objects = ( " BOARD
                                                ", { material = \"glass\"; solid = %s; } );\n";
    check_eye_at(looking_back,
                 "{ box = { min = (-1, -1, -1); max = (1, 1, 1); }; rotate = (0, 30, 0); }", turned,
                 turned);
}

static void an_eye_inside_glass_sees_out(void **state) {
    (void)state;
    static const char format[] =
        HEAD("[30, 20]", "eye = (0.3, -0.4, 0.2); look_at = (1.5, 3.0, -2.0); field_of_view = "
                         "100;") "objects = ( " BOARD
                                 ", { material = \"glass\"; solid = %s; } );\n";
    static const char *const solids[] = {
        "{ box = { min = (-1, -1, -1); max = (1, 1, 1); }; }",
        "{ box = { min = (-1, -1, -1); max = (1, 1, 1); }; rotate = (10, 20, 30); }",
        "{ ball = { radius = 1.2; }; }",
        "{ cylinder = { from = (0, -1, 0); to = (0, 1, 0.3); radius = 1; }; }",
        "{ polyhedron = { planes = ( { normal = (0, 0, -1); offset = 1; },"
        " { normal = (1, 0, 0.5); offset = 0.8; }, { normal = (-1, 0, 0.5); offset = 0.8; },"
        " { normal = (0, 1, 0.5); offset = 0.8; }, { normal = (0, -1, 0.5); offset = 0.8; } ); }; "
        "}",
    };
    for (size_t i = 0; i < sizeof solids / sizeof solids[0]; i++) {
        char text[EXTREME_TEXT_SIZE];
        snprintf(text, sizeof text, format, solids[i]);
        check_against_f128(text);
    }
}

/* Every ray from a ball's centre meets the surface at right angles, goes straight through and comes
 * straight back: 0.96 of the bright world outside arrives at once, the rest after echoes. */
static void an_eye_at_a_balls_centre_looks_straight_out(void **state) {
    (void)state;
    static const char format[] =
        "version = 1; size = [24, 16]; depth = %d; threshold = 0.0; background = [100, 100, 100];"
        "camera = { eye = (0.25, 0.5, 0); look_at = (3, 1, 1); field_of_view = 120; };"
        "materials = { glass = { colour = [0, 0, 0]; ior = 1.5; }; };"
        "objects = ( { material = \"glass\"; solid = { ball = { centre = (0.25, 0.5, 0);"
        " radius = 1; }; }; } );";
    static struct picture found;
    for (int depth = 1; depth <= 3; depth++) {
        char text[2048];
        snprintf(text, sizeof text, format, depth);
        double expected = 100 * (1 - pow(0.04, depth));
        for (int i = 0; i < EXTREME_ARITHMETICS; i++) {
            render_text(&found, text, extreme_arithmetics[i]);
            for (int pixel = 0; pixel < 24 * 16; pixel++) {
                assert_true(fabs(found.level[pixel][1] - expected) < 1e-3);
            }
        }
    }
}

static void a_camera_that_looks_along_up_is_refused(void **state) {
    (void)state;
    static const char objects[] =
        "objects = ( { material = \"clay\"; solid = { ball = { radius = 1; }; }; } );\n";
    char text[EXTREME_TEXT_SIZE];
    snprintf(text, sizeof text, "%s%s",
             HEAD("[4, 4]", "eye = (1, 1, 5); look_at = (1, 1, 0); up = (0, 0, 1);"), objects);
    assert_refused(text, "fx", "test.scene:2:", "looks along 'up'");
    snprintf(text, sizeof text, "%s%s",
             HEAD("[4, 4]", "eye = (0.1, 0.3, 5); look_at = (0.31, 0.37, 5.14); "
                            "up = (-0.3, -0.1, -0.2);"),
             objects);
    assert_refused(text, "fx", "test.scene:2:", "looks along 'up'");
    /* A thousandth of a degree from there is a direction like any other. */
    snprintf(text, sizeof text, "%s%s",
             HEAD("[20, 16]", "eye = (0, 0.0001, 5); look_at = (0, 0, 0); up = (0, 0, 1);"),
             objects);
    check_against_f128(text);
}

/* 1 x 1 is the dot in the middle of any picture with an odd number of rows and columns. */
static void one_dot_and_nearly_all_dots_have_the_same_middle(void **state) {
    (void)state;
    for (int i = 0; i < EXTREME_ARITHMETICS; i++) {
        double one[3], middle[3], corner[3];
        struct render_counts counts;
        memset(&counts, 0, sizeof counts);
        struct scene_description *description = read_text(everything);
        description->width = description->height = 1;
        struct loaded_scene dot = load_description(description, extreme_arithmetics[i]);
        description->width = 639;
        description->height = 399;
        struct loaded_scene large = load_description(description, extreme_arithmetics[i]);
        dot.arithmetic->pixel(dot.scene, 0, 0, one, &counts, NULL);
        large.arithmetic->pixel(large.scene, 319, 199, middle, &counts, NULL);
        large.arithmetic->pixel(large.scene, 638, 398, corner, &counts, NULL);
        assert_memory_equal(one, middle, sizeof one);
        assert_true(fabs(one[0] - corner[0]) > 1);
        assert_int_equal(counts.leaked_rays, 0);
        unload(&dot);
        unload(&large);
        scene_description_free(description);
    }
}

static void a_mirror_symmetric_scene_gives_a_mirror_symmetric_picture(void **state) {
    (void)state;
    static const char text[] =
        HEAD("[48, 32]", "eye = (0, -7.3, 5.2); look_at = (0.0, 0.0, 0.3); field_of_view "
                         "= 40;") "objects = ( { material = \"board\"; solid = { box = { "
                                  "min = (-9, -9, -2); max = (9, 9, "
                                  "-1.7); }; }; },\n"
                                  "{ material = \"glass\"; solid = { difference = (\n"
                                  "  { box = { min = (-1.2, -1.2, -1); max = (1.2, 1.2, "
                                  "1.4); }; },\n"
                                  "  { ball = { centre = (0, 0, 0.2); radius = 0.8; }; } "
                                  "); }; },\n"
                                  "{ material = \"amber\"; solid = { cone = { from = (0, "
                                  "0, -0.3); to = (0, 0.2, 0.8);\n"
                                  "  from_radius = 0.4; }; }; },\n"
                                  "{ material = \"clay\"; solid = { union = ( { ball = { "
                                  "centre = (2, 0, 0); radius = 0.6; };"
                                  " }, { ball = { centre = (-2, 0, 0); radius = 0.6; }; } "
                                  "); }; } );\n";
    static struct picture found;
    for (int i = 0; i < EXTREME_ARITHMETICS; i++) {
        struct scene_description *description = read_text(text);
        description->lights[0].position[0] = 0;
        /* Cells from -0.35 to 0.35: the board is symmetric too. */
        description->materials[0].pattern.origin[0] = -0.35;
        render_description(&found, description, extreme_arithmetics[i]);
        assert_true(pixels_unlike_first(&found) > 300);
        for (int y = 0; y < 32; y++) {
            for (int x = 0; x < 24; x++) {
                const double *left = found.level[48 * y + x];
                const double *right = found.level[48 * y + 47 - x];
                if (memcmp(left, right, sizeof found.level[0]) != 0) {
                    fail_msg("%s: pixel %d %d: %.9g %.9g %.9g, its mirror image %.9g %.9g %.9g",
                             extreme_arithmetics[i], x, y, left[0], left[1], left[2], right[0],
                             right[1], right[2]);
                }
            }
        }
        scene_description_free(description);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_picture_is_the_same_however_large_and_far),
        cmocka_unit_test(solids_written_far_from_the_origin_keep_their_shape),
        cmocka_unit_test(an_eye_on_a_face_is_on_one_side_of_it),
        cmocka_unit_test(an_eye_inside_glass_sees_out),
        cmocka_unit_test(an_eye_at_a_balls_centre_looks_straight_out),
        cmocka_unit_test(a_camera_that_looks_along_up_is_refused),
        cmocka_unit_test(one_dot_and_nearly_all_dots_have_the_same_middle),
        cmocka_unit_test(a_mirror_symmetric_scene_gives_a_mirror_symmetric_picture),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
