/* SPDX-License-Identifier: MIT */
/* Quadrics that planes cut are one primitive, and look like what they are made of. */
#include "scene_fixture.h"

enum { TEXT_SIZE = 16384, SOLID_SIZE = 2048, PLACED_SIZE = 3072, WIDTH = 40, HEIGHT = 25 };

static const char *const arithmetics[] = {"fx", "f32", "f64"};
enum { ARITHMETICS = 3 };

/* The small balls hold the scene's centre and scale fast, whatever else is in it. */
static const char scene_head[] =
    "version = 1; size = [40, 25]; depth = 6;\n"
    "camera = { eye = (3.1, -7.3, 5.2); look_at = (0.0, 0.0, 0.3); field_of_view = 30; "
    "};\n" SCENE_LIGHT_AND_MATERIALS "objects = (\n"
    "  { material = \"board\"; solid = { box = { min = (-9, -9, -2.2); max = (9, 9, -2); }; }; },\n"
    "  { material = \"clay\"; solid = { ball = { centre = (11, 11, 11); radius = 0.1; }; }; },\n"
    "  { material = \"clay\"; solid = { ball = { centre = (-11, -11, -11); radius = 0.1; }; }; }";

/* The scene with an object, or with two of the same material. */
static void make_scene(char text[TEXT_SIZE], const char *material, const char *solid,
                       const char *other) {
    size_t used = (size_t)snprintf(text, TEXT_SIZE, "%s", scene_head);
    if (solid != NULL) {
        used += (size_t)snprintf(text + used, TEXT_SIZE - used,
                                 ",\n  { material = \"%s\"; solid = %s; }", material, solid);
    }
    if (other != NULL) {
        used += (size_t)snprintf(text + used, TEXT_SIZE - used,
                                 ",\n  { material = \"%s\"; solid = %s; }", material, other);
    }
    (void)snprintf(text + used, TEXT_SIZE - used, "\n);\n");
}

static void render(const char *text, const char *arithmetic, double level[WIDTH * HEIGHT][3]) {
    struct loaded_scene loaded = load_text(text, arithmetic);
    struct render_counts counts = {0};
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        loaded.arithmetic->pixel(loaded.scene, (uint16_t)(i % WIDTH), (uint16_t)(i / WIDTH),
                                 level[i], &counts, NULL);
    }
    if (counts.leaked_rays != 0) {
        fail_msg("%s: %u rays leaked of\n%s", arithmetic, (unsigned)counts.leaked_rays, text);
    }
    unload(&loaded);
}

/* How many pixels differ by more than a tolerance, in levels. */
static int pixels_apart(double a[WIDTH * HEIGHT][3], double b[WIDTH * HEIGHT][3],
                        double tolerance) {
    int apart = 0;
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        bool differs = false;
        for (int j = 0; j < 3; j++) {
            differs = differs || !(fabs(a[i][j] - b[i][j]) <= tolerance);
        }
        apart += differs;
    }
    return apart;
}

/* How many pixels show that a solid is there at all. */
static int pixels_seen(double level[WIDTH * HEIGHT][3], const char *arithmetic) {
    static double bare[WIDTH * HEIGHT][3];
    char text[TEXT_SIZE];
    make_scene(text, "", NULL, NULL);
    render(text, arithmetic, bare);
    return pixels_apart(level, bare, 1);
}

/* Fails unless two scenes look alike in every arithmetic; how many pixels show the solid. */
static int assert_alike(const char *text_a, const char *text_b) {
    static double a[WIDTH * HEIGHT][3], b[WIDTH * HEIGHT][3];
    for (int i = 0; i < ARITHMETICS; i++) {
        render(text_a, arithmetics[i], a);
        render(text_b, arithmetics[i], b);
        int apart = pixels_apart(a, b, i == 2 ? 1e-6 : 1);
        /* fx and f32: a ray that just misses an edge may round to the other side of it. */
        if (apart > (i == 2 ? 0 : 2)) {
            fail_msg("%s: %d pixels differ between\n%s\nand\n%s", arithmetics[i], apart, text_a,
                     text_b);
        }
    }
    return pixels_seen(a, arithmetics[2]);
}

/* ---- Random quadrics and what cuts them ------------------------------------------------------ */

