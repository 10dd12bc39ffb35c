/* SPDX-License-Identifier: MIT */
/* The plan of `superframe measure`, its file, its settings, and the cost model. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "base/parallel.h"
#include "compiler/features.h"
#include "compiler/requirements.h"
#include "lab/measure/measure.h"
#include "real/lab/wrap_kinds.h"
#include "render/arithmetic.h"
#include "render/signatures.h"
#include "scene/load.h"
#include "stats/cost_model.h"

static struct measure_point make_point(const char *arithmetic, unsigned depth, double threshold) {
    struct measure_point point;
    memset(&point, 0, sizeof point);
    strcpy(point.scene, "fig3");
    strcpy(point.colour, "full");
    strcpy(point.model, "fresnel");
    strcpy(point.tail, "black");
    (void)snprintf(point.arithmetic, sizeof point.arithmetic, "%s", arithmetic);
    point.depth = depth;
    point.threshold = threshold;
    point.width = 160;
    point.height = 100;
    return point;
}

static void a_key_tells_points_apart(void **state) {
    (void)state;
    struct measure_list list = {NULL, 0, 0};
    for (unsigned i = 0; i < 300; i++) {
        struct measure_point point = make_point(i % 2 ? "fx" : "f64", i / 2, 1.0 / 4096);
        assert_null(measure_list_find(&list, &point));
        assert_true(measure_list_add(&list, &point));
        assert_ptr_equal(measure_list_find(&list, &point), &list.points[i]);
    }
    struct measure_point other = make_point("fx", 7, 1.0 / 1024);
    assert_null(measure_list_find(&list, &other));
    free(list.points);
}

static void the_front_has_no_setting_that_another_beats(void **state) {
    (void)state;
    struct measure_setting some[5];
    static const double seconds[] = {1, 2, 3, 4, NAN}, wrong[] = {50, 10, 20, 0.5, 0};
    static const bool is_front[] = {true, true, false, true, false};
    memset(some, 0, sizeof some);
    for (int i = 0; i < 5; i++) {
        some[i].seconds[0] = seconds[i];
        some[i].wrong = wrong[i];
    }
    const struct measure_settings settings = {some, 5};
    for (size_t i = 0; i < 5; i++) {
        assert_int_equal(measure_is_on_front(&settings, i, 0), is_front[i]);
    }
    assert_ptr_equal(measure_cheapest(&settings, 0, 60), &some[0]);
    assert_ptr_equal(measure_cheapest(&settings, 0, 20), &some[1]);
    assert_ptr_equal(measure_cheapest(&settings, 0, 1), &some[3]);
    assert_null(measure_cheapest(&settings, 0, 0.1));
}

/* ---- Costs ---------------------------------------------------------------------------------- */

static struct compiled_scene *compile_builtin(const char *name) {
    struct scene_overrides overrides;
    struct scene_error error;
    memset(&overrides, 0, sizeof overrides);
    struct compiled_scene *compiled = load_compiled_scene(name, &overrides, &error);
    assert_non_null(compiled);
    return compiled;
}

static void a_mix_counts_every_primitive(void **state) {
    (void)state;
    struct compiled_scene *compiled = compile_builtin("fig3");
    struct cost_mix mix = cost_mix_of(compiled);
    assert_true(fabs(mix.box - 1) < 1e-12 && mix.ball <= 0 && mix.quadric <= 0);
    compiled_scene_free(compiled);
    compiled = compile_builtin("fig5");
    mix = cost_mix_of(compiled);
    assert_true(mix.quadric > 0 && mix.ball > 0 && mix.turned_box > 0);
    assert_true(mix.box + mix.turned_box + mix.ball + mix.quadric <= 1 + 1e-12);
    compiled_scene_free(compiled);
}

