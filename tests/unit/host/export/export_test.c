/* SPDX-License-Identifier: MIT */
/* The POV-Ray export: what it writes, how exactly, and what it refuses by name. */
#include "scene_fixture.h"

#include "export/pov.h"

#define HEAD                                                                                       \
    "version = 1; title = \"A title\"; size = [40, 30]; depth = 7; threshold = 0.125;\n"           \
    "background = [51, 0, 255];\n"                                                                 \
    "camera = { eye = (0.1, -7.3, 2.9); look_at = (0.3, 0, 0.7); field_of_view = 33; };\n"         \
    "lights = ( { position = (-4.1, -6.7, 9.3); colour = [255, 51, 0]; },\n"                       \
    "           { direction = (-1, 2, -3); } );\n"
#define MATERIALS                                                                                  \
    "materials = {\n"                                                                              \
    "  clay = { colour = [204, 102, 51]; diffuse = 0.7; specular = 0.25; gloss = 9; };\n"          \
    "  a-glass = { colour = [0, 51, 102]; diffuse = 0.3; ior = 1.5; specular = 0.5; };\n"          \
    "  smoke = { colour = [0, 0, 0]; ior = 1.25; absorption = (0.5, 0, 0.25); };\n"                \
    "};\n"
#define BALL(material, x)                                                                          \
    "{ name = \"" material " ball\"; material = \"" material "\"; solid = { ball = { centre = (" x \
    ", 0, 0); radius = 0.7; }; }; }"

/* A scene and its source; NULL where it is refused. */
struct exported {
    struct scene_description *description;
    struct compiled_scene *scene;
    char *text;
    struct scene_error error;
};

/* After a change of what the scene says. */
static void write_again(struct exported *exported) {
    size_t length = 0;
    free(exported->text);
    FILE *out = open_memstream(&exported->text, &length);
    assert_non_null(out);
    export_pov_write(out, exported->description, exported->scene);
    assert_int_equal(ferror(out), 0);
    assert_int_equal(fclose(out), 0);
}

static struct exported export_text(const char *text) {
    struct exported exported = {read_text(text), NULL, NULL, {""}};
    exported.scene = scene_compile(exported.description, &exported.error);
    if (!exported.scene) {
        fail_msg("not compiled: %s", exported.error.text);
    }
    if (export_pov_check(exported.description, exported.scene, &exported.error)) {
        write_again(&exported);
    }
    return exported;
}

static void discard(struct exported *exported) {
    free(exported->text);
    compiled_scene_free(exported->scene);
    scene_description_free(exported->description);
}

static unsigned occurrences(const char *text, const char *what) {
    unsigned count = 0;
    for (const char *at = strstr(text, what); at; at = strstr(at + 1, what)) {
        count++;
    }
    return count;
}

static void expect(const struct exported *exported, const char *what) {
    if (!exported->text || !strstr(exported->text, what)) {
        fail_msg("\"%s\" is not in:\n%s%s", what, exported->error.text,
                 exported->text ? exported->text : "");
    }
}

/* The number behind `at`, with what separates it from the next one skipped. */
static double next_number(const char **at) {
    char *end;
    *at += strcspn(*at, "-0123456789");
    double number = strtod(*at, &end);
    assert_ptr_not_equal(end, *at);
    *at = end;
    return number;
}

/* Reads back as many numbers behind a word as there are, bit for bit. */
static void expect_numbers(const char *text, const char *word, const double *numbers,
                           size_t count) {
    const char *at = strstr(text, word);
    if (!at) {
        fail_msg("no \"%s\"", word);
        return;
    }
    at += strlen(word);
    for (size_t i = 0; i < count; i++) {
        double number = next_number(&at);
        if (memcmp(&number, &numbers[i], sizeof number) != 0) {
            fail_msg("number %zu behind \"%s\": %a instead of %a", i, word, number, numbers[i]);
        }
    }
}

