/* SPDX-License-Identifier: MIT */
/* Extremes of CSG: walls that touch, coincide, are as thin as a number can tell, or are not there.
 */
#include "extremes_fixture.h"

static const char head[] =
    "version = 1; size = [40, 25]; depth = 8;\n"
    "camera = { eye = (3.1, -7.3, 5.2); look_at = (0.0, 0.0, 0.3); field_of_view = 34; };\n"
    "lights = ( { position = (-4.0, -6.0, 9.0); } );\n"
    "materials = {\n"
    "  board = { colour = [200, 200, 200]; ambient = 0.3; ambient_is_own = true; diffuse = 0.6;\n"
    "            pattern = { size = (0.7, 0.7, 0); colour = [40, 20, 60]; }; };\n"
    "  glass = { colour = [10, 30, 20]; ambient = 0.4; ambient_is_own = true; diffuse = 0.3;\n"
    "            ior = 1.5; };\n"
    "  amber = { colour = [60, 30, 0]; ambient = 0.3; ambient_is_own = true; ior = 1.3; };\n"
    "  clay = { colour = [200, 90, 40]; ambient = 0.3; ambient_is_own = true; diffuse = 0.7; };\n"
    "};\n"
    "objects = (\n"
    "  { material = \"board\"; solid = { box = { min = (-9, -9, -2.5); max = (9, 9, -2.2); }; }; }";

static void make_scene(char *text, const char *objects) {
    snprintf(text, EXTREME_TEXT_SIZE, "%s%s\n);\n", head, objects);
}

#define OBJECT(material, solid, placement)                                                         \
    ",\n{ material = \"" material "\"; solid = { " solid placement " }; }"
#define CUBE   "box = { min = (-1, -1, -1); max = (1, 1, 1); };"
#define OUTER  "{ box = { min = (-1.3, -1.3, -1.3); max = (1.3, 1.3, 1.3); }; }"
#define TURN   " rotate = (30, 20, 10); translate = (0.1, 0.2, 0);"
#define HOLLOW "difference = ( " OUTER ", { " CUBE " } );"
#define PYRAMID                                                                                    \
    "polyhedron = { planes = ( { normal = (0, 0, -1); offset = 0.9; },"                            \
    " { normal = (1, 0, 0.5); offset = 0.8; }, { normal = (-1, 0, 0.5); offset = 0.8; },"          \
    " { normal = (0, 1, 0.5); offset = 0.8; }, { normal = (0, -1, 0.5); offset = 0.8; } ); };"

/* Whatever fills a cavity to its walls: one interface, the same in every arithmetic. */
static void a_solid_touches_its_cavitys_walls(void **state) {
    (void)state;
    static const char *const scenes[] = {
        OBJECT("glass", HOLLOW, "") OBJECT("amber", CUBE, ""),
        OBJECT("glass", HOLLOW, TURN) OBJECT("amber", CUBE, TURN),
        OBJECT("glass", "difference = ( " OUTER ", { ball = { radius = 1; }; } );", TURN)
            OBJECT("amber", "ball = { radius = 1; };", TURN),
        OBJECT("glass", "difference = ( " OUTER ", { " PYRAMID " } );", TURN)
            OBJECT("amber", PYRAMID, TURN),
        OBJECT("glass",
               "difference = ( " OUTER ", { cylinder = { from = (0, 0, -1); to = (0, 0, 1);"
               " radius = 0.8; }; } );",
               TURN)
            OBJECT("amber", "cylinder = { from = (0, 0, -1); to = (0, 0, 1); radius = 0.8; };",
                   TURN),
        /* one wall only: it stands on the cavity's floor */
        OBJECT("glass", HOLLOW, TURN)
            OBJECT("amber", "box = { min = (-0.5, -0.6, -1); max = (0.6, 0.5, 0.4); };", TURN),
    };
    for (size_t i = 0; i < sizeof scenes / sizeof scenes[0]; i++) {
        char text[EXTREME_TEXT_SIZE];
        make_scene(text, scenes[i]);
        check_against_f128(text);
    }
}

