/* SPDX-License-Identifier: MIT */
/* Every arithmetic against f128: pixels of whole scenes, where they stand and far away. */
#include "scene_fixture.h"

#include "transformed_scene.h"

enum { PIXELS = 4000 };

/* How many of the seeded pixels differ from f128's by more than 1 level in some channel. */
static int wrong_pixels(const struct scene_description *description, const char *arithmetic,
                        int pixels) {
    struct loaded_scene exact = load_description(description, "f128");
    struct loaded_scene tested = load_description(description, arithmetic);
    struct render_counts counts = {0};
    uint64_t state = 1988;
    int wrong = 0;
    for (int i = 0; i < pixels; i++) {
        unsigned x = next_random(&state) % (unsigned)description->width;
        unsigned y = next_random(&state) % (unsigned)description->height;
        int expected[3], found[3];
        pixel_levels(&exact, x, y, expected, &counts);
        pixel_levels(&tested, x, y, found, &counts);
        bool good = true;
        for (int j = 0; j < 3; j++) {
            good = good && abs(expected[j] - found[j]) <= 1;
        }
        if (!good) {
            print_message("%s: pixel %u %u is (%d, %d, %d) instead of (%d, %d, %d)\n", arithmetic,
                          x, y, found[0], found[1], found[2], expected[0], expected[1],
                          expected[2]);
        }
        wrong += !good;
    }
    assert_int_equal(counts.leaked_rays, 0);
    unload(&exact);
    unload(&tested);
    return wrong;
}

/* 99.99 % of the pixels for fx and f32, all for f64. */
static void check(double scale, double move) {
    static const char *const arithmetics[] = {"fx", "f32", "f64"};
    struct scene_error error;
    for (int i = 0; i < 3; i++) {
        struct scene_description *description = load_scene("fig3", &error);
        assert_non_null(description);
        description->width = 640;
        description->height = 400;
        transform_scene(description, scale, move);
        int pixels = PIXELS / (i == 2 ? 4 : 1);
        int wrong = wrong_pixels(description, arithmetics[i], pixels);
        assert_true(10000 * wrong <= (i == 2 ? 0 : pixels));
        scene_description_free(description);
    }
}

static void fig3_is_right_in_every_arithmetic(void **state) {
    (void)state;
    check(1, 0);
}

static void fig3_a_thousand_times_smaller_is_right(void **state) {
    (void)state;
    check(1e-3, 0);
}

static void fig3_a_thousand_times_larger_is_right(void **state) {
    (void)state;
    check(1e3, 0);
}

static void fig3_moved_by_a_hundred_is_right(void **state) {
    (void)state;
    check(1, 100);
}

/* ---- The camera ------------------------------------------------------------------------------ */

/* Half a pixel's steps to the right and down are as large as a fraction may be: with fewer bits in
 * fx the larger pictures were in the wrong place. */
static void the_cameras_steps_have_all_their_bits(void **state) {
    (void)state;
    static const int widths[] = {1, 7, 64, 319, 320, 640};
    uint64_t seed = 640400;
    static const double fields[] = {1, 1.7, 2.5, 20, 40, 90, 120};
    for (int i = 0; i < 6 * 7; i++) {
        struct scene_error error;
        struct scene_description *description = load_scene("fig5", &error);
        assert_non_null(description);
        description->width = widths[i / 7];
        description->camera.field_of_view = fields[i % 7];
        for (int j = 0; j < 3; j++) {
            description->camera.eye[j] = random_between(&seed, -9, 9);
        }
        struct compiled_scene *compiled = scene_compile(description, &error);
        assert_non_null(compiled);
        const struct compiled_camera *camera = &compiled->camera;
        double step =
            tan(fields[i % 7] * 3.14159265358979323846 / 360) / widths[i / 7] *
            sqrt(camera->forward[0] * camera->forward[0] + camera->forward[1] * camera->forward[1] +
                 camera->forward[2] * camera->forward[2]);
        double square[2] = {0, 0}, across = 0, largest = 0;
        for (int j = 0; j < 3; j++) {
            square[0] += pow(ldexp(camera->column[j], -camera->shift), 2);
            square[1] += pow(ldexp(camera->row[j], -camera->shift), 2);
            across += camera->column[j] * camera->row[j];
            largest = fmax(largest, fmax(fabs(camera->column[j]), fabs(camera->row[j])));
        }
        assert_true(fabs(sqrt(square[0]) / step - 1) < 1e-9);
        assert_true(fabs(sqrt(square[1]) / step - 1) < 1e-9);
        assert_true(fabs(across) < 1e-9);
        assert_true(largest >= 0.5 || camera->shift == 16);
        assert_true(largest < 1);
        compiled_scene_free(compiled);
        scene_description_free(description);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(fig3_is_right_in_every_arithmetic),
        cmocka_unit_test(fig3_a_thousand_times_smaller_is_right),
        cmocka_unit_test(fig3_a_thousand_times_larger_is_right),
        cmocka_unit_test(fig3_moved_by_a_hundred_is_right),
        cmocka_unit_test(the_cameras_steps_have_all_their_bits),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