static void settings_are_those_of_the_scene(void **state) {
    (void)state;
    struct exported scene = export_text(HEAD MATERIALS "objects = ( " BALL("clay", "0") " );");
    expect(&scene, "// A title\n");
    expect(&scene, "#version 3.7;");
    expect(&scene, "assumed_gamma 1.0");
    expect(&scene, "max_trace_level 8 ");
    expect(&scene, "adc_bailout 0.125\n");
    expect(&scene, "+W40 +H30");
    expect_numbers(scene.text, "background { rgb ", (double[]){51.0 / 255, 0, 1}, 3);
    assert_int_equal(occurrences(scene.text, "camera {"), 1);
    assert_int_equal(occurrences(scene.text, "light_source {"), 2);
    assert_int_equal(occurrences(scene.text, "parallel\n"), 1);
    assert_int_equal(occurrences(scene.text, "{"), occurrences(scene.text, "}"));
    discard(&scene);
}

static void a_threshold_of_1_leaves_the_surfaces_visible(void **state) {
    (void)state;
    struct exported scene = export_text(HEAD MATERIALS "objects = ( " BALL("clay", "0") " );");
    scene.scene->threshold = 1;
    write_again(&scene);
    const char *at = strstr(scene.text, "adc_bailout ");
    assert_non_null(at);
    double bailout = next_number(&at);
    assert_true(bailout < 1 && bailout > 0.999999);
    discard(&scene);
}

static void numbers_read_back_are_the_same_doubles(void **state) {
    (void)state;
    struct exported scene = export_text(HEAD MATERIALS "objects = ( " BALL(
        "clay",
        "0.3") ",\n"
               "  { material = \"clay\"; solid = { box = { min = (-3.3, 1.1, 0); max = (-2.1, 1.7, "
               "1.3); };\n"
               "    rotate = (10, 20, 30); }; },\n"
               "  { material = \"clay\"; solid = { ellipsoid = { radii = (0.3, 0.7, 1.1); };\n"
               "    rotate = (10, 20, 30); translate = (3.1, 0, 0); }; } );");
    const struct compiled_ball *ball = &scene.scene->balls[0];
    const struct compiled_box *box = &scene.scene->boxes[0];
    const struct compiled_quadric *quadric = &scene.scene->quadrics[0];
    const struct compiled_camera *camera = &scene.scene->camera;
    const struct compiled_frame *frame = &scene.scene->frames[scene.scene->primitives[1].frame];
    expect_numbers(scene.text, "location ", camera->eye, 3);
    expect_numbers(scene.text, "direction ", camera->forward, 3);
    expect_numbers(scene.text, "sphere { ",
                   (double[]){ball->centre[0], ball->centre[1], ball->centre[2], ball->radius}, 4);
    expect_numbers(scene.text, "box { ",
                   (double[]){box->minimum[0], box->minimum[1], box->minimum[2], box->maximum[0],
                              box->maximum[1], box->maximum[2]},
                   6);
    expect_numbers(scene.text, "matrix <", &frame->axis[0][0], 9);
    expect_numbers(scene.text, "quadric { ", quadric->square, 3);
    expect_numbers(scene.text, "light_source {\n    ", scene.scene->lights[0].position, 3);
    discard(&scene);
}

/* POV-Ray's ray of a pixel, direction + (x/w - 1/2) right + (1/2 - y/h) up, x and y at its middle,
 * is the firmware's: the corners' are those of the field of view. */
static void the_camera_has_square_pixels_and_the_field_of_view(void **state) {
    (void)state;
    struct exported scene = export_text(HEAD MATERIALS "objects = ( " BALL("clay", "0") " );");
    const char *at = strstr(scene.text, "right ");
    double right[3], up[3], across = 0, down = 0;
    assert_non_null(at);
    for (int i = 0; i < 3; i++) {
        right[i] = next_number(&at);
        across += right[i] * right[i];
    }
    for (int i = 0; i < 3; i++) {
        up[i] = next_number(&at);
        down += up[i] * up[i];
    }
    assert_true(fabs(sqrt(across) - 2 * tan(33 * 3.14159265358979 / 360)) < 1e-12);
    assert_true(fabs(sqrt(across) / 40 - sqrt(down) / 30) < 1e-15);
    assert_true(up[2] > 0);
    discard(&scene);
}

