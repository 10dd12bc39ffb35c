/* SPDX-License-Identifier: MIT */
/* Streams of rays give the image's own rows, bit for bit and count for count. */
#include "scene_fixture.h"

#include <math.h>

#include "render/engine.h"
#include "scene/builtin.h"

enum { WIDTH_MOST = 128 };

struct rows {
    uint8_t rgb[STREAM_ROWS_MOST * 3 * WIDTH_MOST];
    struct render_counts counts;
};

static struct rows expected, found;

static void same_counts(const char *what, const struct render_counts *a,
                        const struct render_counts *b) {
    if (a->rays != b->rays || a->shadow_rays != b->shadow_rays || a->nodes != b->nodes ||
        a->solid_tests != b->solid_tests || a->leaked_rays != b->leaked_rays) {
        fail_msg("%s: %u rays, %u shadow rays, %u nodes, %u tests, expected %u, %u, %u, %u", what,
                 (unsigned)a->rays, (unsigned)a->shadow_rays, (unsigned)a->nodes,
                 (unsigned)a->solid_tests, (unsigned)b->rays, (unsigned)b->shadow_rays,
                 (unsigned)b->nodes, (unsigned)b->solid_tests);
    }
    assert_true(a->unreached_pixels == b->unreached_pixels);
    assert_true(a->estimated_error == b->estimated_error && a->proved_error == b->proved_error);
    assert_true(a->worst_x == b->worst_x && a->worst_y == b->worst_y);
}

/* All rows of a loaded scene by one engine against the image's: how many bands it gave back. */
static unsigned compare_rows(const char *name, const struct loaded_scene *loaded,
                             const struct stream_engine *engine, unsigned width, unsigned height) {
    char what[128];
    unsigned given_back = 0;
    void *memory;
    assert_int_equal(posix_memalign(&memory, STREAM_ALIGNMENT, engine->memory_bytes), 0);
    memset(memory, 0, engine->memory_bytes);
    for (unsigned first = 0; first < height; first += STREAM_ROWS_MOST) {
        unsigned rows = height - first < STREAM_ROWS_MOST ? height - first : STREAM_ROWS_MOST;
        memset(&expected, 0, sizeof expected);
        memset(&found, 0, sizeof found);
        (void)snprintf(what, sizeof what, "%s by %s, rows from %u", name, engine->set, first);
        if (!engine->rows(memory, loaded->scene, (uint16_t)first, (uint16_t)rows, found.rgb,
                          &found.counts)) {
            assert_int_equal(found.counts.rays, 0);
            given_back++;
            continue;
        }
        for (unsigned y = 0; y < rows; y++) {
            loaded->arithmetic->image->row(loaded->scene, (uint16_t)(first + y),
                                           expected.rgb + (size_t)y * 3 * width, &expected.counts);
        }
        for (size_t i = 0; i < (size_t)rows * 3 * width; i++) {
            if (found.rgb[i] != expected.rgb[i]) {
                fail_msg("%s: byte %u is %u, expected %u", what, (unsigned)i, found.rgb[i],
                         expected.rgb[i]);
            }
        }
        same_counts(what, &found.counts, &expected.counts);
    }
    free(memory);
    return given_back;
}

struct settings {
    int width, height, depth;
    double threshold;
    bool estimates;
    bool lists;   /* also with sets as lists */
    double error; /* 0: no accuracy is asked for */
};

/* Loads a scene anew, with sets as lists. */
static void take_lists(struct loaded_scene *loaded) {
    struct scene_error error;
    if (arithmetic_with_lists(loaded->arithmetic) != NULL) {
        free(loaded->scene);
        loaded->arithmetic = arithmetic_with_lists(loaded->arithmetic);
        loaded->scene = loaded->arithmetic->load(loaded->compiled, &error);
        assert_non_null(loaded->scene);
    }
}

