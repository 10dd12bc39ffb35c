/* SPDX-License-Identifier: MIT */
/* `check` calls dead what is, with the reason, and nothing else: each proof with what undoes it. */
#include "scene_fixture.h"

#include "requirements.h"

enum { TEXT_SIZE = 8192 };

/* The eye is at (0, -6, 2) and looks at (0, 0, 1): 0.36 of the way to each side, 0.23 up and down.
 */
#define HEAD                                                                                       \
    "version = 1; size = [24, 15];\n"                                                              \
    "camera = { eye = (0, -6, 2); look_at = (0, 0, 1); field_of_view = 40; };\n"

#define LAMP       "{ position = (-4, -6, 9); }"
#define RED_LAMP   "{ position = (-4, -6, 9); colour = [255, 0, 0]; }"
#define BLACK_LAMP "{ position = (-4, -6, 9); colour = [0, 0, 0]; }"
#define DIM_LAMP   "{ position = (-4, -6, 9); colour = [0, 0, 1]; }"
#define FROM_BACK  "{ direction = (0, 1, 0); }"
#define FROM_FRONT "{ direction = (0, -1, 0); }"

#define CLAY   "clay = { colour = [200, 90, 40]; diffuse = 0.7; };"
#define OWN    "own = { colour = [9, 9, 9]; ambient = 1; ambient_is_own = true; };"
#define GLASS  "glass = { colour = [0, 0, 0]; ior = 1.5; absorption = 0.5; };"
#define GHOST  "ghost = { colour = [0, 0, 0]; ior = 1; absorption = 0.5; };"
#define MIRROR "mirror = { colour = [0, 0, 0]; specular = 0.5; };"
#define DULL   "dull = { colour = [0, 0, 0]; specular = 0.1; };"
#define SPECULAR_TABLE(a)                                                                          \
    "specular = (" a                                                                               \
    ", 0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5); };"
#define TABLE(a)  "shiny = { colour = [0, 0, 0]; " SPECULAR_TABLE(a)
#define STRIPED   "pattern = { size = [1, 0, 0]; colour = [9, 9, 8]; }; };"
#define MATERIALS CLAY OWN GLASS GHOST MIRROR DULL

#define OF(material, solid) "{ material = \"" material "\"; solid = " solid "; }"
#define BALL_AT(x, y, z, radius)                                                                   \
    "{ ball = { centre = (" x ", " y ", " z "); radius = " radius "; }; }"
#define BALL                   BALL_AT("0", "0", "1", "1")
#define BESIDE                 BALL_AT("1.5", "1", "1", "0.4")
#define BEHIND                 BALL_AT("0", "-9", "1", "0.5")
#define BOX                    "{ box = { min = (-1, -1, 0); max = (1, 1, 2); }; }"
#define WITHIN                 BALL_AT("0", "0", "1", "0.5")
#define NAMED(material, solid) "{ name = \"it\"; material = \"" material "\"; solid = " solid "; }"

struct scene_case {
    const char *settings, *lights, *materials, *objects, *said;
    bool is_said;
};

static struct compiled_scene *compile_case(const struct scene_case *scene, char text[TEXT_SIZE]) {
    (void)snprintf(text, TEXT_SIZE,
                   HEAD "%s\nlights = ( %s );\nmaterials = { %s };\nobjects = ( %s );\n",
                   scene->settings, scene->lights, scene->materials, scene->objects);
    struct scene_error error = {""};
    struct scene_description *description = read_text(text);
    struct compiled_scene *compiled = scene_compile(description, &error);
    scene_description_free(description);
    if (compiled == NULL) {
        fail_msg("not compiled: %s\n%s", error.text, text);
    }
    return compiled;
}

