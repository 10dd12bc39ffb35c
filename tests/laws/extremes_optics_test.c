/* SPDX-License-Identifier: MIT */
/* Extremes of light in matter: indices, the critical angle, grazing light, gloss, absorption. */
#include "extremes_fixture.h"

/* One pixel that looks at the origin along a ray in the x z plane. */
static const char dot_head[] =
    "version = 1; size = [1, 1]; depth = %d; threshold = %.17g; background = [100, 100, 100];\n"
    "camera = { eye = (%.17g, 0, %.17g); look_at = (%.17g, 0, 0); up = (0, 1, 0);"
    " field_of_view = 1; };\n";

/* The first boundary's two branches, and all there is. */
struct first_event {
    double reflected, refracted; /* weights */
    bool passes;
    double level;
    uint64_t rays;
};

static void see_node(void *context, const struct observed_node *node) {
    struct first_event *event = context;
    if (node->parent == 1) {
        *(node->kind == OBSERVED_REFLECTED ? &event->reflected : &event->refracted) =
            node->weight[1];
        event->passes = event->passes || node->kind == OBSERVED_REFRACTED;
    }
}

static void see_end(void *context, const struct observed_end *end) {
    struct first_event *event = context;
    if (end->parent == 1) {
        *(end->kind == OBSERVED_REFLECTED ? &event->reflected : &event->refracted) = end->weight[1];
        event->passes =
            event->passes || (end->kind == OBSERVED_REFRACTED && end->why != OBSERVED_NOTHING);
    }
}

static struct first_event look(const char *text, const char *arithmetic) {
    struct first_event event = {0, 0, false, 0, 0};
    const struct pixel_observer observer = {&event, see_node, see_end};
    struct loaded_scene loaded = load_text(text, arithmetic);
    struct render_counts counts;
    memset(&counts, 0, sizeof counts);
    double level[3];
    loaded.arithmetic->pixel(loaded.scene, 0, 0, level, &counts, &observer);
    assert_int_equal(counts.leaked_rays, 0);
    assert_true(level[1] >= 0 && level[1] <= 32768);
    event.level = level[1];
    event.rays = counts.rays;
    unload(&loaded);
    return event;
}

/* ---- The critical angle ---------------------------------------------------------------------- */

static struct first_event look_from_within(double aside, const char *arithmetic) {
    char text[2048];
    size_t used = (size_t)snprintf(text, sizeof text, dot_head, 1, 0.0, 0.0, -5.0, aside);
    snprintf(text + used, sizeof text - used,
             "materials = { glass = { colour = [0, 0, 0]; ior = 1.5; }; };\nobjects = ( { material "
             "= \"glass\"; solid = { box = { min = (-50, -50, -50); max = (50, 50, 0); }; }; } );");
    return look(text, arithmetic);
}

/* Halves the interval of angles down to one bit of the arithmetic's directions: on one side next to
 * nothing passes, on the other nothing at all, and the boundary is where Snell's law has it. */
static void a_bit_decides_at_the_critical_angle(void **state) {
    (void)state;
    static const double exactness[EXTREME_ARITHMETICS] = {1e-8, 1e-6, 1e-14};
    static const double passes_most[EXTREME_ARITHMETICS] = {1e-3, 1e-2, 1e-6};
    const double critical = 5 / sqrt(1.5 * 1.5 - 1); /* 5 tan(asin(1 / 1.5)) */
    for (int i = 0; i < EXTREME_ARITHMETICS; i++) {
        double low = 4, high = 5, middle;
        while (middle = low + (high - low) / 2, middle > low && middle < high) {
            *(look_from_within(middle, extreme_arithmetics[i]).passes ? &low : &high) = middle;
        }
        const struct first_event below = look_from_within(low, extreme_arithmetics[i]);
        const struct first_event beyond = look_from_within(high, extreme_arithmetics[i]);
        assert_true(fabs(low - critical) < 20 * exactness[i]);
        assert_true(below.passes && !beyond.passes);
        assert_true(fabs(beyond.reflected - 1) <= 0);
        assert_true(below.refracted >= 0 && below.refracted < passes_most[i]);
        assert_true(fabs(below.refracted + below.reflected - 1) < 1e-6);
    }
}

