/* SPDX-License-Identifier: MIT */
/* The depth level that paths can use, and what a page of features has for them. */
#include "required_fixture.h"

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

/* ---- The page of an image ------------------------------------------------------------------- */

static void a_page_has_what_paths_need(void **state) {
    (void)state;
    static const struct {
        const char *settings, *objects;
        bool estimates;
        const char *written;
    } cases[] = {
        {"depth = 0;", OF("glass", BALL), false, "FEATURE_TRANSPARENCY = 0,"},
        {"depth = 1;", OF("glass", BALL), false, "FEATURE_TRANSPARENCY = 1,"},
        {"depth = 0;", OF("glass", BALL), true, "FEATURE_TRANSPARENCY = 1,"},
        {"depth = 9; model = \"simple\";", OF("glass", BALL), false, "FEATURE_SIMPLE = 1,"},
        {"depth = 0; model = \"simple\";", OF("glass", BALL), false, "FEATURE_SIMPLE = 0,"},
        {"depth = 9;", OF("clay", BALL), true, "FEATURE_ESTIMATE = 0,"},
        {"depth = 9;", OF("dull", BALL), true, "FEATURE_ESTIMATE = 1,"},
        {"depth = 9;", OF("ghost", BALL), false, "FEATURE_DEPTH = 2,"},
        {"depth = 9;", OF("clay", BALL), false, "FEATURE_DEPTH = 0,"},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        char text[TEXT_SIZE], page[TEXT_SIZE];
        (void)snprintf(text, sizeof text,
                       HEAD "%s\nlights = ( " LAMP " );\nmaterials = { " MATERIALS
                            " };\nobjects = ( %s );\n",
                       cases[i].settings, cases[i].objects);
        struct scene_description *description = read_text(text);
        description->estimates = cases[i].estimates;
        struct loaded_scene loaded = load_description(description, "f64");
        FILE *file = tmpfile();
        assert_non_null(file);
        assert_int_equal(features_emit(file, loaded.compiled, "it"), 0);
        rewind(file);
        page[fread(page, 1, sizeof page - 1, file)] = '\0';
        (void)fclose(file);
        if (strstr(page, cases[i].written) == NULL) {
            fail_msg("no \"%s\" in\n%s\nof\n%s", cases[i].written, page, text);
        }
        scene_description_free(description);
        unload(&loaded);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(depth_is_what_paths_can_use),
        cmocka_unit_test(what_ends_paths_is_said),
        cmocka_unit_test(a_page_has_what_paths_need),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
