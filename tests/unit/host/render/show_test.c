/* SPDX-License-Identifier: MIT */
/* What the firmware draws of known levels: in full, cut to bits, dithered, bit by bit.
 *
 * Rows come from the test itself (struct drawing's source), go through the firmware and the ports,
 * and are looked at on the board's screen. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "board/camera.h"
#include "board/port_chain.h"
#include "bus.h"
#include "render/arithmetic.h"
#include "render/render.h"
#include "scene/load.h"

enum { LEVELS = 256, PIXELS = 320 * 200 };

/* A board, and a scene of a size and colour mode whose own contents are not looked at. */
struct stage {
    struct port_chain *chain;
    struct compiled_scene *compiled;
    struct scene *scene;
};

static struct stage set_up(int width, int height, enum scene_colour colour, int bits,
                           uint32_t seed) {
    const struct scene_overrides overrides = {.has_depth = true,
                                              .depth = 2,
                                              .has_size = true,
                                              .width = width,
                                              .height = height,
                                              .has_colour = true,
                                              .colour = colour,
                                              .colour_bits = bits,
                                              .has_seed = true,
                                              .seed = seed};
    const struct board_desc desc = board_default_desc(BOARD_1987);
    struct scene_error error;
    struct stage stage;
    stage.chain = port_chain_new(&desc, true);
    stage.compiled = load_compiled_scene("fig3", &overrides, &error);
    assert_non_null(stage.chain);
    assert_non_null(stage.compiled);
    stage.scene = arithmetic_fx.load(stage.compiled, &error);
    assert_non_null(stage.scene);
    (void)bus_bind(&stage.chain->hash.bus);
    return stage;
}

static void take_down(struct stage *stage) {
    assert_int_equal(port_chain_finish(stage->chain), BUS_OK);
    assert_int_equal(board_violations(&stage->chain->board), 0);
    port_chain_free(stage->chain);
    compiled_scene_free(stage->compiled);
    free(stage->scene);
}

/* Draws all rows from the source; the screen is then in chain->rgb. */
static void draw(const struct stage *stage, row_source *source, void *context, unsigned exposure) {
    const struct drawing drawing = {.base = BOARD_FACTORY_BASE,
                                    .last = stage->compiled->height,
                                    .source = source,
                                    .context = context,
                                    .exposure = (uint8_t)exposure};
    arithmetic_fx.image->draw(stage->scene, &drawing);
    port_chain_picture(stage->chain);
    assert_int_equal(stage->chain->picture_state, PICTURE_OK);
}

/* The dot (x, y) of the screen. */
static const uint8_t *dot_at(const struct stage *stage, int x, int y) {
    return &stage->chain->rgb[(y * PICTURE_WIDTH + x) * 3];
}

/* A row in which every level stands once in each primary: 256 pixels. */
static bool all_levels(void *context, uint16_t y, uint8_t *rgb) {
    (void)context;
    for (int x = 0; x < LEVELS; x++) {
        rgb[3 * x] = (uint8_t)x;
        rgb[3 * x + 1] = (uint8_t)(255 - x);
        rgb[3 * x + 2] = (uint8_t)(x + 100 + y);
    }
    return true;
}

/* 320 pixels of the three levels that context points to. */
static bool flat(void *context, uint16_t y, uint8_t *rgb) {
    const uint8_t *levels = context;
    (void)y;
    for (int x = 0; x < 320; x++) {
        memcpy(&rgb[3 * x], levels, 3);
    }
    return true;
}

/* ---- Bits ----------------------------------------------------------------------------------- */