/* Of two identical solids the later one is there, and the earlier one nowhere. */
static void of_identical_solids_the_later_is_seen(void **state) {
    (void)state;
    static const char *const pairs[][2] = {
        {OBJECT("glass", CUBE, TURN) OBJECT("amber", CUBE, TURN), OBJECT("amber", CUBE, TURN)},
        {OBJECT("clay", CUBE, "") OBJECT("glass", CUBE, ""), OBJECT("glass", CUBE, "")},
        {OBJECT("clay", "ball = { radius = 1; };", "")
             OBJECT("glass", "ball = { radius = 1; };", ""),
         OBJECT("glass", "ball = { radius = 1; };", "")},
        {OBJECT("amber", PYRAMID, "") OBJECT("clay", PYRAMID, ""), OBJECT("clay", PYRAMID, "")},
        {OBJECT("glass", CUBE, TURN) OBJECT("glass", CUBE, TURN), OBJECT("glass", CUBE, TURN)},
    };
    static struct picture both, later;
    for (size_t i = 0; i < sizeof pairs / sizeof pairs[0]; i++) {
        for (int j = 0; j < EXTREME_ARITHMETICS; j++) {
            char text[EXTREME_TEXT_SIZE];
            make_scene(text, pairs[i][0]);
            render_text(&both, text, extreme_arithmetics[j]);
            make_scene(text, pairs[i][1]);
            render_text(&later, text, extreme_arithmetics[j]);
            assert_memory_equal(both.level, later.level, sizeof both.level);
            make_scene(text, "");
            render_text(&both, text, extreme_arithmetics[j]);
            assert_true(pixels_apart(&both, &later, 8) > 100);
        }
    }
}

/* Two objects of one material on both sides of a plane are one block, upright and turned. */
static void a_seam_between_coplanar_objects_does_not_show(void **state) {
    (void)state;
    static const char *const turns[] = {"", TURN};
    static struct picture halves, whole;
    for (int i = 0; i < 2; i++) {
        for (int j = 0; j < EXTREME_ARITHMETICS; j++) {
            char text[EXTREME_TEXT_SIZE], objects[2048];
            snprintf(
                objects, sizeof objects,
                ",{ material = \"glass\"; solid = { box = { min = (-1, -1, -1); max = (0.3, 1, "
                "1); }; %s }; },{ material = \"glass\"; solid = { box = { min = (0.3, -1, -1); "
                "max = (1, 1, 1); }; %s }; }",
                turns[i], turns[i]);
            make_scene(text, objects);
            render_text(&halves, text, extreme_arithmetics[j]);
            snprintf(objects, sizeof objects, ",{ material = \"glass\"; solid = { " CUBE "%s }; }",
                     turns[i]);
            make_scene(text, objects);
            render_text(&whole, text, extreme_arithmetics[j]);
            assert_memory_equal(halves.level, whole.level, sizeof whole.level);
        }
    }
}

/* Solids stand on each other, and on the board, with their whole faces. */
static void solids_stand_on_each_other(void **state) {
    (void)state;
    static const char *const scenes[] = {
        OBJECT("glass", "box = { min = (-1, -1, -2.2); max = (1, 1, -1); };", "")
            OBJECT("amber", "box = { min = (-0.8, -1, -1); max = (1.2, 1, 0.4); };", ""),
        OBJECT("glass", "box = { min = (-1, -1, -1); max = (1, 1, 0); };", TURN)
            OBJECT("clay", "box = { min = (-1, -1, 0); max = (1, 0.4, 0.7); };", TURN),
        OBJECT("glass", "cylinder = { from = (0, 0, -2.2); to = (0, 0, 0); radius = 0.9; };", "")
            OBJECT("amber", "cone = { from = (0, 0, 0); to = (0, 0, 1.5); from_radius = 0.9; };",
                   ""),
    };
    for (size_t i = 0; i < sizeof scenes / sizeof scenes[0]; i++) {
        char text[EXTREME_TEXT_SIZE];
        make_scene(text, scenes[i]);
        check_against_f128(text);
    }
}

/* ---- Shells ---------------------------------------------------------------------------------- */

/* All within +-400 and symmetric: one unit of the file is one scaled unit, and 0 is the middle.
 * Walls are at 100, where a length's last bit is 2^-20, 2^-17 and 2^-46; the compiler makes
 * surfaces nearer than 2^-38 one. */
static const char shell_head[] =
    "version = 1; size = [16, 10]; depth = 12; background = [40, 40, 40];\n"
    "camera = { eye = (10, 20, -400); look_at = (0, 0, 0); up = (0, 1, 0); field_of_view = 40; };\n"
    "materials = { glass = { colour = [0, 0, 0]; ior = 1.5; };\n"
    "  wall = { colour = [200, 200, 200]; ambient = 1; ambient_is_own = true;\n"
    "           pattern = { size = (60, 60, 0); colour = [40, 20, 60]; }; }; };\n"
    "objects = ( { material = \"wall\"; solid = { box = { min = (-400, -400, 390); max = (400, "
    "400, "
    "400); }; }; },\n{ material = \"glass\"; solid = ";

