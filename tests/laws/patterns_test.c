/* SPDX-License-Identifier: MIT */
/* Patterns: a cell is that of the solid's side, wherever the pattern's origin lies. */
#include "scene_fixture.h"

enum { TEXT_SIZE = 4096, WIDTH = 40, HEIGHT = 25 };

static const char *const arithmetics[] = {"fx", "f32", "f64", "f128"};
enum { ARITHMETICS = 4 };

/* One patterned material: x, y or z is the axis across which the slab lies. */
struct slab {
    int axis;
    double low, high; /* along the axis, within one cell of it */
    double size;      /* of cells along the axis; 0: the colour does not change along it */
    double origin;    /* of cells along the axis */
    bool swapped;     /* the two colours change places */
    bool is_glass;
};

/* Three numbers: one along the axis, another along the other two. */
static void three(char *text, size_t size, int axis, double along, double others) {
    double v[3] = {others, others, others};
    v[axis] = along;
    snprintf(text, size, "(%.17g, %.17g, %.17g)", v[0], v[1], v[2]);
}

static void write_slab(char *text, const struct slab *slab) {
    char low[80], high[80], size[80], origin[80];
    three(low, sizeof low, slab->axis, slab->low, -2.3);
    three(high, sizeof high, slab->axis, slab->high, 2.2);
    three(size, sizeof size, slab->axis, slab->size, 0.7);
    three(origin, sizeof origin, slab->axis, slab->origin, 0.13);
    snprintf(text, TEXT_SIZE,
             "version = 1; size = [40, 25]; depth = 4; background = [20, 40, 60];\n"
             "camera = { eye = (5.1, -4.3, 4.7); look_at = (0, 0, 0); field_of_view = 40; };\n"
             "lights = ( { direction = (-1, 2, -3); } );\n"
             "materials = { m = { colour = %s; ambient = 0.8; ambient_is_own = true; diffuse = 0.2;"
             " %s pattern = { size = %s; origin = %s; colour = %s; }; }; };\n"
             "objects = ( { material = \"m\"; solid = { box = { min = %s; max = %s; }; }; } );\n",
             slab->swapped ? "(0, 0, 200)" : "(250, 240, 230)", slab->is_glass ? "ior = 1.5;" : "",
             size, origin, slab->swapped ? "(250, 240, 230)" : "(0, 0, 200)", low, high);
}

/* Counts the pixels that differ between two scenes in one arithmetic; fails where nothing is seen.
 */
static int differing(const char *one, const char *other, const char *arithmetic) {
    struct loaded_scene a = load_text(one, arithmetic), b = load_text(other, arithmetic);
    struct render_counts counts = {0};
    int count = 0, seen = 0;
    for (unsigned y = 0; y < HEIGHT; y++) {
        for (unsigned x = 0; x < WIDTH; x++) {
            int left[3], right[3];
            pixel_levels(&a, x, y, left, &counts);
            pixel_levels(&b, x, y, right, &counts);
            count += left[0] != right[0] || left[1] != right[1] || left[2] != right[2];
            seen += left[0] != 20 || left[1] != 40 || left[2] != 60;
        }
    }
    assert_true(seen > WIDTH * HEIGHT / 8);
    unload(&a);
    unload(&b);
    return count;
}

static void a_face_in_which_cells_end_has_the_cell_of_its_solids_side(void **state) {
    (void)state;
    for (int i = 0; i < 3 * 2 * 2; i++) {
        /* The slab lies in cell 0 or in cell -1, and both of its faces where one ends. */
        struct slab ending = {.axis = i % 3, .size = 0.5, .is_glass = i / 6 > 0};
        bool is_odd = i / 3 % 2 > 0;
        ending.low = is_odd ? -0.5 : 0;
        ending.high = is_odd ? 0 : 0.5;
        struct slab plain = ending;
        plain.size = 0;
        plain.swapped = is_odd;
        char text[TEXT_SIZE], reference[TEXT_SIZE];
        write_slab(text, &ending);
        write_slab(reference, &plain);
        for (int j = 0; j < ARITHMETICS; j++) {
            assert_int_equal(differing(text, reference, arithmetics[j]), 0);
        }
    }
}