static void run_cases(const struct scene_case *cases, size_t count) {
    for (size_t i = 0; i < count; i++) {
        char text[TEXT_SIZE], said[TEXT_SIZE];
        struct compiled_scene *compiled = compile_case(&cases[i], text);
        FILE *file = tmpfile();
        assert_non_null(file);
        requirements_print(file, compiled);
        rewind(file);
        said[fread(said, 1, sizeof said - 1, file)] = '\0';
        (void)fclose(file);
        free(compiled);
        if ((strstr(said, cases[i].said) != NULL) != cases[i].is_said) {
            fail_msg("\"%s\" %s:\n%s\nof\n%s", cases[i].said,
                     cases[i].is_said ? "is not said" : "is said", said, text);
        }
    }
}

#define RUN(cases) run_cases(cases, sizeof(cases) / sizeof(cases)[0])

/* ---- Objects -------------------------------------------------------------------------------- */

#define OUT_OF_VIEW "dead        object \"it\" (line 6): it is out of view"
#define SEALED      "dead        object \"it\" (line 6): it lies within an opaque object"
#define FILLED      "dead        object \"it\" (line 6): a later object fills its place"

static void what_is_out_of_view_is_dead_unless_rays_turn_to_it(void **state) {
    (void)state;
    static const struct scene_case cases[] = {
        {"", LAMP, MATERIALS, OF("clay", BALL) "," NAMED("glass", BEHIND), OUT_OF_VIEW, true},
        {"", LAMP, MATERIALS, OF("clay", BALL) "," NAMED("glass", BESIDE), OUT_OF_VIEW, false},
        /* Beyond each side of the picture, and reaching into it. */
        {"", LAMP, MATERIALS, OF("clay", BALL) "," NAMED("glass", BALL_AT("3.3", "0", "1", "0.5")),
         OUT_OF_VIEW, true},
        {"", LAMP, MATERIALS, OF("clay", BALL) "," NAMED("glass", BALL_AT("2.6", "0", "1", "0.5")),
         OUT_OF_VIEW, false},
        {"", LAMP, MATERIALS, OF("clay", BALL) "," NAMED("glass", BALL_AT("-3.3", "0", "1", "0.5")),
         OUT_OF_VIEW, true},
        {"", LAMP, MATERIALS, OF("clay", BALL) "," NAMED("glass", BALL_AT("-2.6", "0", "1", "0.5")),
         OUT_OF_VIEW, false},
        {"", LAMP, MATERIALS, OF("clay", BALL) "," NAMED("glass", BALL_AT("0", "0", "3.2", "0.5")),
         OUT_OF_VIEW, true},
        {"", LAMP, MATERIALS, OF("clay", BALL) "," NAMED("glass", BALL_AT("0", "0", "2.7", "0.5")),
         OUT_OF_VIEW, false},
        {"", LAMP, MATERIALS, OF("clay", BALL) "," NAMED("glass", BALL_AT("0", "0", "-1.2", "0.5")),
         OUT_OF_VIEW, true},
        {"", LAMP, MATERIALS, OF("clay", BALL) "," NAMED("glass", BALL_AT("0", "0", "-0.7", "0.5")),
         OUT_OF_VIEW, false},
        /* A larger one behind the eye crosses all four sides' planes, on the wrong side of it. */
        {"", LAMP, MATERIALS, OF("clay", BALL) "," NAMED("glass", BALL_AT("0", "-12", "2", "5")),
         OUT_OF_VIEW, true},
        {"", LAMP, MATERIALS, OF("clay", BALL) "," NAMED("glass", BALL_AT("0", "-10", "2", "5")),
         OUT_OF_VIEW, false},
        /* A mirror, or glass, turns rays to it; what has its surroundings' index does not. */
        {"", LAMP, MATERIALS, OF("mirror", BALL) "," NAMED("glass", BEHIND), OUT_OF_VIEW, false},
        {"", LAMP, MATERIALS, OF("glass", BALL) "," NAMED("glass", BEHIND), OUT_OF_VIEW, false},
        {"", LAMP, MATERIALS, OF("ghost", BALL) "," NAMED("glass", BEHIND), OUT_OF_VIEW, true},
        {"model = \"simple\";", LAMP, MATERIALS, OF("glass", BALL) "," NAMED("glass", BEHIND),
         OUT_OF_VIEW, true},
        {"depth = 0;", LAMP, MATERIALS, OF("mirror", BALL) "," NAMED("glass", BEHIND), OUT_OF_VIEW,
         true},
        {"depth = 1;", LAMP, MATERIALS, OF("mirror", BALL) "," NAMED("glass", BEHIND), OUT_OF_VIEW,
         false},
        {"", LAMP, MATERIALS TABLE("0.5"), OF("shiny", BALL) "," NAMED("glass", BEHIND),
         OUT_OF_VIEW, false},
    };
    RUN(cases);
}