static const double last_bit[EXTREME_ARITHMETICS] = {0x1p-20, 0x1p-17, 0x1p-37};

static void box_shell(char *text, double wall) {
    double a = 100, b = 100 - wall;
    snprintf(
        text, EXTREME_TEXT_SIZE,
        "%s{ difference = ( { box = { min = (-%.17g, -%.17g, -%.17g); max = (%.17g, %.17g, "
        "%.17g); }; },\n{ box = { min = (-%.17g, -%.17g, -%.17g); max = (%.17g, %.17g, %.17g); "
        "}; } ); }; } );\n",
        shell_head, a, a, a, a, a, a, b, b, b, b, b, b);
}

static void ball_shell(char *text, double wall) {
    snprintf(text, EXTREME_TEXT_SIZE,
             "%s{ difference = ( { ball = { radius = 100.0; }; },\n{ ball = { radius = %.17g; }; } "
             "); }; } );\n",
             shell_head, 100 - wall);
}

/* Its faces are `reach` from the middle: the normals have length 7. */
static void octahedron(char *text, size_t size, double reach) {
    size_t used = (size_t)snprintf(text, size, "{ polyhedron = { planes = ( ");
    for (int i = 0; i < 8; i++) {
        used += (size_t)snprintf(text + used, size - used,
                                 "%s{ normal = (%d, %d, %d); offset = %.17g; }", i ? ", " : "",
                                 i & 1 ? 2 : -2, i & 2 ? 3 : -3, i & 4 ? 6 : -6, 7 * reach);
    }
    snprintf(text + used, size - used, " ); }; }");
}

static void polyhedron_shell(char *text, double wall) {
    char outer[2048], inner[2048];
    octahedron(outer, sizeof outer, 100);
    octahedron(inner, sizeof inner, 100 - wall);
    snprintf(text, EXTREME_TEXT_SIZE, "%s{ difference = ( %s,\n%s ); }; } );\n", shell_head, outer,
             inner);
}

static void ellipsoid_shell(char *text, double wall) {
    double a = 100, b = 100 - wall;
    snprintf(text, EXTREME_TEXT_SIZE,
             "%s{ difference = ( { ellipsoid = { radii = (%.17g, %.17g, %.17g); }; },\n"
             "{ ellipsoid = { radii = (%.17g, %.17g, %.17g); }; } ); }; } );\n",
             shell_head, a, 0.7 * a, 0.9 * a, b, 0.7 * b, 0.9 * b);
}

static void (*const shells[])(char *, double) = {box_shell, ball_shell, polyhedron_shell,
                                                 ellipsoid_shell};
enum { SHELLS = sizeof shells / sizeof shells[0] };

static void a_shell_of_one_last_bit_renders(void **state) {
    (void)state;
    static struct picture expected, found;
    for (int i = 0; i < SHELLS; i++) {
        for (int j = 0; j < EXTREME_ARITHMETICS; j++) {
            char text[EXTREME_TEXT_SIZE];
            shells[i](text, last_bit[j]);
            render_text(&expected, text, "f128");
            render_text(&found, text, extreme_arithmetics[j]);
            assert_pictures_agree(&found, &expected, 0, extreme_arithmetics[j]);
        }
    }
}

static void a_shell_of_less_is_refused(void **state) {
    (void)state;
    for (int i = 0; i < SHELLS; i++) {
        for (int j = 0; j < F64; j++) {
            char text[EXTREME_TEXT_SIZE];
            shells[i](text, last_bit[j] / 8);
            assert_refused(text, extreme_arithmetics[j], "test.scene:", "thinner than");
            assert_non_null(strstr(refusal_of(text, extreme_arithmetics[j]), "--arith"));
            assert_string_equal(refusal_of(text, "f128"), "");
        }
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_solid_touches_its_cavitys_walls),
        cmocka_unit_test(of_identical_solids_the_later_is_seen),
        cmocka_unit_test(a_seam_between_coplanar_objects_does_not_show),
        cmocka_unit_test(solids_stand_on_each_other),
        cmocka_unit_test(a_shell_of_one_last_bit_renders),
        cmocka_unit_test(a_shell_of_less_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