/* By every engine, in both forms of sets. */
static void check_description(const char *name, struct scene_description *description,
                              const struct settings *settings, unsigned *fitting) {
    static const char *const arithmetics[] = {"f32", "f64", "fx"};
    description->width = settings->width;
    description->height = settings->height;
    description->depth = settings->depth;
    description->threshold = settings->threshold;
    description->estimates = settings->estimates;
    description->error = settings->error;
    for (size_t i = 0; i < (settings->lists ? 6 : 3); i++) {
        struct loaded_scene loaded = load_description(description, arithmetics[i % 3]);
        struct estimate estimate;
        struct render_counts ignored = {0};
        const struct stream_engine *engine;
        if (i >= 3) {
            take_lists(&loaded);
        }
        loaded.arithmetic->learn(loaded.scene, &estimate, &ignored);
        for (unsigned j = 0; (engine = stream_engine_get(loaded.arithmetic->name, j)) != NULL;
             j++) {
            if (engine->fits(loaded.scene)) {
                assert_int_equal(compare_rows(name, &loaded, engine, (unsigned)settings->width,
                                              (unsigned)settings->height),
                                 0);
                (*fitting)++;
            }
        }
        unload(&loaded);
    }
}

static void every_built_in_scene_comes_out_alike(void **state) {
    (void)state;
    static const struct settings table[] = {{47, 21, 10, 1.0 / 4096, false, true, 0},
                                            {7, 3, 1, 1.0 / 256, false, true, 0},
                                            {40, 25, 20, 1.0 / 8192, true, false, 0},
                                            {1, 1, 64, 1.0 / 4096, true, true, 0},
                                            {64, 9, 5, 0, false, false, 0},
                                            {33, 9, 0, 1.0 / 4096, true, true, 0},
                                            {19, 9, 24, 0, true, false, 4},
                                            {21, 5, 6, 0, true, true, 1},
                                            {5, 3, 255, 0, true, false, 8}};
    unsigned fitting = 0;
    for (size_t i = 0; i < builtin_scene_count; i++) {
        for (size_t j = 0; j < sizeof table / sizeof table[0]; j++) {
            struct scene_error error;
            struct scene_description *description = load_scene(builtin_scenes[i].name, &error);
            assert_non_null(description);
            check_description(builtin_scenes[i].name, description, &table[j], &fitting);
            scene_description_free(description);
        }
    }
    assert_true(fitting >= 2 * 3 * sizeof table / sizeof table[0]);
}

/* One solid whose faces lie on a coarse grid, so that many of them coincide; some are turned. */
static int write_solid(char *text, size_t room, uint64_t *random) {
    double x = next_random(random) % 5, y = next_random(random) % 5, z = next_random(random) % 4;
    double size = 1 + next_random(random) % 3;
    switch (next_random(random) % 9) {
    case 0:
        return snprintf(text, room, "{ ball = { centre = (%g, %g, %g); radius = %g; }; }", x, y, z,
                        size / 2);
    case 1:
        return snprintf(text, room,
                        "{ ellipsoid = { centre = (%g, %g, %g); radii = (%g, 1.0, 0.5); }; }", x, y,
                        z, size);
    case 2:
        return snprintf(
            text, room,
            "{ intersection = ({ ellipsoid = { centre = (%g, %g, %g); radii = (1.0, %g, 1.5); }; },"
            " { half_space = { normal = [0, 0, 1]; offset = %g; }; }); }",
            x, y, z, size, z);
    case 3:
        return snprintf(text, room,
                        "{ box = { min = (%g, %g, %g); max = (%g, %g, %g); }; rotate = [0, %g, 30];"
                        " }",
                        x, y, z, x + size, y + 1, z + 1, 10 * size);
    case 4:
        return snprintf(text, room,
                        "{ cone = { from = (%g, %g, %g); to = (%g, %g, %g); from_radius = %g;"
                        " to_radius = 0.25; }; }",
                        x, y, z, x, y + 1, z + size, size);
    case 5:
        return snprintf(text, room,
                        "{ hyperboloid = { from = (%g, %g, %g); to = (%g, %g, %g); radius = 1.0;"
                        " %s = 0.5; }; }",
                        x, y, z, x, y, z + size, size > 2 ? "waist" : "gap");
    case 6:
        return snprintf(text, room,
                        "{ cylinder = { from = (%g, %g, %g); to = (%g, %g, %g); radius = 0.5; }; }",
                        x, y, z, x + size, y, z);
    default:
        return snprintf(text, room, "{ box = { min = (%g, %g, %g); max = (%g, %g, %g); }; }", x, y,
                        z, x + size, y + size, z + 1);
    }
}