static void materials_are_declared_once_and_by_name(void **state) {
    (void)state;
    struct exported scene = export_text(HEAD MATERIALS "objects = ( " BALL("clay", "-2") ", " BALL(
        "a-glass", "0") ", " BALL("clay", "2") " );");
    assert_int_equal(occurrences(scene.text, "#declare "), 2);
    expect(&scene, "#declare M1_clay = material {");
    expect(&scene, "#declare M2_a_glass = material {");
    assert_int_equal(occurrences(scene.text, "material { M1_clay }"), 2);
    assert_int_equal(occurrences(scene.text, "material { M2_a_glass }"), 1);
    assert_int_equal(occurrences(scene.text, "no_shadow"), 1);
    expect(&scene, "phong 0.25 phong_size 9");
    expect(&scene, "reflection { 0.25 }");
    expect(&scene, "reflection { 0, 1 fresnel on } conserve_energy");
    expect(&scene, "ior 1.5\n");
    discard(&scene);
}

/* POV-Ray's phong ends where the mirror direction turns away from the light; gloss 0 does not. */
static void a_highlight_of_gloss_0_is_on_the_whole_lit_side(void **state) {
    static const struct {
        const char *highlight, *gloss, *pattern;
        unsigned layers, phongs, speculars;
    } cases[] = {
        {"phong", "0", "", 1, 0, 0},
        {"phong", "0", "diffuse = 0.5; pattern = { size = 1; colour = [9, 9, 9]; };", 2, 0, 0},
        {"phong", "1", "", 0, 1, 0},
        {"blinn", "0", "", 0, 0, 1},
    };
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        char text[4096];
        snprintf(text, sizeof text,
                 "%shighlight = \"%s\";\nmaterials = { m = { colour = [9, 0, 9]; specular = 0.25;\n"
                 "gloss = %s; %s }; };\nobjects = ( %s );",
                 HEAD, cases[i].highlight, cases[i].gloss, cases[i].pattern, BALL("m", "0"));
        struct exported scene = export_text(text);
        assert_non_null(scene.text);
        assert_int_equal(occurrences(scene.text, "diffuse 0.25 brilliance 0"), cases[i].layers);
        assert_int_equal(occurrences(scene.text, " phong "), cases[i].phongs);
        assert_int_equal(occurrences(scene.text, " specular "), cases[i].speculars);
        discard(&scene);
    }
}

/* C / (1 - T) times (1 - T) is C: POV-Ray scales a pigment by its opacity. */
static void a_transparent_pigment_is_scaled_up_by_its_opacity(void **state) {
    (void)state;
    struct exported scene = export_text(HEAD MATERIALS "objects = ( " BALL("a-glass", "0") " );");
    const char *at = strstr(scene.text, "pigment { rgb ");
    assert_non_null(at);
    double colour[3];
    for (int i = 0; i < 3; i++) {
        colour[i] = next_number(&at);
    }
    double transmit = next_number(&at);
    assert_true(1 - transmit <= 0x1p-14 && 1 - transmit > 0);
    assert_true(fabs(colour[1] * (1 - transmit) - 51.0 / 255) < 1e-15);
    assert_true(fabs(colour[2] * (1 - transmit) - 102.0 / 255) < 1e-15);
    discard(&scene);
}

static void an_absorbing_medium_is_hollow_and_per_scaled_unit(void **state) {
    (void)state;
    struct exported scene = export_text(HEAD MATERIALS "objects = ( " BALL("smoke", "0") " );");
    expect(&scene, "hollow");
    expect_numbers(scene.text, "absorption rgb ", scene.scene->materials[1].absorption, 3);
    assert_true(scene.scene->materials[1].absorption[0] > 0);
    discard(&scene);
}

static const char csg[] =
    "solid = { union = ( { difference = ( { box = { min = (-1, -1, -1); max = (1, 1, 1); }; },\n"
    "  { ball = { radius = 0.9; centre = (1, 1, 1); }; }, { ball = { radius = 0.8; }; } ); },\n"
    "  { ball = { centre = (0, 0, 1.2); radius = 0.3; }; },\n"
    "  { ball = { centre = (0, 0, -1.2); radius = 0.3; }; } ); };";

