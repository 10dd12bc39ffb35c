/* SPDX-License-Identifier: MIT */
/* Scenes that cannot be: refused at load, with the line, the reason and what is allowed. */
#include "extremes_fixture.h"

/* One scene in which each case changes one thing. */
static const char good[] =
    "version = 1;\n"
    "size = [4, 4]; depth = 3; threshold = 0.25;\n"
    "camera = { eye = (1, -7, 3); look_at = (0, 0, 0); };\n"
    "lights = ( { position = (0, 0, 9); } );\n"
    "materials = {\n"
    "glass = { colour = [0, 0, 0]; ior = 1.5; gloss = 7; absorption = 2; };\n"
    "clay = { colour = [9, 9, 9]; }; };\n"
    "objects = (\n"
    "{ material = \"glass\"; solid = { box = { min = (-1, -1, -1);\n"
    "max = (1, 1, 1); }; }; },\n"
    "{ material = \"clay\"; solid = { ball = { radius = 0.5; }; }; },\n"
    "{ material = \"clay\"; solid = { quadric = {\n"
    "coefficients = (1, 1, 2, 0, 0, 0, 0, 0, 0, -1); }; }; } );\n";

static const struct change {
    const char *from, *to;
    const char *line, *reason, *allowed;
} changes[] = {
    {"radius = 0.5", "radius = 0", ":11:", "'radius' of the ball is 0", "1e-09"},
    {"radius = 0.5", "radius = -1", ":11:", "'radius' of the ball is -1", "1e-09"},
    {"max = (1, 1, 1)", "max = (1, -2, 1)", ":", "max", "min"},
    {"max = (1, 1, 1)", "max = (1, -1, 1)", ":", "max", "min"},
    {"(1, 1, 2, 0, 0, 0, 0, 0, 0, -1)", "(0, 0, 0, 0, 0, 0, 0, 0, 0, 0)", ":13:", "quadric",
     "differ from 0"},
    {"(1, 1, 2, 0, 0, 0, 0, 0, 0, -1)", "(0, 0, 0, 0, 0, 0, 1, 1, 1, 0)", ":13:", "quadric",
     "half_space"},
    {"(1, 1, 2, 0, 0, 0, 0, 0, 0, -1)", "(1, 1, 2, 0, 0, 0, 0, 0, 0, 1)", ":12:", "no point",
     "negative"},
    {"ior = 1.5", "ior = 0", ":6:", "'ior'", "0.7 to 4"},
    {"ior = 1.5", "ior = 0.69", ":6:", "'ior'", "0.7 to 4"},
    {"ior = 1.5", "ior = 4.01", ":6:", "'ior'", "0.7 to 4"},
    {"ior = 1.5", "ior = -1.5", ":6:", "'ior'", "0.7 to 4"},
    {"ior = 1.5", "ior = nan", ":6:", "'nan'", "finite"},
    {"ior = 1.5", "ior = Inf", ":6:", "'Inf'", "finite"},
    {"ior = 1.5", "ior = 1e400", ":6:", "too large", "1.7e308"},
    {"ior = 1.5", "ior = 1,5", ":6:", "'1,5' is no number", "a dot"},
    {"gloss = 7", "gloss = 65536", ":6:", "'gloss'", "65535"},
    {"gloss = 7", "gloss = -1", ":6:", "'gloss'", "0 to"},
    {"absorption = 2", "absorption = -0.1", ":6:", "'absorption'", "0 to"},
    {"depth = 3", "depth = 256", ":2:", "'depth'", "0 to 255"},
    {"depth = 3", "depth = -1", ":2:", "'depth'", "0 to 255"},
    {"threshold = 0.25", "threshold = 1.0001", ":2:", "'threshold'", "0 to 1"},
    {"size = [4, 4]", "size = [0, 4]", ":2:", "'size'", "1 to 640"},
    {"size = [4, 4]", "size = [4, 401]", ":2:", "'size'", "400"},
    {"(0, 0, 9)", "(0, 0, 1e10)", ":4:", "'position'", "1000000000"},
};

static void each_is_refused_with_its_line_and_what_is_allowed(void **state) {
    (void)state;
    assert_string_equal(refusal_of(good, "fx"), "");
    for (size_t i = 0; i < sizeof changes / sizeof changes[0]; i++) {
        const struct change *change = &changes[i];
        char text[4096];
        const char *place = strstr(good, change->from);
        assert_non_null(place);
        snprintf(text, sizeof text, "%.*s%s%s", (int)(place - good), good, change->to,
                 place + strlen(change->from));
        assert_refused(text, "fx", change->line, change->reason);
        assert_refused(text, "f64", "test.scene:", change->allowed);
    }
}

