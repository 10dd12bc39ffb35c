/* SPDX-License-Identifier: MIT */
/* The scene compiler makes less of a scene, says what it did, and the picture is the same. */
#include "compiled_points.h"

enum { TEXT_SIZE = 8192, WIDTH = 32, HEIGHT = 20 };

static const char *const arithmetics[] = {"fx", "f32", "f64"};
enum { ARITHMETICS = 3 };

/* The board holds the scene's centre and scale fast, whatever else is in it. */
static const char scene_head[] =
    "version = 1; size = [32, 20]; depth = 6;\n"
    "camera = { eye = (3.1, -7.3, 5.2); look_at = (0.0, 0.0, 0.3); field_of_view = 34; };\n"
    "lights = ( { direction = (0.5, 0.6, -1.0); colour = [255, 255, 255]; } );\n"
    "materials = {\n"
    "  board = { colour = [200, 200, 200]; ambient = 0.3; ambient_is_own = true; diffuse = 0.6;\n"
    "            pattern = { size = (0.7, 0.7, 0); colour = [40, 20, 60]; }; };\n"
    "  glass = { colour = [10, 30, 20]; ambient = 0.4; ambient_is_own = true; diffuse = 0.3;\n"
    "            specular = 0.4; gloss = 50; ior = 1.5; };\n"
    "};\n"
    "objects = (\n"
    "  { material = \"board\"; solid = { box = { min = (-9, -9, -6); max = (9, 9, -1.2); }; }; }";

static void make_scene(char text[TEXT_SIZE], const char *solid) {
    (void)snprintf(text, TEXT_SIZE, "%s%s%s%s\n);\n", scene_head,
                   solid[0] != '\0' ? ",\n  { material = \"glass\"; solid = " : "", solid,
                   solid[0] != '\0' ? "; }" : "");
}

static void render(const char *text, const char *arithmetic, double level[WIDTH * HEIGHT][3]) {
    struct loaded_scene loaded = load_text(text, arithmetic);
    struct render_counts counts = {0};
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        loaded.arithmetic->pixel(loaded.scene, (uint16_t)(i % WIDTH), (uint16_t)(i / WIDTH),
                                 level[i], &counts, NULL);
    }
    assert_int_equal(counts.leaked_rays, 0);
    unload(&loaded);
}

/* Fails unless two scenes give the same intensities to the last bit. */
static void assert_same_picture(const char *text_a, const char *text_b) {
    static double a[WIDTH * HEIGHT][3], b[WIDTH * HEIGHT][3];
    for (int i = 0; i < ARITHMETICS; i++) {
        render(text_a, arithmetics[i], a);
        render(text_b, arithmetics[i], b);
        if (memcmp(a, b, sizeof a) != 0) {
            fail_msg("%s: another picture of\n%s\nthan of\n%s", arithmetics[i], text_a, text_b);
        }
    }
}

#define BALL  "{ ball = { centre = (0.2, 0.1, 0.3); radius = 1.1; }; }"
#define EGG   "{ ellipsoid = { centre = (0.1, 0, 0.2); radii = (1.3, 0.8, 1.0); }; }"
#define BOX   "{ box = { min = (-0.9, -0.8, -0.6); max = (1.0, 0.7, 0.9); }; }"
#define SMALL "{ box = { min = (-0.2, -0.2, -0.1); max = (0.2, 0.2, 0.3); }; }"
#define AWAY  "{ ball = { centre = (5, 5, 3); radius = 0.7; }; }"

/* What a solid is turned into. */
static const struct simplification {
    const char *said, *meant;
    unsigned simplified, primitives; /* without the board, and what is left out as dead */
} simplifications[] = {
    {"{ union = ( " BALL ", " BALL " ); }", BALL, 1, 1},
    {"{ intersection = ( " BOX ", " BOX " ); }", BOX, 1, 1},
    {"{ difference = ( " EGG ", " EGG " ); }", "", 0, 0},
    {"{ difference = ( " BOX ", { difference = ( " EGG ", " EGG " ); } ); }", BOX, 2, 1},
    {"{ union = ( { difference = ( " EGG ", " EGG " ); }, " BOX " ); }", BOX, 2, 1},
    {"{ intersection = ( { difference = ( " EGG ", " EGG " ); }, " BOX " ); }", "", 0, 0},
    {"{ difference = ( " BOX ", " AWAY " ); }", BOX, 1, 1},
    {"{ intersection = ( " BOX ", " AWAY " ); }", "", 0, 0},
    {"{ intersection = ( { union = ( " BOX ", " EGG " ); }, " AWAY " ); }", "", 0, 0},
    {"{ union = ( " BOX ", " SMALL " ); }", BOX, 1, 1},
    {"{ intersection = ( " SMALL ", " BALL " ); }", SMALL, 1, 1},
    {"{ intersection = ( " EGG ", " SMALL " ); }", SMALL, 1, 1},
    {"{ difference = ( " SMALL ", " EGG " ); }", "", 0, 0},
    {"{ difference = ( { union = ( " BOX ", " BALL " ); }, { union = ( " BOX ", " BALL " ); } ); }",
     "", 0, 0},
    /* Nothing of this may be left out. */
    {"{ difference = ( " BOX ", " SMALL " ); }", "{ difference = ( " BOX ", " SMALL " ); }", 0, 2},
    {"{ difference = ( " BOX ", " BALL " ); }", "{ difference = ( " BOX ", " BALL " ); }", 0, 2},
    {"{ union = ( " BOX ", " AWAY " ); }", "{ union = ( " BOX ", " AWAY " ); }", 0, 2},
};