static void chains_of_one_operation_are_one_operation(void **state) {
    (void)state;
    char text[4096];
    for (int glass = 0; glass < 2; glass++) {
        snprintf(text, sizeof text, "%sobjects = ( { material = \"%s\"; %s } );", HEAD MATERIALS,
                 glass ? "a-glass" : "clay", csg);
        struct exported scene = export_text(text);
        expect(&scene, glass ? "merge {\n    difference {\n        box {"
                             : "union {\n    difference {\n        box {");
        assert_int_equal(occurrences(scene.text, "merge {"), glass);
        assert_int_equal(occurrences(scene.text, "union {"), !glass);
        assert_int_equal(occurrences(scene.text, "difference {"), 1);
        assert_int_equal(occurrences(scene.text, "        sphere {"), 2);
        assert_int_equal(occurrences(scene.text, "\n    sphere {"), 2);
        assert_int_equal(occurrences(scene.text, "bounded_by"), 1);
        discard(&scene);
    }
}

/* The file is a program of POV-Ray's language: nothing that a scene calls itself may get into it,
 * even if the reader let it through. */
static void names_stay_within_their_comments(void **state) {
    (void)state;
    struct exported scene = export_text(HEAD MATERIALS "objects = ( " BALL("clay", "0") " );");
    scene.description->title = "A\n#rror";
    (void)snprintf(scene.scene->object_names[1], sizeof scene.scene->object_names[1],
                   "ball\r\n#error");
    write_again(&scene);
    expect(&scene, "// A #rror\n");
    expect(&scene, "// ball  #error\n");
    assert_int_equal(occurrences(scene.text, "\n#"), 2); /* #version, #declare */
    discard(&scene);
}

#define TWO_OPAQUE                                                                                 \
    "materials = { one = { colour = [9, 9, 9]; }; two = { colour = [90, 0, 0]; }; };\n"

static void what_pov_ray_lacks_is_refused_by_name(void **state) {
    static const struct {
        const char *text, *what;
    } cases[] = {
        {"model = \"wavelength\";\n" MATERIALS "objects = ( " BALL("clay", "0") " );",
         "test.scene: model wavelength"},
        {"mixing = \"filter\";\n" MATERIALS "objects = ( " BALL("clay", "0") " );",
         "test.scene: mixing filter"},
        {"attenuation = { constant = 3; };\n" MATERIALS "objects = ( " BALL("clay", "0") " );",
         "test.scene: attenuation"},
        {"materials = {\n m = { colour = [9, 9, 9]; specular = (0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,"
         " 0, 0, 0, 0, 1); }; };\nobjects = ( " BALL("m", "0") " );",
         "test.scene:7: material \"m\""},
        {MATERIALS "objects = ( " BALL("a-glass", "0") ",\n" BALL("smoke", "0.5") " );",
         "test.scene:12: object \"smoke ball\" overlaps \"a-glass ball\""},
        {MATERIALS "objects = ( " BALL("clay", "0") ",\n" BALL("smoke", "0.5") " );",
         "test.scene:12: object \"smoke ball\" overlaps \"clay ball\""},
        {MATERIALS "objects = ( { name = \"table\"; material = \"clay\";\n"
                   "solid = { box = { min = (-3, -3, -1); max = (3, 3, 0); }; }; },\n"
                   "{ name = \"cube\"; material = \"a-glass\";\n"
                   "solid = { box = { min = (-1, -1, 0); max = (1, 1, 2); }; }; } );",
         "test.scene:13: object \"cube\" touches \"table\""},
        {"materials = { shade = { colour = [9, 9, 9]; ior = 1.5; casts_shadow = true; }; };\n"
         "objects = ( { name = \"room\"; material = \"shade\";\n"
         "solid = { box = { min = (-99, -99, -99); max = (99, 99, 99); }; }; } );",
         "test.scene:7: the eye is in object \"room\", which casts shadows"},
        {TWO_OPAQUE "objects = ( { name = \"block\"; material = \"one\";\n"
                    "solid = { box = { min = (-1, -1, -1); max = (1, 1, 1); }; }; },\n"
                    "{ name = \"tile\"; material = \"two\";\n"
                    "solid = { box = { min = (-0.5, -0.5, 0); max = (0.5, 0.5, 1); }; }; } );",
         "test.scene:9: object \"tile\" overlaps \"block\" and has a face in common"},
        {MATERIALS "objects = ( { name = \"pot\"; material = \"clay\"; solid = { difference = (\n"
                   "{ box = { min = (-1, -1, 0); max = (1, 1, 2); }; },\n"
                   "{ box = { min = (-0.5, -0.5, 0.5); max = (0.5, 0.5, 2); }; } ); }; } );",
         "test.scene:11: object \"pot\" is made of solids with a common face"},
    };
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        char text[4096];
        snprintf(text, sizeof text, "%s%s", HEAD, cases[i].text);
        struct exported scene = export_text(text);
        assert_null(scene.text);
        if (strncmp(scene.error.text, cases[i].what, strlen(cases[i].what)) != 0 ||
            !strstr(scene.error.text, "allowed is: ")) {
            fail_msg("\"%s\" instead of \"%s\"", scene.error.text, cases[i].what);
        }
        discard(&scene);
    }
}

