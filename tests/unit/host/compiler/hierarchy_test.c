/* SPDX-License-Identifier: MIT */
/* Hierarchies of bounds over random crowds of solids: nothing is left out, and every bound holds
 * what is below it. */
#include <math.h>

#include "compiler/compiler_internal.h"
#include "scene_fixture.h"

enum { CROWDS = 12, SOLIDS_MOST = 300, POINTS = 4000, TEXT_SIZE = 256 * SOLIDS_MOST };

/* A text that grows. */
struct text {
    char *at;
    size_t length;
};

static void say(struct text *text, const char *format, ...) {
    va_list arguments;
    va_start(arguments, format);
    int length = vsnprintf(text->at + text->length, TEXT_SIZE - text->length, format, arguments);
    va_end(arguments);
    assert_in_range(length, 0, (int)(TEXT_SIZE - text->length) - 1);
    text->length += (size_t)length;
}

/* Writes a solid about a place: a ball, a turned box, a cylinder that a half-space cuts, a ball
 * that is used twice, or one with a hole. */
static void say_solid(struct text *text, uint64_t *random) {
    double x = random_between(random, -9, 9), y = random_between(random, -9, 9),
           z = random_between(random, -2, 5);
    double size = random_between(random, 0.2, 0.9);
    switch ((int)random_between(random, 0, 5)) {
    case 0:
        say(text, "{ ball = { centre = [%g, %g, %g]; radius = %g; }; }", x, y, z, size);
        break;
    case 1:
        say(text,
            "{ box = { min = [0, 0, 0]; max = [%g, 1, %g]; }; rotate = [%g, 0, %g]; "
            "translate = [%g, %g, %g]; }",
            size, size, random_between(random, 1, 89), random_between(random, 1, 89), x, y, z);
        break;
    case 2:
        say(text,
            "{ intersection = ({ cylinder = { from = [%g, %g, 0]; to = [%g, %g, 5]; radius = %g; "
            "}; }, { half_space = { normal = [0.2, 0.1, 1]; offset = 4; }; }); }",
            x, y, x, y, size);
        break;
    case 3:
        say(text,
            "{ union = ({ difference = ({ ball = { centre = [%g, %g, %g]; radius = %g; }; }, "
            "{ half_space = { normal = [1, 0.3, 0.2]; offset = %g; }; }); }, "
            "{ intersection = ({ ball = { centre = [%g, %g, %g]; radius = %g; }; }, "
            "{ half_space = { normal = [0.2, 1, 0.3]; offset = %g; }; }); }); }",
            x, y, z, size, x, x, y, z, size, y);
        break;
    default:
        say(text,
            "{ difference = ({ ball = { centre = [%g, %g, %g]; radius = %g; }; }, "
            "{ ball = { centre = [%g, %g, %g]; radius = %g; }; }); }",
            x, y, z, size, x + size / 3, y, z, size / 2);
    }
}

/* Compiles a crowd: objects of one solid, of glass that casts no shadow or of clay, one object that
 * is a union of many, and a floor without an end. */
static struct compiled_scene *compile_crowd(uint64_t seed) {
    static const char head[] =
        "version = 1; size = [8, 5]; depth = 4;\n"
        "camera = { eye = [0, -20, 6]; look_at = [0, 0, 1]; };\n"
        "lights = ( { direction = [0.5, 0.6, -1.0]; } );\n"
        "materials = { clay = { colour = [200, 90, 40]; diffuse = 0.5; }; "
        "glass = { ior = 1.5; colour = [9, 9, 9]; diffuse = 0.1; }; };\n"
        "objects = ({ material = \"clay\"; solid = { half_space = { normal = [0, 0, 1]; "
        "offset = -1; }; }; }";
    struct text text = {malloc(TEXT_SIZE), 0};
    uint64_t random = seed * 77 + 5;
    int count = (int)random_between(&random, 2, SOLIDS_MOST / 2);
    assert_non_null(text.at);
    say(&text, "%s", head);
    for (int i = 0; i < count; i++) {
        say(&text, ",\n{ material = \"%s\"; solid = ", i % 3 == 0 ? "glass" : "clay");
        say_solid(&text, &random);
        say(&text, "; }");
    }
    say(&text, ",\n{ material = \"glass\"; solid = { union = (\n");
    for (int i = 0; i < count; i++) {
        say_solid(&text, &random);
        say(&text, i + 1 < count ? ",\n" : "); }; });\n");
    }
    struct compiled_scene *scene = compile_text(text.at);
    free(text.at);
    return scene;
}

static bool holds_point(const struct compiled_node *node, int bound, const double point[3]) {
    bool holds = true;
    for (int axis = 0; axis < 3; axis++) {
        holds = holds && node->low[axis][bound] <= point[axis] &&
                point[axis] <= node->high[axis][bound];
    }
    return holds;
}