static void operations_that_say_nothing_are_left_out(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof simplifications / sizeof simplifications[0]; i++) {
        const struct simplification *expected = &simplifications[i];
        char said[TEXT_SIZE], meant[TEXT_SIZE];
        make_scene(said, expected->said);
        make_scene(meant, expected->meant);
        struct loaded_scene loaded = load_text(said, "f64");
        if (loaded.compiled->report.simplified != expected->simplified ||
            loaded.compiled->primitive_count != 1 + expected->primitives) {
            fail_msg("%u simplified, %d primitives of %s", loaded.compiled->report.simplified,
                     loaded.compiled->primitive_count - 1, expected->said);
        }
        unload(&loaded);
        assert_same_picture(said, meant);
    }
}

static void an_object_of_which_nothing_is_left_takes_its_name_along(void **state) {
    (void)state;
    char text[TEXT_SIZE];
    (void)snprintf(
        text, sizeof text,
        "%s,\n  { name = \"nothing\"; material = \"glass\"; solid = { difference = ( " BOX ", " BOX
        " ); }; },\n  { name = \"egg\"; material = \"glass\"; solid = " EGG "; }\n);\n",
        scene_head);
    struct loaded_scene loaded = load_text(text, "fx");
    assert_int_equal(loaded.compiled->object_count, 3); /* the air, the board, the egg */
    assert_string_equal(loaded.compiled->object_names[2], "egg");
    assert_int_equal(loaded.compiled->objects[2].length, 1);
    unload(&loaded);
}

static void solids_that_are_the_same_are_shared(void **state) {
    (void)state;
    char text[TEXT_SIZE];
    make_scene(text, "{ union = ( { difference = ( " BOX ", " BALL " ); }, { intersection = ( " BALL
                     ", " EGG " ); }, { box = { min = (-0.9, -0.8, -0.6); max = (1.0, 0.7, 0.9); "
                     "}; rotate = (0, 0, 360); } ); }");
    struct loaded_scene loaded = load_text(text, "fx");
    assert_int_equal(loaded.compiled->report.shared, 2);
    assert_int_equal(loaded.compiled->primitive_count, 4);
    unload(&loaded);
}

static void the_first_solid_of_a_scene_may_be_a_shared_one(void **state) {
    (void)state;
    static const char balls[] =
        "  { material = \"glass\"; solid = " BALL "; },\n"
        "  { material = \"glass\"; solid = { intersection = ( " BALL ", " EGG " ); }; }";
    const char *objects = strstr(scene_head, "objects = (") + strlen("objects = (");
    char text[TEXT_SIZE];
    (void)snprintf(text, sizeof text, "%.*s\n%s,%s\n);\n", (int)(objects - scene_head), scene_head,
                   balls, objects);
    struct loaded_scene loaded = load_text(text, "fx");
    assert_int_equal(loaded.compiled->report.shared, 1);
    assert_int_equal(loaded.compiled->primitive_count, 3);
    unload(&loaded);
}

#define FRUSTUM                                                                                    \
    "polyhedron = { planes = ( { normal = (0, 0, -1); offset = 1; }, { normal = (0, 0, 1); "       \
    "offset = 1; }, { normal = (2, 0, 1); offset = 2; }, { normal = (-2, 0, 1); offset = 2; }, "   \
    "{ normal = (0, 2, 1); offset = 2; }, { normal = (0, -2, 1); offset = 2; } ); }; "

