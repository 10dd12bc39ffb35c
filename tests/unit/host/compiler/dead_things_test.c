/* SPDX-License-Identifier: MIT */
/* Dead things change nothing: neither when they are added to a scene, nor when they are left out.
 */
#include "scene_fixture.h"

#include "compiler/emit.h"
#include "compiler/features.h"

enum { TEXT_SIZE = 8192, TABLES_SIZE = 65536, WIDTH = 24, HEIGHT = 15, SEEDS = 24 };

static const char *const arithmetics[] = {"fx", "f32", "f64"};
enum { ARITHMETICS = 3 };

/* ---- Pictures and tables -------------------------------------------------------------------- */

struct picture {
    double level[WIDTH * HEIGHT][3];
    struct render_counts counts;
};

static void render(const char *text, const char *arithmetic, struct picture *picture) {
    struct loaded_scene loaded = load_text(text, arithmetic);
    memset(picture, 0, sizeof *picture);
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        loaded.arithmetic->pixel(loaded.scene, (uint16_t)(i % WIDTH), (uint16_t)(i / WIDTH),
                                 picture->level[i], &picture->counts, NULL);
    }
    unload(&loaded);
}

/* Fails unless two scenes give one picture, the first of them by no more work. */
static void assert_same_picture(const char *less, const char *more, const char *what) {
    for (int i = 0; i < ARITHMETICS; i++) {
        struct picture a, b;
        render(less, arithmetics[i], &a);
        render(more, arithmetics[i], &b);
        bool is_more_work = a.counts.rays > b.counts.rays || a.counts.nodes > b.counts.nodes ||
                            a.counts.shadow_rays > b.counts.shadow_rays ||
                            a.counts.solid_tests > b.counts.solid_tests;
        if (memcmp(a.level, b.level, sizeof a.level) != 0 || is_more_work) {
            fail_msg("%s, %s: %s of\n%s\nthan of\n%s", what, arithmetics[i],
                     is_more_work ? "more work" : "another picture", less, more);
        }
    }
}

/* Writes all that an image of the firmware gets: the tables, and the features that they require. */
static void write_tables(const char *text, char tables[TABLES_SIZE]) {
    struct loaded_scene loaded = load_text(text, "f64");
    FILE *file = tmpfile();
    assert_non_null(file);
    assert_int_equal(scene_emit(file, loaded.compiled, "test"), 0);
    assert_int_equal(features_emit(file, loaded.compiled, "test"), 0);
    rewind(file);
    tables[fread(tables, 1, TABLES_SIZE - 1, file)] = '\0';
    (void)fclose(file);
    unload(&loaded);
}

/* ---- Dead things added ---------------------------------------------------------------------- */

/* A scene in pieces, for something to be put between them. */
struct pieces {
    char settings[256], lights[512], clay[256], materials[1024], first[512], objects[2048];
};

static void join(const struct pieces *pieces, char text[TEXT_SIZE]) {
    (void)snprintf(text, TEXT_SIZE,
                   "version = 1; size = [24, 15]; %s\n"
                   "camera = { eye = (0, -6, 2); look_at = (0, 0, 1); };\n"
                   "lights = ( %s );\nmaterials = { clay = { colour = [200, 90, 40]; %s };\n%s };\n"
                   "objects = ( %s %s );\n",
                   pieces->settings, pieces->lights, pieces->clay, pieces->materials, pieces->first,
                   pieces->objects);
}

static void add(char *to, size_t size, const char *format, ...)
#if defined(__GNUC__)
    __attribute__((format(printf, 3, 4)))
#endif
    ;

static void add(char *to, size_t size, const char *format, ...) {
    size_t length = strlen(to);
    va_list arguments;
    va_start(arguments, format);
    int more = vsnprintf(to + length, size - length, format, arguments);
    va_end(arguments);
    assert_true(more >= 0 && (size_t)more < size - length);
}

#define ADD(piece, ...) add(piece, sizeof(piece), __VA_ARGS__)

/* What rays do where they meet something: end, turn aside, or go straight on. */
enum base { ENDING, TURNING, STRAIGHT, BASES };

