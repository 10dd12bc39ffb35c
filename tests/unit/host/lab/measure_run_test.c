/* SPDX-License-Identifier: MIT */
/* Real renderings of `superframe measure`: what they are judged by, how many rows were announced,
 * and the pictures of the error. */
#include "measure_fixture.h"
#include "picture/ciede2000.h"
#include "picture/error_map.h"
#include "png_file.h"
#include "scene_fixture.h"

/* Small scenes: glass over a striped board, and something opaque, which is quick. */
static const char glass_text[] =
    "version = 1;\nsize = [16, 10];\n"
    "camera = { eye = (0.3, -6, 1.4); look_at = (0, 0, 0); };\n" SCENE_LIGHT_AND_MATERIALS
    "objects = ( { material = \"glass\"; solid = { ball = { radius = 1; }; }; },\n"
    "            { material = \"board\"; solid = { box = { min = (-3.0, -3.0, -1.3);\n"
    "              max = (3.0, 3.0, -1.1); }; }; } );\n";

static const char clay_text[] =
    "version = 1;\nsize = [16, 10];\n"
    "camera = { eye = (0, -6, 1); look_at = (0, 0, 0); };\n" SCENE_LIGHT_AND_MATERIALS
    "objects = ( { material = \"clay\"; solid = { ball = { radius = 1; }; }; } );\n";

static struct measure *plan_scenes(const char *line) {
    static const char *const names[] = {"glass", "clay", "slate"};
    const char *const texts[] = {glass_text, clay_text, clay_text};
    for (size_t i = 0; i < 3; i++) {
        char path[32];
        (void)snprintf(path, sizeof path, "%s.scene", names[i]);
        FILE *file = fopen(path, "w");
        assert_non_null(file);
        assert_true(fputs(texts[i], file) >= 0);
        assert_int_equal(fclose(file), 0);
    }
    return plan_measure(line);
}

/* ---- Rows ----------------------------------------------------------------------------------- */

/* Runs what is left to do, and checks that as many rows are drawn as were announced. */
static void run_and_count(struct measure *measure) {
    (void)remove(measure->points_path);
    assert_int_equal(measure_run(measure), STATUS_DONE);
    assert_int_equal(measure->work.now.rows, measure->work.progress.rows);
    for (size_t i = 0; i < measure->points.count; i++) {
        assert_true(measure->points.points[i].is_done);
    }
}

/* Several references (models), several arithmetics to a twin, and every share of them done. */
static void the_rows_that_are_announced_are_drawn(void **state) {
    static const char *const lines[] = {
        "measure clay.scene -o m --arith fx --depth 2 --size 3x2 --colour full --tail black "
        "--quiet",
        "measure clay.scene slate.scene -o m --depth 1 --threshold 1/8 --size 3x2 --colour full "
        "--model simple --quiet"};
    uint64_t random = 5;
    (void)state;
    for (unsigned i = 0; i < 3; i++) {
        struct measure *measure = plan_scenes(lines[i > 0 ? 1 : 0]);
        for (size_t j = 0; j < measure->points.count; j++) {
            measure->points.points[j].is_done = i == 2 && splitmix64(&random) % 2 == 0;
        }
        run_and_count(measure);
        discard_measure(measure);
    }
}

/* ---- Judgement ------------------------------------------------------------------------------ */

/* A picture as measure_shoot() gives it. */
struct shot {
    uint8_t *rgb;
    size_t dots;
};

static struct shot shoot(struct measure *measure, const struct measure_point *like,
                         const char *arithmetic) {
    struct measure_point point = *like;
    const struct measure_scene *scene = measure_scene_of(measure, point.scene);
    struct shot shot;
    unsigned dots;
    strcpy(point.arithmetic, arithmetic);
    assert_int_equal(measure_shoot(measure, scene->operand, &point, &shot.rgb, &dots), STATUS_DONE);
    shot.dots = (size_t)point.width * point.height * dots * dots;
    return shot;
}

