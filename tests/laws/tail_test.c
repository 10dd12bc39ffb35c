/* SPDX-License-Identifier: MIT */
/* What a pruned branch counts as: learned, the same in every arithmetic, and worth its rays. */
#include "scene_fixture.h"

enum { WIDTH = 40, HEIGHT = 25, PIXELS = WIDTH * HEIGHT };

/* A picture in levels, neither rounded nor clamped above, and what it took. */
struct picture {
    double level[PIXELS][3];
    unsigned long rays;
    struct estimate estimate;
    struct render_counts counts;
};

static struct scene_description *describe(const char *name, double threshold, bool estimates) {
    struct scene_error refusal;
    struct scene_description *description = load_scene(name, &refusal);
    assert_non_null(description);
    description->width = WIDTH;
    description->height = HEIGHT;
    description->depth = 64;
    description->threshold = threshold;
    description->estimates = estimates;
    return description;
}

/* Frees the description. */
static void render_description(struct picture *picture, struct scene_description *description,
                               const char *arithmetic) {
    struct loaded_scene loaded = load_description(description, arithmetic);
    memset(picture, 0, sizeof *picture);
    loaded.arithmetic->learn(loaded.scene, &picture->estimate, &picture->counts);
    for (int i = 0; i < PIXELS; i++) {
        loaded.arithmetic->pixel(loaded.scene, (uint16_t)(i % WIDTH), (uint16_t)(i / WIDTH),
                                 picture->level[i], &picture->counts, NULL);
    }
    picture->rays = picture->counts.rays;
    assert_int_equal(picture->counts.leaked_rays, 0);
    unload(&loaded);
    scene_description_free(description);
}

static void render_scene(struct picture *picture, const char *name, const char *arithmetic,
                         double threshold, bool estimates) {
    render_description(picture, describe(name, threshold, estimates), arithmetic);
}

/* The number of pixels that differ by more than that many levels, as the screen clamps them. */
static int far_pixels(const struct picture *a, const struct picture *b, double most) {
    int count = 0;
    for (int i = 0; i < PIXELS; i++) {
        double worst = 0;
        for (int j = 0; j < 3; j++) {
            worst = fmax(worst, fabs(fmin(a->level[i][j], 255) - fmin(b->level[i][j], 255)));
        }
        count += worst > most;
    }
    return count;
}

static struct picture converged, black, estimated;

/* Half of the rays that black needs to be as right, or fewer. */
static void an_estimate_is_worth_a_lower_threshold(void **state) {
    (void)state;
    static const char *const scenes[] = {"fig3", "fig5"};
    for (int i = 0; i < 2; i++) {
        render_scene(&converged, scenes[i], "f64", 1.0 / 100000, true);
        render_scene(&estimated, scenes[i], "fx", 1.0 / 2048, true);
        render_scene(&black, scenes[i], "fx", 1.0 / 16384, false);
        int with = far_pixels(&converged, &estimated, 1),
            without = far_pixels(&converged, &black, 1);
        print_message("%s: %d of %d pixels off at 1/2048 with the estimate (%lu rays), %d at "
                      "1/16384 with black (%lu rays)\n",
                      scenes[i], with, PIXELS, estimated.rays, without, black.rays);
        assert_true(with <= without);
        assert_true(with * 50 <= PIXELS);
    }
}

static void black_is_what_an_empty_estimate_gives(void **state) {
    (void)state;
    render_scene(&black, "fig4b", "fx", 1.0 / 512, false);
    for (int i = 0; i < 3; i++) {
        for (int way = 0; way <= WAYS; way++) {
            assert_int_equal(black.estimate.mean[way][i], 0);
        }
    }
    render_scene(&estimated, "fig4b", "fx", 1.0 / 512, true);
    for (int i = 0; i < PIXELS; i++) {
        for (int j = 0; j < 3; j++) {
            assert_true(estimated.level[i][j] >= black.level[i][j]);
        }
    }
    assert_true(far_pixels(&black, &estimated, 1) > PIXELS / 10);
}

/* As one who looks at the screen sees them. */
static double squares(const struct picture *a, const struct picture *b) {
    double sum = 0;
    for (int i = 0; i < PIXELS; i++) {
        for (int j = 0; j < 3; j++) {
            double difference = fmin(a->level[i][j], 255) - fmin(b->level[i][j], 255);
            sum += difference * difference;
        }
    }
    return sum;
}

/* The same picture with an `up` that lies in the floor, ahead of the eye that looks down on it:
 * pruned branches are told apart by a way that means less. */
static void render_lying(struct picture *picture, const char *name, double threshold) {
    struct scene_description *description = describe(name, threshold, true);
    struct scene_camera *camera = &description->camera;
    assert_true(camera->up[2] > 0 && camera->look_at[2] < camera->eye[2]);
    for (int i = 0; i < 3; i++) {
        camera->up[i] = i < 2 ? camera->look_at[i] - camera->eye[i] : 0;
    }
    render_description(picture, description, "fx");
}