static const char clay_specular[] = "diffuse = 0.7; specular = 0.3;";
static const char clay_diffuse[] = "diffuse = 0.7;";

/* Makes a box of clay and a ball before it, of a material that makes the base what it is. */
static void make_base(enum base base, uint64_t *seed, struct pieces *pieces) {
    static const char *const materials[] = {
        "front = { colour = [20, 180, 90]; ambient = 0.8; ambient_is_own = true; };",
        "front = { colour = [20, 10, 0]; diffuse = 0.3; specular = 0.4; ior = 1.5; };",
        "front = { colour = [20, 10, 0]; diffuse = 0.3; absorption = 0.2; ior = 1; };"};
    memset(pieces, 0, sizeof *pieces);
    strcpy(pieces->settings, "depth = 9;");
    strcpy(pieces->clay, base == TURNING ? clay_specular : clay_diffuse);
    strcpy(pieces->materials, materials[base]);
    ADD(pieces->lights, "{ position = (%f, %f, %f); }", random_between(seed, -4, 4),
        random_between(seed, -5, 5), random_between(seed, 3, 9));
    ADD(pieces->objects,
        "{ material = \"clay\"; solid = { box = { min = (-1, 0.5, -0.5); max = (1, 2, 1.5); };"
        " rotate = (0, 0, %f); }; },",
        random_between(seed, -9, 9));
    ADD(pieces->objects,
        " { material = \"front\"; solid = { ball = { centre = (%f, %f, %f); radius = 0.6; }; }; }",
        random_between(seed, -0.8, 0.8), random_between(seed, -2, -1),
        random_between(seed, 0.5, 2));
}

static const char glass[] = "glass = { colour = [0, 0, 9]; ior = (1.5, 1.6, 1.7); absorption = 1.0;"
                            " reflectance_factors = 0.5; pattern = { size = [1, 0, 0]; colour = "
                            "[0, 9, 0]; }; };";

static void an_unused_material(uint64_t *seed, struct pieces *pieces) {
    ADD(pieces->materials, " %s odd = { colour = [%f, 2.0, 3.0]; specular = 0.9; };", glass,
        random_between(seed, 0, 255));
}

static void a_black_light(uint64_t *seed, struct pieces *pieces) {
    ADD(pieces->lights, ", { position = (%f, %f, %f); colour = [0, 0, 0]; }",
        random_between(seed, -99, 99), random_between(seed, -99, 99),
        random_between(seed, -99, 99));
}

static void something_behind_the_eye(uint64_t *seed, struct pieces *pieces) {
    bool is_glass = next_random(seed) % 2 == 0;
    ADD(pieces->materials, " %s", glass);
    ADD(pieces->objects,
        ", { material = \"%s\"; solid = { %s = { from = (%f, %f, %f); to = (0, -8, 1); %s; }; }; }",
        is_glass ? "glass" : "clay", is_glass ? "cylinder" : "cone", random_between(seed, -3, 3),
        random_between(seed, -99, -9), random_between(seed, -3, 3),
        is_glass ? "radius = 0.5" : "from_radius = 0.5");
}

#define IN_THE_BOX                                                                                 \
    "{ material = \"glass\"; solid = { ball = { centre = (%f, 1.2, 0.5); radius = 0.3; }; }; }"

static void something_within_the_box(uint64_t *seed, struct pieces *pieces) {
    ADD(pieces->materials, " %s", glass);
    ADD(pieces->objects, ", " IN_THE_BOX, random_between(seed, -0.3, 0.3));
}

static void something_that_the_box_fills(uint64_t *seed, struct pieces *pieces) {
    ADD(pieces->materials, " %s", glass);
    ADD(pieces->first, IN_THE_BOX ",", random_between(seed, -0.3, 0.3));
}

static void an_object_without_a_point(uint64_t *seed, struct pieces *pieces) {
    double x = random_between(seed, -50, 50);
    ADD(pieces->objects,
        ", { material = \"clay\"; solid = { difference = ( { ball = { centre = (%f, 0, 0); radius "
        "= "
        "2; }; }, { ball = { centre = (%f, 0, 0); radius = 2; }; } ); }; }",
        x, x);
}