static void what_throws_no_shadow_that_is_seen_is_dead(void **state) {
    (void)state;
    static const struct scene_case cases[] = {
        {"", FROM_BACK, MATERIALS, OF("clay", BALL) "," NAMED("clay", BEHIND), OUT_OF_VIEW, false},
        {"", FROM_FRONT, MATERIALS, OF("clay", BALL) "," NAMED("clay", BEHIND), OUT_OF_VIEW, true},
        {"", LAMP, MATERIALS, OF("clay", BALL) "," NAMED("clay", BALL_AT("-3", "-5", "7", "0.5")),
         OUT_OF_VIEW, false},
        {"", LAMP, MATERIALS, OF("clay", BALL) "," NAMED("clay", BALL_AT("-3", "-7", "7", "0.5")),
         OUT_OF_VIEW, true},
        {"", FROM_BACK, MATERIALS, OF("own", BALL) "," NAMED("clay", BEHIND), OUT_OF_VIEW, true},
        {"", "", MATERIALS, OF("clay", BALL) "," NAMED("clay", BEHIND), OUT_OF_VIEW, true},
        {"", FROM_BACK, MATERIALS, OF("clay", BALL) "," NAMED("glass", BEHIND), OUT_OF_VIEW, true},
        /* It takes a part of what throws one away. */
        {"", FROM_BACK, MATERIALS,
         OF("clay", BALL) "," OF("clay", BEHIND) "," NAMED("glass",
                                                           BALL_AT("0", "-9.5", "1", "0.5")),
         OUT_OF_VIEW, false},
        {"", FROM_BACK, MATERIALS,
         OF("clay", BALL) "," NAMED("glass", BALL_AT("0", "-9.5", "1", "0.5")) "," OF("clay",
                                                                                      BEHIND),
         OUT_OF_VIEW, true},
        {"", FROM_BACK, MATERIALS " screen = { colour = [9, 9, 9]; " STRIPED,
         OF("clay", BALL) "," NAMED("screen", BEHIND),
         "dead        look of \"screen\" (line 5): nothing is seen of it but its shadow", true},
        {"", FROM_BACK, MATERIALS " screen = { colour = [9, 9, 9]; " STRIPED,
         OF("clay", BALL) "," NAMED("screen", BESIDE), "look of", false},
    };
    RUN(cases);
}

