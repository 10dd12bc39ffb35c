/* SPDX-License-Identifier: MIT */
/* The validator agrees with what the scene compiler makes of scenes, and with nothing that has been
 * damaged since. */
#include "scene/builtin.h"
#include "scene_fixture.h"
#include "validate/validate.h"

enum { TEXT_SIZE = 16384 };

static const char scene_head[] =
    "version = 1; size = [32, 20]; depth = 6;\n"
    "camera = { eye = (3.1, -7.3, 5.2); look_at = (0.0, 0.0, 0.3); field_of_view = 34; };\n"
    "lights = ( { position = (-4, -6, 9); }, { direction = (0.5, 0.6, -1.0); } );\n"
    "materials = {\n"
    "  board = { colour = [200, 200, 200]; diffuse = 0.6; };\n"
    "  glass = { colour = [10, 30, 20]; diffuse = 0.3; ior = 1.5; };\n"
    "  air = { colour = [0, 0, 0]; ior = 1; };\n"
    "  smoke = { colour = [0, 0, 0]; ior = 1; casts_shadow = true; };\n"
    "};\n"
    "parts = ( { name = \"shell\"; solid = { difference = ( { ball = { radius = 1; }; }, { ball = "
    "{ radius = 0.8; }; } ); }; }, { name = \"pair\"; solid = { union = ( { part = \"shell\"; }, { "
    "part = \"shell\"; translate = (1.1, 0.2, 0); scale = (1, 0.5, 0.8); } ); }; } );\n"
    "objects = (\n";

#define OBJECT(material, solid)                                                                    \
    "{ name = \"a " material "\"; material = \"" material "\"; solid = " solid "; }"
#define BOARD     OBJECT("board", "{ box = { min = (-9, -9, -6); max = (9, 9, -1.2); }; }")
#define ON(solid) BOARD ",\n" OBJECT("glass", solid)

#define BALL "{ ball = { centre = (0.2, 0.1, 0.3); radius = 1.1; }; }"
#define EGG  "{ ellipsoid = { centre = (0.1, 0, 0.2); radii = (1.3, 0.8, 1.0); }; }"
#define BOX  "{ box = { min = (-0.9, -0.8, -0.6); max = (1.0, 0.7, 0.9); }; }"
#define ROD  "{ cylinder = { from = (0.1, 0, -1); to = (0.2, 0.5, 1.5); radius = 0.4; }; }"
#define PLANES                                                                                     \
    "planes = ( { normal = (0, 0, -1); offset = 1; }, { normal = (0, 0, 1); offset = 1; }, { "     \
    "normal = (2, 0, 1); offset = 2; }, { normal = (-2, 0, 1); offset = 2; }, { normal = (0, 2, "  \
    "1); offset = 2; }, { normal = (0, -2, 1); offset = 2; } ); "
#define FRUSTUM  "{ polyhedron = { " PLANES "}; }"
#define SMALLER  "{ polyhedron = { " PLANES "}; scale = 0.7; }"
#define HALF(x)  "{ half_space = { normal = (" x "); offset = 0.4; }; }"
#define SLAB(z)  "{ box = { min = (-3, -3, " z "); max = (3, 3, 0.5); }; }"
#define CUT(w)   "{ box = { min = (-0.4, -3, -0.3); max = (" w ", 3, 0.5); }; }"
#define UNION(a) "{ union = ( " a " ); }"
#define BOTH(a)  "{ intersection = ( " a " ); }"
#define LESS(a)  "{ difference = ( " a " ); }"
#define COLOURED(material, kind)                                                                   \
    "{ material = \"" material "\"; union = ( " kind " ); translate = (0.3, 0.2, 0.1); }"

#define ENDLESS(squares, constant)                                                                 \
    "{ quadric = { coefficients = (" squares ", 0, 0, 0, 0, 0, 0, " constant "); }; }"
#define OFF_X "{ ellipsoid = { centre = (-2, 0, 1.5); radii = (1.3, 0.8, 1); }; }"
#define OFF_Y "{ ellipsoid = { centre = (0, -2, 1.5); radii = (0.8, 1.3, 1); }; }"

