/* SPDX-License-Identifier: MIT */
/* Faces that nearly coincide are named, and made one by `weld`; so is an eye inside a solid. */
#include "scene_fixture.h"

#include "render/remarks.h"

enum { TEXT_SIZE = 4096, WIDTH = 40, HEIGHT = 25 };

/* Two blocks of glass, one on the other, with a gap between them, and a turn of the whole. */
static void write_blocks(char *text, double gap, const char *settings, const char *turn) {
    snprintf(text, TEXT_SIZE,
             "version = 1; size = [40, 25]; depth = 6; background = [150, 160, 180];\n"
             "%s\n"
             "camera = { eye = (3, -6, 4); look_at = (0, 0, 0); field_of_view = 30; };\n"
             "lights = ( { direction = (1, 2, -3); } );\n"
             "materials = { g = { colour = [10, 20, 30]; diffuse = 0.5; ior = 1.5; }; };\n"
             "objects = ( { material = \"g\"; solid = { union = (\n"
             "  { box = { min = (-1, -1, -0.7); max = (1, 1, 0); }; },\n"
             "  { cylinder = { from = (0, 0, %.17g); to = (0, 0, 0.8); radius = 0.9; }; } ); %s }; "
             "} );\n",
             settings, gap, turn);
}

static const char *const turns[] = {"", "rotate = (20, 30, 40);",
                                    "scale = (1, 2, 1.5); "
                                    "rotate = (250, 0, 10);"};
enum { TURNS = 3 };

static void faces_that_nearly_coincide_are_named_with_their_distance(void **state) {
    (void)state;
    for (int i = 0; i < TURNS; i++) {
        static const double gaps[] = {1e-6, 3e-7, -2e-6};
        for (int j = 0; j < 3; j++) {
            char text[TEXT_SIZE];
            write_blocks(text, gaps[j], "", turns[i]);
            struct compiled_scene *compiled = compile_text(text);
            double stretch = i == 2 ? 1.5 : 1;
            assert_int_equal(compiled->near_count, 1);
            assert_int_equal(compiled->near[0].line, 7);
            assert_int_equal(compiled->near[0].other_line, 8);
            assert_true(fabs(compiled->near[0].distance - stretch * fabs(gaps[j])) < 1e-9);
            compiled_scene_free(compiled);
        }
    }
}

static void faces_that_coincide_or_are_well_apart_are_not_named(void **state) {
    (void)state;
    for (int i = 0; i < TURNS; i++) {
        static const double gaps[] = {0, 0.01, -0.01};
        for (int j = 0; j < 3; j++) {
            char text[TEXT_SIZE];
            write_blocks(text, gaps[j], "", turns[i]);
            struct compiled_scene *compiled = compile_text(text);
            assert_int_equal(compiled->near_count, 0);
            compiled_scene_free(compiled);
        }
    }
}

static int differing(const char *one, const char *other, const char *arithmetic) {
    struct loaded_scene a = load_text(one, arithmetic), b = load_text(other, arithmetic);
    struct render_counts counts = {0};
    int count = 0;
    for (unsigned y = 0; y < HEIGHT; y++) {
        for (unsigned x = 0; x < WIDTH; x++) {
            int left[3], right[3];
            pixel_levels(&a, x, y, left, &counts);
            pixel_levels(&b, x, y, right, &counts);
            count += abs(left[0] - right[0]) > 1 || abs(left[1] - right[1]) > 1 ||
                     abs(left[2] - right[2]) > 1;
        }
    }
    assert_int_equal(counts.leaked_rays, 0);
    unload(&a);
    unload(&b);
    return count;
}

static void welded_faces_are_as_faces_that_touch(void **state) {
    (void)state;
    static const char *const arithmetics[] = {"fx", "f32", "f64"};
    for (int i = 0; i < TURNS; i++) {
        for (int j = 0; j < 3; j++) {
            char apart[TEXT_SIZE], welded[TEXT_SIZE], touching[TEXT_SIZE];
            write_blocks(apart, 1e-6, "", turns[i]);
            write_blocks(welded, 1e-6, "weld = 2e-6;", turns[i]);
            write_blocks(touching, 0, "", turns[i]);
            assert_int_equal(differing(welded, touching, arithmetics[j]), 0);
            if (j == 2) {
                assert_true(differing(apart, touching, arithmetics[j]) > 20);
            }
        }
    }
}

static void expect_refusal(const char *text, const char *words) {
    struct scene_error error = {""};
    struct scene_description *description = read_text(text);
    struct compiled_scene *compiled = scene_compile(description, &error);
    assert_null(compiled);
    if (strstr(error.text, words) == NULL) {
        fail_msg("not '%s' but '%s'", words, error.text);
    }
    scene_description_free(description);
}