static void what_is_covered_is_dead(void **state) {
    (void)state;
    static const struct scene_case cases[] = {
        {"", LAMP, MATERIALS, OF("clay", BOX) "," NAMED("glass", WITHIN), SEALED, true},
        {"", LAMP, MATERIALS, OF("mirror", BOX) "," NAMED("glass", WITHIN), SEALED, true},
        {"", LAMP, MATERIALS, OF("glass", BOX) "," NAMED("glass", WITHIN), SEALED, false},
        {"", LAMP, MATERIALS, OF("clay", BOX) "," NAMED("glass", BALL_AT("0", "0", "1.6", "0.5")),
         SEALED, false},
        {"", LAMP, MATERIALS, OF("clay", BOX) "," NAMED("glass", BALL_AT("0", "0", "1", "1")),
         SEALED, false},
        /* Opened by a later object, but not by an earlier one, nor by one that is elsewhere. */
        {"", LAMP, MATERIALS,
         OF("clay", BOX) "," NAMED("glass", WITHIN) "," OF("ghost", BALL_AT("0", "-1", "1", "0.6")),
         SEALED, false},
        {"", LAMP, MATERIALS,
         OF("ghost", BALL_AT("0", "-1", "1", "0.6")) "," OF("clay", BOX) "," NAMED("glass", WITHIN),
         SEALED, true},
        {"", LAMP, MATERIALS, OF("clay", BOX) "," NAMED("glass", WITHIN) "," OF("ghost", BESIDE),
         SEALED, true},
        /* The eye is within, too. */
        {"", LAMP, MATERIALS,
         OF("clay", "{ ball = { centre = (0, 0, 1); radius = 9; }; }") "," NAMED("glass", WITHIN),
         SEALED, false},
        {"", LAMP, MATERIALS,
         OF("clay", BOX) "," NAMED("glass", "{ difference = ( " WITHIN ", " BESIDE " ); }"), SEALED,
         true},
        {"", LAMP, MATERIALS,
         OF("clay", BOX) "," NAMED("glass", "{ union = ( " WITHIN ", " BESIDE " ); }"), SEALED,
         false},
        {"", LAMP, MATERIALS,
         OF("clay", BOX) "," NAMED(
             "glass", "{ intersection = ( " BALL_AT("0", "-0.7", "1", "0.6") ", " WITHIN " ); }"),
         SEALED, true},
        {"", LAMP, MATERIALS, NAMED("mirror", WITHIN) "," OF("glass", BOX), FILLED, true},
        {"", LAMP, MATERIALS, OF("glass", BOX) "," NAMED("mirror", WITHIN), FILLED, false},
        {"", LAMP, MATERIALS, NAMED("mirror", BALL_AT("0", "0", "1.6", "0.5")) "," OF("glass", BOX),
         FILLED, false},
        {"", LAMP, MATERIALS, NAMED("mirror", BALL) "," OF("glass", BALL), FILLED, true},
        {"", LAMP, MATERIALS,
         NAMED("mirror", "{ union = ( " BALL ", " BESIDE
                         " ); }") "," OF("glass", "{ union = ( " BALL ", " BESIDE " ); }"),
         FILLED, true},
        {"", LAMP, MATERIALS,
         NAMED("mirror", "{ union = ( " BALL ", " BESIDE
                         " ); }") "," OF("glass", "{ difference = ( " BALL ", " BOX " ); }"),
         FILLED, false},
        {"", LAMP, MATERIALS,
         NAMED("mirror", "{ difference = ( " BALL ", " BALL " ); }") "," OF("clay", BALL),
         "dead        object \"it\" (line 6): no point is in it", true},
        {"", LAMP, MATERIALS, NAMED("mirror", BALL), "dead        object", false},
    };
    RUN(cases);
}

/* ---- Lights --------------------------------------------------------------------------------- */

#define LIGHT_LEFT "dead        light (line 4): nothing that is seen reflects any of it"
#define GREEN      "green = { colour = [0, 200, 0]; diffuse = 0.7; "

