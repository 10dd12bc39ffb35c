/* SPDX-License-Identifier: MIT */
/* Fig. 3 of the paper: what depth level 5 hides, depth level 10 shows. */
#include "scene_fixture.h"

/* The share, in percent, of the pixels inside the inner cube's outline that change by more than 16
 * levels when the board's two colours change places. The view line's nodes tell which pixels those
 * are: the inner cube is entered straight from the eye. */
struct outline {
    bool reaches_inner;
    uint32_t straight; /* the last node on the way straight through */
    uint8_t inner;     /* the inner cube's object */
};

static void follow_straight(void *context, const struct observed_node *node) {
    struct outline *outline = context;
    if (node->parent != outline->straight || node->kind == OBSERVED_REFLECTED) {
        return;
    }
    outline->straight = node->number;
    outline->reaches_inner = outline->reaches_inner || node->after == outline->inner;
}

static void ignore_end(void *context, const struct observed_end *end) {
    (void)context;
    (void)end;
}

static bool is_inside_outline(const struct loaded_scene *loaded, unsigned x, unsigned y) {
    struct outline outline = {false, 0, (uint8_t)(loaded->compiled->object_count - 1)};
    const struct pixel_observer observer = {&outline, follow_straight, ignore_end};
    struct render_counts counts = {0};
    double intensity[3];
    loaded->arithmetic->pixel(loaded->scene, (uint16_t)x, (uint16_t)y, intensity, &counts,
                              &observer);
    return outline.reaches_inner;
}

static void swap_board_colours(struct scene_description *description) {
    int swapped = 0;
    for (size_t i = 0; i < description->material_count; i++) {
        struct scene_material *material = &description->materials[i];
        for (int j = 0; j < 3 && material->pattern.present; j++) {
            double colour = material->colour[j];
            material->colour[j] = material->pattern.colour[j];
            material->pattern.colour[j] = colour;
            swapped++;
        }
    }
    assert_int_equal(swapped, 3);
}

static double changed_share(int depth) {
    struct scene_error error;
    struct scene_description *description = load_scene("fig3", &error);
    assert_non_null(description);
    description->depth = depth;
    struct loaded_scene plain = load_description(description, "fx");
    swap_board_colours(description);
    struct loaded_scene swapped = load_description(description, "fx");
    struct render_counts counts = {0};
    int inside = 0, changed = 0;
    for (unsigned y = 0; y < 200; y += 2) {
        for (unsigned x = 0; x < 320; x += 2) {
            if (!is_inside_outline(&plain, x, y)) {
                continue;
            }
            int before[3], after[3], most = 0;
            pixel_levels(&plain, x, y, before, &counts);
            pixel_levels(&swapped, x, y, after, &counts);
            for (int i = 0; i < 3; i++) {
                int difference = abs(before[i] - after[i]);
                most = difference > most ? difference : most;
            }
            inside++;
            changed += most > 16;
        }
    }
    unload(&plain);
    unload(&swapped);
    scene_description_free(description);
    assert_true(inside > 200);
    print_message("depth level %d: %d of %d pixels inside the inner cube's outline change\n", depth,
                  changed, inside);
    return 100.0 * changed / inside;
}

static void depth_5_hides_the_board_behind_the_inner_cube(void **state) {
    (void)state;
    assert_true(changed_share(5) < 2);
}

static void depth_10_shows_the_board_through_all_three_cubes(void **state) {
    (void)state;
    assert_true(changed_share(10) > 70);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(depth_5_hides_the_board_behind_the_inner_cube),
        cmocka_unit_test(depth_10_shows_the_board_through_all_three_cubes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