/* Draws what all of a group is held against: double, nothing cut that could be seen. */
static struct shot shoot_reference(struct measure *measure, const struct measure_point *like) {
    struct measure_point point = *like;
    strcpy(point.colour, "full");
    strcpy(point.tail, "estimate");
    point.depth = MEASURE_CONVERGED_DEPTH;
    point.threshold = MEASURE_CONVERGED_THRESHOLD;
    point.error = 0;
    return shoot(measure, &point, "f64");
}

/* How far two pictures are apart, plainly. */
struct apart {
    double wrong, square;
    unsigned largest;
};

static struct apart apart_of(const struct shot *a, const struct shot *b) {
    struct apart apart = {0, 0, 0};
    assert_int_equal(a->dots, b->dots);
    for (size_t i = 0; i < a->dots; i++) {
        unsigned worst = 0;
        for (size_t j = 3 * i; j < 3 * i + 3; j++) {
            unsigned off = (unsigned)abs(a->rgb[j] - b->rgb[j]);
            worst = off > worst ? off : worst;
            apart.square += (double)off * off;
        }
        apart.wrong += worst > 1 ? 100.0 / (double)a->dots : 0;
        apart.largest = worst > apart.largest ? worst : apart.largest;
    }
    return apart;
}

static void assert_judgement(struct measure *measure, const struct measure_point *point,
                             const struct shot *reference) {
    struct shot picture = shoot(measure, point, point->arithmetic);
    struct shot twin = shoot(measure, point, "f64");
    struct apart wrong = apart_of(reference, &picture), apart = apart_of(&twin, &picture);
    struct colour_differences colours;
    double rmse = sqrt(wrong.square / (3 * (double)picture.dots));
    assert_true(is_near(point->wrong, wrong.wrong, 1e-6));
    assert_true(is_near(point->apart, apart.wrong, 1e-6));
    assert_int_equal(point->largest, wrong.largest);
    assert_true(is_near(point->rmse, rmse, 1e-9));
    assert_int_equal(isinf(point->psnr) != 0, wrong.largest == 0);
    assert_true(isinf(point->psnr) || is_near(point->psnr, 20 * log10(255 / rmse), 1e-6));
    assert_true(colour_differences(reference->rgb, picture.rgb, picture.dots, &colours));
    assert_true(is_near(point->colour_mean, colours.mean, 1e-9));
    assert_true(is_near(point->colour_high, colours.high, 1e-9));
    free(picture.rgb);
    free(twin.rgb);
}

static void points_are_judged_against_the_converged_picture_and_their_twin(void **state) {
    static const char *const lines[] = {
        "measure glass.scene -o m --depth 6 --threshold 1/256 --size 100x2 --model fresnel --quiet",
        "measure glass.scene -o m --arith f32 --depth 2 --threshold 1/64 --size 60x2 "
        "--colour bits:4 --model fresnel --quiet"};
    size_t wrong = 0, apart = 0, count = 0;
    (void)state;
    for (size_t i = 0; i < 2; i++) {
        struct measure *measure = plan_scenes(lines[i]);
        run_and_count(measure);
        struct shot reference = shoot_reference(measure, &measure->points.points[0]);
        for (size_t j = 0; j < measure->points.count; j++) {
            const struct measure_point *point = &measure->points.points[j];
            assert_judgement(measure, point, &reference);
            count++;
            wrong += point->wrong > 0;
            apart += point->apart > 0;
        }
        assert_true(measure->scenes[0].oracle > 90 && measure->scenes[0].oracle <= 100);
        free(reference.rgb);
        discard_measure(measure);
    }
    /* The test is none unless pictures were off, and twins were. */
    assert_true(count > 10 && wrong > 2 && apart > 0);
}

/* What a run measured is what points.csv holds, a head and a line each. */
static void what_was_measured_is_in_the_file_at_once(void **state) {
    static const char line[] = "measure clay.scene -o m --arith fx --depth 1 --size 3x2 --colour "
                               "full --tail black --quiet";
    struct measure *measure = plan_scenes(line), *again = plan_scenes(line);
    (void)state;
    run_and_count(measure);
    assert_int_equal(measure_resume(again), STATUS_DONE);
    assert_int_equal(again->kept, measure->points.count);
    for (size_t i = 0; i < again->points.count; i++) {
        const struct measure_point *one = &measure->points.points[i];
        assert_int_equal(again->points.points[i].events.rays, one->events.rays);
        assert_int_equal(again->points.points[i].port_writes, one->port_writes);
        assert_true(one->events.rays > 0 && one->port_writes > 0);
    }
    discard_measure(measure);
    discard_measure(again);
}