static void lights_that_light_nothing_are_dead(void **state) {
    (void)state;
    static const struct scene_case cases[] = {
        {"", BLACK_LAMP, MATERIALS, OF("clay", BALL), "dead        light (line 4): it is black",
         true},
        {"", DIM_LAMP, MATERIALS, OF("clay", BALL), "dead        light", false},
        {"", LAMP, MATERIALS, OF("own", BALL), LIGHT_LEFT, true},
        {"", LAMP, MATERIALS, OF("clay", BALL), LIGHT_LEFT, false},
        {"", LAMP, MATERIALS, OF("mirror", BALL), LIGHT_LEFT, false},
        {"", LAMP, MATERIALS TABLE("0"), OF("shiny", BALL), LIGHT_LEFT, false},
        {"", RED_LAMP, GREEN "};", OF("green", BALL), LIGHT_LEFT, true},
        {"", LAMP, GREEN "};", OF("green", BALL), LIGHT_LEFT, false},
        {"", RED_LAMP, GREEN STRIPED, OF("green", BALL), LIGHT_LEFT, false},
        {"", RED_LAMP, GREEN "specular = 0.1; };", OF("green", BALL), LIGHT_LEFT, false},
        {"", LAMP, MATERIALS, OF("own", BALL) "," OF("clay", BESIDE), LIGHT_LEFT, false},
        {"", LAMP, MATERIALS, OF("own", BALL) "," OF("clay", BEHIND), LIGHT_LEFT, true},
        {"mixing = \"filter\";", LAMP, "lit = { colour = [9, 9, 9]; diffuse = 1; ior = 1.5; };",
         OF("lit", BALL), LIGHT_LEFT, true},
        {"", LAMP, "lit = { colour = [9, 9, 9]; diffuse = 1; ior = 1.5; };", OF("lit", BALL),
         LIGHT_LEFT, false},
        {"attenuation = { constant = 1; };", LAMP, MATERIALS, OF("own", BALL),
         "dead        fading: no light lights anything", true},
        {"attenuation = { constant = 1; };", LAMP, MATERIALS, OF("clay", BALL),
         "dead        fading", false},
        {"highlight = \"blinn\";", LAMP, MATERIALS, OF("clay", BALL),
         "dead        highlights by beta: every material's specular is 0", true},
        {"highlight = \"blinn\";", "", MATERIALS, OF("mirror", BALL),
         "dead        highlights by beta: no light lights anything", true},
        {"highlight = \"blinn\";", LAMP, MATERIALS, OF("mirror", BALL),
         "dead        highlights by beta", false},
        {"", LAMP, MATERIALS, OF("clay", BALL), "dead        highlights and mirrors", true},
        {"", LAMP, MATERIALS, OF("mirror", BALL), "dead        highlights and mirrors", false},
        {"", LAMP, MATERIALS TABLE("0"), OF("shiny", BALL), "dead        highlights and mirrors",
         false},
        {"", LAMP, MATERIALS, OF("own", BALL), "dead        shadow rays: there is no light", true},
        {"", LAMP, MATERIALS, OF("clay", BALL), "dead        shadow rays", false},
    };
    RUN(cases);
}

/* ---- Materials ------------------------------------------------------------------------------ */

#define UNMADE          "dead        material \"glass\" (line 5): no object is made of it"
#define UNREACHED       "dead        material \"glass\" (line 5): no ray reaches what is made of it"
#define PATTERN_OF(why) "dead        pattern of \"striped\" (line 5): " why
#define HALF_SEEN       "striped = { colour = [200, 9, 8]; " STRIPED
#define OWN_STRIPES     "striped = { colour = [200, 9, 8]; ambient = 1; ambient_is_own = true; " STRIPED
#define LIT_STRIPES     "striped = { colour = [200, 9, 8]; diffuse = 1; " STRIPED
#define SAME_STRIPES    "striped = { colour = [9, 9, 8]; diffuse = 1; " STRIPED
#define GLASS_STRIPES   "striped = { colour = [200, 9, 8]; diffuse = 1; ior = 1.5; " STRIPED