static void write_scene(char *text, size_t room, const char *absorption, uint64_t *random) {
    static const char *const materials[] = {"glass", "water", "chalk"};
    static const char *const operations[] = {"difference", "union", "intersection"};
    char first[400], second[400];
    int at = snprintf(text, room,
                      "version = 1; size = [37, 23]; depth = 9; background = [10, 20, 30];"
                      "camera = { eye = (9.0, -8.0, 7.0); look_at = (2.5, 2.5, 1.5);"
                      " field_of_view = 45; };"
                      "lights = ({ direction = (-0.4, 0.5, -1.0); colour = [255, 250, 240]; },"
                      " { position = (6.0, -5.0, 9.0); colour = [90, 90, 120]; });"
                      "materials = {"
                      " glass = { colour = [20, 30, 10]; ambient = 0.2; diffuse = 0.3;"
                      "  specular = 0.4; gloss = 37; ior = 1.5; };"
                      " water = { colour = [0, 10, 40]; ambient = 0.1; diffuse = 0.2; ior = 1.33;"
                      "  absorption = %s; };"
                      " chalk = { colour = [210, 190, 170]; ambient = 0.3; diffuse = 0.6;"
                      "  specular = 0.2; gloss = 5;"
                      "  pattern = { size = (0.5, 0, 0.7); colour = [60, 20, 20]; }; }; };"
                      "objects = (",
                      absorption);
    for (int i = 0; i < 5; i++) {
        (void)write_solid(first, sizeof first, random);
        (void)write_solid(second, sizeof second, random);
        at += snprintf(text + at, room - (size_t)at,
                       "%s{ name = \"%d\"; material = \"%s\"; solid = { %s = (%s, %s); }; }",
                       i == 0 ? "" : ", ", i, materials[next_random(random) % 3],
                       operations[next_random(random) % 3], first, second);
    }
    (void)snprintf(text + at, room - (size_t)at, ");");
}

static void random_scenes_with_coincident_faces_come_out_alike(void **state) {
    (void)state;
    static char text[8192];
    uint64_t random = 20261122;
    unsigned fitting = 0;
    for (int i = 0; i < 24; i++) {
        const struct settings settings = {
            37, 23, 9, 1.0 / 4096, i % 2 == 1, i % 4 == 0, i % 4 == 3 ? 1 : 0};
        write_scene(text, sizeof text, i % 3 == 0 ? "0.3" : "[0.2, 0.1, 0.05]", &random);
        struct scene_description *description = read_text(text);
        check_description("a random scene", description, &settings, &fitting);
        scene_description_free(description);
    }
    assert_true(fitting >= (24 + 6) * 3);
}

/* A wall that mirrors a light, seen so narrowly that all of it is the highlight: of a cosine raised
 * to 65535 as many last bits are wrong as steps were rounded in another way. */
static void highlights_of_any_gloss_come_out_alike(void **state) {
    (void)state;
    static const unsigned glosses[] = {0, 1, 37, 5000, 40961, 65534, 65535};
    static const struct settings settings = {101, 63, 0, 1.0 / 4096, false, true, 0};
    char text[2048];
    unsigned fitting = 0;
    for (size_t i = 0; i < 2 * sizeof glosses / sizeof glosses[0]; i++) {
        unsigned gloss = glosses[i / 2];
        (void)snprintf(text, sizeof text,
                       "version = 1; size = [101, 63]; highlight = \"%s\";"
                       "camera = { eye = (0, -9, 0); look_at = (0, 0, 0); up = (0, 0, 1);"
                       " field_of_view = %d; };"
                       "lights = ( { direction = (0.002, 1, 0.001); colour = [250, 240, 255]; } );"
                       "materials = { chrome = { colour = [0, 0, 0]; diffuse = 0; specular = 1;"
                       " gloss = %u; }; };"
                       "objects = ( { material = \"chrome\"; solid = { box = {"
                       " min = (-4, 1, -4); max = (4, 2, 0.02); }; }; } );",
                       i % 2 == 0 ? "phong" : "blinn", gloss > 5000 ? 2 : 30, gloss);
        struct scene_description *description = read_text(text);
        check_description("a highlight", description, &settings, &fitting);
        scene_description_free(description);
    }
    assert_true(fitting >= 2 * 3 * sizeof glosses / sizeof glosses[0]);
}