/* Each solid kind, each step of the compiler, and each kind of place has its scene. */
static const char *const scenes[] = {
    ON(BALL),
    ON(UNION(BALL ", " BALL)),
    ON(LESS(EGG ", " EGG)) ",\n" OBJECT("smoke", BALL),
    ON(LESS(BOX ", " BALL)),
    ON(UNION("{ box = { min = (-1, -1, -1); max = (0.3, 1, 1); }; }, "
             "{ box = { min = (0.3, -1, -1); max = (1, 1, 1); }; }")),
    /* Fused: capped round solids, cut ones, boxes within boxes. */
    ON(ROD),
    ON(UNION(ROD ", { cone = { from = (0, 0, -1); to = (0.2, 0.1, 1.6); from_radius = 1.2; }; "
                 "translate = (2, 0, 0); }")),
    ON("{ cone = { from = (0, 0, -1); to = (1, 1, 1); from_radius = 0.3; to_radius = 1; }; }"),
    ON("{ paraboloid = { from = (0, 0, -0.8); to = (0, 0.1, 1.4); radius = 1.0; }; }"),
    ON("{ hyperboloid = { from = (0, 0, -1); to = (0, 0, 1.8); radius = 1; waist = 0.4; }; }"),
    ON("{ hyperboloid = { from = (0, 0.1, -1.2); to = (0, 0, 2); radius = 1; gap = 0.5; }; }"),
    ON(BOTH(BALL ", " SLAB("-0.3"))),
    ON(BOTH(BALL ", " HALF("1, 2, 3"))),
    ON(UNION(BOTH(EGG ", " SLAB("-0.3")) ", " BOTH(EGG ", " CUT("0.7")))),
    ON(UNION(BOTH(EGG ", " SLAB("-0.3")) ", " LESS(BOTH(EGG ", " CUT("0.7")) ", " ROD))),
    ON(BOTH(BOX ", { box = { min = (-0.5, -3, -3); max = (3, 0.1, 3); }; }")),
    ON(LESS(ROD ", { box = { min = (-1, -4, 0.3); max = (4, 4, 0.9); }; rotate = (0, 20, 0); }")),
    ON(LESS(EGG ", " HALF("0, 0, 1"))),
    ON(BOTH(UNION(EGG ", " ROD) ", " SLAB("-0.3"))),
    /* Bounded: what has no end, and what goes beyond all that is seen of it. */
    ON(BOTH(BOX ", { quadric = { coefficients = (1, -0.5, 0, 0, 0, 0, 0, 0, -1, 0); }; }")),
    ON(LESS(BOX ", " HALF("0.2, 0.4, 1") ", " HALF("0, 0, -1"))),
    ON(LESS(BALL ", { ellipsoid = { centre = (0, 0, 3); radii = (8, 8, 2.9); }; }")),
    OBJECT("board", HALF("0, 0, 1")) ",\n" OBJECT("board", HALF("0.1, -1, 0.2")) ",\n" OBJECT(
        "glass", "{ ball = { centre = (1, -1, 2); radius = 1; }; }"),
    /* Quadrics without an end along an axis, or along two, and about a place off the centre. */
    OBJECT("board", ENDLESS("1, 2, 0", "-0.4")),
    OBJECT("board", ENDLESS("0, 1, 2", "-0.4")) ",\n" OBJECT("board", ENDLESS("2, 0, 1", "-0.3")),
    ON(LESS(BOX ", " ENDLESS("0, 1, 0", "-0.1"))) ",\n" OBJECT("board", ENDLESS("3, 0, 0", "-0.1")),
    ON(UNION(OFF_X ", { box = { min = (-2.5, -0.3, 1.2); max = (2, 0.3, 1.8); }; }")),
    ON(UNION(OFF_Y ", { box = { min = (-0.3, -2.5, 1.2); max = (0.3, 2, 1.8); }; }")),
    ON(LESS(OFF_X ", { ball = { centre = (-2.1, 0.1, 1.5); radius = 0.5; }; }")),
    /* Enclosures, apart and touching; polyhedra that move when the tables are compacted. */
    ON(LESS(FRUSTUM ", " SMALLER)),
    ON(LESS(EGG ", { ball = { centre = (0.1, 0, 0.2); radius = 0.7; }; }")),
    BOARD ",\n" OBJECT("glass", LESS(BALL ", { polyhedron = { " PLANES "}; translate = (0, 0, "
                                          "40); }")) ",\n" OBJECT("glass", SMALLER),
    BOARD ",\n" OBJECT("glass", BOX) ",\n" OBJECT("air", "{ ball = { radius = 0.5; }; }"),
    BOARD ",\n" OBJECT("smoke", BOX) ",\n" OBJECT("glass", BALL) ",\n" OBJECT("air", EGG),
    /* Nothing but a body that keeps light off its own far side, as seen from inside of it. */
    OBJECT("smoke", BOX),
    /* One casts its shadow on the other, which lies beside it. */
    OBJECT("board", "{ box = { min = (-1, -1, -1); max = (0, 0, 1); }; }") ",\n" OBJECT(
        "board", "{ box = { min = (-0.9, 0.2, -1); max = (0, 1, 0.5); }; }"),
    /* Parts, several materials, and what cuts them. */
    ON("{ part = \"pair\"; rotate = (10, 20, 30); }") ",\n" OBJECT(
        "smoke", "{ part = \"pair\"; translate = (0, 0, 2); }"),
    ON(LESS(UNION(COLOURED("smoke", BOX) ", " COLOURED("glass", EGG) ", " BALL) ", " ROD)),
    ON(BOTH(LESS(UNION(COLOURED("air", FRUSTUM) ", " BALL) ", " ROD) ", " SLAB("-0.5"))),
    /* Placements: mirrored, skewed, far away, small. */
    ON("{ union = ( { box = { min = (-1, -1, -1); max = (1, 1, 1); }; rotate = (30, 20, 10); } ); "
       "scale = (1, 0.4, -0.8); }"),
    ON("{ union = ( " ROD ", " FRUSTUM ", " EGG " ); scale = (-1, 0.4, 0.8); rotate = (0, 0, 25); "
       "}"),
    OBJECT("glass", "{ union = ( " ROD ", " EGG " ); translate = (1e5, 2e5, -3e5); }"),
    ON("{ union = ( " BOX ", " EGG " ); rotate = (90, 0, 90); }"),
    ON("{ union = ( " LESS(FRUSTUM ", " ROD) " ); scale = 1e-4; rotate = (40, 50, 60); }"),
    /* A saddle that nothing cuts: a ray leaves it and comes back. */
    OBJECT("board", "{ quadric = { coefficients = (1, 0.5, -0.3, 0, 0, 0, 0, 0, 0, -0.2); }; }"),
    /* The eye in glass. */
    ON("{ ball = { centre = (3, -7, 5); radius = 1; }; }"),
    ON("{ box = { min = (-1, -1, -1); max = (1, 1, 1); }; rotate = (20, 30, 40); translate = (3, "
       "-7, 5); "
       "}"),
};
enum { SCENES = sizeof scenes / sizeof scenes[0] };