/* What a format cannot hold is refused, and what it just can is not. */
static void fx_refuses_what_it_cannot_hold(void **state) {
    (void)state;
    static const char format[] =
        "version = 1; size = [4, 4];%s\n"
        "camera = { eye = (0, -8, 0); look_at = (0, 0, 0); };\n"
        "materials = { glass = { colour = [0, 0, 0]; ior = 1.5; absorption = %.17g; }; };\n"
        "objects = ( { material = \"glass\"; solid = { box = { min = (-8, -8, -8);"
        " max = (8, 8, 8); }; }; },\n"
        "{ material = \"glass\"; solid = { ball = { centre = (3, 0, 0); radius = %.17g; }; }; } );";
    char text[2048];
    /* The content reaches +-8: 64 scaled units make one of the file's, and 2^-20 is an LSB. */
    snprintf(text, sizeof text, format, "", 511.0, 1.0);
    assert_string_equal(refusal_of(text, "fx"), "");
    snprintf(text, sizeof text, format, "", 512.0, 1.0);
    assert_refused(text, "fx", "test.scene:3:", "absorption too strong");
    /* A radius of four times the noise of a distance: 2^-17 in fx, 2^-12 in f32. */
    snprintf(text, sizeof text, format, "", 1.0, 0x1p-21);
    assert_string_equal(refusal_of(text, "fx"), "");
    assert_refused(text, "f32", "test.scene:5:", "smaller than this arithmetic resolves");
    snprintf(text, sizeof text, format, "", 1.0, 0x1.ep-22);
    assert_refused(text, "fx", "test.scene:5:", "smaller than this arithmetic resolves");
    assert_string_equal(refusal_of(text, "f64"), "");
    snprintf(text, sizeof text, format, "", 1.0, 0x1p-16);
    assert_string_equal(refusal_of(text, "f32"), "");
    snprintf(text, sizeof text, format, "attenuation = { constant = 15.9; };", 1.0, 1.0);
    assert_string_equal(refusal_of(text, "fx"), "");
    snprintf(text, sizeof text, format, "attenuation = { constant = 16.0; };", 1.0, 1.0);
    assert_refused(text, "fx", "test.scene", "C of C + D is too large");
}

/* What is round has to be some noises wide, and a quadric must not stray from its numbers. */
static void curves_that_lose_their_shape_are_refused(void **state) {
    (void)state;
    static const char format[] =
        "version = 1; size = [4, 4];\n"
        "camera = { eye = (0, -8, 0); look_at = (0, 0, 0); };\n"
        "materials = { m = { colour = [200, 0, 0]; }; };\n"
        "objects = ( { material = \"m\"; solid = { box = { min = (-8, -8, -8);"
        " max = (8, -7, 8); }; }; },\n"
        "{ material = \"m\"; solid = { %s }; } );";
    static const struct {
        const char *solid, *arithmetic, *words;
    } cases[] = {
        {"cylinder = { from = (0, 0, 0); to = (3, 4, 1); radius = 1e-7; };", "fx", "narrower"},
        {"cylinder = { from = (0, 0, 0); to = (3, 4, 1); radius = 1e-6; };", "fx", ""},
        {"cylinder = { from = (0, 0, 0); to = (3, 4, 1); radius = 1e-6; };", "f32", "narrower"},
        {"cylinder = { from = (0, 0, 0); to = (3, 4, 1); radius = 1e-4; };", "f32", ""},
        {"ellipsoid = { radii = (7, 1, 1e-6); };", "f32", "narrower"},
        {"ellipsoid = { radii = (7, 0.0004, 0.0004); };", "fx", "longer for its width"},
        {"ellipsoid = { radii = (7, 0.0004, 0.0004); };", "f32", ""},
        {"ellipsoid = { radii = (7, 0.02, 0.02); };", "fx", ""},
        {"cone = { from = (0, 0, 0); to = (0, 0.0001, 0.0002); from_radius = 0; to_radius = 7; };",
         "fx", "longer for its width"},
        {"cone = { from = (0, 0, 0); to = (0, 0.0001, 0.0002); from_radius = 0; to_radius = 7; };",
         "f32", ""},
        {"cone = { from = (0, 0, 0); to = (3, 4, 1); from_radius = 1e-6; to_radius = 1; };", "f32",
         ""},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        char text[2048];
        snprintf(text, sizeof text, format, cases[i].solid);
        if (cases[i].words[0] == '\0') {
            assert_string_equal(refusal_of(text, cases[i].arithmetic), "");
        } else {
            assert_refused(text, cases[i].arithmetic, "test.scene:5:", cases[i].words);
        }
    }
}

