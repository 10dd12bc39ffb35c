/* SPDX-License-Identifier: MIT */
/* The world around the solids: how far it reaches, and the air in it. */
#include "compiler/emit.h"
#include "scene_fixture.h"

enum { WIDTH = 40, HEIGHT = 30 };

/* A floor of light clay at z = 0 under a ball, seen from a height, along y and down or up. */
struct view {
    double height, sunk, world; /* sunk: how much lower than the eye look_at is, 10 units away */
};

static struct loaded_scene load_view(const struct view *view, const char *arithmetic) {
    char text[1024];
    (void)snprintf(
        text, sizeof text,
        "version = 1; size = [%d, %d]; depth = 0; world = %.17g;\n"
        "camera = { eye = [0, 0, %.17g]; look_at = [0, 10, %.17g]; "
        "field_of_view = 60; };\n"
        "materials = { clay = { colour = [200, 200, 200]; ambient = 1; "
        "ambient_is_own = true; }; };\n"
        "objects = ( { material = \"clay\"; solid = { half_space = { normal = [0, 0, 1]; "
        "offset = 0; }; }; },\n"
        "{ material = \"clay\"; solid = { ball = { centre = [0, -3, 0]; radius = 0.5; "
        "}; }; } );",
        WIDTH, HEIGHT, view->world, view->height, view->height - view->sunk);
    return load_text(text, arithmetic);
}

/* Returns how far from the eye's foot the ray of a pixel meets the floor; infinite: never. */
static double floor_distance(const struct view *view, unsigned x, unsigned y) {
    const double length = sqrt(100 + view->sunk * view->sunk);
    const double forward[3] = {0, 10 / length, -view->sunk / length};
    const double up[3] = {0, view->sunk / length, 10 / length};
    const double pitch = 2 * tan(30 * 3.14159265358979323846 / 180) / WIDTH;
    const double across = (x + 0.5 - WIDTH / 2.0) * pitch, down = (y + 0.5 - HEIGHT / 2.0) * pitch;
    const double ray[3] = {across, forward[1] - down * up[1], forward[2] - down * up[2]};
    return ray[2] >= 0 ? INFINITY : hypot(ray[0], ray[1]) * view->height / -ray[2];
}

static void a_floor_is_seen_as_far_as_the_world_reaches(void **state) {
    (void)state;
    static const char *const arithmetics[] = {"fx", "f32", "f64"};
    uint64_t seed = 1988;
    unsigned seen = 0, beyond = 0;
    for (int round = 0; round < 60; round++) {
        const struct view view = {random_between(&seed, 0.5, 4), random_between(&seed, -3, 6),
                                  exp(random_between(&seed, log(3), log(300)))};
        struct loaded_scene loaded = load_view(&view, arithmetics[round % 3]);
        for (unsigned y = 0; y < HEIGHT; y++) {
            for (unsigned x = 0; x < WIDTH; x++) {
                struct render_counts counts = {0};
                const double distance = floor_distance(&view, x, y);
                int level[3];
                pixel_levels(&loaded, x, y, level, &counts);
                if (distance < 0.99 * view.world - 4) { /* the middle is within 4 of the eye */
                    seen++;
                    if (level[0] != 200) {
                        fail_msg("%s: height %g, sunk %g, world %g: (%u, %u), %g away, is %d",
                                 arithmetics[round % 3], view.height, view.sunk, view.world, x, y,
                                 distance, level[0]);
                    }
                }
                beyond += !isfinite(distance) && level[0] == 0;
            }
        }
        unload(&loaded);
    }
    assert_true(seen > 10000 && beyond > 1000);
}

/* Air that is put where air is changes nothing: in any mixing, and without a description. */
static void air_in_the_air_changes_nothing(void **state) {
    (void)state;
    static const char *const mixings[] = {"additive", "filter"};
    uint64_t seed = 1789;
    for (int round = 0; round < 24; round++) {
        struct loaded_scene scenes[2];
        char ball[200];
        (void)snprintf(
            ball, sizeof ball,
            ", { material = \"air\"; solid = { ball = { centre = [%.3f, -2, %.3f]; radius "
            "= %.3f; }; }; }",
            random_between(&seed, -1, 1), random_between(&seed, -1, 1),
            random_between(&seed, 0.1, 0.9));
        for (int i = 0; i < 2; i++) {
            char text[1400];
            (void)snprintf(
                text, sizeof text,
                "version = 1; size = [%d, %d]; mixing = \"%s\";\n"
                "camera = { eye = [0, -6, 0]; look_at = [0, 0, 0]; };\n" SCENE_LIGHT_AND_MATERIALS
                "objects = ( { material = \"clay\"; solid = { box = { min = [-2, 0, -2]; max "
                "= [2, 1, 2]; }; }; }%s );",
                WIDTH, HEIGHT, mixings[round % 2], i == 0 ? "" : ball);
            scenes[i] = load_text(text, round % 4 < 2 ? "fx" : "f64");
        }
        assert_true(scenes[1].compiled->object_count > scenes[0].compiled->object_count);
        for (unsigned y = 0; y < HEIGHT; y++) {
            for (unsigned x = 0; x < WIDTH; x++) {
                struct render_counts counts = {0};
                int levels[2][3];
                pixel_levels(&scenes[0], x, y, levels[0], &counts);
                pixel_levels(&scenes[1], x, y, levels[1], &counts);
                for (int i = 0; i < 3; i++) {
                    if (abs(levels[0][i] - levels[1][i]) > 1) {
                        fail_msg("%s, (%u, %u): %d without air, %d with it", mixings[round % 2], x,
                                 y, levels[0][i], levels[1][i]);
                    }
                }
            }
        }
        unload(&scenes[0]);
        unload(&scenes[1]);
    }
}

/* A world that is smaller than what is in it changes nothing. */
static void a_small_world_changes_nothing(void **state) {
    (void)state;
    const struct view none = {2, 1, 0}, small = {2, 1, 1e-3};
    struct loaded_scene loaded = load_view(&none, "f64"), other = load_view(&small, "f64");
    assert_true(other.compiled->has_world && !loaded.compiled->has_world);
    char digest[SCENE_DIGEST_SIZE], other_digest[SCENE_DIGEST_SIZE];
    assert_true(scene_digest(loaded.compiled, digest));
    assert_true(scene_digest(other.compiled, other_digest));
    assert_string_equal(digest, other_digest);
    unload(&loaded);
    unload(&other);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_floor_is_seen_as_far_as_the_world_reaches),
        cmocka_unit_test(air_in_the_air_changes_nothing),
        cmocka_unit_test(a_small_world_changes_nothing),
    };
    return cmocka_run_group_tests_name("world", tests, NULL, NULL);
}
