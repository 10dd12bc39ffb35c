/* SPDX-License-Identifier: MIT */
/* What a render counts is exact beyond 32 bits: in a row, in a band of rows, and in their sums. */
#include "scene_fixture.h"

#include "board.h"
#include "null_bus.h"
#include "render/engine.h"
#include "render/render.h"

enum { WIDTH = 24, HEIGHT = 9 };

/* The counts that are sums, by name. */
enum { SUMS = 5 };
static const char *const names[SUMS] = {"rays", "shadow rays", "nodes", "solid tests",
                                        "leaked rays"};

static void sums_of(const struct render_counts *counts, uint64_t sums[SUMS]) {
    const uint64_t found[SUMS] = {counts->rays, counts->shadow_rays, counts->nodes,
                                  counts->solid_tests, counts->leaked_rays};
    memcpy(sums, found, sizeof found);
}

static struct render_counts counts_of(uint64_t each) {
    const struct render_counts counts = {
        .rays = each, .shadow_rays = each, .nodes = each, .solid_tests = each, .leaked_rays = each};
    return counts;
}

/* Counts so much already when the work begins: a few steps below 2^32, and far beyond. */
static const uint64_t befores[] = {UINT32_MAX - UINT64_C(5), UINT64_C(7) << 40};
enum { BEFORES = sizeof befores / sizeof befores[0] };

/* Fails unless `counts` are those that began at `before`, of the same work as `plain`. */
static void check_counts(const char *what, const struct render_counts *plain,
                         const struct render_counts *counts, uint64_t before) {
    uint64_t expected[SUMS], found[SUMS];
    sums_of(plain, expected);
    sums_of(counts, found);
    for (int i = 0; i < SUMS; i++) {
        if (found[i] != before + expected[i]) {
            fail_msg("%s, %s: %llu and %llu are not %llu", what, names[i],
                     (unsigned long long)before, (unsigned long long)expected[i],
                     (unsigned long long)found[i]);
        }
    }
}

static struct loaded_scene load_small(const char *name, const char *arithmetic, double error) {
    struct scene_error refusal;
    struct scene_description *description = load_scene(name, &refusal);
    assert_non_null(description);
    description->width = WIDTH;
    description->height = HEIGHT;
    description->depth = 6;
    description->estimates = true;
    description->error = error;
    struct loaded_scene loaded = load_description(description, arithmetic);
    scene_description_free(description);
    return loaded;
}

/* One kind of work that counts. */
typedef void work(const struct loaded_scene *loaded, struct render_counts *counts);

static void do_learn(const struct loaded_scene *loaded, struct render_counts *counts) {
    struct estimate estimate;
    loaded->arithmetic->learn(loaded->scene, &estimate, counts);
}

static void do_rows(const struct loaded_scene *loaded, struct render_counts *counts) {
    uint8_t rgb[3 * WIDTH];
    for (uint16_t y = 0; y < HEIGHT; y++) {
        loaded->arithmetic->image->row(loaded->scene, y, rgb, counts);
    }
}

static void do_pixel(const struct loaded_scene *loaded, struct render_counts *counts) {
    double intensity[3];
    loaded->arithmetic->pixel(loaded->scene, WIDTH / 2, HEIGHT / 2, intensity, counts, NULL);
}

/* Renders a band by every engine that takes the scene. */
static void do_band(const struct loaded_scene *loaded, struct render_counts *counts) {
    static uint8_t rgb[STREAM_ROWS_MOST * 3 * WIDTH];
    const struct stream_engine *engine;
    const char *name = loaded->arithmetic->image->name;
    for (unsigned i = 0; (engine = stream_engine_get(name, i)) != NULL; i++) {
        void *memory;
        assert_int_equal(posix_memalign(&memory, STREAM_ALIGNMENT, engine->memory_bytes), 0);
        memset(memory, 0, engine->memory_bytes);
        if (engine->fits(loaded->scene)) {
            assert_true(engine->rows(memory, loaded->scene, 0, STREAM_ROWS_MOST, rgb, counts));
        }
        free(memory);
    }
}

static void what_is_counted_goes_on_beyond_32_bits(void **state) {
    static const char *const scenes[] = {"fig4b", "figA"}; /* with shadows */
    static const char *const arithmetics[] = {"fx", "f32", "f64"};
    static work *const works[] = {do_learn, do_rows, do_pixel, do_band};
    static const char *const texts[] = {"learn", "rows", "pixel", "band"};
    uint64_t all[SUMS] = {0};
    (void)state;
    for (int i = 0; i < 2 * 3 * 2 * 4; i++) {
        int j = i / 4 % 3, k = i % 4;
        struct loaded_scene loaded = load_small(scenes[i / 24], arithmetics[j], i / 12 % 2 * 8);
        struct render_counts ignored = {0}, plain = {0};
        uint64_t sums[SUMS];
        do_learn(&loaded, &ignored);
        works[k](&loaded, &plain);
        sums_of(&plain, sums);
        for (int l = 0; l < SUMS; l++) {
            all[l] += sums[l];
        }
        for (int l = 0; l < BEFORES; l++) {
            struct render_counts counts = counts_of(befores[l]);
            works[k](&loaded, &counts);
            check_counts(texts[k], &plain, &counts, befores[l]);
        }
        unload(&loaded);
    }
    for (int l = 0; l < SUMS - 1; l++) { /* no ray leaks */
        assert_true(all[l] > 1000);
    }
}

/* A row of an image that takes more than 32 bits hold, as 640 pixels of a million rays each do. */
static const uint64_t heavy = UINT64_C(82000000003);

static void heavy_row(const struct scene *scene, uint16_t y, uint8_t *rgb,
                      struct render_counts *counts) {
    (void)scene;
    memset(rgb, y, 3 * WIDTH);
    counts->rays += heavy;
    counts->shadow_rays += heavy;
    counts->nodes += heavy;
    counts->solid_tests += heavy;
    counts->leaked_rays += heavy;
}

static void a_render_adds_up_rows_beyond_32_bits(void **state) {
    (void)state;
    static const unsigned jobs[] = {1, 2, 5};
    struct loaded_scene loaded = load_small("fig3", "fx", 0);
    loaded.compiled->estimates = false;
    const struct image image = {"heavy", arithmetic_fx.image->learn, heavy_row,
                                arithmetic_fx.image->draw};
    const struct arithmetic arithmetic = {&image,
                                          "heavy",
                                          arithmetic_fx.noise,
                                          arithmetic_fx.has_room,
                                          arithmetic_fx.load,
                                          arithmetic_fx.learn,
                                          arithmetic_fx.pixel};
    for (int i = 0; i < 3; i++) {
        struct bus bus;
        struct render_totals totals;
        struct scene_error error;
        const struct render_job job = {.arithmetic = &arithmetic,
                                       .scene = loaded.compiled,
                                       .base = BOARD_FACTORY_BASE,
                                       .last_row = HEIGHT,
                                       .jobs = jobs[i]};
        null_bus_init(&bus);
        (void)bus_bind(&bus);
        assert_true(render(&job, &totals, &error));
        const struct render_counts counts = {.rays = totals.rays,
                                             .shadow_rays = totals.shadow_rays,
                                             .nodes = totals.nodes,
                                             .solid_tests = totals.solid_tests,
                                             .leaked_rays = totals.leaked_rays};
        const struct render_counts nothing = {0};
        check_counts("render", &nothing, &counts, HEIGHT * heavy);
    }
    unload(&loaded);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_counted_goes_on_beyond_32_bits),
        cmocka_unit_test(a_render_adds_up_rows_beyond_32_bits),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
