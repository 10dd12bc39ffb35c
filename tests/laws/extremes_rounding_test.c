/* SPDX-License-Identifier: MIT */
/* The four rounding modes of the host's floating-point unit: fx does not notice, the others hardly.
 */
#include "extremes_fixture.h"

#include <fenv.h>

/* Not FE_TONEAREST alone: C99 has four macros, each there if the machine has the mode. */
static const int modes[] = {FE_TONEAREST, FE_UPWARD, FE_DOWNWARD, FE_TOWARDZERO};
enum { MODES = sizeof modes / sizeof modes[0] };

/* Compiles as ever, then loads and renders in a rounding mode. */
static void render_in_mode(struct picture *picture, struct compiled_scene *compiled,
                           const char *arithmetic, int mode) {
    struct scene_error error;
    struct loaded_scene loaded = {arithmetic_find(arithmetic), compiled, NULL};
    assert_int_equal(fesetround(mode), 0);
    loaded.scene = loaded.arithmetic->load(compiled, &error);
    if (loaded.scene) {
        render_loaded(picture, &loaded);
    }
    fesetround(FE_TONEAREST);
    assert_non_null(loaded.scene);
    free(loaded.scene);
}

static void the_rounding_mode_does_not_show(void **state) {
    (void)state;
    static const char *const scenes[] = {"fig3", "fig4b", "fig5", "fig7-frustum"};
    static struct picture expected, found;
    for (size_t i = 0; i < sizeof scenes / sizeof scenes[0]; i++) {
        struct scene_error error;
        struct scene_description *description = load_scene(scenes[i], &error);
        assert_non_null(description);
        description->width = 64;
        description->height = 40;
        struct compiled_scene *compiled = scene_compile(description, &error);
        assert_non_null(compiled);
        for (int j = 0; j < EXTREME_ARITHMETICS; j++) {
            render_in_mode(&expected, compiled, extreme_arithmetics[j], FE_TONEAREST);
            for (int k = 1; k < MODES; k++) {
                render_in_mode(&found, compiled, extreme_arithmetics[j], modes[k]);
                if (j == FX) {
                    assert_memory_equal(found.level, expected.level, sizeof found.level);
                    assert_int_equal(found.counts.rays, expected.counts.rays);
                }
                assert_pictures_agree(&found, &expected, pixels_allowed(j, &found),
                                      extreme_arithmetics[j]);
            }
        }
        compiled_scene_free(compiled);
        scene_description_free(description);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_rounding_mode_does_not_show),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