static void more_depth(uint64_t *seed, struct pieces *pieces) {
    (void)snprintf(pieces->settings, sizeof pieces->settings, "depth = %u;",
                   10 + next_random(seed) % 246);
}

static void a_filter(uint64_t *seed, struct pieces *pieces) {
    (void)seed;
    ADD(pieces->settings, " mixing = \"filter\"; model = \"simple\"; highlight = \"blinn\";");
}

static void a_pattern_of_one_colour(uint64_t *seed, struct pieces *pieces) {
    ADD(pieces->clay, " pattern = { size = [%f, 1.0, 0.0]; colour = [200, 90, 40]; };",
        random_between(seed, 0.1, 2));
}

/* Writes the clay's specular as a table: 0.3 where rays turn aside, else 0. */
static void a_table_of_one_value(uint64_t *seed, struct pieces *pieces) {
    (void)seed;
    bool is_specular = strcmp(pieces->clay, clay_specular) == 0;
    strcpy(pieces->clay, clay_diffuse);
    ADD(pieces->clay, " specular = (");
    for (int i = 0; i < SPECULAR_STEPS; i++) {
        ADD(pieces->clay, "%s%s", i > 0 ? ", " : "", is_specular ? "0.3" : "0");
    }
    ADD(pieces->clay, ");");
}

static const struct {
    void (*add)(uint64_t *seed, struct pieces *pieces);
    const char *name;
    bool is_dead[BASES]; /* where nothing ends, turns or goes straight on */
} additions[] = {
    {an_unused_material, "an unused material", {true, true, true}},
    {a_black_light, "a black light", {true, true, true}},
    {something_behind_the_eye, "something behind the eye", {true, false, true}},
    {something_within_the_box, "something within the box", {true, true, true}},
    {something_that_the_box_fills, "something that the box fills", {true, true, true}},
    {an_object_without_a_point, "an object without a point", {true, true, true}},
    {more_depth, "more depth", {true, false, true}},
    {a_filter, "filters and a model", {true, false, false}},
    {a_table_of_one_value, "a table of one value", {true, true, true}},
    {a_pattern_of_one_colour, "a pattern of one colour", {true, true, true}},
};

enum { ADDITIONS = sizeof additions / sizeof additions[0] };

/* Adds some things and fails unless tables and picture stay, or the tables change where one lives.
 */
static void compare_with(enum base base, uint64_t seed, unsigned added) {
    static char tables[2][TABLES_SIZE];
    char with[TEXT_SIZE], without[TEXT_SIZE], names[512] = "";
    struct pieces pieces;
    bool is_dead = true;
    make_base(base, &seed, &pieces);
    join(&pieces, without);
    for (unsigned i = 0; i < ADDITIONS; i++) {
        if ((added >> i & 1) != 0) {
            additions[i].add(&seed, &pieces);
            is_dead = is_dead && additions[i].is_dead[base];
            ADD(names, "%s, ", additions[i].name);
        }
    }
    join(&pieces, with);
    write_tables(without, tables[0]);
    write_tables(with, tables[1]);
    if ((strcmp(tables[0], tables[1]) == 0) != is_dead) {
        fail_msg("%s%s tables of\n%s\n%s\ninstead of\n%s", names, is_dead ? "other" : "the same",
                 with, tables[1], tables[0]);
    }
    if (is_dead) {
        assert_same_picture(with, without, names);
    }
}

static void dead_things_that_are_added_change_neither_tables_nor_picture(void **state) {
    (void)state;
    for (int base = 0; base < BASES; base++) {
        for (unsigned i = 0; i < ADDITIONS; i++) {
            compare_with((enum base)base, 77 + i, 1u << i);
        }
    }
}

