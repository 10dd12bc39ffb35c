/* SPDX-License-Identifier: MIT */
/* The tree of rays of a pixel as an observer sees it: each branch once, and their sum is the pixel.
 */
#include "scene_fixture.h"

#include "render/ray_tree.h"

enum { WIDTH = 16, HEIGHT = 10, PIXELS = WIDTH * HEIGHT };

/* Scenes without absorption, tints and filters: what goes out of a boundary is what came to it. */
static const char *const scenes[] = {"fig3",  "fig4a",         "fig4b",        "fig5", "fig6a",
                                     "fig6b", "fig7-isolated", "fig7-frustum", "figA"};
enum { SCENES = sizeof scenes / sizeof scenes[0] };

/* The ways to end a tree. */
static const struct ending {
    const char *arithmetic;
    bool estimates;
    double error;
    uint32_t budget; /* 0: the scene's own */
    int depth;       /* 0: the scene's own */
} endings[] = {{"fx", false, 0, 0, 0},   {"fx", true, 0, 0, 0},    {"fx", true, 0.5, 0, 0},
               {"f32", true, 1, 0, 0},   {"f64", true, 4, 0, 0},   {"f64", true, 0.25, 0, 0},
               {"fx", false, 0, 50, 0},  {"f64", true, 0, 50, 0},  {"fx", true, 0.5, 9, 0},
               {"f32", true, 1, 200, 0}, {"f64", true, 2, 2000, 0}};
enum { ENDINGS = sizeof endings / sizeof endings[0] };

static struct loaded_scene load_ended(const char *name, const struct ending *ending) {
    struct scene_error error = {""};
    struct render_counts counts = {0};
    struct estimate estimate;
    struct scene_description *description = load_scene(name, &error);
    assert_non_null(description);
    description->width = WIDTH;
    description->height = HEIGHT;
    if (ending->depth > 0) {
        description->depth = ending->depth;
    }
    description->estimates = ending->estimates;
    description->error = ending->error;
    struct loaded_scene loaded = {arithmetic_find(ending->arithmetic),
                                  scene_compile(description, &error), NULL};
    assert_non_null(loaded.compiled);
    scene_description_free(description);
    if (ending->budget > 0) {
        loaded.compiled->ray_budget = ending->budget;
    }
    loaded.scene = loaded.arithmetic->load(loaded.compiled, &error);
    assert_non_null(loaded.scene);
    loaded.arithmetic->learn(loaded.scene, &estimate, &counts);
    return loaded;
}

/* The branches of a node, and the weight that they carry on. */
struct outlet {
    unsigned branches;
    double weight;
};

static void take(struct outlet *outlets, const struct ray_tree *tree, uint32_t parent,
                 const double weight[3]) {
    assert_true(parent <= tree->node_count);
    outlets[parent].branches++;
    outlets[parent].weight += weight[1];
}

/* Fails unless each boundary has given the branches of its materials, and all of its weight. */
static void check_outlets(const struct ray_tree *tree, const struct compiled_scene *scene,
                          const struct outlet *outlets) {
    assert_int_equal(outlets[0].branches, 1);
    assert_true(fabs(outlets[0].weight - 1) < 1e-6);
    for (size_t i = 1; i <= tree->node_count; i++) {
        const struct observed_node *node = &tree->nodes[i - 1];
        bool goes_through = scene->materials[scene->objects[node->before].material].transparent &&
                            scene->materials[scene->objects[node->after].material].transparent;
        assert_int_equal(outlets[i].branches, goes_through ? 2 : 1);
        if (goes_through && fabs(outlets[i].weight - node->weight[1]) > 1e-5) {
            fail_msg("node %zu: %f of %f", i, outlets[i].weight, node->weight[1]);
        }
    }
}

/* Fails unless what is seen of a tree is all of the pixel but the estimate of the pruned branches.
 */