/* A solid in two forms: one that the compiler fuses, and one that it cannot, for a union cuts it.
 */
struct forms {
    char fused[SOLID_SIZE], parts[SOLID_SIZE];
};

/* Everything of a half-space, or of a slab, that matters: two boxes that run into each other. */
static void boxes_between(char *text, size_t size, double low, double high) {
    (void)snprintf(text, size,
                   "{ union = ( { box = { min = (-9, -9, %.17g); max = (0.2, 9, %.17g); }; },"
                   " { box = { min = (-0.2, -9, %.17g); max = (9, 9, %.17g); }; } ); }",
                   low, high, low, high);
}

/* A surface x^2 + y^2 + zz z^2 + z z + one between two heights, and the leaf that is the same. */
static void round_forms(struct forms *forms, const char *leaf, double zz, double z, double one,
                        double low, double high) {
    char boxes[512];
    boxes_between(boxes, sizeof boxes, low, high);
    (void)snprintf(forms->fused, SOLID_SIZE, "%s", leaf);
    (void)snprintf(forms->parts, SOLID_SIZE,
                   "{ intersection = ( { quadric = { coefficients = (1.0, 1.0, %.17g, 0.0, 0.0, "
                   "0.0, 0.0, 0.0, %.17g, %.17g); }; }, %s ); }",
                   zz, z, one, boxes);
}

static void cylinder_forms(struct forms *forms, uint64_t *seed) {
    char leaf[512];
    double low = random_between(seed, -1, -0.2), high = random_between(seed, 0.2, 1);
    double radius = random_between(seed, 0.3, 1);
    (void)snprintf(leaf, sizeof leaf,
                   "{ cylinder = { from = (0, 0, %.17g); to = (0, 0, %.17g); radius = %.17g; }; }",
                   low, high, radius);
    round_forms(forms, leaf, 0, 0, -radius * radius, low, high);
}

static void cone_forms(struct forms *forms, uint64_t *seed) {
    char leaf[512];
    double low = random_between(seed, -1, -0.2), high = random_between(seed, 0.2, 1);
    double from = random_between(seed, 0.6, 1.2), to = random_between(seed, 0, 0.5);
    double k = (to - from) / (high - low), axis = from - k * low;
    (void)snprintf(leaf, sizeof leaf,
                   "{ cone = { from = (0, 0, %.17g); to = (0, 0, %.17g); from_radius = %.17g; "
                   "to_radius = %.17g; }; }",
                   low, high, from, to);
    round_forms(forms, leaf, -k * k, -2 * k * axis, -axis * axis, low, high);
}

static void paraboloid_forms(struct forms *forms, uint64_t *seed) {
    char leaf[512];
    double low = random_between(seed, -1, -0.2), high = random_between(seed, 0.2, 1);
    double radius = random_between(seed, 0.5, 1.2), k = radius * radius / (high - low);
    (void)snprintf(
        leaf, sizeof leaf,
        "{ paraboloid = { from = (0, 0, %.17g); to = (0, 0, %.17g); radius = %.17g; }; }", low,
        high, radius);
    round_forms(forms, leaf, 0, -k, k * low, low, high);
}

static void hyperboloid_forms(struct forms *forms, uint64_t *seed) {
    char leaf[512];
    double half = random_between(seed, 0.6, 1.2), radius = random_between(seed, 0.7, 1.2);
    double neck = random_between(seed, 0.1, 0.5);
    bool sheets = (next_random(seed) & 1) != 0;
    double tip = neck * neck / 4, waist = neck * neck;
    double k =
        sheets ? radius * radius / (half * half - tip) : (radius * radius - waist) / (half * half);
    (void)snprintf(leaf, sizeof leaf,
                   "{ hyperboloid = { from = (0, 0, %.17g); to = (0, 0, %.17g); radius = %.17g; "
                   "%s = %.17g; }; }",
                   -half, half, radius, sheets ? "gap" : "waist", neck);
    round_forms(forms, leaf, -k, 0, sheets ? k * tip : -waist, -half, half);
}

