/* SPDX-License-Identifier: MIT */
/* Extremes of the tree of rays and of lighting: depth, threshold, lights in odd places, fading. */
#include "extremes_fixture.h"

/* ---- Depth and threshold --------------------------------------------------------------------- */

/* Straight down on a slab: each event sends one branch out for good and one on. */
static const char slab[] =
    "version = 1; size = [1, 1]; depth = %d; threshold = %.17g; model = \"%s\";\n"
    "background = [100, 100, 100];\n"
    "camera = { eye = (0, 0, 20); look_at = (0, 0, 0); up = (0, 1, 0); field_of_view = 1; };\n"
    "materials = { glass = { colour = [0, 0, 0]; ior = 2.5; transmittance = %.17g; }; };\n"
    "objects = ( { material = \"glass\"; solid = { box = { min = (-9, -9, -1); max = (9, 9, 0); };"
    " }; } );\n";

static void render_slab(struct picture *picture, const char *arithmetic, int depth,
                        double threshold, const char *model, double transmittance) {
    char text[2048];
    snprintf(text, sizeof text, slab, depth, threshold, model, transmittance);
    render_text(picture, text, arithmetic);
}

static void depth_0_to_255_cuts_after_as_many_events(void **state) {
    (void)state;
    static const int depths[] = {0, 1, 2, 10, 64, 255};
    static struct picture seen;
    const double ks = (1.5 / 3.5) * (1.5 / 3.5);
    for (size_t i = 0; i < sizeof depths / sizeof depths[0]; i++) {
        for (int j = 0; j < EXTREME_ARITHMETICS; j++) {
            int depth = depths[i];
            render_slab(&seen, extreme_arithmetics[j], depth, 0, "fresnel", 1);
            /* What is reflected inside is cut off or has come out. */
            double expected = depth == 0 ? 0 : 100 * (ks + (1 - ks) * (1 - pow(ks, depth - 1)));
            assert_true(fabs(seen.level[0][1] - expected) < 1e-3);
            assert_true(fabs(seen.weight_at_ends[0] - 1) < 1e-6);
            assert_true(seen.counts.rays <= 1 + 2 * (uint32_t)depth);
            assert_true(depth > 10 || seen.counts.rays == 1 + 2 * (uint32_t)depth);
            assert_true(j < F64 || seen.counts.rays == 1 + 2 * (uint32_t)depth);
        }
    }
}

/* From within a cube of n = 4 hardly any ray gets out: its weight stays 1 for all 255 events. */
static void trapped_light_is_followed_255_times_and_no_more(void **state) {
    (void)state;
    static struct picture seen;
    for (int j = 0; j < EXTREME_ARITHMETICS; j++) {
        render_text(&seen,
                    "version = 1; size = [9, 7]; depth = 255; threshold = 0.0001;\n"
                    "background = [100, 100, 100];\n"
                    "camera = { eye = (0.1, 0.2, 0.3); look_at = (1.1, 1.3, 1.2); up = (0, 0, 1);"
                    " field_of_view = 3; };\n"
                    "materials = { glass = { colour = [0, 0, 0]; ior = 4.0; }; };\n"
                    "objects = ( { material = \"glass\"; solid = { box = { min = (-1, -1, -1);"
                    " max = (1, 1, 1); }; }; } );\n",
                    extreme_arithmetics[j]);
        assert_int_equal(seen.counts.rays, 63 * 256);
        for (int pixel = 0; pixel < 63; pixel++) {
            assert_true(fabs(seen.weight_at_ends[pixel] - 1) <= 0);
            assert_true(fabs(seen.level[pixel][0]) <= 0);
        }
    }
}

/* A branch is cut where it weighs less than the threshold, not where it weighs as much. */
static void the_threshold_cuts_what_is_less(void **state) {
    (void)state;
    static struct picture seen;
    for (int j = 0; j < EXTREME_ARITHMETICS; j++) {
        const char *arithmetic = extreme_arithmetics[j];
        render_slab(&seen, arithmetic, 9, 0.5, "simple", 0.5);
        assert_int_equal(seen.counts.rays, 2);
        render_slab(&seen, arithmetic, 9, 0.5 + 1e-7, "simple", 0.5);
        assert_int_equal(seen.counts.rays, 1);
        render_slab(&seen, arithmetic, 9, 0.25, "simple", 0.5);
        assert_int_equal(seen.counts.rays, 3);
        assert_true(fabs(seen.level[0][0] - 25) < 1e-4);
        render_slab(&seen, arithmetic, 9, 0, "simple", 0.5);
        assert_int_equal(seen.counts.rays, 3);
        render_slab(&seen, arithmetic, 9, 1, "simple", 0.5);
        assert_int_equal(seen.counts.rays, 1);
        render_slab(&seen, arithmetic, 9, 1, "simple", 1);
        assert_int_equal(seen.counts.rays, 3);
        assert_true(fabs(seen.level[0][0] - 100) < 1e-4);
    }
}