static struct scene_description *read_objects(const char *objects) {
    char text[TEXT_SIZE];
    const int length = snprintf(text, TEXT_SIZE, "%s%s\n);\n", scene_head, objects);
    assert_in_range(length, 1, TEXT_SIZE - 1);
    return read_text(text);
}

/* What the scene compiler did on the way. */
struct coverage {
    struct compiled_report done;
    unsigned enclosures, cuts, removed, kinds[4], shadows;
};

static void cover(struct coverage *coverage, const struct compiled_scene *scene) {
    coverage->done.shared += scene->report.shared;
    coverage->done.simplified += scene->report.simplified;
    coverage->done.fused += scene->report.fused;
    coverage->done.bounded += scene->report.bounded;
    coverage->done.hidden += scene->report.hidden;
    coverage->shadows += scene->has_shadows;
    for (uint32_t i = 0; i < scene->primitive_count; i++) {
        coverage->enclosures += scene->primitives[i].enclosure != COMPILED_ENCLOSURE_NONE;
        coverage->kinds[scene->primitives[i].kind]++;
    }
    for (uint32_t i = 0; i < scene->quadric_count; i++) {
        coverage->cuts += scene->quadrics[i].cuts != 0;
    }
    coverage->removed += scene->objects[scene->object_count - 1].part + 1 >= scene->object_count;
}