static void up_and_down_say_more_than_near_and_far(void **state) {
    (void)state;
    static const char *const scenes[] = {"fig3", "fig4b", "fig5", "fig6b"};
    static struct picture lying;
    for (int i = 0; i < 4; i++) {
        render_scene(&converged, scenes[i], "f64", 1.0 / 65536, true);
        render_scene(&estimated, scenes[i], "fx", 1.0 / 512, true);
        render_lying(&lying, scenes[i], 1.0 / 512);
        double right = squares(&estimated, &converged), wrong = squares(&lying, &converged);
        print_message("%s: squares of %.0f by up and down, %.0f by near and far\n", scenes[i],
                      right, wrong);
        assert_int_equal(estimated.rays, lying.rays);
        assert_true(right < 0.9 * wrong);
    }
}

/* What is learned of a description, which is freed. */
static struct estimate learned(struct scene_description *description, const char *arithmetic,
                               double error) {
    struct estimate estimate;
    struct render_counts counts = {0};
    description->error = error;
    description->estimates = true;
    struct loaded_scene loaded = load_description(description, arithmetic);
    loaded.arithmetic->learn(loaded.scene, &estimate, &counts);
    unload(&loaded);
    scene_description_free(description);
    return estimate;
}

/* For an accuracy so coarse that the pre-pass is short. */
static struct estimate learned_in(const char *arithmetic) {
    struct scene_error refusal;
    struct scene_description *description = load_scene("fig3", &refusal);
    assert_non_null(description);
    description->width = WIDTH;
    description->height = HEIGHT;
    return learned(description, arithmetic, 8);
}

static bool is_near(int32_t found, int32_t right) {
    return right > 0 && abs(found - right) <= right / 64;
}

static void every_arithmetic_learns_the_same(void **state) {
    (void)state;
    static const char *const arithmetics[] = {"fx", "f32", "f128"};
    const struct estimate right = learned_in("f64");
    for (int i = 0; i < 3; i++) {
        const struct estimate found = learned_in(arithmetics[i]);
        assert_int_equal(found.first, right.first);
        for (int j = 0; j < 3 * (WAYS + 1); j++) {
            int32_t mean = found.mean[j / 3][j % 3];
            assert_true(abs(mean - right.mean[j / 3][j % 3]) < 65536);
        }
        assert_true(is_near(found.mean_variance, right.mean_variance));
        assert_true(is_near(found.branch_variance, right.branch_variance));
        assert_true(is_near(found.noise, right.noise));
    }
}

/* A ball of glass between a black plane and the white background, with a way up of its own. */
static struct estimate learned_between(const char *up, const char *towards_black, double error) {
    char text[1024];
    (void)snprintf(
        text, sizeof text,
        "version = 1; size = [40, 25]; depth = 20; threshold = 0.015625;\n"
        "background = [255, 255, 255]; camera = { eye = (2.5, -2, 1.5); look_at = (0, 0, 0);\n"
        "  up = %s; };\n"
        "materials = { black = { colour = [0, 0, 0]; };\n"
        "  glass = { colour = [0, 0, 0]; ior = 1.5; }; };\n"
        "objects = ( { material = \"glass\"; solid = { ball = { centre = (0, 0, 0); radius = 1; }; "
        "}; },\n"
        "  { material = \"black\"; solid = { half_space = { normal = %s; offset = -3; }; }; } );\n",
        up, towards_black);
    return learned(read_text(text), "fx", error);
}

/* Whatever the file takes for up, and on which side the dark is. */
static void a_branch_is_worth_what_is_where_it_goes(void **state) {
    (void)state;
    static const struct {
        const char *up, *normal;
        bool is_dark_below;
    } cases[] = {
        {"(0, 0, 1)", "(0, 0, 1)", true},
        {"(0, 0, 1)", "(0, 0, -1)", false},
        {"(0, 3, 0)", "(0, 1, 0)", true},
        {"(-2, 0, 0)", "(1, 0, 0)", false},
        {"(1, 2, 3)", "(0.267, 0.535, 0.802)", true},
    };
    for (size_t i = 0; i < sizeof cases / sizeof *cases; i++) {
        for (int asked = 0; asked < 2; asked++) {
            const struct estimate found = learned_between(cases[i].up, cases[i].normal, asked);
            int dark = cases[i].is_dark_below ? WAY_DOWN : WAY_UP;
            int bright = cases[i].is_dark_below ? WAY_UP : WAY_DOWN;
            for (int j = 0; j < 3; j++) {
                assert_true(found.mean[dark][j] + 15 * 65536 < found.mean[WAY_ANY][j]);
                assert_true(found.mean[bright][j] - 15 * 65536 > found.mean[WAY_ANY][j]);
            }
        }
    }
}

/* White wherever one looks: what the training pass did not follow to the end is left out, not
 * black. */