static void materials_without_an_effect_are_dead(void **state) {
    (void)state;
    static const struct scene_case cases[] = {
        {"", LAMP, MATERIALS, OF("clay", BALL), UNMADE, true},
        {"", LAMP, MATERIALS, OF("glass", BALL), UNMADE, false},
        {"", LAMP, MATERIALS, OF("clay", BALL) "," OF("glass", BEHIND), UNREACHED, true},
        {"", LAMP, MATERIALS, OF("mirror", BALL) "," OF("glass", BEHIND), "material \"glass\"",
         false},
        /* What cuts gives shape only. */
        {"", LAMP, MATERIALS,
         OF("clay",
            "{ difference = ( " BALL ", { ball = { radius = 0.5; }; material = \"glass\"; } ); }"),
         UNMADE, true},
        {"", LAMP, MATERIALS,
         OF("clay",
            "{ union = ( " BESIDE ", { ball = { radius = 0.5; }; material = \"glass\"; } ); }"),
         "material \"glass\"", false},
        {"", LAMP, SAME_STRIPES, OF("striped", BALL),
         PATTERN_OF("both of its colours are the same"), true},
        {"", LAMP, LIT_STRIPES, OF("striped", BALL), "dead        pattern", false},
        {"", LAMP, HALF_SEEN, OF("striped", BALL), PATTERN_OF("its colours are not to be seen"),
         true},
        {"", "", LIT_STRIPES, OF("striped", BALL), PATTERN_OF("its colours are not to be seen"),
         true},
        {"", "", OWN_STRIPES, OF("striped", BALL), "dead        pattern", false},
        {"mixing = \"filter\";", LAMP, GLASS_STRIPES, OF("striped", BALL),
         PATTERN_OF("its colours are not to be seen"), true},
        {"", LAMP, GLASS_STRIPES, OF("striped", BALL), "dead        pattern", false},
        {"", LAMP, TABLE("0.5"), OF("shiny", BALL),
         "dead        table of \"shiny\" (line 5): all of its values are the same", true},
        {"", LAMP, TABLE("0.4"), OF("shiny", BALL), "dead        table", false},
        {"mixing = \"filter\";", LAMP,
         "lit = { colour = [9, 9, 9]; specular = 0.4; ior = 1.5; };" CLAY,
         OF("lit", BALL) "," OF("clay", BESIDE),
         "dead        highlight of \"lit\" (line 5): no light makes one", true},
        {"", LAMP, "lit = { colour = [9, 9, 9]; specular = 0.4; ior = 1.5; };", OF("lit", BALL),
         "dead        highlight of", false},
        {"", "", "lit = { colour = [9, 9, 9]; specular = 0.4; ior = 1.5; };", OF("lit", BALL),
         "dead        highlight of", true},
        {"", "", GLASS, OF("glass", BALL), "dead        highlight of", false},
        {"", "", "lit = { colour = [9, 9, 9]; ior = 1.5; " SPECULAR_TABLE("0.4"), OF("lit", BALL),
         "dead        highlight of", true},
        {"", "", MIRROR, OF("mirror", BALL), "dead        highlight of", false},
    };
    RUN(cases);
}

#define UNENTERED   "dead        absorption of \"glass\" (line 5): no ray enters it"
#define OPEN(tau)   "glass = { colour = [0, 0, 0]; transmittance = " tau "; absorption = 0.5; };"
#define TINTED(red) "glass = { colour = [" red ", 0, 0]; ior = 1.5; absorption = 0.5; };"
#define BLOCKED(kt)                                                                                \
    "glass = { colour = [9, 9, 9]; ior = 1.5; absorption = 0.5; "                                  \
    "transmittance_factors = (0, 0, " kt "); };"