/* The board lies apart from all of them, and they from it. */
static void what_cannot_be_met_from_within_another_one_is_counted(void **state) {
    (void)state;
    static const struct {
        const char *solid;
        unsigned hidden;
    } cases[] = {
        {BALL, 2},
        {"{ difference = ( { " FRUSTUM "}, { " FRUSTUM "scale = 0.7; } ); }", 5},
        {"{ difference = ( " EGG ", { ball = { centre = (0.1, 0, 0.2); radius = 0.7; }; } ); }", 5},
        {"{ difference = ( " EGG ", " SMALL " ); rotate = (10, 20, 30); }", 5},
        {"{ difference = ( " EGG ", { ball = { centre = (0.1, 0, 0.2); radius = 0.9; }; } ); }", 4},
        {"{ union = ( " BOX ", " AWAY " ); }", 6},
        /* The plane between them lies slanted. */
        {"{ union = ( { ball = { radius = 1; }; }, { ball = { centre = (1.3, 1.3, 1.3); radius = "
         "1; }; } ); }",
         6},
        {"{ union = ( { ball = { radius = 1; }; }, { ball = { centre = (1, 1, 1); radius = 1; }; } "
         "); }",
         4},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        char text[TEXT_SIZE];
        make_scene(text, cases[i].solid);
        struct loaded_scene loaded = load_text(text, "fx");
        if (loaded.compiled->report.hidden != cases[i].hidden) {
            fail_msg("%u pairs instead of %u of %s", loaded.compiled->report.hidden,
                     cases[i].hidden, cases[i].solid);
        }
        unload(&loaded);
    }
}

/* Each of them lies within all that stand before it. */
#define NESTED_0 "{ box = { min = (-3, -3, -1.1); max = (3, 3, 4); }; }"
#define NESTED_1 "{ ellipsoid = { centre = (0, 0, 0.4); radii = (1.5, 1.3, 1.4); }; }"
#define NESTED_2 "{ ball = { centre = (0, 0.1, 0.4); radius = 0.7; }; }"
#define NESTED_3                                                                                   \
    "{ box = { min = (-0.15, -0.1, 0.3); max = (0.1, 0.15, 0.5); }; rotate = (0, 0, 30); }"
enum { NESTED = 4 };

static void the_enclosure_is_the_innermost_of_all_around(void **state) {
    (void)state;
    static const struct {
        const char *solid;
        int place[NESTED]; /* of each of them in its program */
    } orders[] = {
        {"{ difference = ( " NESTED_0 ", { difference = ( " NESTED_1 ", { difference = ( " NESTED_2
         ", " NESTED_3 " ); } ); } ); }",
         {0, 1, 2, 3}},
        {"{ union = ( { difference = ( " NESTED_2 ", " NESTED_3 " ); }, { difference = ( " NESTED_0
         ", " NESTED_1 " ); } ); }",
         {2, 3, 0, 1}},
        {"{ intersection = ( { union = ( " NESTED_3 ", { difference = ( " NESTED_1 ", " NESTED_2
         " ); } ); }, " NESTED_0 " ); }",
         {3, 1, 2, 0}},
    };
    for (size_t order = 0; order < sizeof orders / sizeof orders[0]; order++) {
        char text[TEXT_SIZE];
        const int *place = orders[order].place;
        (void)snprintf(text, sizeof text, "%s,\n  { material = \"glass\"; solid = %s; }\n);\n",
                       scene_head, orders[order].solid);
        struct loaded_scene loaded = load_text(text, "fx");
        const struct compiled_primitive *primitives = loaded.compiled->primitives;
        assert_int_equal(loaded.compiled->primitive_count, 1 + NESTED);
        assert_int_equal(primitives[0].enclosure, COMPILED_ENCLOSURE_NONE);
        assert_int_equal(primitives[1 + place[0]].enclosure, COMPILED_ENCLOSURE_NONE);
        for (int i = 1; i < NESTED; i++) {
            assert_int_equal(primitives[1 + place[i]].enclosure, 1 + place[i - 1]);
        }
        unload(&loaded);
    }
}

/* ---- The same points ------------------------------------------------------------------------ */

static bool in_box(const double p[3]) {
    return p[0] > -0.9 && p[0] < 1 && p[1] > -0.8 && p[1] < 0.7 && p[2] > -0.6 && p[2] < 0.9;
}

static bool in_rod(const double p[3]) {
    return p[0] * p[0] + p[1] * p[1] < 0.16;
}

static bool in_half_space(const double p[3]) {
    return p[0] + p[2] < -0.3;
}

static bool in_plank(const double p[3]) {
    return p[0] > -5 && p[0] < 5 && p[1] > -0.2 && p[1] < 0.2 && p[2] > -5 && p[2] < 0.4;
}

