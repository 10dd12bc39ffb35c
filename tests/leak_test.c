/* SPDX-License-Identifier: MIT */
/* No ray leaves any built-in scene while it is still inside a medium. */
#include "scene_fixture.h"

#include "builtin_scenes.h"

static void check_scene(const char *name, const char *arithmetic, int depth, int width,
                        int height) {
    struct scene_error error;
    struct scene_description *description = load_scene(name, &error);
    assert_non_null(description);
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

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_ray_leaks_in_fx),
        cmocka_unit_test(no_ray_leaks_in_f32),
        cmocka_unit_test(no_ray_leaks_in_f64),
        cmocka_unit_test(no_ray_leaks_in_f128),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