/* An ellipsoid below a plane, above one, less what is above one, or in a box. */
static void ellipsoid_forms(struct forms *forms, uint64_t *seed) {
    char leaf[256], boxes[512];
    double height = random_between(seed, -0.3, 0.5);
    unsigned kind = next_random(seed) % 4;
    (void)snprintf(leaf, sizeof leaf, "{ ellipsoid = { radii = (%.17g, %.17g, %.17g); }; }",
                   random_between(seed, 0.6, 1.4), random_between(seed, 0.6, 1.4),
                   random_between(seed, 0.6, 1.2));
    boxes_between(boxes, sizeof boxes, kind % 2 == 0 ? -9 : height, kind % 2 == 0 ? height : 9);
    if (kind == 3) {
        boxes_between(boxes, sizeof boxes, -0.4, height);
    }
    (void)snprintf(forms->parts, SOLID_SIZE, "{ %s = ( %s, %s ); }",
                   kind == 2 ? "difference" : "intersection", leaf, boxes);
    if (kind == 3) {
        (void)snprintf(
            forms->fused, SOLID_SIZE,
            "{ intersection = ( %s, { box = { min = (-9, -9, -0.4); max = (9, 9, %.17g); "
            "}; } ); }",
            leaf, height);
        return;
    }
    (void)snprintf(forms->fused, SOLID_SIZE,
                   "{ %s = ( %s, { half_space = { normal = (0, 0, %d); offset = %.17g; }; } ); }",
                   kind == 2 ? "difference" : "intersection", leaf, kind == 1 ? -1 : 1,
                   kind == 1 ? -height : height);
}

/* A ball below a slanted plane: it takes on the plane's axes. */
static void ball_forms(struct forms *forms, uint64_t *seed) {
    char ball[128], plane[256];
    (void)snprintf(ball, sizeof ball, "{ ball = { centre = (0.1, 0, 0); radius = %.17g; }; }",
                   random_between(seed, 0.7, 1.3));
    (void)snprintf(
        plane, sizeof plane, "{ half_space = { normal = (%.17g, %.17g, 1.0); offset = %.17g; }; }",
        random_between(seed, -1, 1), random_between(seed, -1, 1), random_between(seed, -0.3, 0.4));
    (void)snprintf(forms->fused, SOLID_SIZE, "{ intersection = ( %s, %s ); }", ball, plane);
    (void)snprintf(forms->parts, SOLID_SIZE,
                   "{ intersection = ( %s, { union = (\n"
                   " { intersection = ( %s, { box = { min = (-9, -9, -9); max = (0.2, 9, 9); }; } "
                   "); },\n"
                   " { intersection = ( %s, { box = { min = (-0.2, -9, -9); max = (9, 9, 9); }; } "
                   "); } ); } ); }",
                   ball, plane, plane);
}

static void place(char *text, const char *solid, const double turn[3], const double scale[3]) {
    (void)snprintf(text, PLACED_SIZE,
                   "{ union = ( %s ); scale = (%.17g, %.17g, %.17g); rotate = (%.17g, %.17g, "
                   "%.17g); translate = (0.1, 0.2, 0.1); }",
                   solid, scale[0], scale[1], scale[2], turn[0], turn[1], turn[2]);
}

static int primitives_of(const char *text) {
    struct loaded_scene loaded = load_text(text, "f64");
    int count = (int)loaded.compiled->primitive_count;
    unload(&loaded);
    return count;
}

static void a_cut_quadric_looks_like_what_it_is_made_of(void **state) {
    (void)state;
    static void (*const kinds[])(struct forms *, uint64_t *) = {cylinder_forms,   cone_forms,
                                                                paraboloid_forms, hyperboloid_forms,
                                                                ellipsoid_forms,  ball_forms};
    enum { KINDS = sizeof kinds / sizeof kinds[0], ROUNDS = 8 };
    for (uint64_t i = 0; i < KINDS * ROUNDS; i++) {
        uint64_t seed = 104729 * (i + 1);
        struct forms forms;
        char fused[PLACED_SIZE], parts[PLACED_SIZE], text[TEXT_SIZE], other[TEXT_SIZE];
        double turn[3], scale[3];
        bool upright = next_random(&seed) % 2 == 0, even = next_random(&seed) % 2 == 0;
        for (int j = 0; j < 3; j++) {
            turn[j] = upright ? 0 : random_between(&seed, -180, 180);
            scale[j] = even ? 1 : random_between(&seed, 0.7, 1.2);
        }
        kinds[i % KINDS](&forms, &seed);
        place(fused, forms.fused, turn, scale);
        place(parts, forms.parts, turn, scale);
        const char *material = next_random(&seed) % 2 == 0 ? "glass" : "clay";
        make_scene(text, material, fused, NULL);
        make_scene(other, material, parts, NULL);
        assert_true(primitives_of(text) < primitives_of(other));
        assert_true(assert_alike(text, other) > 10);
    }
}