static void bits_are_cut_exactly(void **state) {
    (void)state;
    for (int bits = 1; bits <= 8; bits++) {
        struct stage stage = set_up(LEVELS, 2, COLOUR_BITS, bits, 1);
        const int step = 1 << (8 - bits);
        draw(&stage, all_levels, NULL, 0);
        for (int y = 0; y < 4; y++) {
            for (int x = 0; x < 2 * LEVELS; x++) {
                const int levels[3] = {x / 2, 255 - x / 2, (x / 2 + 100 + y / 2) % LEVELS};
                for (int i = 0; i < 3; i++) {
                    assert_int_equal(dot_at(&stage, x, y)[i], levels[i] / step * step);
                }
            }
        }
        take_down(&stage);
    }
}

static void full_is_all_of_it(void **state) {
    (void)state;
    struct stage stage = set_up(LEVELS, 1, COLOUR_FULL, 3, 1); /* the bits are not for this mode */
    draw(&stage, all_levels, NULL, 5);                         /* nor is the exposure */
    for (int x = 0; x < LEVELS; x++) {
        const uint8_t expected[3] = {(uint8_t)x, (uint8_t)(255 - x), (uint8_t)(x + 100)};
        assert_memory_equal(dot_at(&stage, 2 * x, 0), expected, 3);
    }
    take_down(&stage);
}

/* ---- Dither --------------------------------------------------------------------------------- */

/* How many of pixel (x, y)'s four dots are lit in a primary. Each dot is one of the 8 colours. */
static int lit_dots(const struct stage *stage, int x, int y, int primary) {
    int lit = 0;
    for (int i = 0; i < 4; i++) {
        uint8_t level = dot_at(stage, 2 * x + i % 2, 2 * y + i / 2)[primary];
        assert_true(level == 0 || level == 255);
        lit += level == 255;
    }
    return lit;
}

/* Over 64,000 pixels of one level v the numbers of lit dots are binomial: four draws of p = v/255.
 * Chi-square against that has 4 degrees of freedom (fewer where a share is nearly 0); 40 is passed
 * by chance once in 2 x 10^7 times. */
static void five_levels_have_the_right_shares(void **state) {
    (void)state;
    static const uint8_t levels[][3] = {{1, 64, 128}, {200, 254, 32}, {96, 160, 230}};
    for (size_t i = 0; i < sizeof levels / sizeof levels[0]; i++) {
        uint8_t row[3];
        struct stage stage = set_up(320, 200, COLOUR_DITHER, 0, 7 + (uint32_t)i);
        memcpy(row, levels[i], sizeof row);
        draw(&stage, flat, row, 0);
        for (int primary = 0; primary < 3; primary++) {
            static const double ways[5] = {1, 4, 6, 4, 1};
            const double p = levels[i][primary] / 255.0;
            long counts[5] = {0}, lit = 0;
            for (int pixel = 0; pixel < PIXELS; pixel++) {
                counts[lit_dots(&stage, pixel % 320, pixel / 320, primary)]++;
            }
            double chi_square = 0;
            for (int k = 0; k < 5; k++) {
                const double expected = PIXELS * ways[k] * pow(p, k) * pow(1 - p, 4 - k);
                lit += k * counts[k];
                chi_square += ((double)counts[k] - expected) * ((double)counts[k] - expected) /
                              fmax(expected, 1);
            }
            assert_true(chi_square < 40);
            /* The mean, to five standard deviations. */
            assert_true(fabs((double)lit - 4 * PIXELS * p) < 5 * sqrt(4 * PIXELS * p * (1 - p)));
        }
        take_down(&stage);
    }
}

static void black_and_white_have_no_speckles(void **state) {
    (void)state;
    uint8_t levels[3] = {0, 255, 0};
    struct stage stage = set_up(320, 200, COLOUR_DITHER, 0, 1);
    draw(&stage, flat, levels, 0);
    for (size_t i = 0; i < PICTURE_BYTES; i++) {
        assert_int_equal(stage.chain->rgb[i], i % 3 == 1 ? 255 : 0);
    }
    take_down(&stage);
}

