/* SPDX-License-Identifier: MIT */
/* Extremes of what is learned of pruned branches: the deepest levels, light that never ends, lights
 * as bright as they may be. */
#include "extremes_fixture.h"

/* Without an accuracy asked for, and with one: every second pixel either way of 4 x 3, twice. */
enum { PIXELS_LEARNED = 640, PIXELS_LEARNED_FOR_ACCURACY = 2 * 4 };

/* Learns first, as a render does; returns the rays of that. */
static uint64_t render_learned(struct picture *picture, const char *text, const char *arithmetic,
                               bool estimates, double error, struct estimate *estimate) {
    struct scene_description *description = read_text(text);
    struct render_counts counts = {0};
    description->estimates = estimates;
    description->error = error;
    struct loaded_scene loaded = load_description(description, arithmetic);
    memset(estimate, 0, sizeof *estimate);
    if (estimates) {
        loaded.arithmetic->learn(loaded.scene, estimate, &counts);
        assert_int_equal(counts.leaked_rays, 0);
    }
    render_loaded(picture, &loaded);
    unload(&loaded);
    scene_description_free(description);
    return counts.rays;
}

/* A room of perfect mirrors that shine by themselves: each event adds half a level, 1 goes on. */
static const char room[] =
    "version = 1; size = [4, 3]; depth = %d; threshold = 0.001;\n"
    "camera = { eye = (0.1, -3, 0.2); look_at = (0.3, 0, 0.1); };\n"
    "materials = { mirror = { colour = [64, 64, 64]; ambient = 0.0078125; ambient_is_own = true;"
    " specular = 1; };\n  glass = { colour = [0, 0, 0]; ior = 1.1; }; };\n"
    "objects = ( { material = \"mirror\"; solid = { difference = ("
    " { box = { min = (-5, -5, -5); max = (5, 5, 5); }; },"
    " { box = { min = (-4, -4, -4); max = (4, 4, 4); }; } ); }; } %s );\n";

static const char cube[] = ", { material = \"glass\"; solid = { box = { min = (-0.2, -0.2, -0.2); "
                           "max = (0.2, 0.2, 0.2); }; }; }";

static const int deepest[] = {238, 239, 255};
enum { DEEPEST = sizeof deepest / sizeof deepest[0] };

static void what_the_deepest_levels_cut_is_not_followed_in_circles(void **state) {
    (void)state;
    static struct picture seen;
    static struct estimate estimate;
    for (int i = 0; i < DEEPEST; i++) {
        for (int j = 0; j < EXTREME_ARITHMETICS; j++) {
            for (int error = 0; error <= 1; error++) {
                char text[EXTREME_TEXT_SIZE];
                snprintf(text, sizeof text, room, deepest[i], "");
                uint64_t rays =
                    render_learned(&seen, text, extreme_arithmetics[j], true, error, &estimate);
                int followed = deepest[i] < 239 ? deepest[i] + 16 : 255;
                assert_int_equal(rays, error > 0 ? PIXELS_LEARNED_FOR_ACCURACY * (deepest[i] + 1)
                                                 : PIXELS_LEARNED * (followed + 1));
                assert_int_equal(seen.counts.rays, 12 * (deepest[i] + 1));
                assert_int_equal(seen.counts.exhausted_pixels, 0);
                for (int pixel = 0; pixel < 12; pixel++) {
                    double level = 0.5 * (deepest[i] + 1);
                    assert_true(fabs(seen.level[pixel][1] - level) < 0.01);
                }
            }
        }
    }
}

/* Two branches from each of many events: what waits has a place, and ends at the same level. */
static void glass_in_a_room_of_mirrors_is_learned_at_the_deepest_levels(void **state) {
    (void)state;
    static struct picture seen, black;
    static struct estimate estimate;
    for (int i = 0; i < DEEPEST; i++) {
        char text[EXTREME_TEXT_SIZE];
        snprintf(text, sizeof text, room, deepest[i], cube);
        for (int j = 0; j < EXTREME_ARITHMETICS; j++) {
            render_learned(&black, text, extreme_arithmetics[j], false, 0, &estimate);
            render_learned(&seen, text, extreme_arithmetics[j], true, 0, &estimate);
            for (int pixel = 0; pixel < 12; pixel++) {
                assert_true(seen.level[pixel][1] >= black.level[pixel][1] - 0.01);
            }
        }
    }
}

/* A glass block before a checkered floor, with a highlight and as much light as there may be. */
static const char bright[] =
    "version = 1; size = [8, 5]; depth = 64; threshold = 0.001; background = [%d, %d, 90];\n"
    "camera = { eye = (3, -5, 2); look_at = (0, 0, 0); };\n"
    "lights = ( { direction = (0.3, 1, -1); colour = (%d, %d, %d); } );\n"
    "materials = { floor = { colour = [255, 255, 200]; diffuse = 1; specular = 0.9; };\n"
    "  glass = { colour = [255, 200, 255]; diffuse = 1; ior = 1.5; }; };\n"
    "objects = ( { material = \"floor\"; solid = { half_space = { normal = (0, 0, 1);"
    " offset = -1; }; }; }, { material = \"glass\"; solid = { box = { min = (-1, -1, -1);"
    " max = (1, 1, 1); }; }; } );\n";

static void means_are_as_many_times_brighter_as_the_lights(void **state) {
    (void)state;
    static struct picture seen;
    static struct estimate dim, many;
    for (int j = 0; j < EXTREME_ARITHMETICS; j++) {
        char text[EXTREME_TEXT_SIZE];
        snprintf(text, sizeof text, bright, 0, 0, 32, 32, 32);
        render_learned(&seen, text, extreme_arithmetics[j], true, 0, &dim);
        snprintf(text, sizeof text, bright, 0, 0, 8192, 8192, 8192);
        render_learned(&seen, text, extreme_arithmetics[j], true, 0, &many);
        for (int way = 0; way < WAYS; way++) {
            double few = dim.mean[way][0], more = many.mean[way][0];
            assert_true(few > 65536);
            assert_true(fabs(more / few - 256) < 256 * 0.002);
        }
    }
}

static void the_brightest_lights_are_learned_without_an_overflow(void **state) {
    (void)state;
    static struct picture seen;
    static struct estimate estimate;
    static const double errors[] = {0.1, 1, 255};
    for (int j = 0; j < EXTREME_ARITHMETICS; j++) {
        for (int i = 0; i < 3; i++) {
            char text[EXTREME_TEXT_SIZE];
            snprintf(text, sizeof text, bright, 255, 255, 32767, 32767, 32767);
            render_learned(&seen, text, extreme_arithmetics[j], true, errors[i], &estimate);
            for (int way = 0; way < WAYS; way++) {
                assert_true(estimate.mean[way][0] > 65536);
            }
            assert_true(estimate.mean_variance > 0);
            assert_true(estimate.branch_variance > 0);
            assert_true(estimate.noise > 0);
            assert_true(seen.counts.proved_error <= 255u << 16);
            assert_true(seen.counts.estimated_error <= seen.counts.proved_error);
        }
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_the_deepest_levels_cut_is_not_followed_in_circles),
        cmocka_unit_test(glass_in_a_room_of_mirrors_is_learned_at_the_deepest_levels),
        cmocka_unit_test(means_are_as_many_times_brighter_as_the_lights),
        cmocka_unit_test(the_brightest_lights_are_learned_without_an_overflow),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