/* Whoever sees past all solids into a light: half-way between the two there is nothing. */
static void a_look_into_a_light_comes_out_alike(void **state) {
    (void)state;
    static const struct settings settings = {41, 31, 3, 1.0 / 4096, false, false, 0};
    struct scene_description *description =
        read_text("version = 1; size = [41, 31]; highlight = \"blinn\";"
                  "camera = { eye = (0, -9, 0); look_at = (0, 0, 0); up = (0, 0, 1); };"
                  "lights = ( { direction = (0, -1, 0); } );"
                  "materials = { chrome = { colour = [90, 90, 90]; diffuse = 0.5; specular = 0.5;"
                  " gloss = 20; }; };"
                  "objects = ( { material = \"chrome\"; solid = { ball = {"
                  " centre = (-2, 0, 0); radius = 1.7; }; }; } );");
    unsigned fitting = 0;
    check_description("a light ahead", description, &settings, &fitting);
    scene_description_free(description);
    assert_true(fitting >= 2 * 3);
}

/* Solids that come last in a scene, and how many surfaces each has; the last of those may be a cap.
 */
static const struct last_solid {
    const char *solid;
    unsigned surfaces;
} last_solids[] = {
    {"{ ball = { centre = (-5, 0, 0); radius = 1; }; }", 1},
    {"{ box = { min = (-6.37, 0.13, 0.31); max = (-5.11, 1.77, 0.83); }; }", 6},
    {"{ ellipsoid = { centre = (-5, 0, 0); radii = (1.0, 2.0, 1.5); }; }", 1},
    {"{ cylinder = { from = (-6, 0, 0); to = (-5, 0, 0.5); radius = 1; }; }", 3},
    {"{ cone = { from = (-6, 0, 0); to = (-5, 0, 0.5); from_radius = 1; }; }", 3},
    {"{ intersection = ( { ellipsoid = { centre = (-5, 0, 0); radii = (1.0, 2.0, 1.5); }; },"
     " { half_space = { normal = (0, 0, 1); offset = 0.25; }; } ); }",
     3}, /* the other end has a plane, too, beyond the solid */
    {"{ polyhedron = { planes = ( { normal = (-1, -2, -1); offset = 4; },"
     " { normal = (1, -3, -5); offset = 0; }, { normal = (1, 2, -7); offset = 0; },"
     " { normal = (0, 3, 8); offset = 3; } ); }; }",
     4},
};

/* Says whether an engine takes a scene of so many polyhedra, the first with so many faces and each
 * other with the most, and another solid. */
static bool fits_with_faces(unsigned count, unsigned first_faces, const char *last) {
    static char text[65536];
    int at = snprintf(text, sizeof text,
                      "version = 1; size = [8, 8]; depth = 2;"
                      "camera = { eye = (9, -8, 7); look_at = (0, 0, 0); field_of_view = 45; };"
                      "lights = ({ direction = (-0.4, 0.5, -1.0); colour = [255, 255, 255]; });"
                      "materials = { chalk = { colour = [210, 190, 170]; diffuse = 0.6; }; };"
                      "objects = (");
    for (unsigned i = 0; i < count; i++) {
        unsigned faces = i == 0 ? first_faces : 64;
        at += snprintf(
            text + at, sizeof text - (size_t)at,
            "{ name = \"%u\"; material = \"chalk\"; solid = { polyhedron = { planes = ("
            "{ normal = (0, 0, 1); offset = %u.5; }, { normal = (0, 0, -1); offset = -%u; }",
            i, i, i);
        for (unsigned k = 2; k < faces; k++) {
            double angle = 6.283185307179586 * k / (faces - 2);
            at += snprintf(text + at, sizeof text - (size_t)at,
                           ", { normal = (%.9f, %.9f, 0); offset = %u; }", cos(angle), sin(angle),
                           i + 1);
        }
        at += snprintf(text + at, sizeof text - (size_t)at, "); }; }; }, ");
    }
    (void)snprintf(text + at, sizeof text - (size_t)at,
                   "{ name = \"last\"; material = \"chalk\"; solid = %s; } );", last);
    struct scene_description *description = read_text(text);
    struct loaded_scene loaded = load_description(description, "f32");
    bool fits = stream_engine_get("f32", 0)->fits(loaded.scene);
    unload(&loaded);
    scene_description_free(description);
    return fits;
}

