/* SPDX-License-Identifier: MIT */
/* `check` calls dead what is, with the reason, and nothing else: each proof with what undoes it. */
#include "required_fixture.h"

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
    compiled_scene_free(compiled);
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
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