static void any_number_of_them_does_neither(void **state) {
    (void)state;
    uint64_t seed = UINT64_C(0x5EED0DEAD);
    for (int i = 0; i < SEEDS; i++) {
        enum base base = (enum base)(next_random(&seed) % BASES);
        unsigned added = next_random(&seed) % (1u << ADDITIONS);
        unsigned with_glass = added & 0x1D; /* one of those that bring the glass along */
        added &= ~(with_glass & (with_glass - 1));
        for (unsigned j = 0; j < ADDITIONS; j++) {
            added &= additions[j].is_dead[base] ? ~0u : ~(1u << j);
        }
        compare_with(base, next_random(&seed), added);
    }
}

/* ---- The scale ------------------------------------------------------------------------------ */

/* Compiles scenes with something far behind the eye: it may be there to say how far an endless
 * floor reaches, or how large C of C + D may be. */
static void what_is_dead_keeps_its_say_in_the_scale_where_that_is_asked_for(void **state) {
    (void)state;
    static const struct {
        const char *settings, *objects;
        int exponent; /* 2^9 scaled units reach 2^(9 - exponent) of the file's */
    } cases[] = {
        {"", "{ material = \"clay\"; solid = { ball = { centre = (0, 0, 1); radius = 1; }; }; }",
         7},
        {"",
         "{ material = \"clay\"; solid = { half_space = { normal = [0, 0, 1]; offset = 0; }; }; }",
         3},
        {"attenuation = { constant = 99; };",
         "{ material = \"clay\"; solid = { ball = { centre = (0, 0, 1); radius = 1; }; }; }", 3},
        {"attenuation = { constant = 4; };",
         "{ material = \"clay\"; solid = { ball = { centre = (0, 0, 1); radius = 1; }; }; }", 7},
    };
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; i++) {
        char text[TEXT_SIZE];
        struct pieces pieces;
        memset(&pieces, 0, sizeof pieces);
        strcpy(pieces.settings, cases[i].settings);
        strcpy(pieces.lights, "{ direction = (0, 1, -1); }");
        strcpy(pieces.clay, clay_diffuse);
        strcpy(pieces.materials, glass);
        ADD(pieces.objects,
            "%s, { material = \"glass\"; solid = { ball = { centre = (0, -99, 9); radius = 1; }; "
            "}; }",
            cases[i].objects);
        join(&pieces, text);
        struct loaded_scene loaded = load_text(text, "f64");
        if (loaded.compiled->exponent != cases[i].exponent || loaded.compiled->object_count != 2) {
            fail_msg("2^%d, %d objects of\n%s", loaded.compiled->exponent,
                     loaded.compiled->object_count, text);
        }
        unload(&loaded);
    }
}

/* ---- Live things left out ------------------------------------------------------------------- */

/* A grain of glass between the rays of the middle pixels: none meets it, but as far as the compiler
 * can know they may, and may turn anywhere from there. So nothing is dead for being out of view,
 * and no path's events are counted. It lies between the eye and the post, and does not change the
 * scale.
 */
static const char grain[] = "{ material = \"glass\"; solid = { ball = { centre = (0.0, -3.0, 1.5); "
                            "radius = 0.01; }; }; }";

static const char post[] = ", { material = \"own\"; solid = { ball = { centre = (0.0, 5.0, 0.0); "
                           "radius = 0.5; }; }; }";

#define BITTEN                                                                                     \
    "{ difference = ( { ball = { radius = 1; }; }, { ball = { centre = (0.6, 0, 0); radius = "     \
    "0.7; "                                                                                        \
    "}; } ); "

static void add_solid(uint64_t *seed, char *to, size_t size) {
    static const char *const materials[] = {"clay", "striped", "air", "smoke", "mirror", "own"};
    static const char *const kinds[] = {
        "{ ball = { radius = 1; }; ", "{ box = { min = (-1, -1, -1); max = (1, 1, 1); }; ",
        "{ cylinder = { from = (0, 0, -1); to = (0, 0, 1); radius = 0.7; }; ",
        "{ hyperboloid = { from = (0, 0, -1); to = (0, 0, 1); radius = 1; waist = 0.5; }; ",
        BITTEN};
    double x = random_between(seed, -5, 5), y = random_between(seed, -12, 5);
    uint32_t which = next_random(seed);
    bool is_mirror = which % 6 == 4 && which / 64 % 4 > 0; /* one of those ends too much of this */
    add(to, size,
        ", { material = \"%s\"; solid = %s scale = %f; rotate = (%f, %f, 0); translate = (%f, %f, "
        "%f); }; }",
        materials[is_mirror ? 0 : which % 6], kinds[which / 8 % 5], random_between(seed, 0.3, 1.2),
        random_between(seed, -90, 90), random_between(seed, -90, 90), x, y,
        random_between(seed, -1, 4));
}

