/* SPDX-License-Identifier: MIT */
/* The points that `superframe measure` plans, and how points.csv brings them back. Nothing is
 * rendered. */
#include "measure_fixture.h"

/* ---- The plan ------------------------------------------------------------------------------- */

static bool is_grid(const struct measure *measure, const struct measure_point *point) {
    return is_of_first_kind(measure, point) && strcmp(point->tail, "black") == 0 &&
           !(point->error > 0);
}

static struct measure_point with_arithmetic(const struct measure_point *point, const char *name) {
    struct measure_point other = *point;
    (void)snprintf(other.arithmetic, sizeof other.arithmetic, "%s", name);
    return other;
}

static size_t count_points(const struct measure *measure, const char *scene,
                           const struct measure_point *like) {
    size_t count = 0;
    for (size_t i = 0; i < measure->points.count; i++) {
        const struct measure_point *point = &measure->points.points[i];
        count += strcmp(point->scene, scene) == 0 && is_same_but_scene(point, like);
    }
    return count;
}

static void no_point_is_planned_twice_and_no_scene_lacks_one(void **state) {
    (void)state;
    for (unsigned i = 0; i < PLANS; i++) {
        struct measure *measure = plan_measure(plans[i]);
        for (size_t j = 0; j < measure->points.count; j++) {
            const struct measure_point *point = &measure->points.points[j];
            assert_false(point->is_done);
            for (size_t k = 0; k < measure->scene_count; k++) {
                assert_int_equal(count_points(measure, measure->scenes[k].name, point), 1);
            }
        }
        discard_measure(measure);
    }
}

/* Each arithmetic gets the same work, or they could not be compared. */
static void the_grid_is_the_same_for_every_arithmetic(void **state) {
    static const char *const all[] = {"fx", "f32", "f64", "q16", "q16_epsilon"};
    struct measure *measure = plan_measure("measure fig3 -o m");
    const struct measure_list *list = &measure->points;
    bool has_depth[65] = {false}, has_paper = false;
    (void)state;
    for (size_t i = 0; i < list->count; i++) {
        const struct measure_point *point = &list->points[i];
        bool is_exact = strncmp(point->arithmetic, "q16", 3) != 0;
        assert_true(is_exact || is_grid(measure, point));
        for (size_t j = 0; j < (is_grid(measure, point) ? 5U : 3U); j++) {
            const struct measure_point other = with_arithmetic(point, all[j]);
            assert_true(!is_of_first_kind(measure, point) ||
                        measure_list_find(list, &other) != NULL);
        }
        /* A tree without a threshold doubles with each level. */
        assert_true(point->depth <= 10 || point->threshold > 0 || point->error > 0);
        assert_true(point->depth <= 64);
        has_depth[point->depth] = true;
        has_paper = has_paper || (point->depth == 10 && point->threshold + point->error <= 0);
    }
    assert_true(has_depth[1] && has_paper && has_depth[64]);
    discard_measure(measure);
}

/* An estimate and an accuracy belong together: with a black tail none can be asked for. */
static void tails_and_accuracies_are_planned_where_no_option_forbids_them(void **state) {
    static const struct {
        const char *options;
        bool has_tails, has_errors, has_grid;
    } cases[] = {{"", true, true, true},
                 {" --tail black", false, false, true},
                 {" --tail estimate", false, true, false},
                 {" --threshold 1/512", true, false, true},
                 {" --error 2", true, true, true},
                 {" --depth 5", true, true, true}};
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        char line[LINE_SIZE];
        size_t tails = 0, errors = 0, grid = 0;
        (void)snprintf(line, sizeof line, "measure fig3 -o m%s", cases[i].options);
        struct measure *measure = plan_measure(line);
        bool is_estimated = strcmp(measure->points.points[0].tail, "estimate") == 0;
        for (size_t j = 0; j < measure->points.count; j++) {
            const struct measure_point *point = &measure->points.points[j];
            errors += point->error > 0;
            tails += !is_estimated && !(point->error > 0) && strcmp(point->tail, "estimate") == 0;
            grid += is_grid(measure, point);
            assert_true(!(point->error > 0) || !(point->threshold > 0));
            assert_true(!(point->error > 0) || strcmp(point->tail, "estimate") == 0);
        }
        assert_int_equal(tails > 0, cases[i].has_tails);
        assert_int_equal(errors > 0, cases[i].has_errors);
        assert_int_equal(grid > 0, cases[i].has_grid);
        discard_measure(measure);
    }
}