/* ---- Lights ---------------------------------------------------------------------------------- */

static const char plate_head[] =
    "version = 1; size = [9, 9]; depth = 4; background = [0, 0, 0]; %s\n"
    "camera = { eye = (%.17g, %.17g, %.17g); look_at = (0, 0, %.17g); up = (0, 1, 0);"
    " field_of_view = 20; };\n"
    "lights = ( %s );\n"
    "materials = { plate = { colour = [200, 200, 200]; diffuse = 1; };\n"
    "  glass = { colour = [0, 0, 0]; ior = 1.5; casts_shadow = %s; };\n"
    "  clay = { colour = [90, 90, 90]; diffuse = 1; }; };\n"
    "objects = ( { material = \"plate\"; solid = { box = { min = (-9, -9, -1); max = (9, 9, 0); };"
    " }; } %s );\n";

static void render_plate(struct picture *picture, const char *arithmetic, const char *lights,
                         const char *objects) {
    char text[EXTREME_TEXT_SIZE];
    snprintf(text, sizeof text, plate_head, "", 0.0, 0.0, 20.0, 0.0, lights, "false", objects);
    render_text(picture, text, arithmetic);
}

/* Middle pixel: 4, 4. */
enum { MIDDLE = 9 * 4 + 4 };

static void a_light_on_or_behind_a_surface_does_not_light_it(void **state) {
    (void)state;
    static struct picture seen;
    for (int j = 0; j < EXTREME_ARITHMETICS; j++) {
        render_plate(&seen, extreme_arithmetics[j], "{ position = (0, 0, 0); }", "");
        for (int pixel = 0; pixel < 81; pixel++) {
            assert_true(seen.level[pixel][0] < 0.5);
        }
        render_plate(&seen, extreme_arithmetics[j],
                     "{ position = (0, 0, -0.5); }, { position = (0, 0, -5); }, "
                     "{ direction = (0, 0, 1); }, { direction = (1, 0, 0); }",
                     "");
        for (int pixel = 0; pixel < 81; pixel++) {
            assert_true(fabs(seen.level[pixel][0]) <= 0);
        }
        /* ... and just above, it does: straight under it with all its strength. */
        render_plate(&seen, extreme_arithmetics[j], "{ position = (0, 0, 0.001); }", "");
        assert_true(fabs(seen.level[MIDDLE][0] - 200) < 1);
        assert_true(seen.level[0][0] < 1);
    }
}

/* Clear glass keeps no light off; glass that casts a shadow keeps in all of it, a shell too. */
static void a_light_inside_glass_shines_through_it(void **state) {
    (void)state;
    static const char light[] = "{ position = (3, 0, 2); }";
    static const char *const lamps[] = {
        ", { material = \"glass\"; solid = { ball = { centre = (3, 0, 2); radius = 0.5; }; }; }",
        ", { material = \"glass\"; solid = { box = { min = (2.5, -1, 1); max = (4, 1, 3); }; }; }",
        (", { material = \"glass\"; solid = { difference = ( { ball = { centre = (3, 0, 2); "
         "radius = 0.5; }; }, { ball = { centre = (3, 0, 2); radius = 0.4; }; } ); }; }"),
    };
    static struct picture bare, seen;
    char text[EXTREME_TEXT_SIZE];
    for (size_t i = 0; i < sizeof lamps / sizeof lamps[0]; i++) {
        for (int j = 0; j < EXTREME_ARITHMETICS; j++) {
            render_plate(&bare, extreme_arithmetics[j], light, "");
            render_plate(&seen, extreme_arithmetics[j], light, lamps[i]);
            double cosine = 2 / sqrt(13); /* at the middle pixel */
            assert_true(fabs(seen.level[MIDDLE][0] - 200 * cosine) < 0.01);
            for (int y = 0; y < 9; y++) { /* the left half, which the lamp does not hide */
                assert_true(fabs(bare.level[9 * y][0] - seen.level[9 * y][0]) < 1e-2);
            }
            snprintf(text, sizeof text, plate_head, "", 0.0, 0.0, 20.0, 0.0, light, "true",
                     lamps[i]);
            render_text(&seen, text, extreme_arithmetics[j]);
            assert_true(fabs(seen.level[MIDDLE][0]) <= 0);
        }
    }
}