/* ---- Shots ---------------------------------------------------------------------------------- */

/* Renders by the command what measure_shoot() draws of a point, and compares dot by dot. */
static void assert_shot(struct measure *measure, const struct measure_point *point,
                        const char *options) {
    struct measure_point shot = *point;
    struct png_image image;
    struct png_error error;
    char line[512];
    uint8_t *rgb;
    unsigned dots;
    (void)snprintf(line, sizeof line,
                   "superframe render glass.scene -o shot.png --quiet --arith %s --depth %u "
                   "--size %ux%u --colour %s --model %s --tail %s %s",
                   point->arithmetic, point->depth, point->width, point->height, point->colour,
                   point->model, point->tail, options);
    assert_status(line, 0);
    FILE *file = fopen("shot.png", "rb");
    assert_non_null(file);
    assert_int_equal(read_png(file, &image, &error), PNG_OK);
    (void)fclose(file);
    assert_int_equal(measure_shoot(measure, "glass.scene", &shot, &rgb, &dots), STATUS_DONE);
    assert_true(point->width * dots <= image.width && point->height * dots <= image.height);
    for (size_t y = 0; y < (size_t)point->height * dots; y++) {
        size_t width = (size_t)point->width * dots * 3;
        assert_memory_equal(rgb + y * width, image.rgb + y * image.width * 3, width);
    }
    assert_true(shot.events.rays > 0 && shot.port_writes > 0);
    free_png(&image);
    free(rgb);
}

static void a_point_is_drawn_as_render_draws_it(void **state) {
    static const struct {
        struct measure_point point;
        const char *options;
    } cases[] = {
        {{"glass", "fx", "full", "fresnel", "black", 3, 40, 25, .threshold = 0}, "--threshold 0"},
        {{"glass", "f32", "bits:1", "simple", "black", 9, 40, 25, .threshold = 0.25},
         "--threshold 0.25"},
        {{"glass", "f64", "bits:4", "wavelength", "black", 4, 40, 25, .threshold = 0.01},
         "--threshold 0.01"},
        {{"glass", "fx", "dither", "fresnel", "black", 2, 40, 25, .threshold = 0}, "--threshold 0"},
        {{"glass", "f64", "full", "fresnel", "estimate", 5, 40, 25, .threshold = 0.1},
         "--threshold 0.1"},
        {{"glass", "f32", "full", "simple", "estimate", 20, 40, 25, .error = 3}, "--error 3"},
        {{"glass", "f64", "full", "fresnel", "black", 2, 330, 3, .threshold = 0}, "--threshold 0"},
    };
    struct measure *measure = plan_scenes("measure glass.scene -o m --quiet");
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        assert_shot(measure, &cases[i].point, cases[i].options);
    }
    discard_measure(measure);
}

/* ---- Pictures of the error ------------------------------------------------------------------ */

enum { WIDTH = 100, HEIGHT = 7, FACTOR = 3, GAP = 8 };

static void read_shown(const char *name, struct png_image *image) {
    char path[64];
    struct png_error error;
    (void)snprintf(path, sizeof path, "m/%s.png", name);
    FILE *file = fopen(path, "rb");
    assert_non_null(file);
    assert_int_equal(read_png(file, image, &error), PNG_OK);
    (void)fclose(file);
}

/* Left the picture, three times as large; a grey gap; right where it is off. */
static void assert_shown(const char *name, const uint8_t *picture, const uint8_t *difference) {
    static const uint8_t grey[3] = {128, 128, 128};
    struct png_image image;
    read_shown(name, &image);
    assert_int_equal(image.width, 2 * WIDTH * FACTOR + GAP);
    assert_int_equal(image.height, HEIGHT * FACTOR);
    for (size_t y = 0; y < HEIGHT * FACTOR; y++) {
        for (size_t x = 0; x < image.width; x++) {
            size_t right = WIDTH * FACTOR + GAP;
            size_t column = (x < WIDTH * FACTOR ? x : x - right) / FACTOR;
            size_t place = 3 * (y / FACTOR * WIDTH + column);
            const uint8_t *expected = x < WIDTH * FACTOR ? picture + place
                                      : x < right        ? grey
                                                         : difference + place;
            assert_memory_equal(image.rgb + 3 * (y * image.width + x), expected, 3);
        }
    }
    free_png(&image);
}