/* ---- What it becomes ------------------------------------------------------------------------- */

#define EGG  "{ ellipsoid = { radii = (1.2, 0.9, 1.0); }; }"
#define BALL "{ ball = { radius = 1.0; }; }"
#define ROD                                                                                        \
    "{ quadric = { coefficients = (1.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, -0.36); }; }"

static void cut_solids_are_one_primitive(void **state) {
    (void)state;
    static const char *const solids[] = {
        "{ cylinder = { from = (0, 0, -1); to = (0, 0, 1); radius = 0.5; }; }",
        "{ cone = { from = (0, 0, -1); to = (1, 0.4, 1); from_radius = 0.5; }; }",
        "{ paraboloid = { from = (0, 0, -1); to = (0, 1, 1); radius = 0.5; }; }",
        "{ hyperboloid = { from = (0, 0, -1); to = (0, 0, 1); radius = 0.5; waist = 0.2; }; }",
        "{ hyperboloid = { from = (0, 0, -1); to = (0, 0, 1); radius = 0.5; gap = 0.2; }; }",
        "{ intersection = ( " EGG ", { half_space = { normal = [0, 0, 1]; offset = 0.1; }; } ); }",
        "{ intersection = ( { half_space = { normal = [0, 1, 0]; offset = 0.1; }; }, " EGG " ); }",
        "{ difference = ( " EGG ", { half_space = { normal = [0, 0, 1]; offset = 0.1; }; } ); }",
        "{ intersection = ( " EGG
        ", { box = { min = (-1, -0.5, -2); max = (0.5, 0.5, 2); }; } ); }",
        "{ intersection = ( " BALL ", { half_space = { normal = (1, 2, 3); offset = 0.1; }; } ); }",
        "{ intersection = ( " BALL ", { half_space = { normal = [0, 0, 1]; offset = 0.3; }; }, "
        "{ half_space = { normal = [0, 0, -1]; offset = 0.3; }; } ); }",
        "{ intersection = ( " EGG
        ", { half_space = { normal = [0, 0, 1]; offset = 0.1; }; } ); rotate = (10, 20, 30); }",
        "{ intersection = ( { box = { min = (-1, -1, -1); max = (1, 1, 1); }; }, "
        "{ half_space = { normal = [0, 0, 1]; offset = 0.1; }; } ); }"};
    char text[TEXT_SIZE];
    for (size_t i = 0; i < sizeof solids / sizeof solids[0]; i++) {
        make_scene(text, "glass", solids[i], NULL);
        struct loaded_scene loaded = load_text(text, "f64");
        if (loaded.compiled->primitive_count != 4) { /* the board, two balls and this */
            fail_msg("%d primitives of %s", loaded.compiled->primitive_count - 3, solids[i]);
        }
        assert_true(loaded.compiled->report.fused > 0);
        unload(&loaded);
    }
}

static void planes_that_lie_slanted_to_a_quadric_stay_by_themselves(void **state) {
    (void)state;
    char text[TEXT_SIZE];
    make_scene(text, "glass",
               "{ intersection = ( " EGG
               ", { half_space = { normal = (1, 0, 1); offset = 0.1; }; } ); }",
               NULL);
    struct loaded_scene loaded = load_text(text, "f64");
    assert_int_equal(loaded.compiled->primitive_count, 5);
    assert_int_equal(loaded.compiled->report.fused, 0);
    assert_int_equal(loaded.compiled->report.bounded, 1); /* the half-space ends with the egg */
    unload(&loaded);
}