/* The share of dots that are alike in two places of two screens: `step` bytes further in b. */
static double share_alike(const uint8_t *a, const uint8_t *b, size_t step) {
    long alike = 0;
    for (size_t i = 0; i + step < PICTURE_BYTES; i++) {
        alike += a[i] == b[i + step];
    }
    return (double)alike / (double)(PICTURE_BYTES - step);
}

/* At level 127 or 128 two dots that have nothing to do with each other are alike half of the time.
 * Of 768,000 pairs the share is off by more than 0.004 (seven standard deviations) by no chance. */
static void dots_have_nothing_to_do_with_each_other(void **state) {
    (void)state;
    static uint8_t first[PICTURE_BYTES];
    static const size_t steps[] = {
        1, 2, 3, 6, PICTURE_WIDTH * 3, PICTURE_WIDTH * 6, PICTURE_WIDTH * 3 + 3};
    uint8_t levels[3] = {128, 127, 128};
    struct stage stage = set_up(320, 200, COLOUR_DITHER, 0, 1);
    draw(&stage, flat, levels, 0);
    memcpy(first, stage.chain->rgb, sizeof first);
    for (size_t i = 0; i < sizeof steps / sizeof steps[0]; i++) {
        assert_true(fabs(share_alike(first, first, steps[i]) - 0.5) < 0.004);
    }
    take_down(&stage);
    for (uint32_t seed = 0; seed < 4; seed++) {
        stage = set_up(320, 200, COLOUR_DITHER, 0, seed == 3 ? UINT32_MAX : seed);
        draw(&stage, flat, levels, 0);
        if (seed == 1) {
            assert_memory_equal(stage.chain->rgb, first, sizeof first);
        } else {
            assert_true(fabs(share_alike(first, stage.chain->rgb, 0) - 0.5) < 0.004);
            /* Nor is it the same moved by one. */
            assert_true(fabs(share_alike(first, stage.chain->rgb, 1) - 0.5) < 0.004);
            assert_true(fabs(share_alike(stage.chain->rgb, first, 1) - 0.5) < 0.004);
        }
        take_down(&stage);
    }
}

static void a_dither_needs_four_dots_a_pixel(void **state) {
    (void)state;
    static const int sizes[][2] = {{321, 200}, {320, 201}, {640, 400}};
    for (size_t i = 0; i < sizeof sizes / sizeof sizes[0]; i++) {
        const struct scene_overrides overrides = {.has_size = true,
                                                  .width = sizes[i][0],
                                                  .height = sizes[i][1],
                                                  .has_colour = true,
                                                  .colour = COLOUR_DITHER};
        struct scene_error error = {""};
        assert_null(load_compiled_scene("fig3", &overrides, &error));
        assert_non_null(strstr(error.text, "fig3: colour \"dither\""));
        assert_non_null(strstr(error.text, "up to 320 x 200"));
    }
}

/* ---- Exposures ------------------------------------------------------------------------------ */

static void exposures_show_one_bit_each_and_add_up(void **state) {
    (void)state;
    struct stage stage = set_up(LEVELS, 2, COLOUR_EXPOSURES, 0, 1);
    struct camera *camera = camera_new(NULL);
    assert_non_null(camera);
    for (unsigned k = 0; k < RENDER_EXPOSURES; k++) {
        draw(&stage, all_levels, NULL, k);
        camera_take(camera, stage.chain->rgb, k);
        for (int x = 0; x < LEVELS; x++) {
            assert_int_equal(dot_at(&stage, 2 * x, 0)[0], x / (1 << k) % 2 * 255);
            assert_int_equal(dot_at(&stage, 2 * x, 0)[1], (255 - x) / (1 << k) % 2 * 255);
        }
    }
    camera_develop(camera);
    for (int y = 0; y < 4; y++) {
        for (int x = 0; x < 2 * LEVELS; x++) {
            const uint8_t expected[3] = {(uint8_t)(x / 2), (uint8_t)(255 - x / 2),
                                         (uint8_t)(x / 2 + 100 + y / 2)};
            assert_memory_equal(&camera->rgb[(y * PICTURE_WIDTH + x) * 3], expected, 3);
        }
    }
    camera_free(camera);
    take_down(&stage);
}