static void make_random(uint64_t *seed, bool with_grain, char text[TEXT_SIZE]) {
    uint32_t which = next_random(seed);
    text[0] = '\0';
    add(text, TEXT_SIZE,
        "version = 1; size = [24, 15]; depth = 255;%s%s%s\n"
        "camera = { eye = (0, -6, 2); look_at = (0, 0, 1); };\nlights = ( %s",
        which % 8 == 0 ? " mixing = \"filter\";" : "",
        which / 8 % 2 ? " highlight = \"blinn\";" : "",
        which / 16 % 4 == 0 ? " model = \"wavelength\";" : "", which / 64 % 4 ? "" : "); #");
    add(text, TEXT_SIZE, "%s = (%f, %f, %f); } );\n",
        which / 256 % 2 ? "{ position" : "{ direction", random_between(seed, -6, 6),
        random_between(seed, -9, 6), random_between(seed, which / 256 % 2 ? 1 : -9, 9));
    add(text, TEXT_SIZE,
        "materials = {\n"
        "  clay = { colour = [200, 90, 40]; diffuse = 0.7; };\n"
        "  striped = { colour = [40, 90, 200]; diffuse = 0.5; specular = 0.3; ambient = 0.2;\n"
        "              ambient_is_own = true; pattern = { size = (0.7, 0.5, 0); colour = (9, 9, "
        "8); };"
        " };\n"
        "  air = { colour = [20, 9, 9]; ior = 1; diffuse = 0.2; casts_shadow = true; };\n"
        "  smoke = { colour = [90, 9, 0]; ior = 1; absorption = (0.2, 0.1, 0.3); };\n"
        "  mirror = { colour = [9, 9, 9]; specular = 0.1; };\n"
        "  own = { colour = [200, 200, 9]; ambient = 1; ambient_is_own = true; };\n"
        "  glass = { colour = [0, 0, 0]; ior = 1.5; };\n"
        "};\nobjects = ( { material = \"%s\"; solid = { half_space = { normal = [0, 0, 1]; offset "
        "= "
        "-1; }; }; }",
        which / 512 % 2 ? "own" : "clay");
    for (int i = 0; i < 5; i++) {
        add_solid(seed, text, TEXT_SIZE);
    }
    add(text, TEXT_SIZE, "%s%s%s );\n", post, with_grain ? ", " : "", with_grain ? grain : "");
}

static void what_is_left_out_was_not_to_be_seen(void **state) {
    (void)state;
    unsigned dead[2] = {0, 0}, shallow[2] = {0, 0};
    for (uint64_t i = 1; i <= 8 * SEEDS; i++) {
        char text[2][TEXT_SIZE];
        for (int with_grain = 0; with_grain < 2; with_grain++) {
            uint64_t seed = i * UINT64_C(0x9E3779B97F4A7C15);
            make_random(&seed, with_grain, text[with_grain]);
            struct loaded_scene loaded = load_text(text[with_grain], "f64");
            dead[with_grain] += (unsigned)(8 + with_grain) - loaded.compiled->object_count;
            shallow[with_grain] += loaded.compiled->depth < 255;
            unload(&loaded);
        }
        assert_same_picture(text[0], text[1], "without the grain");
    }
    assert_true(dead[0] > dead[1] + 4 * SEEDS && shallow[0] > SEEDS + 8 * shallow[1]);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(dead_things_that_are_added_change_neither_tables_nor_picture),
        cmocka_unit_test(any_number_of_them_does_neither),
        cmocka_unit_test(what_is_dead_keeps_its_say_in_the_scale_where_that_is_asked_for),
        cmocka_unit_test(what_is_left_out_was_not_to_be_seen),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