static void operations_add_up(void **state) {
    (void)state;
    double operations[WRAP_KINDS];
    const struct cost_events events = {10, 5, 3, 100};
    const struct cost_mix mix = {0.25, 0, 0.75, 0, 0};
    cost_operations_of(&events, &mix, operations);
    for (int i = 0; i < WRAP_KINDS; i++) {
        double expected = 10 * cost_operations[COST_RAY][i] +
                          5 * cost_operations[COST_SHADOW_RAY][i] +
                          3 * cost_operations[COST_NODE][i] + 25 * cost_operations[COST_BOX][i] +
                          75 * cost_operations[COST_BALL][i];
        assert_true(fabs(operations[i] - expected) < 1e-9);
    }
    /* What the source says: three quotients for where a box is left, three more for where it is
     * entered if that is asked; six products of vectors to turn a ray; one root a ball. */
    assert_true(cost_operations[COST_BOX][WRAP_OVER] > 3);
    assert_true(cost_operations[COST_BOX][WRAP_OVER] < 6);
    assert_true(fabs(cost_operations[COST_TURNED_BOX][WRAP_DOT] - 6) < 0.1);
    assert_true(fabs(cost_operations[COST_BALL][WRAP_ROOT] - 1) < 0.05);
}

static void every_machine_has_code_and_a_source(void **state) {
    (void)state;
    const struct cost_work work = {{1000, 100, 900, 5000}, {1, 0, 0, 0, 0}, 10000};
    const struct cost_work twice = {{2000, 200, 1800, 10000}, {1, 0, 0, 0, 0}, 20000};
    for (const struct cost_target *target = cost_targets; target->name != NULL; target++) {
        double seconds = cost_seconds(target, "fx", &work);
        assert_true(seconds > 0 && isfinite(seconds));
        assert_true(fabs(cost_seconds(target, "fx", &twice) / seconds - 2) < 1e-9);
        assert_true(isnan(cost_seconds(target, "q16", &work)));
        assert_true(strlen(target->source) > 20);
        if (target->clocks_f32 > 0) {
            assert_true(cost_seconds(target, "f64", &work) >= cost_seconds(target, "f32", &work));
        } else {
            assert_true(isnan(cost_seconds(target, "f32", &work)));
        }
    }
}

/* ---- Requirements --------------------------------------------------------------------------- */

static void requirements_of_built_in_scenes(void **state) {
    (void)state;
    struct compiled_scene *fig3 = compile_builtin("fig3");
    assert_true(requirements_total_reflection(fig3));
    assert_true(requirements_highlight(fig3));
    assert_true(requirements_nesting(fig3) >= 3); /* three nested hollow cubes */
    fig3->simple = true;
    assert_false(requirements_total_reflection(fig3));
    fig3->simple = false;
    for (uint32_t i = 0; i < fig3->material_count; i++) {
        fig3->materials[i].optical = fig3->materials[0].optical;
        fig3->materials[i].specular = 0;
    }
    assert_false(requirements_total_reflection(fig3));
    assert_false(requirements_highlight(fig3));
    compiled_scene_free(fig3);
}

static void count_feature(void *context, const char *name, int value) {
    int *counts = context;
    counts[0]++;
    counts[1] += strcmp(name, "SHADOWS") == 0 && value == 0;
    counts[2] += strcmp(name, "BOX") == 0 && value != 0;
}

/* What `check` says that a scene requires, its lines made one. */
static void requirements_of(const char *scene, char *text, size_t size) {
    struct compiled_scene *compiled = compile_builtin(scene);
    FILE *file = tmpfile();
    assert_non_null(file);
    requirements_print(file, compiled);
    rewind(file);
    size_t length = fread(text, 1, size - 1, file);
    assert_true(length > 0);
    text[length] = '\0';
    for (char *at = text; (at = strstr(at, ",\n            ")) != NULL;) {
        memmove(at + 2, at + 14, strlen(at + 14) + 1);
        at[1] = ' ';
    }
    (void)fclose(file);
    compiled_scene_free(compiled);
}

static void check_and_compile_share_the_features(void **state) {
    (void)state;
    struct compiled_scene *fig3 = compile_builtin("fig3");
    int counts[3] = {0, 0, 0};
    features_tell(fig3, count_feature, counts);
    assert_true(counts[0] > 10 && counts[1] == 1 && counts[2] == 1);
    compiled_scene_free(fig3);
}