/* What an option fixes is the same in every point. */
static void an_option_fixes_its_column(void **state) {
    static const char line[] = "measure fig3 fig5 -o m --arith f32 --depth 6 --threshold 1/128 "
                               "--size 20x10 --colour bits:3 --model simple";
    struct measure *measure = plan_measure(line);
    (void)state;
    for (size_t i = 0; i < measure->points.count; i++) {
        const struct measure_point *point = &measure->points.points[i];
        assert_string_equal(point->arithmetic, "f32");
        assert_string_equal(point->colour, "bits:3");
        assert_string_equal(point->model, "simple");
        assert_true(point->depth == 6 && point->width == 20 && point->height == 10);
        assert_true(is_near(point->threshold, 1.0 / 128, 0));
    }
    discard_measure(measure);
}

/* Beside the grid one thing is varied at a time, from the middle of it. */
static void what_is_varied_beside_the_grid_is_one_thing(void **state) {
    struct measure *measure = plan_measure("measure fig3 -o m");
    const struct measure_point *first = &measure->points.points[0];
    size_t sizes = 0, colours = 0, models = 0;
    (void)state;
    for (size_t i = 0; i < measure->points.count; i++) {
        const struct measure_point *point = &measure->points.points[i];
        bool is_size = point->width != first->width || point->height != first->height;
        bool is_colour = strcmp(point->colour, first->colour) != 0;
        bool is_model = strcmp(point->model, first->model) != 0;
        struct measure_point middle = *point;
        assert_true(is_size + is_colour + is_model <= 1);
        sizes += is_size;
        colours += is_colour;
        models += is_model;
        middle.width = first->width;
        middle.height = first->height;
        strcpy(middle.colour, first->colour);
        strcpy(middle.model, first->model);
        assert_non_null(measure_list_find(&measure->points, &middle));
        assert_int_equal(point->width * first->height, point->height * first->width);
    }
    assert_int_equal(sizes, 3);
    assert_int_equal(colours, 5);
    assert_int_equal(models, 2);
    discard_measure(measure);
}

/* A dithered pixel has 2 x 2 dots, and the board 640 x 400. */
static void only_what_the_board_shows_is_planned(void **state) {
    static const char *const plans_of_size[] = {
        "measure fig3 -o m",
        "measure fig3 -o m --colour dither",
        "measure fig3 -o m --size 320x200",
        "measure fig3 -o m --size 321x200 --depth 2",
        "measure fig3 -o m --size 320x201 --depth 2",
    };
    struct options_error error;
    struct options options;
    struct measure refused;
    (void)state;
    for (size_t i = 0; i < sizeof plans_of_size / sizeof plans_of_size[0]; i++) {
        struct measure *measure = plan_measure(plans_of_size[i]);
        size_t dithered = 0;
        for (size_t j = 0; j < measure->points.count; j++) {
            const struct measure_point *point = &measure->points.points[j];
            bool is_dithered = strcmp(point->colour, "dither") == 0;
            dithered += is_dithered;
            assert_true(!is_dithered || (point->width <= 320 && point->height <= 200));
        }
        assert_int_equal(dithered > 0, i < 3);
        discard_measure(measure);
    }
    memset(&refused, 0, sizeof refused);
    assert_true(parse("measure fig3 -o m --colour dither --size 640x400", &options, &error));
    refused.options = &options;
    refused.scene_count = 1;
    refused.scenes[0].operand = "fig3";
    assert_int_equal(measure_plan(&refused), STATUS_BAD_INPUT);
    assert_int_equal(refused.points.count, 0);
}

/* ---- points.csv ----------------------------------------------------------------------------- */

static FILE *create_points(const struct measure *measure) {
    FILE *file = fopen(measure->points_path, "w+");
    assert_non_null(file);
    assert_true(measure_write_head(file));
    return file;
}