/* ---- Angles and indices ---------------------------------------------------------------------- */

static double fresnel(double cosine, double n) {
    double refracted = sqrt(1 - (1 - cosine * cosine) / (n * n));
    double s = (cosine - n * refracted) / (cosine + n * refracted);
    double p = (n * cosine - refracted) / (n * cosine + refracted);
    return (s * s + p * p) / 2;
}

static void grazing_light_is_reflected_by_fresnels_law(void **state) {
    (void)state;
    static const double angles[] = {85, 89, 89.9, 89.99, 89.999};
    static const double tolerance[EXTREME_ARITHMETICS] = {1e-6, 1e-5, 1e-9};
    for (size_t i = 0; i < sizeof angles / sizeof angles[0]; i++) {
        for (int j = 0; j < EXTREME_ARITHMETICS; j++) {
            char text[2048];
            double radians = angles[i] * acos(-1) / 180;
            size_t used = (size_t)snprintf(text, sizeof text, dot_head, 1, 0.0, 20 * sin(radians),
                                           20 * cos(radians), 0.0);
            snprintf(text + used, sizeof text - used,
                     "materials = { glass = { colour = [0, 0, 0]; ior = 1.5; }; };\nobjects = ( { "
                     "material = \"glass\"; solid = { box = { min = (-9, -9, -1); max = (9, 9, 0); "
                     "}; }; } );");
            const struct first_event event = look(text, extreme_arithmetics[j]);
            assert_true(fabs(event.reflected - fresnel(cos(radians), 1.5)) < tolerance[j]);
            assert_true(fabs(event.reflected + event.refracted - 1) < 1e-6);
        }
    }
}

static const char world[] =
    "version = 1; size = [32, 20]; depth = 12;\n"
    "camera = { eye = (3.1, -7.3, 5.2); look_at = (0.0, 0.0, 0.2); field_of_view = 30; };\n"
    "materials = { glass = { colour = [0, 0, 0]; ior = %.17g; };\n"
    "  board = { colour = [200, 200, 200]; ambient = 0.8; ambient_is_own = true;\n"
    "            pattern = { size = (0.7, 0.7, 0); colour = [40, 20, 60]; }; }; };\n"
    "objects = ( { material = \"board\"; solid = { box = { min = (-9, -9, -2.5); max = (9, 9, "
    "-2.2); }; }; }, { material = \"glass\"; solid = { union = (\n"
    "{ ball = { centre = (-1, 0, 0); radius = 1.1; }; },\n"
    "{ box = { min = (-0.8, -0.8, -0.8); max = (0.8, 0.8, 0.8); }; rotate = (10, 20, 30);"
    " translate = (1.2, 0, 0); } ); }; } );\n";

static void every_allowed_index_gives_f128s_picture(void **state) {
    (void)state;
    static const double indices[] = {0.7, 0.75, 1.0001, 2.5, 4};
    for (size_t i = 0; i < sizeof indices / sizeof indices[0]; i++) {
        char text[EXTREME_TEXT_SIZE];
        snprintf(text, sizeof text, world, indices[i]);
        check_against_f128(text);
    }
}

/* Through n = 1 the board is seen as if nothing were there. */
static void index_1_is_no_interface(void **state) {
    (void)state;
    static struct picture through, without;
    for (int i = 0; i < EXTREME_ARITHMETICS; i++) {
        char text[EXTREME_TEXT_SIZE];
        snprintf(text, sizeof text, world, 1.0);
        render_text(&through, text, extreme_arithmetics[i]);
        assert_true(through.counts.rays > through.counts.nodes);
        /* The same scene, its glass sunk below the board. */
        char *place = strstr(text, "translate = (1.2, 0, 0)");
        assert_non_null(place);
        strcpy(place, "translate = (1.2, 0, -5); } ); translate = (0, 0, -6.0); }; } );\n");
        render_text(&without, text, extreme_arithmetics[i]);
        assert_pictures_agree(&through, &without, pixels_allowed(i, &through),
                              extreme_arithmetics[i]);
        assert_true(without.counts.rays < through.counts.rays);
    }
}