/* As a quadric here and a ball there one surface would round in two ways. */
static void a_ball_that_is_used_elsewhere_too_stays_a_ball(void **state) {
    (void)state;
    static const char half[] =
        "{ intersection = ( " BALL ", { half_space = { normal = [0, 0, 1]; offset = 0.1; }; } ); }";
    static const char shell[] =
        "{ difference = ( { box = { min = (-1.5, -1.5, -1.5); max = (1.5, 1.5, 1.5); }; }, " BALL
        " ); }";
    char text[TEXT_SIZE];
    make_scene(text, "glass", shell, half);
    struct loaded_scene loaded = load_text(text, "f64");
    assert_int_equal(loaded.compiled->quadric_count, 0);
    assert_int_equal(loaded.compiled->ball_count, 3); /* the two that hold the scene as well */
    unload(&loaded);
}

/* ---- Cut solids that are used twice -----------------------------------------------------------
 */

/* A quadric within a box, put somewhere: each differs from the first one in one thing. */
static const struct cut {
    const char *quadric;
    double low[3], high[3];
    const char *placement;
} cuts[] = {
    {EGG, {-9, -9, -9}, {9, 9, 0.2}, ""},
    {EGG, {-9, -9, -9}, {9, 9, 0.4}, ""},
    {EGG, {-9, -9, -0.3}, {9, 9, 9}, ""},
    {EGG, {-9, -9, -0.3}, {9, 9, 0.2}, ""},
    {EGG, {-9, -9, -9}, {0.2, 9, 9}, ""},
    {EGG, {-9, -9, -9}, {0.3, 9, 0.2}, ""},
    {EGG, {-9, -9, -9}, {9, 9, 0.2}, "rotate = (0, 0, 30); "},
    {EGG, {-9, -9, -9}, {9, 9, 0.2}, "translate = (0.2, 0, 0); "},
    {"{ ellipsoid = { radii = (1.0, 0.9, 1.0); }; }", {-9, -9, -9}, {9, 9, 0.2}, ""},
    {ROD, {-9, -9, -1}, {9, 9, 0.2}, ""},
    {ROD, {-9, -9, -1}, {9, 9, 0.7}, ""},
    {ROD, {-9, -9, -0.8}, {9, 9, 0.7}, "rotate = (0, 90, 0); "},
};
enum { CUTS = sizeof cuts / sizeof cuts[0] };

/* The fused form, and the one in which two boxes that run into each other are in the box's place.
 */
static void cut_forms(struct forms *forms, const struct cut *cut) {
    const double *low = cut->low, *high = cut->high;
    (void)snprintf(forms->fused, SOLID_SIZE,
                   "{ intersection = ( %s, { box = { min = (%g, %g, %g); max = (%g, %g, %g); }; } "
                   "); %s}",
                   cut->quadric, low[0], low[1], low[2], high[0], high[1], high[2], cut->placement);
    (void)snprintf(forms->parts, SOLID_SIZE,
                   "{ intersection = ( %s, { union = (\n"
                   "  { box = { min = (%g, %g, %g); max = (%g, 0.1, %g); }; },\n"
                   "  { box = { min = (%g, -0.1, %g); max = (%g, %g, %g); }; } ); } ); %s}",
                   cut->quadric, low[0], low[1], low[2], high[0], high[2], low[0], low[2], high[0],
                   high[1], high[2], cut->placement);
}

/* One of them is cut out of a block, the other one put there: where they are the same solid, it is
 * compiled once; where they differ in anything, each has its own faces. */
static void a_cut_quadric_is_shared_with_its_equal_alone(void **state) {
    (void)state;
    static const char block[] =
        "{ difference = ( { box = { min = (-1.5, -1.5, -1.2); max = (1.5, 1.5, 1.2); }; }, %s ); }";
    for (int i = 0; i < CUTS * CUTS; i++) {
        const struct cut *one = &cuts[i / CUTS], *other = &cuts[i % CUTS];
        struct forms first, second;
        char text[TEXT_SIZE], unfused[TEXT_SIZE], outside[PLACED_SIZE];
        cut_forms(&first, one);
        cut_forms(&second, other);
        (void)snprintf(outside, sizeof outside, block, first.fused);
        make_scene(text, "glass", outside, second.fused);
        /* The board, two small balls, the block. */
        assert_int_equal(primitives_of(text), 4 + (one == other ? 1 : 2));
        if (one != &cuts[0]) {
            continue; /* pictures of the first one with each will do */
        }
        (void)snprintf(outside, sizeof outside, block, first.parts);
        make_scene(unfused, "glass", outside, second.parts);
        assert_true(assert_alike(text, unfused) > 100);
    }
}