static void check_names_what_a_scene_requires(void **state) {
    (void)state;
    static const struct {
        const char *scene, *said;
        bool is_said;
    } cases[] = {
        {"fig3", " box,", true},
        {"fig3", " ball,", false},
        {"fig3", " csg,", true},
        {"fig3", " difference,", true},
        {"fig3", " union,", false},
        {"fig3", " transparency,", true},
        {"fig3", " total reflection", true},
        {"fig3", " highlights", true},
        {"fig3", "more than one light", false},
        {"fig3", "dead        shadow rays: nothing", true},
        {"fig3", "dead        dispersion", true},
        {"fig3", "dead        total reflection", false},
        {"fig3", "ranges      1 light, gloss up to 60, indices 1.5 to 1.5", true},
        {"fig3", "nesting     4 deep", true},
        {"fig5", " quadric, rotation,", true},
        {"fig5", " polyhedron,", false}, /* its planes are taken in by the quadrics that they cut */
        {"fig5", " union, difference,", true},
        {"fig7-frustum", " polyhedron,", true},
        {"fig5", " shadows,", true},
        {"figA", " point lights,", true},
        {"figA", " more than one light,", true},
        {"figA", " transparency", false},
        {"figA", "dead        total reflection: nothing is transparent", true},
        {"tests/targets/features.scene", " absorption, dispersion, tint, filter, specular table,",
         true},
        {"tests/targets/features.scene", " fading,", true},
        {"tests/targets/features.scene", "dead        dispersion", false},
        {"tests/targets/features.scene", "indices 1.6 to 1.65, absorption up to 0.0", true},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        char text[8192];
        requirements_of(cases[i].scene, text, sizeof text);
        if ((strstr(text, cases[i].said) != NULL) != cases[i].is_said) {
            fail_msg("%s: \"%s\" %s", cases[i].scene, cases[i].said,
                     cases[i].is_said ? "is not said" : "is said");
        }
    }
}

/* ---- Signatures ----------------------------------------------------------------------------- */

/* What is asked of the pruned branches: a tail, or an accuracy. */
struct tail {
    bool estimates;
    double error;
};

static void make_signatures(const char *arithmetic, const struct tail *tail, unsigned first,
                            unsigned last, unsigned jobs, struct signatures *signatures) {
    struct scene_error error;
    struct scene_overrides overrides;
    memset(&overrides, 0, sizeof overrides);
    overrides.has_size = true;
    overrides.width = 24;
    overrides.height = 15;
    overrides.has_estimates = true;
    overrides.estimates = tail->estimates;
    overrides.has_error = tail->error > 0;
    overrides.error = tail->error;
    struct compiled_scene *compiled = load_compiled_scene("fig3", &overrides, &error);
    assert_non_null(compiled);
    const struct signature_job job = {
        arithmetic_find_any(arithmetic), compiled, first, last, jobs, NULL};
    assert_true(signatures_make(&job, signatures, &error));
    compiled_scene_free(compiled);
}

static bool are_equal(const struct signatures *a, const struct signatures *b) {
    return memcmp(a->of_pixel, b->of_pixel, (size_t)24 * 15 * sizeof *a->of_pixel) == 0;
}

static void signatures_do_not_depend_on_jobs(void **state) {
    static const struct tail tails[] = {{false, 0}, {true, 0}, {true, 8}, {true, 0.5}};
    (void)state;
    for (size_t tail = 0; tail < sizeof tails / sizeof tails[0]; tail++) {
        struct signatures one, many, part;
        make_signatures("f64", &tails[tail], 0, 15, 1, &one);
        make_signatures("f64", &tails[tail], 0, 15, 3, &many);
        make_signatures("f64", &tails[tail], 5, 7, 2, &part);
        assert_true(are_equal(&one, &many));
        for (unsigned i = 0; i < 24 * 15; i++) {
            assert_true(one.of_pixel[i] != 0);
            bool is_asked = i / 24 >= 5 && i / 24 < 7;
            assert_true(part.of_pixel[i] == (is_asked ? one.of_pixel[i] : 0));
        }
        signatures_free(&one);
        signatures_free(&many);
        signatures_free(&part);
    }
}