static void a_patterns_cell_of_no_size_is_refused(void **state) {
    (void)state;
    static const char format[] =
        "version = 1; size = [4, 4];\n"
        "camera = { eye = (0, -8, 0); look_at = (0, 0, 0); };\n"
        "materials = { board = { colour = [200, 0, 0]; ambient = 1; ambient_is_own = true;\n"
        "  pattern = { size = (1, 0, %.17g); colour = [0, 0, 200]; }; }; };\n"
        "objects = ( { material = \"board\"; solid = { box = { min = (-8, -8, -8);"
        " max = (8, -4, 8); }; }; } );";
    static struct picture seen;
    char text[2048];
    /* 64 scaled units make one of the file's, and 2^-20 is an LSB: half of one is rounded. */
    snprintf(text, sizeof text, format, 0x1p-26);
    render_text(&seen, text, "fx");
    snprintf(text, sizeof text, format, 0x1p-27);
    assert_refused(text, "fx", "test.scene:3:", "a pattern's cell smaller");
    for (int i = F32; i < EXTREME_ARITHMETICS; i++) {
        render_text(&seen, text, extreme_arithmetics[i]);
    }
}

/* The union of so many solids, as a part that so many objects are. */
static void write_unions(char *text, size_t room, int objects, int solids) {
    int at = snprintf(text, room,
                      "version = 1; size = [4, 4];\n"
                      "camera = { eye = (0, -8, 0); look_at = (0, 0, 0); };\n"
                      "materials = { m = { colour = [9, 9, 9]; }; };\n"
                      "parts = ( { name = \"row\"; solid = { union = (");
    for (int i = 0; i < solids; i++) {
        at += snprintf(text + at, room - (size_t)at,
                       "%s{ ball = { centre = (%d, 0, 0); radius = 0.%d; }; }", i > 0 ? "," : "",
                       i % 8, 1 + i / 8 % 7);
    }
    at += snprintf(text + at, room - (size_t)at, "); }; } );\nobjects = (");
    for (int i = 0; i < objects; i++) {
        at += snprintf(text + at, room - (size_t)at,
                       "%s{ material = \"m\"; solid = { part = \"row\"; }; }\n", i > 0 ? "," : "");
    }
    (void)snprintf(text + at, room - (size_t)at, ");\n");
}

static void unions_of_any_length_are_taken(void **state) {
    (void)state;
    static const int lengths[] = {128, 129, 500};
    static char text[1 << 15];
    for (size_t i = 0; i < sizeof lengths / sizeof lengths[0]; i++) {
        write_unions(text, sizeof text, 1, lengths[i]);
        assert_string_equal(refusal_of(text, "f64"), "");
    }
    write_unions(text, sizeof text, 33, 64);
    assert_string_equal(refusal_of(text, "f64"), "");
}

/* Without an end: nothing to be told of its inside. */
static void unbounded_glass_is_refused(void **state) {
    (void)state;
    static const char *const solids[] = {
        "half_space = { normal = (0, 0, 1); offset = 0; };",
        "quadric = { coefficients = (1, 1, -1, 0, 0, 0, 0, 0, 0, 0); };",
        ("difference = ( { half_space = { normal = (0, 1, 1); offset = 0; }; },"
         " { ball = { radius = 1; }; } );"),
    };
    for (size_t i = 0; i < sizeof solids / sizeof solids[0]; i++) {
        char text[2048];
        snprintf(text, sizeof text,
                 "version = 1; camera = { eye = (1, -7, 3); look_at = (0, 0, 0); };\n"
                 "materials = { glass = { colour = [0, 0, 0]; ior = 1.5; }; };\n"
                 "objects = ( { material = \"glass\"; solid = { ball = { radius = 2; }; }; },\n"
                 "{ material = \"glass\"; solid = { %s }; } );",
                 solids[i]);
        assert_refused(text, "fx", "test.scene:4:", "transparent object without an end");
    }
}

/* The world ends: a floor beyond it would be missing without a word. What only cuts a bounded solid
 * may be anywhere. The eye and the ball give a world of 8 units around (1.5, 1, 1). */