/* What a walk finds below a root. */
struct walk {
    const struct compiled_scene *scene;
    unsigned *met; /* by primitive */
    unsigned levels;
};

/* Bounds are wider than the primitive by more than any arithmetic rounds. */
static void check_margin(const struct compiled_scene *scene, uint32_t primitive,
                         const struct compiled_node *node, int bound) {
    struct bounds bounds = primitive_bounds(scene, primitive);
    for (int axis = 0; axis < 3; axis++) {
        assert_true(node->low[axis][bound] <= bounds.low[axis] - 0x1p-7);
        assert_true(node->high[axis][bound] >= bounds.high[axis] + 0x1p-7);
    }
}

static void walk_node(struct walk *walk, uint32_t number, unsigned level) {
    const struct compiled_node *node = &walk->scene->hierarchy.nodes[number];
    assert_in_range(number, 0, walk->scene->hierarchy.node_count - 1);
    walk->levels = level > walk->levels ? level : walk->levels;
    for (int i = 0; i < NODE_WIDTH; i++) {
        uint32_t child = node->child[i];
        if (child == COMPILED_NODE_NONE) {
            continue;
        }
        if (child >= COMPILED_NODE_PRIMITIVE) {
            walk->met[child - COMPILED_NODE_PRIMITIVE]++;
            check_margin(walk->scene, child - COMPILED_NODE_PRIMITIVE, node, i);
            continue;
        }
        const struct compiled_node *below = &walk->scene->hierarchy.nodes[child];
        for (int j = 0; j < NODE_WIDTH; j++) {
            for (int axis = 0; axis < 3 && below->child[j] != COMPILED_NODE_NONE; axis++) {
                assert_true(node->low[axis][i] <= below->low[axis][j]);
                assert_true(node->high[axis][i] >= below->high[axis][j]);
            }
        }
        walk_node(walk, child, level + 1);
    }
}

static void every_primitive_is_met_once_from_where_it_can_be_entered(void **state) {
    (void)state;
    for (uint64_t seed = 0; seed < CROWDS; seed++) {
        struct compiled_scene *scene = compile_crowd(seed);
        const struct compiled_hierarchy *hierarchy = &scene->hierarchy;
        unsigned *met = calloc(scene->primitive_count, sizeof *met);
        struct walk walk = {scene, met, 0};
        assert_non_null(met);
        for (uint32_t i = 0; i < hierarchy->endless_count; i++) {
            met[hierarchy->endless[i]]++;
        }
        walk_node(&walk, hierarchy->root, 1);
        for (uint32_t i = 0; i < scene->primitive_count; i++) {
            bool is_within = scene->primitives[i].enclosure != COMPILED_ENCLOSURE_NONE;
            assert_int_equal(met[i], is_within ? 0 : 1);
        }
        for (uint32_t i = 0; i < scene->primitive_count; i++) {
            if (hierarchy->leads[i].within != COMPILED_NODE_NONE) {
                memset(met, 0, scene->primitive_count * sizeof *met);
                walk_node(&walk, hierarchy->leads[i].within, 1);
                for (uint32_t j = 0; j < scene->primitive_count; j++) {
                    assert_int_equal(met[j], scene->primitives[j].enclosure == i ? 1 : 0);
                }
            }
        }
        assert_int_equal(walk.levels, hierarchy->levels);
        free(met);
        compiled_scene_free(scene);
    }
}

static void shadow_rays_meet_what_can_keep_off_light_and_nothing_else(void **state) {
    (void)state;
    for (uint64_t seed = 0; seed < CROWDS; seed++) {
        struct compiled_scene *scene = compile_crowd(seed);
        const struct compiled_hierarchy *hierarchy = &scene->hierarchy;
        unsigned *met = calloc(scene->primitive_count, sizeof *met);
        struct walk walk = {scene, met, 0};
        assert_non_null(met);
        for (uint32_t i = 0; i < hierarchy->endless_count; i++) {
            met[hierarchy->endless[i]] += hierarchy->leads[hierarchy->endless[i]].in_shadow_test;
        }
        if (hierarchy->shadow_root != COMPILED_NODE_NONE) {
            walk_node(&walk, hierarchy->shadow_root, 1);
        }
        for (uint32_t i = 0; i < scene->primitive_count; i++) {
            if (hierarchy->leads[i].within_shadow != COMPILED_NODE_NONE) {
                assert_true(hierarchy->leads[i].in_shadow_test);
                walk_node(&walk, hierarchy->leads[i].within_shadow, 1);
            }
        }
        for (uint32_t i = 0; i < scene->primitive_count; i++) {
            assert_int_equal(met[i], compiled_set_has(&scene->shadow_primitives, i));
            assert_int_equal(met[i], hierarchy->leads[i].in_shadow_test);
        }
        free(met);
        compiled_scene_free(scene);
    }
}

