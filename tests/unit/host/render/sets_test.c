/* SPDX-License-Identifier: MIT */
/* Sets as bits and sets as lists draw the same rows, of rays that run along the world's axes, too.
 */
#include "scene_fixture.h"

enum { WIDTH = 40, HEIGHT = 25, TEXT_SIZE = 1 << 14 };

/* Writes balls and cubes of glass and clay over a floor. Light comes straight along two axes, so
 * that shadow rays have components that are exactly 0. */
static void write_grid(char *text) {
    int at = snprintf(text, TEXT_SIZE,
                      "version = 1; size = [%d, %d]; depth = 5;\n"
                      "camera = { eye = [0, -12, 5]; look_at = [0, 0, 0.5]; };\n"
                      "lights = ({ direction = [0, 0, -1]; colour = [120, 120, 120]; },\n"
                      "  { direction = [-1, 0, 0]; colour = [90, 90, 90]; });\n"
                      "materials = { clay = { colour = [200, 90, 40]; diffuse = 0.7; };\n"
                      "  glass = { ior = 1.5; colour = [20, 30, 40]; diffuse = 0.2; }; };\n"
                      "objects = ({ material = \"clay\"; solid = { box = { min = [-8, -8, -1]; "
                      "max = [8, 8, 0]; }; }; }",
                      WIDTH, HEIGHT);
    for (int i = 0; i < 30; i++) {
        int x = 2 * (i % 6) - 5, y = 2 * (i / 6) - 4;
        const char *material = i % 3 == 0 ? "glass" : "clay";
        if (i % 2 == 0) {
            at += snprintf(text + at, TEXT_SIZE - (size_t)at,
                           ",\n{ material = \"%s\"; solid = { ball = { centre = [%d, %d, 1.5]; "
                           "radius = 0.7; }; }; }",
                           material, x, y);
        } else {
            int z = i % 4 / 2;
            at += snprintf(text + at, TEXT_SIZE - (size_t)at,
                           ",\n{ material = \"%s\"; solid = { box = { min = [%d, %d, %d]; "
                           "max = [%g, %g, %g]; }; }; }",
                           material, x, y, z, x + 0.5, y + 0.5, z + 1.75);
        }
    }
    (void)snprintf(text + at, TEXT_SIZE - (size_t)at, ");\n");
}

static void rays_along_an_axis_meet_the_same_with_bits_and_lists(void **state) {
    (void)state;
    static const struct arithmetic *const arithmetics[] = {&arithmetic_fx, &arithmetic_f32,
                                                           &arithmetic_f64};
    static char text[TEXT_SIZE];
    struct scene_error error = {""};
    write_grid(text);
    struct scene_description *description = read_text(text);
    struct compiled_scene *compiled = scene_compile(description, &error);
    assert_non_null(compiled);
    assert_true(compiled_fits_bits(compiled));
    for (size_t i = 0; i < sizeof arithmetics / sizeof arithmetics[0]; i++) {
        const struct arithmetic *bits = arithmetics[i], *lists = arithmetic_with_lists(bits);
        assert_non_null(lists);
        struct scene *few = bits->load(compiled, &error), *many = lists->load(compiled, &error);
        assert_non_null(few);
        assert_non_null(many);
        for (uint16_t y = 0; y < HEIGHT; y++) {
            uint8_t expected[3 * WIDTH], found[3 * WIDTH];
            struct render_counts counts = {0}, own = {0};
            bits->image->row(few, y, expected, &own);
            lists->image->row(many, y, found, &counts);
            assert_memory_equal(found, expected, sizeof found);
            assert_int_equal(counts.rays, own.rays);
            assert_int_equal(counts.shadow_rays, own.shadow_rays);
            assert_int_equal(counts.leaked_rays, 0);
        }
        free(few);
        free(many);
    }
    compiled_scene_free(compiled);
    scene_description_free(description);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rays_along_an_axis_meet_the_same_with_bits_and_lists),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
