/* SPDX-License-Identifier: MIT */
/* No ray leaves any built-in scene, or one of thin walls, while it is still inside a medium. */
#include "scene_fixture.h"

#include "scene/builtin.h"

static void check_description(struct scene_description *description, const char *name,
                              const char *arithmetic, int depth, int width, int height) {
    description->depth = depth;
    description->width = width;
    description->height = height;
    struct loaded_scene loaded = load_description(description, arithmetic);
    struct render_counts counts = {0};
    uint8_t rgb[3 * 640];
    for (int y = 0; y < height; y++) {
        loaded.arithmetic->image->row(loaded.scene, (uint16_t)y, rgb, &counts);
    }
    if (counts.leaked_rays != 0) {
        fail_msg("%s in %s at depth level %d: %u of %u rays leaked", name, arithmetic, depth,
                 (unsigned)counts.leaked_rays, (unsigned)counts.rays);
    }
    assert_true(counts.rays >= (uint32_t)(width * height));
    unload(&loaded);
    scene_description_free(description);
}

static void check_scene(const char *name, const char *arithmetic, int depth, int width,
                        int height) {
    struct scene_error error;
    struct scene_description *description = load_scene(name, &error);
    assert_non_null(description);
    check_description(description, name, arithmetic, depth, width, height);
}

static void check_arithmetic(const char *arithmetic, int width, int height) {
    assert_true(builtin_scene_count >= 2);
    for (size_t i = 0; i < builtin_scene_count; i++) {
        for (int depth = 1; depth <= 20; depth++) {
            check_scene(builtin_scenes[i].name, arithmetic, depth, width, height);
        }
    }
}

static void no_ray_leaks_in_fx(void **state) {
    (void)state;
    check_arithmetic("fx", 29, 19);
}

static void no_ray_leaks_in_f32(void **state) {
    (void)state;
    check_arithmetic("f32", 29, 19);
}

static void no_ray_leaks_in_f64(void **state) {
    (void)state;
    check_arithmetic("f64", 23, 13);
}

static void no_ray_leaks_in_f128(void **state) {
    (void)state;
    check_arithmetic("f128", 5, 3);
}

/* Shells of glass whose walls are a few last bits thick, a box around a ball, seen from within,
 * so that rays run into edges and corners: where a crossing is lost by rounding, if
 * it ever is. The half extent is 100. */
static void no_ray_leaks_from_walls_of_a_few_last_bits(void **state) {
    (void)state;
    static const struct {
        const char *arithmetic;
        double wall;
    } cases[] = {{"fx", 0x1p-19}, {"f32", 0x1p-16}, {"f64", 0x1p-38}};
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        char text[4096];
        double inner = 100 - cases[i].wall, ball = 50 - cases[i].wall;
        (void)snprintf(
            text, sizeof text,
            "version = 1; size = [29, 19]; threshold = 0.0;\n"
            "camera = { eye = (0, 0, 0); look_at = (1, 1, 1); field_of_view = 100; };\n"
            "materials = { glass = { colour = [9, 9, 9]; ior = 1.5; }; };\n"
            "objects = ( { material = \"glass\"; solid = { difference = (\n"
            "{ box = { min = (-100, -100, -100); max = (100, 100, 100); }; },\n"
            "{ box = { min = (%.17g, %.17g, %.17g); max = (%.17g, %.17g, %.17g); }; } ); }; },\n"
            "{ material = \"glass\"; solid = { difference = (\n"
            "{ ball = { radius = 50; }; }, { ball = { radius = %.17g; }; } ); }; } );\n",
            -inner, -inner, -inner, inner, inner, inner, ball);
        for (int depth = 1; depth <= 12; depth++) {
            check_description(read_text(text), "the shells", cases[i].arithmetic, depth, 29, 19);
        }
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_ray_leaks_in_fx),
        cmocka_unit_test(no_ray_leaks_in_f32),
        cmocka_unit_test(no_ray_leaks_in_f64),
        cmocka_unit_test(no_ray_leaks_in_f128),
        cmocka_unit_test(no_ray_leaks_from_walls_of_a_few_last_bits),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