/* Tells whether all bounds above a primitive hold a point, below a node. */
static bool is_led_to(const struct compiled_hierarchy *hierarchy, uint32_t number,
                      uint32_t primitive, const double point[3]) {
    const struct compiled_node *node = &hierarchy->nodes[number];
    bool found = false;
    for (int i = 0; i < NODE_WIDTH && !found; i++) {
        uint32_t child = node->child[i];
        found = child != COMPILED_NODE_NONE && holds_point(node, i, point) &&
                (child >= COMPILED_NODE_PRIMITIVE ? child - COMPILED_NODE_PRIMITIVE == primitive
                                                  : is_led_to(hierarchy, child, primitive, point));
    }
    return found;
}

static void bounds_hold_every_point_of_what_is_below_them(void **state) {
    uint64_t random = 4;
    unsigned held = 0;
    (void)state;
    for (uint64_t seed = 0; seed < CROWDS; seed++) {
        struct compiled_scene *scene = compile_crowd(seed);
        const struct compiled_hierarchy *hierarchy = &scene->hierarchy;
        for (int i = 0; i < POINTS; i++) {
            double point[3];
            for (int axis = 0; axis < 3; axis++) {
                point[axis] = random_between(&random, -512, 512);
            }
            for (uint32_t j = 0; j < scene->primitive_count; j++) {
                uint32_t enclosure = scene->primitives[j].enclosure;
                bool is_endless = false;
                for (uint32_t k = 0; k < hierarchy->endless_count; k++) {
                    is_endless = is_endless || hierarchy->endless[k] == j;
                }
                if (!is_endless && compiled_primitive_holds(scene, j, point)) {
                    uint32_t root = enclosure == COMPILED_ENCLOSURE_NONE
                                        ? hierarchy->root
                                        : hierarchy->leads[enclosure].within;
                    assert_true(is_led_to(hierarchy, root, j, point));
                    held++;
                }
            }
        }
        compiled_scene_free(scene);
    }
    assert_true(held > 100);
}

/* Runs a program by its parents, from the places that are true. */
static bool holds_by_parents(const struct compiled_scene *scene,
                             const struct compiled_hierarchy *hierarchy, uint32_t number,
                             const struct compiled_set *inside) {
    const struct compiled_object *object = &scene->objects[number];
    unsigned char *sides = calloc(object->length, 1);
    bool holds = false;
    assert_non_null(sides);
    for (uint32_t i = 0; i < object->length; i++) {
        uint32_t code = scene->programs[object->program + i];
        bool is = code == COMPILED_UNION          ? sides[i] != 0
                  : code == COMPILED_INTERSECTION ? sides[i] == 3
                  : code == COMPILED_DIFFERENCE   ? sides[i] == 1
                                                  : compiled_set_has(inside, code);
        uint32_t parent = hierarchy->parents[object->program + i];
        if (parent == COMPILED_PLACE_ROOT) {
            assert_int_equal(i, object->length - 1);
            holds = is;
        } else if (is) {
            sides[parent / 2] |= (unsigned char)(1u << (parent & 1));
        }
    }
    free(sides);
    return holds;
}

static bool has_key(const struct compiled_hierarchy *hierarchy, uint32_t primitive,
                    uint32_t object) {
    const struct compiled_lead *lead = &hierarchy->leads[primitive];
    unsigned found = 0;
    for (uint32_t i = 0; i < lead->key_count; i++) {
        found += hierarchy->keys[lead->key + i] == object;
    }
    assert_in_range(found, 0, 1);
    return found == 1;
}

static void an_object_that_holds_a_place_has_a_key_there(void **state) {
    uint64_t random = 9;
    unsigned held = 0;
    (void)state;
    for (uint64_t seed = 0; seed < CROWDS; seed++) {
        struct compiled_scene *scene = compile_crowd(seed);
        const struct compiled_hierarchy *hierarchy = &scene->hierarchy;
        for (int i = 0; i < POINTS / 4; i++) {
            struct compiled_set inside = {0};
            double point[3];
            for (int axis = 0; axis < 3; axis++) {
                point[axis] = random_between(&random, -512, 512);
            }
            for (uint32_t j = 0; j < scene->primitive_count; j++) {
                if (compiled_primitive_holds(scene, j, point)) {
                    compiled_set_include(&inside, j);
                }
            }
            for (uint32_t number = 1; number < scene->object_count; number++) {
                bool holds = compiled_object_holds(scene, number, point), keyed = false;
                assert_int_equal(holds, holds_by_parents(scene, hierarchy, number, &inside));
                for (uint32_t j = 0; j < scene->primitive_count && holds; j++) {
                    keyed =
                        keyed || (compiled_set_has(&inside, j) && has_key(hierarchy, j, number));
                }
                assert_int_equal(keyed, holds);
                held += holds;
            }
            compiled_set_clear(&inside);
        }
        compiled_scene_free(scene);
    }
    assert_true(held > 100);
}