static void a_light_inside_an_opaque_solid_is_hidden(void **state) {
    (void)state;
    static struct picture seen;
    for (int j = 0; j < EXTREME_ARITHMETICS; j++) {
        render_plate(
            &seen, extreme_arithmetics[j], "{ position = (0, 3, 2); }",
            ", { material = \"clay\"; solid = { ball = { centre = (0, 3, 2); radius = 0.5; "
            "}; }; }");
        assert_true(fabs(seen.level[MIDDLE][0]) <= 0);
    }
}

static void a_hundred_lights_are_a_hundred_times_one(void **state) {
    (void)state;
    static struct picture one, many;
    char lights[8192] = "";
    for (int i = 0; i < 100; i++) {
        strcat(lights, i ? ", " : "");
        strcat(lights, "{ direction = (0.3, 0.2, -1); colour = (2.55, 1.5, 0.5); }");
    }
    for (int j = 0; j < EXTREME_ARITHMETICS; j++) {
        render_plate(&many, extreme_arithmetics[j], lights, "");
        render_plate(&one, extreme_arithmetics[j],
                     "{ direction = (0.3, 0.2, -1); colour = (255, 150, 50); }", "");
        assert_true(one.level[MIDDLE][0] > 150);
        for (int i = 0; i < 3; i++) {
            assert_true(fabs(many.level[MIDDLE][i] - one.level[MIDDLE][i]) < 0.01);
        }
    }
    /* 128 of the strongest saturate: white, not a number that has wrapped. */
    lights[0] = '\0';
    for (int i = 0; i < 128; i++) {
        strcat(lights, i ? ", " : "");
        strcat(lights, "{ direction = (0, 0, -1); colour = [32767, 32767, 32767]; }");
    }
    for (int j = 0; j < EXTREME_ARITHMETICS; j++) {
        render_plate(&many, extreme_arithmetics[j], lights, "");
        assert_true(many.level[MIDDLE][0] > 32767);
    }
}

/* ---- Fading by C + D ------------------------------------------------------------------------- */

/* The eye is on the plate and looks into it: D = 0. With C = 0 the light has no limit but white. */
static void where_c_and_d_are_0_the_light_is_white(void **state) {
    (void)state;
    static const double constants[] = {0, 1e-9, 0.001, 4};
    static struct picture seen;
    for (size_t i = 0; i < sizeof constants / sizeof constants[0]; i++) {
        for (int j = 0; j < EXTREME_ARITHMETICS; j++) {
            char text[EXTREME_TEXT_SIZE], attenuation[64];
            snprintf(attenuation, sizeof attenuation, "attenuation = { constant = %.17g; };",
                     constants[i]);
            snprintf(text, sizeof text, plate_head, attenuation, 0.0, 0.0, 0.0, -1.0,
                     "{ position = (0, 0, 5); }", "false", "");
            render_text(&seen, text, extreme_arithmetics[j]);
            double expected = fmin(200 / constants[i], 32767);
            if (!(fabs(seen.level[MIDDLE][0] - expected) < 2)) {
                fail_msg("%s, C = %g: %.9g instead of %.9g", extreme_arithmetics[j], constants[i],
                         seen.level[MIDDLE][0], expected);
            }
            /* From 20 units away it is the law of the paper's Eq. (1). */
            snprintf(text, sizeof text, plate_head, attenuation, 0.0, 0.0, 20.0, 0.0,
                     "{ position = (0, 0, 5); }", "false", "");
            render_text(&seen, text, extreme_arithmetics[j]);
            assert_true(fabs(seen.level[MIDDLE][0] - 200 / (20 + constants[i])) < 1e-3);
        }
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(depth_0_to_255_cuts_after_as_many_events),
        cmocka_unit_test(trapped_light_is_followed_255_times_and_no_more),
        cmocka_unit_test(the_threshold_cuts_what_is_less),
        cmocka_unit_test(a_light_on_or_behind_a_surface_does_not_light_it),
        cmocka_unit_test(a_light_inside_glass_shines_through_it),
        cmocka_unit_test(a_light_inside_an_opaque_solid_is_hidden),
        cmocka_unit_test(a_hundred_lights_are_a_hundred_times_one),
        cmocka_unit_test(where_c_and_d_are_0_the_light_is_white),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