static bool in_turned_plank(const double p[3]) {
    const double turned[3] = {0.6 * p[0] + 0.8 * p[1], -0.8 * p[0] + 0.6 * p[1], p[2]};
    return in_plank(turned);
}

static bool in_bell(const double p[3]) {
    return p[0] * p[0] + p[1] * p[1] - 0.5 * p[2] * p[2] < 0.16;
}

/* Solids that go on far beyond what they cut: as the file says them, and as points. */
static const struct cutter {
    const char *text;
    bool (*holds)(const double p[3]);
} cutters[] = {
    {"{ quadric = { coefficients = (1.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.16); }; }",
     in_rod},
    {"{ half_space = { normal = (1, 0, 1); offset = -0.3; }; }", in_half_space},
    {"{ box = { min = (-5, -0.2, -5); max = (5, 0.2, 0.4); }; }", in_plank},
    {"{ box = { min = (-5, -0.2, -5); max = (5, 0.2, 0.4); }; rotate = (0, 0, "
     "53.13010235415598); }",
     in_turned_plank},
    {"{ quadric = { coefficients = (1.0, 1.0, -0.5, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.16); }; }",
     in_bell},
};
enum { CUTTERS = sizeof cutters / sizeof cutters[0] };

enum operation { LESS, WITHIN, OPERATIONS };

static void what_is_cut_off_changes_no_point(void **state) {
    (void)state;
    static const char *const names[OPERATIONS] = {"difference", "intersection"};
    for (int i = 0; i < CUTTERS * OPERATIONS; i++) {
        const struct cutter *cutter = &cutters[i / OPERATIONS];
        enum operation operation = (enum operation)(i % OPERATIONS);
        char solid[1024], text[TEXT_SIZE];
        uint64_t seed = 31337 + (uint64_t)i;
        int held = 0, missed = 0;
        (void)snprintf(solid, sizeof solid, "{ %s = ( " BOX ", %s ); }", names[operation],
                       cutter->text);
        make_scene(text, solid);
        struct loaded_scene loaded = load_text(text, "fx");
        const struct compiled_report *report = &loaded.compiled->report;
        assert_true(report->bounded + report->fused > 0);
        for (int j = 0; j < 4000; j++) {
            double point[3];
            for (int k = 0; k < 3; k++) {
                point[k] = random_between(&seed, -1.3, 1.3);
            }
            bool expected = in_box(point) && cutter->holds(point) == (operation == WITHIN);
            if (object_has(loaded.compiled, 2, point) != expected) {
                fail_msg("(%g, %g, %g) of %s", point[0], point[1], point[2], solid);
            }
            held += expected;
            missed += !expected;
        }
        assert_true(held > 50 && missed > 50);
        unload(&loaded);
    }
}

/* What is to be seen far out in one place is not cut off for the sake of another one. */
static void a_solid_is_cut_off_only_beyond_all_of_its_uses(void **state) {
    (void)state;
    static const double drilled[3] = {0.1, 0.1, 0.1}, beside[3] = {0.6, 0.1, 0.1};
    static const double far_out[3] = {0.1, 0.1, -7.5}, farther[3] = {0.1, 0.1, 20};
    char text[TEXT_SIZE];
    (void)snprintf(text, sizeof text,
                   "%s,\n  { material = \"glass\"; solid = { difference = ( " BOX
                   ", %s ); }; },\n  { material = \"board\"; solid = { intersection = ( %s, "
                   "{ ball = { centre = (0, 0, -7.5); radius = 1; }; } ); }; }\n);\n",
                   scene_head, cutters[0].text, cutters[0].text);
    struct loaded_scene loaded = load_text(text, "fx");
    assert_int_equal(loaded.compiled->report.bounded, 1);
    assert_false(object_has(loaded.compiled, 2, drilled));
    assert_true(object_has(loaded.compiled, 2, beside));
    assert_true(object_has(loaded.compiled, 3, far_out));
    assert_false(object_has(loaded.compiled, 3, farther));
    unload(&loaded);
}

/* ---- What is left for good --------------------------------------------------------------------
 */

/* Mirrors that fill part of the view, by themselves, and whether they are convex and nothing cuts
 * them: only then no ray that starts on them looks for them again. */
