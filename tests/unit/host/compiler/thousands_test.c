/* SPDX-License-Identifier: MIT */
/* Scenes of thousands of solids: the tables are those that a look at every pair gives. */
#include "base/grow.h"
#include "compiler/neighbours.h"
#include "scene_fixture.h"
#include "splitmix64.h"

enum { BOUNDS = 400, QUERIES = 200, SEEDS = 6, SOLIDS = 150, GRID = 64 };

/* Two coordinates this near are one to the compiler, which works in scaled units. */
#define ONE 0x1p-38

static double between(uint64_t *seed, double low, double high) {
    return low + (high - low) * (double)(splitmix64(seed) >> 11) * 0x1p-53;
}

static struct bounds random_bounds(uint64_t *seed) {
    struct bounds bounds;
    for (int i = 0; i < 3; i++) {
        double size = ldexp(between(seed, 0, 1), (int)between(seed, -20, 7));
        bounds.low[i] = between(seed, -60, 60);
        bounds.high[i] = bounds.low[i] + (splitmix64(seed) % 8 == 0 ? 0 : size);
        if (splitmix64(seed) % 32 == 0) {
            *(splitmix64(seed) % 2 == 0 ? &bounds.low[i] : &bounds.high[i]) =
                splitmix64(seed) % 2 == 0 ? -HUGE_VAL : HUGE_VAL;
        }
        if (bounds.low[i] > bounds.high[i]) {
            bounds.low[i] = -HUGE_VAL;
            bounds.high[i] = HUGE_VAL;
        }
    }
    return bounds;
}

static void neighbours_are_those_that_a_look_at_all_finds(void **state) {
    (void)state;
    static const double gaps[] = {0, 1e-3, 20};
    uint64_t seed = 1;
    struct bounds all[BOUNDS];
    struct neighbours neighbours = {.count = 0};
    struct compiled_set found = {NULL, 0};
    unsigned sum = 0;
    for (uint32_t i = 0; i < BOUNDS; i++) {
        all[i] = random_bounds(&seed);
        assert_true(neighbours_add(&neighbours, &all[i], i));
    }
    for (int i = 0; i < QUERIES; i++) {
        const struct bounds asked = random_bounds(&seed);
        const double gap = gaps[i % 3];
        assert_true(neighbours_find(&neighbours, &asked, gap, &found));
        for (uint32_t j = 0; j < BOUNDS; j++) {
            const bool is_found = compiled_set_has(&found, j);
            assert_true(is_found || bounds_are_apart(&all[j], &asked, gap));
            assert_false(is_found && bounds_are_apart(&all[j], &asked, gap + 1e-6));
            sum += is_found;
        }
    }
    assert_in_range(sum, QUERIES, QUERIES * BOUNDS / 2);
    neighbours_clear(&neighbours);
    compiled_set_clear(&found);
}

/* ---- Every pair ----------------------------------------------------------------------------- */

/* Begins a scene's text in a static buffer of that size. */
enum { TEXT_MOST = 1 << 20 };
static char text[TEXT_MOST];
static size_t used;

static void begin_text(void) {
    used = (size_t)snprintf(text, TEXT_MOST,
                            "version = 1; size = [32, 20];\n"
                            "camera = { eye = (20, -70, 60); look_at = (20, 20, 0); };\n"
                            "%sobjects = (\n",
                            SCENE_LIGHT_AND_MATERIALS);
}

static void add(bool is_first, const char *material, const char *solid) {
    used += (size_t)snprintf(text + used, TEXT_MOST - used, "%s{ material = \"%s\"; solid = %s; }",
                             is_first ? "" : ",\n", material, solid);
    assert_true(used < TEXT_MOST - 8);
}

static struct compiled_scene *compile_all(void) {
    (void)snprintf(text + used, TEXT_MOST - used, " );\n");
    return compile_text(text);
}

/* Makes a solid on a coarse lattice, where many have faces, axes and surfaces in common. */
static void random_solid(uint64_t *seed, char solid[256]) {
    const int x = (int)between(seed, 0, 24), y = (int)between(seed, 0, 24);
    const int size = 1 + (int)between(seed, 0, 3), turn = 30 * (int)between(seed, 0, 12);
    switch (splitmix64(seed) % 4) {
    case 0:
        (void)snprintf(solid, 256, "{ ball = { centre = (%d, %d, 0); radius = %d.5; }; }", x, y,
                       size);
        break;
    case 1:
        (void)snprintf(solid, 256,
                       "{ box = { min = (%d, %d, -1); max = (%d, %d, 1); }; rotate = (0, 0, %d); }",
                       x, y, x + size, y + size, turn);
        break;
    case 2:
        (void)snprintf(solid, 256,
                       "{ cylinder = { from = (%d, %d, -1); to = (%d, %d, %d); radius = 0.5; }; }",
                       x, y, x, y, size);
        break;
    default:
        (void)snprintf(solid, 256,
                       "{ ellipsoid = { centre = (%d, %d, 0); radii = (%d, 1, 2); }; rotate = (%d, "
                       "0, 0); }",
                       x, y, size, turn);
        break;
    }
}