static void absorption_of_glass_never_entered_is_dead(void **state) {
    (void)state;
    static const struct scene_case cases[] = {
        {"depth = 0;", LAMP, GLASS, OF("glass", BALL), UNENTERED, true},
        {"depth = 1;", LAMP, GLASS, OF("glass", BALL), UNENTERED, false},
        {"depth = 0;", LAMP, GLASS, OF("glass", BALL_AT("0", "-6", "2", "1")), UNENTERED, false},
        {"model = \"simple\";", LAMP, OPEN("0"), OF("glass", BALL), UNENTERED, true},
        {"model = \"simple\";", LAMP, OPEN("0.5"), OF("glass", BALL), UNENTERED, false},
        {"mixing = \"filter\";", LAMP, TINTED("0"), OF("glass", BALL), UNENTERED, true},
        {"mixing = \"filter\";", LAMP, TINTED("1"), OF("glass", BALL), UNENTERED, false},
        {"", LAMP, TINTED("0"), OF("glass", BALL), UNENTERED, false},
        {"model = \"wavelength\";", LAMP, BLOCKED("0"), OF("glass", BALL), UNENTERED, true},
        {"model = \"wavelength\";", LAMP, BLOCKED("0.5"), OF("glass", BALL), UNENTERED, false},
        {"mixing = \"filter\";", LAMP, MATERIALS, OF("clay", BALL),
         "dead        filters: nothing that is seen is transparent", true},
        {"mixing = \"filter\";", LAMP, MATERIALS, OF("ghost", BALL), "dead        filters", false},
        {"model = \"simple\";", LAMP, MATERIALS, OF("clay", BALL),
         "dead        simplified model: nothing that is seen is transparent", true},
        {"model = \"simple\";", LAMP, MATERIALS, OF("glass", BALL), "dead        simplified model",
         false},
    };
    RUN(cases);
}

/* An object of several materials is in several parts. */
static void an_object_is_called_dead_once_for_each_reason(void **state) {
    (void)state;
#define TWO(other, x)                                                                              \
    NAMED("clay", "{ union = ( " BALL_AT(x, "-9", "1",                                             \
                                         "0.5") ", { ball = { centre = (" x                        \
                                                ", -9, 3); radius = 0.5; }; material = \"" other   \
                                                "\"; } ); }")
    static const struct scene_case scene = {
        "", LAMP, MATERIALS, TWO("dull", "0") "," TWO("ghost", "2") "," OF("own", BALL), "", true};
    char text[TEXT_SIZE];
    struct compiled_scene *compiled = compile_case(&scene, text);
    unsigned told = 0;
    for (unsigned i = 0; i < compiled->dead_count; i++) {
        told += strcmp(compiled->dead[i].what, "object \"it\" (line 6)") == 0;
    }
    assert_int_equal(told, 3); /* of the second one, only the clay could throw a shadow */
    free(compiled);
}

/* ---- Depth ---------------------------------------------------------------------------------- */