/* Nearer than points of the face are rounded: within the cell, and beyond its end. */
static void a_face_near_the_end_of_a_cell_has_the_cell_that_it_lies_in(void **state) {
    (void)state;
    static const double offsets[] = {1e-6, -1e-6, 3e-5, -3e-5};
    for (size_t i = 0; i < sizeof offsets / sizeof offsets[0]; i++) {
        /* Top and bottom lie in the same cell; the sides pass the end by less than a pixel. */
        struct slab near = {.axis = 2, .low = -0.3, .high = 0, .size = 0.5, .origin = offsets[i]};
        struct slab plain = near;
        plain.size = 0;
        plain.swapped = true; /* all but the top is in cell -1 */
        char text[TEXT_SIZE], reference[TEXT_SIZE];
        write_slab(reference, &plain);
        if (offsets[i] < 0) {
            near.low = near.origin; /* only what is above the end: cell 0 */
            near.high = 0.3;
            plain = near;
            plain.size = 0;
            write_slab(reference, &plain);
        }
        write_slab(text, &near);
        for (int j = 0; j < ARITHMETICS; j++) {
            assert_int_equal(differing(text, reference, arithmetics[j]), 0);
        }
    }
}

static void a_pattern_is_the_same_from_any_of_its_corners(void **state) {
    (void)state;
    static const double steps[] = {2, -34, 4000, -123456};
    for (size_t i = 0; i < sizeof steps / sizeof steps[0]; i++) {
        /* Sizes that the steps multiply exactly: the corner is one of the pattern's. */
        struct slab slab = {.axis = 2, .low = -0.4, .high = 0.3, .size = 0.25, .origin = 0.11};
        char near[TEXT_SIZE], far[TEXT_SIZE];
        write_slab(near, &slab);
        slab.origin += steps[i] * slab.size;
        write_slab(far, &slab);
        for (int j = 0; j < ARITHMETICS; j++) {
            assert_true(differing(near, far, arithmetics[j]) <= 1);
        }
    }
}

static void expect_refusal(const char *text, const char *arithmetic, const char *words) {
    struct scene_error error = {""};
    struct scene_description *description = read_text(text);
    struct compiled_scene *compiled = scene_compile(description, &error);
    struct scene *scene =
        compiled == NULL ? NULL : arithmetic_find(arithmetic)->load(compiled, &error);
    assert_null(scene);
    if (strstr(error.text, words) == NULL) {
        fail_msg("not '%s' but '%s'", words, error.text);
    }
    compiled_scene_free(compiled);
    scene_description_free(description);
}

static void cells_whose_borders_would_stray_are_refused_where_they_do(void **state) {
    (void)state;
    /* Some 20,000 cells, of a size that fx rounds by a part in 70,000 or so. */
    struct slab slab = {.axis = 2, .low = -50, .high = 50, .size = 0.00437, .origin = 0.1};
    char text[TEXT_SIZE];
    write_slab(text, &slab);
    expect_refusal(text, "fx", "test.scene:4: a pattern's cell smaller than this arithmetic");
    struct loaded_scene loaded = load_text(text, "f64");
    unload(&loaded);
}

static void huge_cells_whose_origin_is_out_of_reach_are_refused(void **state) {
    (void)state;
    struct slab slab = {.axis = 2, .low = -0.5, .high = 0.5, .size = 1e6, .origin = 4e5};
    char text[TEXT_SIZE];
    write_slab(text, &slab);
    expect_refusal(text, "f64", "test.scene:4: a pattern of cells larger than the scene");
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_face_in_which_cells_end_has_the_cell_of_its_solids_side),
        cmocka_unit_test(a_face_near_the_end_of_a_cell_has_the_cell_that_it_lies_in),
        cmocka_unit_test(a_pattern_is_the_same_from_any_of_its_corners),
        cmocka_unit_test(cells_whose_borders_would_stray_are_refused_where_they_do),
        cmocka_unit_test(huge_cells_whose_origin_is_out_of_reach_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