static void check_sum(const struct ray_tree *tree, const struct compiled_scene *scene,
                      bool estimates) {
    for (int j = 0; j < 3; j++) {
        double seen = 0, cut = 0;
        for (size_t i = 0; i < tree->node_count; i++) {
            seen += tree->nodes[i].weight[j] * tree->nodes[i].local[j];
        }
        for (size_t i = 0; i < tree->end_count; i++) {
            const struct observed_end *end = &tree->ends[i];
            seen += end->why == OBSERVED_LEFT ? end->weight[j] * scene->background[j] : 0;
            cut += end->why != OBSERVED_LEFT ? end->weight[j] : 0;
        }
        double noise = 0.01 + 0x1p-15 * (double)(tree->node_count + tree->end_count);
        double rest = tree->intensity[j] - seen;
        if (rest < -noise || rest > (estimates ? 512 * cut : 0) + noise) {
            fail_msg("%f of %f is seen, %f cut", seen, tree->intensity[j], cut);
        }
    }
}

static void check_tree(const struct ray_tree *tree, const struct loaded_scene *loaded,
                       bool estimates) {
    struct outlet *outlets = calloc(tree->node_count + 1, sizeof *outlets);
    assert_non_null(outlets);
    for (size_t i = 0; i < tree->node_count; i++) {
        const struct observed_node *node = &tree->nodes[i];
        assert_int_equal(node->number, i + 1);
        assert_true(node->parent <= i);
        take(outlets, tree, node->parent, node->weight);
    }
    for (size_t i = 0; i < tree->end_count; i++) {
        take(outlets, tree, tree->ends[i].parent, tree->ends[i].weight);
    }
    check_outlets(tree, loaded->compiled, outlets);
    check_sum(tree, loaded->compiled, estimates);
    free(outlets);
}

static void every_branch_is_seen_once_however_a_tree_ends(void **state) {
    unsigned exhausted = 0, nodes = 0;
    (void)state;
    for (int i = 0; i < SCENES * ENDINGS; i++) {
        const struct ending *ending = &endings[i / SCENES];
        struct loaded_scene loaded = load_ended(scenes[i % SCENES], ending);
        for (uint16_t pixel = 0; pixel < PIXELS; pixel += 3) {
            struct ray_tree tree;
            assert_true(ray_tree_grow(&tree, loaded.arithmetic, loaded.scene, pixel % WIDTH,
                                      pixel / WIDTH));
            check_tree(&tree, &loaded, ending->estimates);
            exhausted += tree.counts.exhausted_pixels;
            nodes += (unsigned)tree.node_count;
            ray_tree_free(&tree);
        }
        unload(&loaded);
    }
    print_message("%u nodes; %u pixels ended by their budget\n", nodes, exhausted);
    assert_true(exhausted > 100);
}

/* Returns the rays of a tree: each has led to a node or out of the scene. */
static uint32_t rays_seen(const struct ray_tree *tree) {
    uint32_t rays = (uint32_t)tree->node_count;
    for (size_t i = 0; i < tree->end_count; i++) {
        rays += tree->ends[i].why == OBSERVED_LEFT;
    }
    return rays;
}

static void a_pixel_that_begins_again_is_seen_from_its_last_beginning(void **state) {
    static const struct ending ending = {"f64", true, 0.05, 0, SCENE_ERROR_DEPTH};
    unsigned again = 0;
    (void)state;
    struct loaded_scene loaded = load_ended("fig4a", &ending);
    for (uint16_t pixel = 0; pixel < PIXELS; pixel += 9) {
        struct ray_tree tree;
        assert_true(
            ray_tree_grow(&tree, loaded.arithmetic, loaded.scene, pixel % WIDTH, pixel / WIDTH));
        check_tree(&tree, &loaded, true);
        assert_true(rays_seen(&tree) <= tree.counts.rays);
        again += rays_seen(&tree) < tree.counts.rays;
        ray_tree_free(&tree);
    }
    unload(&loaded);
    print_message("%u pixels began again\n", again);
    assert_true(again > 0);
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_pixel_that_begins_again_is_seen_from_its_last_beginning),
        cmocka_unit_test(every_branch_is_seen_once_however_a_tree_ends),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