static void assert_validates(const struct scene_description *description, const char *what,
                             struct coverage *coverage) {
    struct scene_error error = {""};
    struct validations validations = {.description = description};
    const struct compile_observer observer = {validations_look, &validations};
    struct compiled_scene *compiled = scene_compile_observed(description, &observer, &error);
    if (compiled == NULL) {
        fail_msg("not compiled: %s: %s", error.text, what);
    }
    for (int i = 0; i < STEP_COUNT; i++) {
        const struct validation *step = &validations.of[i];
        if (step->faults > 0 || step->points < 1000) {
            fail_msg("%s: %u points, %u faults, first: %s, of\n%s",
                     compile_step_name((enum compile_step)i), step->points, step->faults,
                     step->first, what);
        }
        /* What is passed over is the exception. */
        assert_true(step->near < step->points / 4);
    }
    cover(coverage, compiled);
    compiled_scene_free(compiled);
}

static void every_step_agrees_with_the_scene(void **state) {
    (void)state;
    struct coverage coverage = {{0}, 0, 0, 0, {0}, 0};
    for (int i = 0; i < SCENES; i++) {
        struct scene_description *description = read_objects(scenes[i]);
        assert_validates(description, scenes[i], &coverage);
        scene_description_free(description);
    }
    assert_true(coverage.done.shared > 0 && coverage.done.simplified > 0);
    assert_true(coverage.done.fused > 0 && coverage.done.bounded > 0 && coverage.done.hidden > 0);
    assert_true(coverage.enclosures > 0 && coverage.cuts > 0 && coverage.removed > 0);
    assert_true(coverage.shadows > 0);
    for (int i = 0; i < 4; i++) {
        assert_true(coverage.kinds[i] > 0);
    }
}

static void every_step_agrees_with_the_built_in_scenes(void **state) {
    (void)state;
    struct coverage coverage = {{0}, 0, 0, 0, {0}, 0};
    for (size_t i = 0; i < builtin_scene_count; i++) {
        struct scene_error error = {""};
        struct scene_description *description = load_scene(builtin_scenes[i].name, &error);
        assert_non_null(description);
        assert_validates(description, builtin_scenes[i].name, &coverage);
        scene_description_free(description);
    }
}

/* ---- Damage --------------------------------------------------------------------------------- */

/* One scene that has something of each table: solids that lie within one another, apart and in each
 * other's way. */
#define SMALL_BALL "{ ball = { centre = (0.1, 0, 0); radius = 0.3; }; }"
#define PRISM      "{ polyhedron = { " PLANES "}; translate = (3, 0, 0); }"
#define WAIST                                                                                      \
    "{ hyperboloid = { from = (0, 3, -1); to = (0.3, 3.2, 1); radius = 1; waist = 0.3; }; }"
#define ABOUT_EYE "{ ball = { centre = (3.1, -7.3, 5); radius = 1; }; }"
static const char damaged_objects[] =
    BOARD ",\n" OBJECT("glass", LESS(BOX ", " SMALL_BALL)) ",\n" OBJECT(
        "smoke", PRISM) ",\n" OBJECT("board", WAIST) ",\n" OBJECT("glass", ABOUT_EYE);

/* Takes a primitive out of a set, or puts it in where it is not there. */
static void toggle(struct compiled_set *set, uint32_t primitive) {
    const struct compiled_set old = *set;
    const bool was_there = compiled_set_has(set, primitive);
    *set = (struct compiled_set){NULL, 0};
    for (uint32_t i = 0; i < old.count; i++) {
        if (old.members[i] != primitive) {
            assert_true(compiled_set_include(set, old.members[i]));
        }
    }
    assert_true(was_there || compiled_set_include(set, primitive));
    free(old.members);
}