static void what_was_not_seen_says_nothing(void **state) {
    (void)state;
    static const char text[] =
        "version = 1; size = [40, 25]; depth = 20; threshold = 0.015625;\n"
        "background = [255, 255, 255]; camera = { eye = (3, 2, 1); look_at = (0, 0, 0); };\n"
        "materials = { glass = { colour = [0, 0, 0]; ior = 1.5; }; };\n"
        "objects = ( { material = \"glass\"; solid = { ball = { radius = 1; }; }; } );\n";
    const struct estimate found = learned(read_text(text), "fx", 0);
    for (int i = 0; i < 3 * (WAYS + 1); i++) {
        assert_in_range(found.mean[i / 3][i % 3], 254 * 65536, 256 * 65536);
    }
}

/* Plates of glass that reflect a sixth, each with a pattern of its own: between them light goes to
 * and fro for longer than a budget lasts. */
static const char trapping[] =
    "version = 1; size = [8, 5]; depth = %d; background = [255, 200, 90];\n"
    "camera = { eye = (0.3, 0.2, -1); look_at = (0.4, 0.3, 0); field_of_view = 30; };\n"
    "materials = { glass = { colour = [0, 0, 0]; ambient = 1.0; ambient_is_own = true; ior = 2.4;\n"
    "  pattern = { size = (0.3, 0.3, 0); colour = [90, 60, 30]; }; }; };\n"
    "objects = ( %s );\n";

static const char plate[] = "%s{ material = \"glass\"; solid = { box = { min = (-5, -5, %g);\n"
                            "  max = (5, 5, %g); }; }; }";

static void write_trapping(int depth, char *text, size_t size) {
    char plates[1024];
    size_t used = 0;
    for (int i = 0; i < 6; i++) {
        used += (size_t)snprintf(plates + used, sizeof plates - used, plate, i > 0 ? ", " : "",
                                 i * 0.2, i * 0.2 + 0.1);
    }
    (void)snprintf(text, size, trapping, depth, plates);
}

struct trapped {
    struct render_counts counts;
    unsigned budget;
};

static struct trapped trace_trapped(int depth) {
    char text[2048];
    struct trapped found = {0};
    struct estimate estimate;
    write_trapping(depth, text, sizeof text);
    struct scene_description *description = read_text(text);
    description->error = 0.25;
    struct loaded_scene loaded = load_description(description, "fx");
    loaded.arithmetic->learn(loaded.scene, &estimate, &found.counts);
    memset(&found.counts, 0, sizeof found.counts);
    for (int i = 0; i < 40; i += 8) {
        double level[3];
        loaded.arithmetic->pixel(loaded.scene, (uint16_t)(i % 8), (uint16_t)(i / 8), level,
                                 &found.counts, NULL);
    }
    found.budget = loaded.compiled->ray_budget;
    unload(&loaded);
    scene_description_free(description);
    return found;
}

static void trapped_light_ends_within_the_budget_and_is_told_of(void **state) {
    (void)state;
    const struct trapped deep = trace_trapped(255), shallow = trace_trapped(3);
    print_message("%lu rays, %u unreached, estimated %.3f, proved %.3f\n",
                  (unsigned long)deep.counts.rays, (unsigned)deep.counts.unreached_pixels,
                  deep.counts.estimated_error / 65536.0, deep.counts.proved_error / 65536.0);
    assert_in_range(deep.counts.rays, deep.budget / 2, 5u * (deep.budget + 1000));
    assert_in_range(deep.counts.unreached_pixels, 1, 5);
    assert_true(deep.counts.estimated_error > 16384);
    assert_true(deep.counts.proved_error >= deep.counts.estimated_error);
    assert_int_equal(deep.counts.leaked_rays, 0);
    assert_int_equal(shallow.counts.unreached_pixels, 0);
    assert_in_range(shallow.counts.estimated_error, 0, 16384);
}

/* The figures are those of docs/design.md. */
static void a_pixel_may_take_fewer_rays_where_an_error_is_asked_for(void **state) {
    (void)state;
    static const struct {
        double error;
        unsigned budget;
    } cases[] = {{0, 1000000}, {0.25, 100000}, {255, 100000}};
    static const char text[] =
        "version = 1; camera = { eye = (3, 2, 1); look_at = (0, 0, 0); };\n"
        "materials = { glass = { colour = [0, 0, 0]; ior = 1.5; }; };\n"
        "objects = ( { material = \"glass\"; solid = { ball = { radius = 1; }; }; } );\n";
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        struct scene_description *description = read_text(text);
        description->error = cases[i].error;
        struct loaded_scene loaded = load_description(description, "fx");
        assert_int_equal(loaded.compiled->ray_budget, cases[i].budget);
        unload(&loaded);
        scene_description_free(description);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(an_estimate_is_worth_a_lower_threshold),
        cmocka_unit_test(up_and_down_say_more_than_near_and_far),
        cmocka_unit_test(black_is_what_an_empty_estimate_gives),
        cmocka_unit_test(every_arithmetic_learns_the_same),
        cmocka_unit_test(a_branch_is_worth_what_is_where_it_goes),
        cmocka_unit_test(what_was_not_seen_says_nothing),
        cmocka_unit_test(trapped_light_ends_within_the_budget_and_is_told_of),
        cmocka_unit_test(a_pixel_may_take_fewer_rays_where_an_error_is_asked_for),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