/* ---- Whole renders -------------------------------------------------------------------------- */

/* A stage with the camera before its screen. */
struct photographed {
    const struct stage *stage;
    struct camera *camera;
};

static void take_exposure(void *context, unsigned exposure) {
    const struct photographed *photographed = context;
    port_chain_picture(photographed->stage->chain);
    camera_take(photographed->camera, photographed->stage->chain->rgb, exposure);
}

/* Renders rows first .. last-1 of the stage's scene onto its board. */
static void render_rows(const struct stage *stage, unsigned first, unsigned last, unsigned jobs,
                        struct camera *camera) {
    struct photographed photographed = {stage, camera};
    struct render_job job = {.arithmetic = &arithmetic_fx,
                             .scene = stage->compiled,
                             .base = BOARD_FACTORY_BASE,
                             .first_row = first,
                             .last_row = last,
                             .jobs = jobs,
                             .exposed = camera != NULL ? take_exposure : NULL,
                             .exposed_context = &photographed};
    struct render_totals totals;
    struct scene_error error;
    assert_true(render(&job, &totals, &error));
    assert_int_equal(totals.rows, last - first);
}

static void dither_depends_on_neither_jobs_nor_order(void **state) {
    (void)state;
    struct stage whole = set_up(60, 37, COLOUR_DITHER, 0, 3);
    render_rows(&whole, 0, 37, 1, NULL);
    port_chain_picture(whole.chain);
    struct stage threads = set_up(60, 37, COLOUR_DITHER, 0, 3);
    render_rows(&threads, 0, 37, 2, NULL);
    port_chain_picture(threads.chain);
    assert_memory_equal(whole.chain->rgb, threads.chain->rgb, PICTURE_BYTES);
    struct stage halves = set_up(60, 37, COLOUR_DITHER, 0, 3);
    render_rows(&halves, 19, 37, 1, NULL);
    render_rows(&halves, 0, 19, 2, NULL);
    port_chain_picture(halves.chain);
    assert_memory_equal(whole.chain->rgb, halves.chain->rgb, PICTURE_BYTES);
    take_down(&halves);
    take_down(&threads);
    take_down(&whole);
}

static void a_multiple_exposure_is_the_full_picture(void **state) {
    (void)state;
    struct stage full = set_up(60, 37, COLOUR_FULL, 0, 1);
    render_rows(&full, 0, 37, 1, NULL);
    port_chain_picture(full.chain);
    for (unsigned jobs = 1; jobs <= 2; jobs++) {
        struct stage stage = set_up(60, 37, COLOUR_EXPOSURES, 0, 1);
        struct camera *camera = camera_new(NULL);
        assert_non_null(camera);
        render_rows(&stage, 5, 37, jobs, camera);
        camera_develop(camera);
        /* Rows that were not drawn are dark. */
        const size_t start = 10 * PICTURE_WIDTH * 3;
        for (size_t i = 0; i < start; i++) {
            assert_int_equal(camera->rgb[i], 0);
        }
        assert_memory_equal(camera->rgb + start, full.chain->rgb + start, PICTURE_BYTES - start);
        camera_free(camera);
        take_down(&stage);
    }
    take_down(&full);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(bits_are_cut_exactly),
        cmocka_unit_test(full_is_all_of_it),
        cmocka_unit_test(five_levels_have_the_right_shares),
        cmocka_unit_test(black_and_white_have_no_speckles),
        cmocka_unit_test(dots_have_nothing_to_do_with_each_other),
        cmocka_unit_test(a_dither_needs_four_dots_a_pixel),
        cmocka_unit_test(exposures_show_one_bit_each_and_add_up),
        cmocka_unit_test(dither_depends_on_neither_jobs_nor_order),
        cmocka_unit_test(a_multiple_exposure_is_the_full_picture),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