static void a_floor_beyond_the_world_is_refused(void **state) {
    (void)state;
    static const struct {
        const char *solid;
        bool is_there;
    } cases[] = {
        {"half_space = { normal = (0, 0, 1); offset = -6.5; };", true},
        {"half_space = { normal = (0, 0, 1); offset = -7.5; };", false},
        {"half_space = { normal = (0, 0, -1); offset = -6.5; };", true},
        {"half_space = { normal = (1, 2, 3); through = (-6, -6.5, -6.5); };", true},
        {"half_space = { normal = (1, 2, 3); through = (-7, -7.5, -7.5); };", false},
        {"union = ( { ball = { radius = 1; }; },"
         " { half_space = { normal = (0, 1, 0); offset = -70; }; } );",
         false},
        {"difference = ( { ball = { radius = 1; }; },"
         " { half_space = { normal = (0, 1, 0); offset = -70; }; } );",
         true},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        char text[2048];
        snprintf(text, sizeof text,
                 "version = 1; camera = { eye = (5, 4, 4); look_at = (0, 0, 0); };\n"
                 "materials = { chalk = { colour = [9, 9, 9]; }; };\n"
                 "objects = ( { material = \"chalk\"; solid = { ball = { radius = 2; }; }; },\n"
                 "{ material = \"chalk\"; solid = { %s }; } );",
                 cases[i].solid);
        if (cases[i].is_there) {
            struct loaded_scene loaded = load_text(text, "fx");
            unload(&loaded);
        } else {
            assert_refused(text, "fx", "test.scene:4:", "ends 8 units from the middle");
        }
    }
}

/* ---- Whole messages ---------------------------------------------------------------------------
 */

/* The content reaches 8 units from the middle along y, so that 64 scaled units make one of the
 * file's: the world, of 1024, ends at 16. */
static const char refused_format[] =
    "version = 1; %s\n"
    "camera = { eye = (0, -8, 0); look_at = (0, 0, 0); };\n"
    "materials = { m = { colour = [9, 9, 9]; };\n"
    "glass = { colour = [9, 9, 9]; ior = 1.5; absorption = %s; }; };\n"
    "objects = ( { material = \"m\"; solid = { box = { min = (-1, 7, -1); max = (1, 8, 1); }; }; "
    "},\n"
    "{ material = \"%s\"; solid = { union = (\n"
    "{ ball = { radius = 1; }; },\n"
    "%s ); }; } );\n";

#define PLANE(x, y, z) "{ normal = (" #x ", " #y ", " #z "); offset = 1; }"

static const struct whole_message {
    const char *setting, *absorption, *material, *solid, *message;
} messages[] = {
    {"attenuation = { constant = 16; };", "0", "m", "{ ball = { radius = 2; }; }",
     "test.scene: the constant C of C + D is too large for the scene: at most 16 is allowed"},
    {"size = [321, 200]; colour = \"dither\";", "0", "m", "{ ball = { radius = 2; }; }",
     "test.scene: colour \"dither\" with 321 x 200 pixels, each of 2 x 2 dots; allowed is: up to "
     "320 "
     "x 200, or another colour"},
    {"", "512", "glass", "{ ball = { radius = 2; }; }",
     "test.scene:4: absorption too strong for the size of the scene: at most 511.36 is allowed; an "
     "opaque material looks the same"},
    {"", "0", "m", "{ half_space = { normal = (0, 0, 1); offset = -17; }; }",
     "test.scene:8: a half_space or quadric out of the scene, which ends 16 units from the middle "
     "of its bounded solids, eye and lights: move it nearer, or add a bounded solid that is as far "
     "away"},
    {"", "0", "m", "{ quadric = { coefficients = (1, 1, 0, 0, 0, 0, 36, 0, 0, 323); }; }",
     "test.scene:8: a half_space or quadric out of the scene, which ends 16 units from the middle "
     "of its bounded solids, eye and lights: move it nearer, or add a bounded solid that is as far "
     "away"},
    {"", "0", "m", "{ quadric = { coefficients = (1, 2, 3, 0, 0, 0, 0, 0, 0, 1); }; }",
     "test.scene:8: a quadric that holds no point: its form has to be negative somewhere"},
    {"", "0", "m", "{ quadric = { coefficients = (1, 1, 0, 0, 0, 0, 0, 0, 99, 0); }; }",
     "test.scene:8: a quadric that is nearly flat over the whole scene: use a half_space, or make "
     "it "
     "smaller"},
    {"", "0", "m", "{ quadric = { coefficients = (1, 1, 0, 0, 0, 0, 34, 0, 0, 285); }; }",
     "test.scene:8: a quadric whose centre or apex lies outside of the scene, at more than twice "
     "its "
     "size: use a half_space, or move it"},
    {"", "0", "m",
     "{ polyhedron = { planes = ( " PLANE(1, 0, 0) ", " PLANE(0, 1, 0) ", " PLANE(
         0, 0, 1) ", " PLANE(-1, 0, 0) " ); }; }",
     "test.scene:8: a polyhedron without an end: add the planes that close it, or intersect "
     "half_spaces"},
    {"", "0", "m",
     "{ polyhedron = { planes = ( " PLANE(1, 0, 0) ", " PLANE(0, 1, 0) ", " PLANE(
         0, 0, 1) ", "
                  "{ normal = (-1, -1, -1); offset = -9; } ); }; }",
     "test.scene:8: an empty polyhedron: no point lies behind all of its planes; look for a normal "
     "that points inwards"},
};