static void assert_same_results(const struct measure_point *a, const struct measure_point *b) {
    assert_int_equal(a->events.rays, b->events.rays);
    assert_int_equal(a->events.shadow_rays, b->events.shadow_rays);
    assert_int_equal(a->events.nodes, b->events.nodes);
    assert_int_equal(a->events.solid_tests, b->events.solid_tests);
    assert_int_equal(a->leaked_rays, b->leaked_rays);
    assert_int_equal(a->port_writes, b->port_writes);
    assert_int_equal(a->largest, b->largest);
    assert_true(is_near(a->seconds, b->seconds, 1e-6));
    assert_true(is_near(a->wrong, b->wrong, 1e-6));
    assert_true(is_near(a->apart, b->apart, 1e-6));
    assert_true(is_near(a->rmse, b->rmse, 1e-6));
    assert_true(isinf(a->psnr) ? isinf(b->psnr) : is_near(a->psnr, b->psnr, 1e-4));
    assert_true(is_near(a->colour_mean, b->colour_mean, 1e-6));
    assert_true(is_near(a->colour_high, b->colour_high, 1e-6));
}

/* Half of the lines, in the other direction, between lines of a scene that is not asked for and a
 * line that was cut off. */
static void points_come_back_as_they_were_written(void **state) {
    static const char line[] = "measure fig3 figA -o m";
    struct measure *written = plan_measure(line), *read = plan_measure(line);
    size_t kept = 0;
    (void)state;
    draw_results(written, 9);
    FILE *file = create_points(written);
    for (size_t i = written->points.count; i-- > 0;) {
        struct measure_point foreign = written->points.points[i];
        if (i % 2 == 0) {
            measure_write_point(written, file, &written->points.points[i]);
            kept++;
        }
        strcpy(foreign.scene, "other");
        measure_write_point(written, file, &foreign);
    }
    (void)fputs("fig3,fx,1,0.00390625,160,100,full,fresnel,black,0,12,", file);
    (void)fclose(file);
    assert_int_equal(measure_resume(read), STATUS_DONE);
    assert_int_equal(read->kept, kept);
    for (size_t i = 0; i < read->points.count; i++) {
        assert_int_equal(read->points.points[i].is_done, i % 2 == 0);
        if (i % 2 == 0) {
            assert_same_results(&read->points.points[i], &written->points.points[i]);
        }
    }
    discard_measure(written);
    discard_measure(read);
}

/* A line without its end may have lost digits too; one of another scene than today's is refused. */
static void a_line_that_is_not_whole_is_not_taken(void **state) {
    static const char plan[] = "measure fig3 -o m --arith fx --depth 3 --tail black";
    struct measure *measure = plan_measure(plan);
    char line[1024];
    (void)state;
    draw_results(measure, 4);
    FILE *file = create_points(measure);
    long begin = ftell(file);
    measure_write_point(measure, file, &measure->points.points[0]);
    size_t length = (size_t)(ftell(file) - begin);
    assert_int_equal(fseek(file, begin, SEEK_SET), 0);
    assert_int_equal(fread(line, 1, length, file), length);
    (void)fclose(file);
    for (size_t i = 0; i <= length; i++) {
        struct measure *again = plan_measure(plan);
        file = create_points(again);
        assert_int_equal(fwrite(line, 1, i, file), i);
        (void)fclose(file);
        assert_int_equal(measure_resume(again), STATUS_DONE);
        assert_int_equal(again->kept, i == length);
        assert_int_equal(again->points.points[0].is_done, i == length);
        discard_measure(again);
    }
    discard_measure(measure);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        TEST(no_point_is_planned_twice_and_no_scene_lacks_one),
        TEST(the_grid_is_the_same_for_every_arithmetic),
        TEST(tails_and_accuracies_are_planned_where_no_option_forbids_them),
        TEST(an_option_fixes_its_column),
        TEST(what_is_varied_beside_the_grid_is_one_thing),
        TEST(only_what_the_board_shows_is_planned),
        TEST(points_come_back_as_they_were_written),
        TEST(a_line_that_is_not_whole_is_not_taken),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