/* A tail is added to what was followed; an accuracy says how far that is. */
static void signatures_tell_an_accuracy_but_no_tail(void **state) {
    static const struct tail tails[] = {{false, 0}, {true, 0}, {true, 8}};
    struct signatures signatures[3];
    (void)state;
    for (int i = 0; i < 3; i++) {
        make_signatures("f64", &tails[i], 0, 15, 1, &signatures[i]);
    }
    assert_true(are_equal(&signatures[0], &signatures[1]));
    assert_false(are_equal(&signatures[0], &signatures[2]));
    for (int i = 0; i < 3; i++) {
        signatures_free(&signatures[i]);
    }
}

static void drift_and_flips_are_told_apart(void **state) {
    (void)state;
    uint64_t left[] = {1, 2, 3, 4}, right[] = {1, 2, 9, 4};
    const struct signatures one = {2, 2, left}, other = {2, 2, right};
    const uint8_t a[] = {10, 10, 10, 20, 20, 20, 30, 30, 30, 40, 40, 40};
    const uint8_t b[] = {10, 10, 10, 20, 21, 20, 99, 30, 30, 40, 40, 43};
    struct signature_comparison found;
    signatures_compare(&one, &other, a, b, 2, 1, &found);
    assert_int_equal(found.pixels, 4);
    assert_int_equal(found.flips, 1);
    assert_int_equal(found.flip_error, 69);
    assert_int_equal(found.drift, 3);
    assert_int_equal(found.drifted, 1);
    signatures_compare(&one, &one, NULL, NULL, 0, 1, &found);
    assert_int_equal(found.flips, 0);
}

static void signature_files_come_back_and_damage_is_found(void **state) {
    (void)state;
    static const char *const damaged[] = {"",
                                          "superframe signatures 1 0 5\n",
                                          "superframe signatures 1 5\n",
                                          "superframe signatures 1 99999 1\n",
                                          "superframe signatures 1 2 2\n12345678",
                                          "superframe signatures 2 1 1\n12345678",
                                          "superframe signatures 1 1 1\n123456789"};
    struct signatures written, back;
    make_signatures("fx", &(struct tail){false, 0}, 0, 15, 1, &written);
    FILE *file = tmpfile();
    assert_non_null(file);
    assert_true(signatures_write(&written, file));
    rewind(file);
    assert_null(signatures_read(file, &back));
    (void)fclose(file);
    assert_memory_equal(written.of_pixel, back.of_pixel, 24 * 15 * sizeof *back.of_pixel);
    signatures_free(&written);
    signatures_free(&back);
    for (size_t i = 0; i < sizeof damaged / sizeof damaged[0]; i++) {
        file = tmpfile();
        assert_non_null(file);
        (void)fputs(damaged[i], file);
        rewind(file);
        assert_non_null(signatures_read(file, &back));
        (void)fclose(file);
        signatures_free(&back);
    }
}

/* Each place is its own thread's alone. */
static void mark(void *context, unsigned i) {
    uint8_t *marks = context;
    marks[i]++;
}

static void work_is_done_once_each(void **state) {
    (void)state;
    const volatile sig_atomic_t stop = 1;
    for (unsigned jobs = 1; jobs <= 5; jobs++) {
        uint8_t marks[100] = {0};
        parallel_for(10, 90, jobs, mark, marks, NULL);
        for (unsigned i = 0; i < 100; i++) {
            assert_int_equal(marks[i], i >= 10 && i < 90);
        }
        parallel_for(0, 10, jobs, mark, marks, &stop);
        assert_int_equal(marks[0], 0);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_key_tells_points_apart),
        cmocka_unit_test(the_front_has_no_setting_that_another_beats),
        cmocka_unit_test(a_mix_counts_every_primitive),
        cmocka_unit_test(operations_add_up),
        cmocka_unit_test(every_machine_has_code_and_a_source),
        cmocka_unit_test(requirements_of_built_in_scenes),
        cmocka_unit_test(check_and_compile_share_the_features),
        cmocka_unit_test(check_names_what_a_scene_requires),
        cmocka_unit_test(signatures_do_not_depend_on_jobs),
        cmocka_unit_test(signatures_tell_an_accuracy_but_no_tail),
        cmocka_unit_test(drift_and_flips_are_told_apart),
        cmocka_unit_test(signature_files_come_back_and_damage_is_found),
        cmocka_unit_test(work_is_done_once_each),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