static void a_refusal_says_where_and_what_and_nothing_else(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof messages / sizeof messages[0]; i++) {
        const struct whole_message *message = &messages[i];
        char text[2048];
        (void)snprintf(text, sizeof text, refused_format, message->setting, message->absorption,
                       message->material, message->solid);
        assert_string_equal(refusal_of(text, "f64"), message->message);
    }
}

/* A solid of two lines, which differs with its place. */
static const struct two_lines {
    const char *first, *second;
} pairs[] = {
    {"{ union = ( { ball = { centre = (%g, 0, 0); radius = 0.2; };", " } ); }"},
    {"{ intersection = ( { ellipsoid = { centre = (%g, 0, 0); radii = (0.3, 0.4, 0.5); }; },",
     "{ half_space = { normal = (0, 0, 1); offset = 0.1; }; } ); }"},
    {"{ difference = ( { ellipsoid = { centre = (%g, 0, 0); radii = (0.3, 0.4, 0.5); }; },",
     "{ half_space = { normal = (0, 0, 1); offset = 0.1; }; } ); }"},
};

static void solids_by_the_dozen_are_taken(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof pairs / sizeof pairs[0]; i++) {
        static char text[1 << 15];
        int at = snprintf(text, sizeof text,
                          "version = 1; camera = { eye = (0, -300, 0); look_at = (0, 0, 0); };\n"
                          "materials = { m = { colour = [9, 9, 9]; }; };\nobjects = (\n");
        for (int j = 0; j < 70; j++) {
            at += snprintf(text + at, sizeof text - (size_t)at,
                           "%s{ material = \"m\"; solid = ", j > 0 ? ",\n" : "");
            at += snprintf(text + at, sizeof text - (size_t)at, pairs[i].first, j + 0.0);
            at += snprintf(text + at, sizeof text - (size_t)at, "\n%s; }", pairs[i].second);
        }
        (void)snprintf(text + at, sizeof text - (size_t)at, " );\n");
        assert_string_equal(refusal_of(text, "f64"), "");
    }
}

/* Balls of glass within one another, each a little smaller. */
static void write_shells(char *text, size_t room, int count) {
    int at = snprintf(text, room,
                      "version = 1; camera = { eye = (0, -9, 0); look_at = (0, 0, 0); };\n"
                      "materials = { m = { colour = [9, 9, 9]; ior = 1.5; }; };\nobjects = (\n");
    for (int i = 0; i < count; i++) {
        at += snprintf(text + at, room - (size_t)at,
                       "%s{ material = \"m\"; solid = { ball = { radius = %g; }; }; }",
                       i > 0 ? ",\n" : "", 3 - i / 40.0);
    }
    (void)snprintf(text + at, room - (size_t)at, " );\n");
}

static void more_solids_at_one_place_than_lists_hold_are_refused(void **state) {
    (void)state;
    static char text[1 << 14];
    write_shells(text, sizeof text, 64);
    assert_string_equal(refusal_of(text, "f64"), "");
    write_shells(text, sizeof text, 65);
    assert_string_equal(refusal_of(text, "f64"),
                        "test.scene: up to 65 solids overlap at one place; at most 64 are allowed: "
                        "take solids apart, or draw them in several scenes");
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_is_refused_with_its_line_and_what_is_allowed),
        cmocka_unit_test(fx_refuses_what_it_cannot_hold),
        cmocka_unit_test(curves_that_lose_their_shape_are_refused),
        cmocka_unit_test(a_patterns_cell_of_no_size_is_refused),
        cmocka_unit_test(unions_of_any_length_are_taken),
        cmocka_unit_test(more_solids_at_one_place_than_lists_hold_are_refused),
        cmocka_unit_test(unbounded_glass_is_refused),
        cmocka_unit_test(a_floor_beyond_the_world_is_refused),
        cmocka_unit_test(a_refusal_says_where_and_what_and_nothing_else),
        cmocka_unit_test(solids_by_the_dozen_are_taken),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