/* 255 surfaces have a place in an engine's table, and the last place is nobody's. */
static void more_surfaces_than_an_engine_has_places_for_are_left_to_the_image(void **state) {
    (void)state;
    for (size_t i = 0; i < sizeof last_solids / sizeof last_solids[0]; i++) {
        unsigned faces = 63 - last_solids[i].surfaces;
        assert_true(fits_with_faces(4, faces, last_solids[i].solid));
        assert_false(fits_with_faces(4, faces + 1, last_solids[i].solid));
    }
}

/* A built-in scene with one thing changed, in f32, as an engine sees it. */
static bool plainest_engine_fits(const char *name, void (*change)(struct scene_description *)) {
    struct scene_error error;
    struct scene_description *description = load_scene(name, &error);
    assert_non_null(description);
    change(description);
    struct loaded_scene loaded = load_description(description, "f32");
    bool fits = stream_engine_get("f32", 0)->fits(loaded.scene);
    unload(&loaded);
    scene_description_free(description);
    return fits;
}

static void keep(struct scene_description *description) {
    (void)description;
}

static void ask_for_accuracy(struct scene_description *description) {
    description->error = 1;
}

static void take_the_simple_model(struct scene_description *description) {
    description->model = MODEL_SIMPLE;
}

static void what_an_engine_does_not_know_is_left_to_the_image(void **state) {
    (void)state;
    assert_true(plainest_engine_fits("fig3", keep));
    assert_true(plainest_engine_fits("fig5", keep));
    assert_true(plainest_engine_fits("fig3", ask_for_accuracy));
    assert_false(plainest_engine_fits("fig3", take_the_simple_model));
}

/* What has no room, or no budget, is the image's work: nothing of it is counted. */
static void assert_given_back(int depth, double threshold, uint32_t budget) {
    struct scene_error error;
    struct scene_description *description = load_scene("fig3", &error);
    assert_non_null(description);
    description->width = 24;
    description->height = 16;
    description->depth = depth;
    description->threshold = threshold;
    struct compiled_scene *compiled = scene_compile(description, &error);
    assert_non_null(compiled);
    compiled->ray_budget = budget;
    struct loaded_scene loaded = {arithmetic_find("f64"), compiled, NULL};
    loaded.scene = loaded.arithmetic->load(compiled, &error);
    assert_non_null(loaded.scene);
    const struct stream_engine *engine;
    for (unsigned i = 0; (engine = stream_engine_get("f64", i)) != NULL; i++) {
        assert_true(compare_rows("fig3", &loaded, engine, 24, 16) > 0);
    }
    unload(&loaded);
    scene_description_free(description);
}

static void a_band_beyond_its_budget_is_given_back(void **state) {
    (void)state;
    assert_given_back(10, 1.0 / 4096, 5);
}

/* A glass bead that one pixel alone sees, of a picture that is empty else. */
static struct scene_description *describe_bead(unsigned x, unsigned y, unsigned width,
                                               unsigned height) {
    static const double field = 20, distance = 8;
    double pitch = 2 * distance * tan(field * 3.14159265358979323846 / 360) / width;
    char text[1024];
    (void)snprintf(text, sizeof text,
                   "version = 1; size = [%u, %u]; depth = 6; threshold = 0.001;"
                   "camera = { eye = (0, %.17g, 0); look_at = (0, 0, 0); field_of_view = %g; };"
                   "materials = { glass = { colour = [20, 30, 10]; ior = 1.5; }; };"
                   "objects = ( { material = \"glass\"; solid = { ball = {"
                   " centre = (%.17g, 0, %.17g); radius = %.17g; }; }; } );",
                   width, height, -distance, field, pitch * (x + 0.5 - width / 2.0),
                   -pitch * (y + 0.5 - height / 2.0), pitch * 0.3);
    return read_text(text);
}