static const struct mirror {
    const char *solid;
    bool left_for_good;
} mirrors[] = {
    {BALL, true},
    {EGG, true},
    {"{ quadric = { coefficients = (0, 1, 1, 0, 0, 0, 0, 0, 0, -1); }; }", true},
    {"{ quadric = { coefficients = (1, 0, 2, 0, 0, 0, 0, 0, 0, -1); }; }", true},
    {"{ quadric = { coefficients = (1, 1, 0, 0, 0, 0, 0, 0, 0, -1); }; }", true},
    {"{ quadric = { coefficients = (1, 0, 2, 0, 0, 0, 0, 0, 0, -1); }; }", true},
    {"{ quadric = { coefficients = (0, 1, 2, 0, 0, 0, 0, 0, 0, -1); }; }", true},
    {"{ quadric = { coefficients = (1, 1, 0, 0, 0, 0, 0, 0, 1, 0); }; }", true},
    {"{ quadric = { coefficients = (2, 1, 0, 0, 0, 0, 0, 0, 0, -1); }; rotate = (10, 20, 30); }",
     true},
    {"{ quadric = { coefficients = (-1, 1, 1, 0, 0, 0, 0, 0, 0, -0.5); }; }", false},
    {"{ quadric = { coefficients = (1, -0.3, 1, 0, 0, 0, 0, 0, 0, -0.5); }; }", false},
    {"{ quadric = { coefficients = (1, 1, -1, 0, 0, 0, 0, 0, 0, -0.5); }; }", false},
    {"{ quadric = { coefficients = (1, 1, -1, 0, 0, 0, 0, 0, 0, 0); }; }", false},
    {"{ quadric = { coefficients = (0.6, 0.6, -1, 0, 0, 0, 0, 0, 0, 0.3); }; }", false},
    {"{ quadric = { coefficients = (1, 0, -0.2, 0, 0, 0, 0, 0, 0, 0.1); }; }", false},
    {"{ cylinder = { from = (0, 0, -1); to = (0, 0, 1); radius = 1; }; }", false},
    {"{ intersection = ( " EGG ", { half_space = { normal = (0, 0, 1); offset = 0.4; }; } ); }",
     false},
};

/* The mirror is all that there is: each ray from the eye is tested against it, and each reflected
 * one if the mirror may be met again. */
static void a_ray_that_leaves_a_convex_solid_does_not_look_for_it(void **state) {
    (void)state;
    for (size_t i = 0; i < ARITHMETICS * sizeof mirrors / sizeof mirrors[0]; i++) {
        const struct mirror *mirror = &mirrors[i / ARITHMETICS];
        struct render_counts counts = {0};
        char text[TEXT_SIZE];
        (void)snprintf(
            text, sizeof text,
            "version = 1; size = [32, 20]; depth = 6;\n"
            "camera = { eye = (3.1, -7.3, 5.2); look_at = (0, 0, 0.3); field_of_view = 34; };\n"
            "lights = ( { position = (-3, -7, -5); } );\n"
            "materials = { chrome = { colour = [90, 90, 90]; diffuse = 0.2; specular = 1; }; };\n"
            "objects = ( { material = \"chrome\"; solid = %s; } );\n",
            mirror->solid);
        struct loaded_scene loaded = load_text(text, arithmetics[i % ARITHMETICS]);
        assert_int_equal(loaded.compiled->primitive_count, 1);
        for (int j = 0; j < WIDTH * HEIGHT; j++) {
            double level[3];
            loaded.arithmetic->pixel(loaded.scene, (uint16_t)(j % WIDTH), (uint16_t)(j / WIDTH),
                                     level, &counts, NULL);
        }
        const uint64_t tests = counts.solid_tests;
        bool expected = mirror->left_for_good
                            ? tests == WIDTH * HEIGHT
                            : tests >= counts.rays && tests <= counts.rays + counts.shadow_rays;
        if (counts.rays <= WIDTH * HEIGHT + 20 || !expected) {
            fail_msg("%s: %u rays, %u tests against %s", arithmetics[i % ARITHMETICS],
                     (unsigned)counts.rays, (unsigned)tests, mirror->solid);
        }
        unload(&loaded);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(operations_that_say_nothing_are_left_out),
        cmocka_unit_test(an_object_of_which_nothing_is_left_takes_its_name_along),
        cmocka_unit_test(solids_that_are_the_same_are_shared),
        cmocka_unit_test(the_first_solid_of_a_scene_may_be_a_shared_one),
        cmocka_unit_test(what_cannot_be_met_from_within_another_one_is_counted),
        cmocka_unit_test(a_ray_that_leaves_a_convex_solid_does_not_look_for_it),
        cmocka_unit_test(the_enclosure_is_the_innermost_of_all_around),
        cmocka_unit_test(what_is_cut_off_changes_no_point),
        cmocka_unit_test(a_solid_is_cut_off_only_beyond_all_of_its_uses),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