static void a_weld_that_is_too_much_for_the_scene_is_refused(void **state) {
    (void)state;
    char text[TEXT_SIZE];
    write_blocks(text, 0, "weld = 0.01;", "");
    expect_refusal(text, "test.scene: 'weld' is 0.01; at most 0.000");
}

static void a_solid_that_its_weld_makes_flat_is_refused(void **state) {
    (void)state;
    char text[TEXT_SIZE];
    for (int i = 0; i < TURNS; i++) {
        write_blocks(text, 0.8 - 1e-5, "weld = 3e-5;", turns[i]);
        expect_refusal(text, "test.scene:8: a solid thinner than");
    }
    write_blocks(text, 0, "weld = 1e-5;", "scale = (1, 1, 1e-5);");
    expect_refusal(text, "test.scene:7: a solid thinner than");
}

/* An eye at the origin, in or out of what is put there. */
static void write_eye(char *text, const char *material, const char *solid) {
    snprintf(
        text, TEXT_SIZE,
        "version = 1; size = [4, 3]; depth = 2;\n"
        "camera = { eye = (0, 0, 0); look_at = (0, 1, 0); };\n"
        "materials = { %s };\n"
        "objects = ( { material = \"m\"; solid = %s; },\n"
        "  { material = \"m\"; solid = { ball = { centre = (0, 8, 0); radius = 1; }; }; } );\n",
        material, solid);
}

static void an_eye_in_an_opaque_solid_without_an_end_is_refused(void **state) {
    (void)state;
    static const char *const inside[] = {
        "{ half_space = { normal = (5, 0, 1); offset = 5; }; }",
        "{ half_space = { normal = (0, 0, -1); offset = 1; }; }",
        "{ difference = ( { half_space = { normal = (0, 1, 0); offset = 2; }; },"
        " { ball = { centre = (3, 0, 0); radius = 1; }; } ); }"};
    char text[TEXT_SIZE];
    for (int i = 0; i < 3; i++) {
        write_eye(text, "m = { colour = (9, 9, 9); specular = 0.4; };", inside[i]);
        expect_refusal(text, "test.scene:2: the eye is inside the opaque object of line 4");
    }
    /* A bounded one that reaches into the endless one: there is no boundary between them. */
    write_eye(
        text, "m = { colour = (9, 9, 9); specular = 0.4; };",
        "{ box = { min = (-3, -10, -10); max = (3, 10, 10); }; }; },\n"
        "  { material = \"m\"; solid = { half_space = { normal = (1, 0, 0); offset = -2; }; }");
    expect_refusal(text, "test.scene:2: the eye is inside the opaque object of line 4, and that of "
                         "line 5");
    write_eye(text, "m = { colour = (9, 9, 9); specular = 0.4; };",
              "{ half_space = { normal = (5, 0, 1); offset = -5; }; }");
    compiled_scene_free(compile_text(text));
}

static void an_eye_inside_a_solid_is_told(void **state) {
    (void)state;
    static const char *const solids[] = {"{ ball = { radius = 1; }; }",
                                         "{ ball = { centre = (0, 3, 0); radius = 1; }; }"};
    static const char *const materials[] = {"m = { colour = (9, 9, 9); };",
                                            "m = { colour = (9, 9, 9); ior = 1.5; };"};
    static const char *const words[] = {"inside the opaque object of line 4",
                                        "inside the transparent object of line 4"};
    for (int i = 0; i < 4; i++) {
        char text[TEXT_SIZE], remarks[TEXT_SIZE] = "";
        write_eye(text, materials[i / 2], solids[i % 2]);
        struct compiled_scene *compiled = compile_text(text);
        FILE *file = tmpfile();
        assert_non_null(file);
        remarks_print(file, compiled);
        rewind(file);
        size_t length = fread(remarks, 1, sizeof remarks - 1, file);
        (void)fclose(file);
        assert_int_equal(length > 0, i % 2 == 0);
        assert_true(i % 2 == 1 || strstr(remarks, words[i / 2]) != NULL);
        compiled_scene_free(compiled);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(faces_that_nearly_coincide_are_named_with_their_distance),
        cmocka_unit_test(faces_that_coincide_or_are_well_apart_are_not_named),
        cmocka_unit_test(welded_faces_are_as_faces_that_touch),
        cmocka_unit_test(a_weld_that_is_too_much_for_the_scene_is_refused),
        cmocka_unit_test(a_solid_that_its_weld_makes_flat_is_refused),
        cmocka_unit_test(an_eye_in_an_opaque_solid_without_an_end_is_refused),
        cmocka_unit_test(an_eye_inside_a_solid_is_told),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