/* Checks that faces have one surface just where they lie in one plane. */
static void check_faces(const struct compiled_scene *scene) {
    for (uint32_t i = 0; i < scene->primitive_count; i++) {
        struct compiled_face own[COMPILED_FACES_MOST], others[COMPILED_FACES_MOST];
        int count = compiled_faces(scene, i, own);
        for (uint32_t j = 0; j < i; j++) {
            int more = compiled_faces(scene, j, others);
            for (int k = 0; k < count * more; k++) {
                const struct compiled_face *a = &own[k / more], *b = &others[k % more];
                double sign = 0, lean = 0;
                for (int m = 0; m < 3; m++) {
                    sign += a->normal[m] * b->normal[m];
                }
                for (int m = 0; m < 3; m++) {
                    lean = fmax(lean, fabs(a->normal[m] - copysign(1, sign) * b->normal[m]));
                }
                const bool is_one =
                    lean * 512 <= ONE && fabs(a->offset - copysign(1, sign) * b->offset) <= ONE;
                assert_int_equal(a->surface == b->surface, is_one);
            }
        }
    }
}

/* Returns how far the innermost point of one ball's surface lies within another one. */
static double depth_in(const struct compiled_ball *inner, const struct compiled_ball *outer) {
    double square = 0;
    for (int i = 0; i < 3; i++) {
        square += pow(inner->centre[i] - outer->centre[i], 2);
    }
    return outer->radius - sqrt(square) - inner->radius;
}

/* Checks that no primitive without an enclosure is a ball that lies within another ball, and that
 * no ball between the two is smaller than a ball's enclosure. Returns how many enclosures there
 * are. */
static unsigned check_enclosures(const struct compiled_scene *scene) {
    unsigned enclosed = 0;
    for (uint32_t i = 0; i < scene->primitive_count; i++) {
        const struct compiled_primitive *entry = &scene->primitives[i];
        enclosed += entry->enclosure != COMPILED_ENCLOSURE_NONE;
        for (uint32_t j = 0; j < scene->primitive_count && entry->kind == PRIMITIVE_BALL; j++) {
            const struct compiled_primitive *other = &scene->primitives[j];
            if (i != j && other->kind == PRIMITIVE_BALL &&
                depth_in(&scene->balls[entry->index], &scene->balls[other->index]) > 1e-6) {
                assert_true(entry->enclosure < scene->primitive_count);
                const struct compiled_primitive *found = &scene->primitives[entry->enclosure];
                assert_true(entry->enclosure == j || found->kind != PRIMITIVE_BALL ||
                            depth_in(&scene->balls[other->index], &scene->balls[found->index]) <=
                                1e-6);
            }
        }
    }
    return enclosed;
}

/* Checks that no point is in more primitives than the nesting says; returns the most that one is
 * in. */
static unsigned check_nesting(const struct compiled_scene *scene, uint64_t *seed) {
    unsigned most = 0;
    for (int i = 0; i < 2000; i++) {
        const struct bounds *bounds =
            &scene->objects[1 + splitmix64(seed) % (scene->object_count - 1)].bounds;
        const double point[3] = {between(seed, bounds->low[0], bounds->high[0]),
                                 between(seed, bounds->low[1], bounds->high[1]),
                                 between(seed, bounds->low[2], bounds->high[2])};
        unsigned in = 0;
        for (uint32_t j = 0; j < scene->primitive_count; j++) {
            in += compiled_primitive_holds(scene, j, point);
        }
        assert_true(in <= scene->nesting);
        most = in > most ? in : most;
    }
    return most;
}

static void tables_are_those_that_a_look_at_every_pair_gives(void **state) {
    (void)state;
    unsigned enclosed = 0;
    for (uint64_t i = 1; i <= SEEDS; i++) {
        uint64_t seed = i;
        char solid[256];
        begin_text();
        for (int j = 0; j < SOLIDS; j++) {
            random_solid(&seed, solid);
            add(j == 0, "clay", solid);
        }
        struct compiled_scene *scene = compile_all();
        assert_in_range(scene->primitive_count, COMPILED_BITS_MOST + 1, SOLIDS);
        check_faces(scene);
        enclosed += check_enclosures(scene);
        assert_true(check_nesting(scene, &seed) > 0);
        compiled_scene_free(scene);
    }
    assert_true(enclosed > SEEDS);
}