/* Near to what is refused, but no reason to. */
static void what_only_looks_like_it_is_taken(void **state) {
    static const char *const cases[] = {
        /* Opaque solids may overlap each other and stick in glass that comes before them. */
        MATERIALS "objects = ( " BALL("a-glass", "0") ", " BALL("clay", "0.5") " );",
        MATERIALS "objects = ( " BALL("clay", "0") ", " BALL("clay", "0.5") " );",
        TWO_OPAQUE "objects = ( { material = \"one\";\n"
                   "solid = { box = { min = (-1, -1, -1); max = (1, 1, 1); }; }; },\n"
                   "{ material = \"two\";\n"
                   "solid = { box = { min = (-0.5, -0.5, 1); max = (0.5, 0.5, 2); }; }; } );",
        TWO_OPAQUE "objects = ( { material = \"one\";\n"
                   "solid = { box = { min = (-1, -1, -1); max = (1, 1, 1); }; }; },\n"
                   "{ material = \"two\";\n"
                   "solid = { box = { min = (-0.5, -0.5, 0); max = (0.5, 0.5, 2); }; }; } );",
        /* Faces in one plane that don't touch; solids on each other that are one opaque union. */
        MATERIALS "objects = ( { material = \"a-glass\"; solid = { union = (\n"
                  "{ box = { min = (-2, -1, 0); max = (-1, 1, 2); }; },\n"
                  "{ box = { min = (1, -1, 0); max = (2, 1, 2); }; } ); }; } );",
        MATERIALS "objects = ( { material = \"clay\"; solid = { union = (\n"
                  "{ box = { min = (-2, -1, 0); max = (0, 1, 2); }; },\n"
                  "{ box = { min = (0, -1, 0); max = (2, 1, 2); }; } ); }; } );",
        /* A hollow ball around another one: their bounds overlap, they don't. */
        MATERIALS "objects = ( { material = \"a-glass\"; solid = { difference = (\n"
                  "{ ball = { radius = 2; }; }, { ball = { radius = 1; }; } ); }; },\n" BALL(
                      "smoke", "0") " );",
    };
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        char text[4096];
        snprintf(text, sizeof text, "%s%s", HEAD, cases[i]);
        struct exported scene = export_text(text);
        if (!scene.text) {
            fail_msg("case %zu is refused: %s", i, scene.error.text);
        }
        discard(&scene);
    }
}

static void a_glass_that_casts_shadows_has_an_opaque_twin_for_them(void **state) {
    (void)state;
    struct exported scene = export_text(
        HEAD "materials = { shade = { colour = [9, 9, 9]; ior = 1.5; casts_shadow = true; }; };\n"
             "objects = ( " BALL("shade", "0") " );");
    assert_int_equal(occurrences(scene.text, "sphere {"), 2);
    assert_int_equal(occurrences(scene.text, "no_shadow"), 1);
    assert_int_equal(occurrences(scene.text, "no_image\n    no_reflection"), 1);
    discard(&scene);
}