/* ---- Gloss and absorption -------------------------------------------------------------------- */

/* A black plate seen from straight above: the highlight alone, 200 cos^g of the light's angle. */
static void gloss_from_0_to_65535_is_the_cosines_power(void **state) {
    (void)state;
    static const int gloss[] = {0, 1, 32, 1024, 65535};
    static const double angles[] = {0, 0.1, 0.5, 5, 60, 89};
    static const double last_bit[EXTREME_ARITHMETICS] = {0x1p-30, 0x1p-23, 0x1p-52};
    for (size_t i = 0; i < sizeof gloss / sizeof gloss[0]; i++) {
        for (size_t j = 0; j < sizeof angles / sizeof angles[0]; j++) {
            char text[2048];
            double radians = angles[j] * acos(-1) / 180;
            size_t used = (size_t)snprintf(text, sizeof text, dot_head, 0, 0.0, 0.0, 20.0, 0.0);
            snprintf(text + used, sizeof text - used,
                     "lights = ( { direction = (%.17g, 0, %.17g); colour = [200, 200, 200]; } );\n"
                     "materials = { plate = { colour = [0, 0, 0]; specular = 1; gloss = %d; }; };\n"
                     "objects = ( { material = \"plate\"; solid = { box = { min = (-9, -9, -1);"
                     " max = (9, 9, 0); }; }; } );",
                     -sin(radians), -cos(radians), gloss[i]);
            double expected = 200 * pow(cos(radians), gloss[i]);
            for (int k = 0; k < EXTREME_ARITHMETICS; k++) {
                double found = look(text, extreme_arithmetics[k]).level;
                /* A bit of the cosine is worth g bits of its power. */
                double tolerance = 1e-3 + 4 * gloss[i] * last_bit[k] * expected;
                if (!(fabs(found - expected) <= tolerance)) {
                    fail_msg("%s, gloss %d, %g degrees: %.9g instead of %.9g",
                             extreme_arithmetics[k], gloss[i], angles[j], found, expected);
                }
            }
        }
    }
}

static struct first_event look_through(double absorption, const char *arithmetic) {
    char text[2048];
    size_t used = (size_t)snprintf(text, sizeof text, dot_head, 3, 0.0, 0.0, 20.0, 0.0);
    snprintf(text + used, sizeof text - used,
             "materials = { glass = { colour = [0, 0, 0]; ior = 1.0; absorption = %.17g; }; };\n"
             "objects = ( { material = \"glass\"; solid = { box = { min = (-9, -9, -18);"
             " max = (9, 9, 0); }; }; } );",
             absorption);
    return look(text, arithmetic);
}

static void absorption_from_none_to_all_is_exponential(void **state) {
    (void)state;
    static const double depths[] = {0, 1e-6, 0.5, 1, 10, 20, 100, 1000};
    for (size_t i = 0; i < sizeof depths / sizeof depths[0]; i++) {
        for (int j = 0; j < EXTREME_ARITHMETICS; j++) {
            double found = look_through(depths[i] / 18, extreme_arithmetics[j]).level;
            if (!(fabs(found - 100 * exp(-depths[i])) <= 1e-4)) {
                fail_msg("%s, alpha x = %g: %.9g", extreme_arithmetics[j], depths[i], found);
            }
            assert_true(depths[i] > 0 || fabs(found - 100) <= 0);
            assert_true(depths[i] < 999 || fabs(found) <= 0);
        }
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_bit_decides_at_the_critical_angle),
        cmocka_unit_test(grazing_light_is_reflected_by_fresnels_law),
        cmocka_unit_test(every_allowed_index_gives_f128s_picture),
        cmocka_unit_test(index_1_is_no_interface),
        cmocka_unit_test(gloss_from_0_to_65535_is_the_cosines_power),
        cmocka_unit_test(absorption_from_none_to_all_is_exponential),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