/* Returns the rays of one pixel. */
static uint32_t rays_of_pixel(const struct loaded_scene *loaded, unsigned x, unsigned y) {
    struct render_counts counts = {0};
    double intensity[3];
    loaded->arithmetic->pixel(loaded->scene, (uint16_t)x, (uint16_t)y, intensity, &counts, NULL);
    return (uint32_t)counts.rays;
}

/* With a budget of what every other pixel takes, and of what the bead's one does. */
static void check_bead(unsigned pixel, const char *arithmetic) {
    enum { BEAD_WIDTH = 7, BEAD_HEIGHT = 5 };
    unsigned x = pixel % BEAD_WIDTH, y = pixel / BEAD_WIDTH;
    struct scene_description *description = describe_bead(x, y, BEAD_WIDTH, BEAD_HEIGHT);
    struct loaded_scene loaded = load_description(description, arithmetic);
    uint32_t most = rays_of_pixel(&loaded, x, y);
    const struct stream_engine *engine;
    assert_true(most > 2);
    for (unsigned i = 0; i < BEAD_WIDTH * BEAD_HEIGHT; i++) {
        assert_int_equal(rays_of_pixel(&loaded, i % BEAD_WIDTH, i / BEAD_WIDTH),
                         i == pixel ? most : 1);
    }
    for (uint32_t budget = most - 1; budget <= most; budget++) {
        struct scene_error error;
        free(loaded.scene);
        loaded.compiled->ray_budget = budget;
        loaded.scene = loaded.arithmetic->load(loaded.compiled, &error);
        assert_non_null(loaded.scene);
        for (unsigned i = 0; (engine = stream_engine_get(arithmetic, i)) != NULL; i++) {
            assert_int_equal(compare_rows("a bead", &loaded, engine, BEAD_WIDTH, BEAD_HEIGHT),
                             budget < most);
        }
    }
    unload(&loaded);
    scene_description_free(description);
}

static void one_pixel_beyond_its_budget_is_noticed_wherever_it_is(void **state) {
    (void)state;
    static const unsigned pixels[] = {0, 1, 6, 15, 16, 17, 33, 34};
    for (size_t i = 0; i < sizeof pixels / sizeof pixels[0]; i++) {
        check_bead(pixels[i], i % 2 == 0 ? "f64" : "fx");
    }
}

/* Without a threshold rays double from level to level, and without a budget nothing else ends it.
 */
static void a_band_with_more_rays_than_there_is_room_for_is_given_back(void **state) {
    (void)state;
    assert_given_back(255, 0, UINT32_MAX);
}

static void the_best_engine_is_the_last_that_runs_here(void **state) {
    (void)state;
    static const char *const arithmetics[] = {"fx", "f32", "f64"};
    for (size_t i = 0; i < 3; i++) {
        const struct stream_engine *last = NULL, *next;
        for (unsigned j = 0; (next = stream_engine_get(arithmetics[i], j)) != NULL; j++) {
            last = next;
        }
        assert_non_null(last);
        assert_ptr_equal(stream_engine_find(arithmetics[i]), last);
    }
    assert_null(stream_engine_find("f128"));
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_built_in_scene_comes_out_alike),
        cmocka_unit_test(random_scenes_with_coincident_faces_come_out_alike),
        cmocka_unit_test(highlights_of_any_gloss_come_out_alike),
        cmocka_unit_test(a_look_into_a_light_comes_out_alike),
        cmocka_unit_test(what_an_engine_does_not_know_is_left_to_the_image),
        cmocka_unit_test(more_surfaces_than_an_engine_has_places_for_are_left_to_the_image),
        cmocka_unit_test(a_band_beyond_its_budget_is_given_back),
        cmocka_unit_test(one_pixel_beyond_its_budget_is_noticed_wherever_it_is),
        cmocka_unit_test(a_band_with_more_rays_than_there_is_room_for_is_given_back),
        cmocka_unit_test(the_best_engine_is_the_last_that_runs_here),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