/* Tells whether brackets pair off outside of comments and strings. */
static bool are_brackets_paired(const char *text) {
    char open[256];
    size_t depth = 0;
    for (; *text != '\0'; text++) {
        if (strncmp(text, "//", 2) == 0) {
            text += strcspn(text, "\n") - 1;
        } else if (*text == '{' || *text == '[' || *text == '(') {
            open[depth++] = *text == '{' ? '}' : *text == '[' ? ']' : ')';
        } else if (strchr("}])", *text) != NULL) {
            if (depth == 0 || open[--depth] != *text) {
                return false;
            }
        }
        if (depth == sizeof open) {
            return false;
        }
    }
    return depth == 0;
}

/* Behind each pigment stands a finish, with a diffuse part that POV-Ray does not choose. */
static void every_source_is_well_formed(void **state) {
    static const char *const names[] = {"fig3",  "fig4a",         "fig4b",        "fig5", "fig6a",
                                        "fig6b", "fig7-isolated", "fig7-frustum", "figA"};
    (void)state;
    for (size_t i = 0; i < sizeof names / sizeof names[0] + 1; i++) {
        struct exported scene = {NULL, NULL, NULL, {""}};
        if (i < sizeof names / sizeof names[0]) {
            scene.description = load_scene(names[i], &scene.error);
            scene.scene = scene_compile(scene.description, &scene.error);
            write_again(&scene);
        } else {
            scene = export_text(
                HEAD MATERIALS
                "objects = ( { material = \"clay\"; solid = { "
                "polyhedron = { planes = ( { normal = (1, 0, 0); offset = 1; }, { normal = "
                "(-1, 0.1, 0); offset = 1; }, { normal = (0, 1, 0.2); offset = 1; }, "
                "{ normal = (0, -1, 0); offset = 1; }, { normal = (0.3, 0, 1); "
                "offset = 1; }, { normal = (0, 0, -1); offset = 1; } ); }; }; } );");
            assert_int_equal(occurrences(scene.text, "plane { "), 6);
            assert_int_equal(occurrences(scene.text, "intersection {"), 1);
        }
        assert_non_null(scene.text);
        if (!are_brackets_paired(scene.text)) {
            fail_msg("%s", scene.text);
        }
        assert_true(occurrences(scene.text, "pigment { rgb") > 0);
        assert_int_equal(occurrences(scene.text, "finish { ambient 0 diffuse "),
                         occurrences(scene.text, "pigment { rgb"));
        discard(&scene);
    }
}

static void every_built_in_scene_is_taken(void **state) {
    static const char *const names[] = {"fig3",  "fig4a",         "fig4b",        "fig5", "fig6a",
                                        "fig6b", "fig7-isolated", "fig7-frustum", "figA"};
    (void)state;
    for (size_t i = 0; i < sizeof names / sizeof names[0]; i++) {
        struct scene_error error = {""};
        struct scene_description *description = load_scene(names[i], &error);
        assert_non_null(description);
        struct compiled_scene *scene = scene_compile(description, &error);
        assert_non_null(scene);
        if (!export_pov_check(description, scene, &error)) {
            fail_msg("%s", error.text);
        }
        compiled_scene_free(scene);
        scene_description_free(description);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(settings_are_those_of_the_scene),
        cmocka_unit_test(a_threshold_of_1_leaves_the_surfaces_visible),
        cmocka_unit_test(numbers_read_back_are_the_same_doubles),
        cmocka_unit_test(the_camera_has_square_pixels_and_the_field_of_view),
        cmocka_unit_test(materials_are_declared_once_and_by_name),
        cmocka_unit_test(a_highlight_of_gloss_0_is_on_the_whole_lit_side),
        cmocka_unit_test(a_transparent_pigment_is_scaled_up_by_its_opacity),
        cmocka_unit_test(an_absorbing_medium_is_hollow_and_per_scaled_unit),
        cmocka_unit_test(chains_of_one_operation_are_one_operation),
        cmocka_unit_test(names_stay_within_their_comments),
        cmocka_unit_test(what_pov_ray_lacks_is_refused_by_name),
        cmocka_unit_test(what_only_looks_like_it_is_taken),
        cmocka_unit_test(a_glass_that_casts_shadows_has_an_opaque_twin_for_them),
        cmocka_unit_test(every_built_in_scene_is_taken),
        cmocka_unit_test(every_source_is_well_formed),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