static uint32_t find_kind(const struct compiled_scene *scene, enum primitive_kind kind) {
    for (uint32_t i = 0; i < scene->primitive_count; i++) {
        if (scene->primitives[i].kind == kind) {
            return i;
        }
    }
    fail_msg("no primitive of kind %d", kind);
    return 0;
}

static void program(struct compiled_scene *scene) {
    scene->programs[scene->objects[2].program + 2] = COMPILED_UNION;
}
static void broken_program(struct compiled_scene *scene) {
    scene->objects[2].length--;
}
static void next_program(struct compiled_scene *scene) {
    scene->objects[1].program++;
}
static void box_side(struct compiled_scene *scene) {
    scene->boxes[1].maximum[1] += 1e-5;
}
static void radius(struct compiled_scene *scene) {
    scene->balls[0].radius -= 1e-5;
}
static void plane(struct compiled_scene *scene) {
    scene->planes[2].offset += 1e-5;
}
static void cut(struct compiled_scene *scene) {
    scene->quadrics[0].cuts = 0;
}
static void material(struct compiled_scene *scene) {
    scene->objects[2].material = scene->objects[1].material;
}
static void name(struct compiled_scene *scene) {
    scene->object_names[2][0] = 'A';
}
static void object_bounds(struct compiled_scene *scene) {
    scene->objects[2].bounds.low[0] += 0.1;
}
static void polyhedron_low(struct compiled_scene *scene) {
    scene->polyhedra[0].low[2] += 0.1;
}
static void quadric_reach(struct compiled_scene *scene) {
    scene->quadrics[0].reach *= 0.99;
}
static void surface_of_box(struct compiled_scene *scene) {
    scene->boxes[1].surface[3]++;
}
static void surface_of_ball(struct compiled_scene *scene) {
    scene->balls[0].surface++;
}
static void surface_out_of_all(struct compiled_scene *scene) {
    scene->planes[0].surface = scene->surface_count;
}
static void surface_set(struct compiled_scene *scene) {
    toggle(&scene->surfaces[scene->balls[0].surface], 0);
}
static void left_for_good(struct compiled_scene *scene) {
    scene->quadrics[0].left_for_good = true;
}
static void hidden_by(struct compiled_scene *scene) {
    /* The ball lies in the box: a ray in the box meets it. */
    compiled_set_include(&scene->hidden_by[find_kind(scene, PRIMITIVE_BALL)], 1);
}
static void hidden_by_itself(struct compiled_scene *scene) {
    compiled_set_include(&scene->hidden_by[1], 1);
}
static void enclosure(struct compiled_scene *scene) {
    scene->primitives[find_kind(scene, PRIMITIVE_BALL)].enclosure = 0;
}
static void no_such_enclosure(struct compiled_scene *scene) {
    scene->primitives[1].enclosure = scene->primitive_count;
}
static void shadow_test(struct compiled_scene *scene) {
    scene->objects[3].in_shadow_test = false;
}
static void shadow_primitives(struct compiled_scene *scene) {
    compiled_set_clear(&scene->shadow_primitives);
}
static void shadows_of_a_light(struct compiled_scene *scene) {
    scene->lights[0].casts_shadows = false;
}
static void uses(struct compiled_scene *scene) {
    toggle(&scene->objects[2].uses, 0);
}
static void eye_inside(struct compiled_scene *scene) {
    toggle(&scene->camera.inside, 0);
}
static void eye_object(struct compiled_scene *scene) {
    scene->camera.object = 1;
}
static void eye_place(struct compiled_scene *scene) {
    scene->camera.eye[0] += 1e-6;
}
static void frame(struct compiled_scene *scene) {
    scene->frames[0].axis[0][0] += 1e-3;
}