/* ---- Surfaces that cut solids share with others ---------------------------------------------- */

static void two_parts_of_a_quadric_are_the_whole(void **state) {
    (void)state;
    static const char low[] =
        "{ intersection = ( " EGG ", { half_space = { normal = [0, 0, 1]; offset = 0.2; }; } ); }";
    static const char high[] = "{ intersection = ( " EGG
                               ", { half_space = { normal = [0, 0, -1]; offset = -0.2; }; } ); }";
    static double whole[WIDTH * HEIGHT][3], parts[WIDTH * HEIGHT][3];
    char text[TEXT_SIZE], one[TEXT_SIZE], two[TEXT_SIZE], both[SOLID_SIZE];
    (void)snprintf(both, sizeof both, "{ union = ( %s, %s ); }", low, high);
    make_scene(text, "glass", EGG, NULL);
    make_scene(one, "glass", both, NULL);
    make_scene(two, "glass", low, high);
    for (int i = 0; i < ARITHMETICS; i++) {
        render(text, arithmetics[i], whole);
        render(one, arithmetics[i], parts);
        assert_int_equal(pixels_apart(whole, parts, 0), 0);
        render(two, arithmetics[i], parts);
        assert_int_equal(pixels_apart(whole, parts, 0), 0);
        assert_true(pixels_seen(whole, arithmetics[i]) > 100);
    }
}

/* A ray that leaves a whole quadric by its curved face can enter the part of it by the flat one. */
static void a_part_may_be_entered_from_outside_after_the_whole_was_left(void **state) {
    (void)state;
    static const char shell[] =
        "{ difference = ( { box = { min = (-1.5, -1.5, -1.5); max = (1.5, 1.5, 1.5); }; }, " EGG
        " ); }";
    static const char part[] =
        "{ intersection = ( " EGG ", { half_space = { normal = [0, 0, 1]; offset = 0.2; }; } ); }";
    static const char split[] =
        "{ intersection = ( " EGG ", { union = ( { box = { min = (-9, -9, -9); max = (0.2, 9, "
        "0.2); }; }, { box = { min = (-0.2, -9, -9); max = (9, 9, 0.2); }; } ); } ); }";
    char text[TEXT_SIZE], other[TEXT_SIZE];
    make_scene(text, "glass", shell, part);
    make_scene(other, "glass", shell, split);
    assert_true(assert_alike(text, other) > 100);
}

/* The flat face lies in the plane of the board's upper one. */
static void a_cut_quadric_may_stand_on_another_solid(void **state) {
    (void)state;
    static const char dome[] =
        "{ intersection = ( { ellipsoid = { centre = (0, 0, -2); radii = (1.5, 1.2, 2); }; }, "
        "{ half_space = { normal = [0, 0, -1]; offset = 2; }; } ); }";
    static const char split[] =
        "{ intersection = ( { ellipsoid = { centre = (0, 0, -2); radii = (1.5, 1.2, 2); }; }, "
        "{ union = ( { box = { min = (-9, -9, -2); max = (0.2, 9, 9); }; }, { box = { min = "
        "(-0.2, -9, -2); max = (9, 9, 9); }; } ); } ); }";
    char text[TEXT_SIZE], other[TEXT_SIZE];
    make_scene(text, "glass", dome, NULL);
    make_scene(other, "glass", split, NULL);
    assert_true(assert_alike(text, other) > 100);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_cut_quadric_looks_like_what_it_is_made_of),
        cmocka_unit_test(cut_solids_are_one_primitive),
        cmocka_unit_test(planes_that_lie_slanted_to_a_quadric_stay_by_themselves),
        cmocka_unit_test(a_ball_that_is_used_elsewhere_too_stays_a_ball),
        cmocka_unit_test(a_cut_quadric_is_shared_with_its_equal_alone),
        cmocka_unit_test(two_parts_of_a_quadric_are_the_whole),
        cmocka_unit_test(a_part_may_be_entered_from_outside_after_the_whole_was_left),
        cmocka_unit_test(a_cut_quadric_may_stand_on_another_solid),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