/* ---- Thousands ------------------------------------------------------------------------------ */

static void write_ball(char solid[96], int number) {
    (void)snprintf(solid, 96, "{ ball = { centre = (%d, %d, 0); radius = 0.4; }; }", number % GRID,
                   number / GRID);
}

static void four_thousand_solids_are_compiled(void **state) {
    (void)state;
    char solid[96];
    begin_text();
    add(true, "board", "{ box = { min = (-2, -2, -2); max = (66, 66, -1); }; }");
    for (int i = 0; i < GRID * GRID; i++) {
        write_ball(solid, i);
        add(false, i % 2 == 0 ? "glass" : "clay", solid);
    }
    struct compiled_scene *scene = compile_all();
    assert_int_equal(scene->primitive_count, GRID * GRID + 1);
    assert_int_equal(scene->object_count, GRID * GRID + 2); /* the air is one */
    assert_int_equal(scene->surface_count, GRID * GRID + 6);
    assert_int_equal(scene->nesting, 1);
    assert_int_equal(scene->near_count, 0);
    compiled_scene_free(scene);
}

static void a_union_of_thousands_holds_what_its_solids_hold(void **state) {
    (void)state;
    char solid[96];
    begin_text();
    used += (size_t)snprintf(text + used, TEXT_MOST - used,
                             "{ material = \"clay\"; solid = { union = (\n");
    for (int i = 0; i < GRID * GRID; i++) {
        write_ball(solid, i);
        used += (size_t)snprintf(text + used, TEXT_MOST - used, "%s%s", i > 0 ? ",\n" : "", solid);
    }
    used += (size_t)snprintf(text + used, TEXT_MOST - used, " ); }; }");
    struct compiled_scene *scene = compile_all();
    assert_int_equal(scene->object_count, 2);
    assert_int_equal(scene->objects[1].length, 2 * GRID * GRID - 1);
    for (int i = 0; i < GRID * GRID; i += 97) {
        double point[3] = {i % GRID, i / GRID, 0}; /* NOLINT(bugprone-integer-division) */
        for (int j = 0; j < 2; j++) {
            double scaled[3];
            point[0] += 0.5 * j;
            for (int k = 0; k < 3; k++) {
                scaled[k] = ldexp(point[k] - scene->centre[k], scene->exponent);
            }
            assert_int_equal(compiled_object_holds(scene, 1, scaled), j == 0);
        }
    }
    compiled_scene_free(scene);
}

static void shells_nest_as_deep_as_there_are(void **state) {
    (void)state;
    char solid[96];
    begin_text();
    for (int i = 0; i < 60; i++) {
        (void)snprintf(solid, sizeof solid, "{ ball = { radius = %g; }; }", 20 - 0.3 * i);
        add(i == 0, "glass", solid);
    }
    struct compiled_scene *scene = compile_all();
    assert_int_equal(scene->nesting, 60);
    for (uint32_t i = 0; i < scene->primitive_count; i++) {
        assert_int_equal(scene->primitives[i].enclosure, i > 0 ? i - 1 : COMPILED_ENCLOSURE_NONE);
    }
    compiled_scene_free(scene);
}

/* ---- Tables that grow ----------------------------------------------------------------------- */

static void a_table_grows_by_entries_of_zeros_and_no_further_than_numbers_go(void **state) {
    (void)state;
    uint32_t *table = NULL;
    for (size_t i = 0; i < 1000; i++) {
        assert_true(GROW(table, i));
        assert_int_equal(table[i], 0);
        table[i] = (uint32_t)i + 1;
        assert_int_equal(table[i / 2], i / 2 + 1);
    }
    assert_true(GROW(table, 10)); /* after others have gone */
    assert_int_equal(table[10], 0);
    assert_int_equal(table[9], 10);
    uint32_t *before = table;
    assert_false(GROW(table, (size_t)1 << 31));
    assert_ptr_equal(table, before);
    free(table);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(neighbours_are_those_that_a_look_at_all_finds),
        cmocka_unit_test(tables_are_those_that_a_look_at_every_pair_gives),
        cmocka_unit_test(four_thousand_solids_are_compiled),
        cmocka_unit_test(a_union_of_thousands_holds_what_its_solids_hold),
        cmocka_unit_test(shells_nest_as_deep_as_there_are),
        cmocka_unit_test(a_table_grows_by_entries_of_zeros_and_no_further_than_numbers_go),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