/* Each of the four kinds of points that are shown, and near ones that are not. */
static void four_points_are_shown_beside_where_they_are_off(void **state) {
    static const struct {
        struct measure_point point;
        const char *file;
    } cases[] = {
        {{"glass", "fx", "full", "fresnel", "black", 10, 3, 2, .threshold = 0}, "difference-paper"},
        {{"glass", "fx", "full", "fresnel", "black", 64, 3, 2, .threshold = 1.0 / 65536},
         "difference-fx"},
        {{"glass", "q16_epsilon", "full", "fresnel", "black", 64, 3, 2, .threshold = 1.0 / 65536},
         "difference-q16-epsilon"},
        {{"glass", "fx", "full", "fresnel", "estimate", 64, 3, 2, .error = 1}, "difference-error"},
        {{"clay", "fx", "full", "fresnel", "black", 10, 3, 2, .threshold = 0}, NULL},
        {{"glass", "f32", "full", "fresnel", "black", 10, 3, 2, .threshold = 0}, NULL},
        {{"glass", "fx", "bits:4", "fresnel", "black", 10, 3, 2, .threshold = 0}, NULL},
        {{"glass", "fx", "full", "fresnel", "estimate", 10, 3, 2, .threshold = 0}, NULL},
        {{"glass", "fx", "full", "fresnel", "black", 7, 3, 2, .threshold = 0}, NULL},
        {{"glass", "fx", "full", "fresnel", "black", 10, 3, 2, .threshold = 1.0 / 256}, NULL},
        {{"glass", "fx", "full", "fresnel", "black", 32, 3, 2, .threshold = 1.0 / 65536}, NULL},
        {{"glass", "fx", "full", "fresnel", "black", 64, 3, 2, .threshold = 1.0 / 16384}, NULL},
        {{"glass", "q16", "full", "fresnel", "black", 64, 3, 2, .threshold = 1.0 / 65536}, NULL},
        {{"glass", "fx", "full", "fresnel", "estimate", 64, 3, 2, .error = 2}, NULL},
        {{"glass", "fx", "full", "fresnel", "estimate", 64, 3, 2, .error = 0.5}, NULL},
        {{"glass", "f32", "full", "fresnel", "estimate", 64, 3, 2, .error = 1}, NULL},
    };
    static uint8_t picture[WIDTH * HEIGHT * 3], reference[WIDTH * HEIGHT * 3],
        difference[WIDTH * HEIGHT * 3];
    struct measure *measure = plan_scenes("measure glass.scene clay.scene -o m --arith fx");
    uint64_t random = 3;
    (void)state;
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        for (size_t j = 0; j < sizeof picture; j++) {
            picture[j] = (uint8_t)splitmix64(&random);
            reference[j] = (uint8_t)(picture[j] ^ (splitmix64(&random) & splitmix64(&random) & 3));
        }
        difference_picture(reference, picture, WIDTH * HEIGHT, difference);
        assert_int_equal(measure_show(measure, &cases[i].point, reference, picture, WIDTH, HEIGHT),
                         STATUS_DONE);
        assert_status("ls m | wc -l", 0);
        assert_int_equal(atoi(text_of("out")), cases[i].file != NULL);
        if (cases[i].file != NULL) {
            assert_shown(cases[i].file, picture, difference);
            assert_status("rm m/*.png", 0);
        }
    }
    discard_measure(measure);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        TEST(the_rows_that_are_announced_are_drawn),
        TEST(points_are_judged_against_the_converged_picture_and_their_twin),
        TEST(a_point_is_drawn_as_render_draws_it),
        TEST(what_was_measured_is_in_the_file_at_once),
        TEST(four_points_are_shown_beside_where_they_are_off),
    };
    return cmocka_run_group_tests(tests, enter_group, leave_group);
}