static const struct damage {
    void (*damage)(struct compiled_scene *scene);
    const char *said; /* of the first fault */
} damages[] = {
    {program, "'a glass' of line 13, material 'glass'"},
    {broken_program, "a broken program"},
    {next_program, "'a board'"},
    {box_side, "the tables have a point in it that is not"},
    {radius, "the tables have a point in it that is not"},
    {plane, "'a smoke'"},
    {cut, "'a board'"},
    {material, "is none of the file's"},
    {name, "is none of the file's"},
    {object_bounds, "out of its bounds"},
    {polyhedron_low, "the polyhedron of line"},
    {quadric_reach, "goes beyond the ball about it"},
    {surface_of_box, "surface"},
    {surface_of_ball, "surface"},
    {surface_out_of_all, "has no surface"},
    {surface_set, "does not bound"},
    {left_for_good, "a ray comes back"},
    {hidden_by, "is said to hide"},
    {hidden_by_itself, "is said to hide"},
    {enclosure, "said to enclose"},
    {no_such_enclosure, "said to enclose"},
    {shadow_test, "what keeps it off here is not tried"},
    {shadow_primitives, "what keeps it off here is not tried"},
    {shadows_of_a_light, "light 1: what keeps it off"},
    {uses, "uses other solids"},
    {eye_inside, "the tables have the eye in the solid of line 12"},
    {eye_object, "the tables have the eye in object 1"},
    {eye_place, "the eye is elsewhere"},
    {frame, "right angles"},
};

static void whatever_is_damaged_is_found(void **state) {
    (void)state;
    struct scene_description *description = read_objects(damaged_objects);
    struct validation validation;
    for (size_t i = 0; i < sizeof damages / sizeof damages[0]; i++) {
        struct compiled_scene *scene = compile_description(description);
        assert_true(compiled_scene_agrees(description, scene, STEP_ENCLOSURES, &validation));
        damages[i].damage(scene);
        if (compiled_scene_agrees(description, scene, STEP_ENCLOSURES, &validation) ||
            strstr(validation.first, damages[i].said) == NULL) {
            fail_msg("damage %zu: %u faults, \"%s\" without \"%s\"", i, validation.faults,
                     validation.first, damages[i].said);
        }
        compiled_scene_free(scene);
    }
    scene_description_free(description);
}

/* Places are the file's: far away from its origin they must be too. */
static void a_fault_is_told_with_its_place_in_the_file(void **state) {
    (void)state;
    struct scene_description *description = read_objects(
        OBJECT("glass", "{ ball = { centre = (-1200, 2900, -1900); radius = 500; }; }"));
    struct compiled_scene *scene = compile_description(description);
    struct validation validation;
    scene->balls[0].radius /= 2;
    assert_false(compiled_scene_agrees(description, scene, STEP_ENCLOSURES, &validation));
    double place[3];
    const char *at = strstr(validation.first, ", at (");
    assert_non_null(at);
    assert_int_equal(sscanf(at, ", at (%lf, %lf, %lf)", &place[0], &place[1], &place[2]), 3);
    const double away = hypot(hypot(place[0] + 1200, place[1] - 2900), place[2] + 1900);
    assert_true(away > 249.9 && away < 500.1);
    compiled_scene_free(scene);
    scene_description_free(description);
}

/* A later step's tables are not there yet: nothing is asked of them. */
static void a_step_is_held_to_what_it_claims(void **state) {
    (void)state;
    struct scene_description *description = read_objects(damaged_objects);
    struct compiled_scene *scene = compile_description(description);
    struct validation validation;
    enclosure(scene);
    assert_true(compiled_scene_agrees(description, scene, STEP_SHADOWS, &validation));
    shadow_primitives(scene);
    assert_true(compiled_scene_agrees(description, scene, STEP_VIEW, &validation));
    eye_object(scene);
    assert_true(compiled_scene_agrees(description, scene, STEP_COMPACT, &validation));
    surface_set(scene);
    assert_true(compiled_scene_agrees(description, scene, STEP_BOUND, &validation));
    compiled_scene_free(scene);
    scene_description_free(description);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_step_agrees_with_the_scene),
        cmocka_unit_test(every_step_agrees_with_the_built_in_scenes),
        cmocka_unit_test(whatever_is_damaged_is_found),
        cmocka_unit_test(a_fault_is_told_with_its_place_in_the_file),
        cmocka_unit_test(a_step_is_held_to_what_it_claims),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