/* Tells whether one primitive is the other, or lies within it at any depth. */
static bool lies_below(const struct compiled_scene *scene, uint32_t one, uint32_t other) {
    while (one != COMPILED_ENCLOSURE_NONE && one != other) {
        one = scene->primitives[one].enclosure;
    }
    return one == other;
}

static void a_primitive_stands_apart_if_it_is_apart_from_each_other_one(void **state) {
    unsigned apart = 0, crowded = 0;
    (void)state;
    for (uint64_t seed = 0; seed < CROWDS; seed++) {
        struct compiled_scene *scene = compile_crowd(seed);
        const struct compiled_hierarchy *hierarchy = &scene->hierarchy;
        for (uint32_t i = 0; i < scene->primitive_count; i++) {
            bool expected = true;
            for (uint32_t j = 0; j < hierarchy->endless_count; j++) {
                expected = expected && hierarchy->endless[j] != i;
            }
            for (uint32_t j = 0; j < scene->primitive_count; j++) {
                expected = expected && (lies_below(scene, i, j) || lies_below(scene, j, i) ||
                                        primitives_are_apart(scene, i, j));
            }
            assert_int_equal(hierarchy->leads[i].stands_apart, expected);
            apart += expected;
            crowded += !expected;
        }
        compiled_scene_free(scene);
    }
    assert_true(apart > 20 && crowded > 20);
}

static void uses_name_the_places_of_programs_in_rising_order(void **state) {
    struct compiled_scene *scene = compile_crowd(3);
    const struct compiled_hierarchy *hierarchy = &scene->hierarchy;
    uint32_t leaves = 0;
    (void)state;
    for (uint32_t i = 0; i < scene->primitive_count; i++) {
        const struct compiled_lead *lead = &hierarchy->leads[i];
        for (uint32_t j = 0; j < lead->use_count; j++) {
            const struct compiled_use *use = &hierarchy->uses[lead->use + j];
            const struct compiled_object *object = &scene->objects[use->object];
            assert_int_equal(scene->programs[object->program + use->place], i);
            if (j > 0) {
                assert_true(use[-1].object < use->object ||
                            (use[-1].object == use->object && use[-1].place < use->place));
            }
        }
    }
    for (uint32_t i = 0; i < scene->program_length; i++) {
        leaves += scene->programs[i] < COMPILED_UNION;
    }
    assert_int_equal(hierarchy->use_count, leaves);
    compiled_scene_free(scene);
}

/* Balls that shrink towards a corner divide badly by place: each division takes off one. */
static void a_hierarchy_has_no_more_levels_than_an_image_has_room_for(void **state) {
    struct text text = {malloc(TEXT_SIZE), 0};
    (void)state;
    assert_non_null(text.at);
    say(&text,
        "version = 1; size = [8, 5]; camera = { eye = [0, -3, 1]; look_at = [0, 0, 0]; };\n"
        "lights = ({ direction = [0, 1, -1]; }); materials = { clay = { colour = [9, 9, 9]; }; };\n"
        "objects = (");
    for (int i = 0; i < SOLIDS_MOST; i++) {
        double place = pow(0.97, i);
        say(&text,
            "%s{ material = \"clay\"; solid = { ball = { centre = [%.12g, 0, 0]; radius = %.12g; "
            "}; "
            "}; }",
            i > 0 ? ",\n" : "", place, place / 100);
    }
    say(&text, ");");
    struct compiled_scene *scene = compile_text(text.at);
    assert_in_range(scene->hierarchy.levels, 3, COMPILED_LEVELS_MOST);
    compiled_scene_free(scene);
    free(text.at);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_primitive_is_met_once_from_where_it_can_be_entered),
        cmocka_unit_test(shadow_rays_meet_what_can_keep_off_light_and_nothing_else),
        cmocka_unit_test(bounds_hold_every_point_of_what_is_below_them),
        cmocka_unit_test(an_object_that_holds_a_place_has_a_key_there),
        cmocka_unit_test(a_primitive_stands_apart_if_it_is_apart_from_each_other_one),
        cmocka_unit_test(uses_name_the_places_of_programs_in_rising_order),
        cmocka_unit_test(a_hierarchy_has_no_more_levels_than_an_image_has_room_for),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