static void depth_is_what_paths_can_use(void **state) {
    (void)state;
    static const struct {
        const char *settings, *objects;
        bool estimates;
        unsigned depth;
    } cases[] = {
        {"", OF("clay", BALL), false, 0},
        {"", OF("clay", BALL) "," OF("mirror", BEHIND), false, 0},
        {"", OF("clay", BALL), true, 0},
        /* A ball mirrors no ray to itself; a box, two balls, or one that is hollow may. */
        {"threshold = 0;", OF("mirror", BALL), false, 1},
        {"threshold = 0;", OF("mirror", "{ ellipsoid = { radii = (1, 0.5, 0.7); }; }"), false, 1},
        {"threshold = 0;", OF("mirror", BOX), false, 255},
        {"threshold = 0;", OF("mirror", BALL_AT("0", "-6", "2", "1")), false, 255},
        {"threshold = 0;", OF("mirror", BALL) "," OF("mirror", BESIDE), false, 255},
        {"threshold = 0;", OF("mirror", BALL) "," OF("ghost", BALL_AT("0", "-1", "1", "0.5")),
         false, 255},
        {"threshold = 0;", OF("ghost", BALL_AT("0", "-1", "1", "0.5")) "," OF("mirror", BALL),
         false, 5},
        {"threshold = 0;", OF("mirror", "{ difference = ( " BALL ", " BESIDE " ); }"), false, 1},
        {"threshold = 0;",
         OF("mirror", "{ difference = ( " BALL ", " BALL_AT("0", "-1", "1", "0.5") " ); }"), false,
         255},
        {"threshold = 0;", OF("glass", BALL), false, 255},
        /* Straight on, each convex solid is entered and left once, others twice. */
        {"threshold = 0;", OF("ghost", BALL), false, 2},
        {"threshold = 0;", OF("ghost", BOX), false, 2},
        {"threshold = 0;", OF("ghost", "{ ellipsoid = { radii = (1, 0.5, 0.7); }; }"), false, 2},
        {"threshold = 0;", OF("ghost", BALL) "," OF("ghost", BESIDE), false, 4},
        {"threshold = 0;", OF("ghost", BALL) "," OF("clay", BESIDE), false, 2},
        {"threshold = 0; model = \"simple\";", OF("glass", BALL), false, 2},
        {"threshold = 0;",
         OF("ghost", "{ hyperboloid = { from = (0, 0, 0); to = (0, 0, 2); radius = 1; "
                     "waist = 0.5; }; }"),
         false, 4},
        {"threshold = 0;", OF("ghost", BALL) "," OF("mirror", BALL_AT("0", "3", "1", "0.5")), false,
         5},
        /* 0.1^3 is above the threshold of 1/4096, 0.1^4 is not; 0.5^12 is just that. */
        {"", OF("dull", BOX) "," OF("dull", BESIDE), false, 4},
        {"", OF("dull", BOX) "," OF("dull", BESIDE), true, 255},
        {"", OF("dull", BOX) "," OF("mirror", BESIDE), false, 13},
        {"threshold = 0.000001;", OF("dull", BOX), false, 255},
        {"threshold = 1;", OF("dull", BOX), false, 1},
        {"", OF("dull", BOX) "," OF("glass", BESIDE), false, 255},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        char text[TEXT_SIZE];
        (void)snprintf(text, sizeof text,
                       HEAD "depth = 255; %s\nlights = ( " LAMP " );\nmaterials = { " MATERIALS
                            " };\nobjects = ( %s );\n",
                       cases[i].settings, cases[i].objects);
        struct scene_description *description = read_text(text);
        description->estimates = cases[i].estimates;
        struct loaded_scene loaded = load_description(description, "f64");
        if (loaded.compiled->depth != cases[i].depth || loaded.compiled->depth_asked != 255) {
            fail_msg("depth %u instead of %u of\n%s", loaded.compiled->depth, cases[i].depth, text);
        }
        scene_description_free(description);
        unload(&loaded);
    }
}

static void what_ends_paths_is_said(void **state) {
    (void)state;
    static const struct scene_case cases[] = {
        {"", LAMP, MATERIALS, OF("clay", BALL),
         "dead        depth beyond 0: what is seen neither mirrors nor lets light through", true},
        {"", LAMP, MATERIALS, OF("ghost", BALL),
         "dead        depth beyond 2: no path is mirrored or let through more often", true},
        {"", LAMP, MATERIALS, OF("dull", BOX),
         "dead        depth beyond 4: the threshold ends every path by then", true},
        {"", LAMP, MATERIALS, OF("glass", BALL), "dead        depth", false},
        {"depth = 4;", LAMP, MATERIALS, OF("dull", BOX), "dead        depth", false},
    };
    RUN(cases);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_out_of_view_is_dead_unless_rays_turn_to_it),
        cmocka_unit_test(what_throws_no_shadow_that_is_seen_is_dead),
        cmocka_unit_test(what_is_covered_is_dead),
        cmocka_unit_test(lights_that_light_nothing_are_dead),
        cmocka_unit_test(materials_without_an_effect_are_dead),
        cmocka_unit_test(absorption_of_glass_never_entered_is_dead),
        cmocka_unit_test(an_object_is_called_dead_once_for_each_reason),
        cmocka_unit_test(depth_is_what_paths_can_use),
        cmocka_unit_test(what_ends_paths_is_said),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
