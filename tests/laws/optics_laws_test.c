/* SPDX-License-Identifier: MIT */
/* Laws of light at boundaries, read from the trees of rays of small scenes. */
#include "scene_fixture.h"

/* One pixel that looks straight or aslant at slabs of glass; nothing shines of itself. */
static const char head[] =
    "version = 1; size = [1, 1]; depth = %d; threshold = 0.0; background = [%d, %d, %d];\n"
    "camera = { eye = (%.17g, 0, %.17g); look_at = (0, 0, 0); up = (0, 1, 0); field_of_view = 1; "
    "};\n"
    "materials = { %s };\nobjects = ( %s );\n";

enum { NODES_MOST = 4096 };

struct collected {
    struct observed_node nodes[NODES_MOST];
    struct observed_end ends[NODES_MOST];
    size_t node_count, end_count;
    double intensity[3];
};

static void collect_node(void *context, const struct observed_node *node) {
    struct collected *tree = context;
    assert_true(tree->node_count < NODES_MOST);
    tree->nodes[tree->node_count++] = *node;
}

static void collect_end(void *context, const struct observed_end *end) {
    struct collected *tree = context;
    assert_true(tree->end_count < NODES_MOST);
    tree->ends[tree->end_count++] = *end;
}

static void grow(struct collected *tree, const char *text, const char *arithmetic, unsigned x,
                 unsigned y) {
    struct loaded_scene loaded = load_text(text, arithmetic);
    struct render_counts counts = {0};
    const struct pixel_observer observer = {tree, collect_node, collect_end};
    tree->node_count = tree->end_count = 0;
    loaded.arithmetic->pixel(loaded.scene, (uint16_t)x, (uint16_t)y, tree->intensity, &counts,
                             &observer);
    assert_int_equal(counts.leaked_rays, 0);
    unload(&loaded);
}

/* Looks at the scene from an angle (degrees from the z axis, in the x z plane). */
static void look(struct collected *tree, const char *arithmetic, double angle, int depth, int light,
                 const char *materials, const char *objects) {
    char text[8192];
    double radians = angle * acos(-1) / 180;
    snprintf(text, sizeof text, head, depth, light, light, light, 20 * sin(radians),
             20 * cos(radians), materials, objects);
    grow(tree, text, arithmetic, 0, 0);
}

static const char *const arithmetics[] = {"fx", "f32", "f64", "f128"};
static const double noise[] = {1e-7, 1e-5, 1e-12, 1e-15};
enum { ARITHMETICS = 4 };

#define SLAB                                                                                       \
    "{ material = \"glass\"; solid = { box = { min = (-9, -9, -1); max = (9, 9, 0); }; }; }"

static const struct observed_node *child(const struct collected *tree, uint32_t parent,
                                         enum observed_kind kind) {
    for (size_t i = 0; i < tree->node_count; i++) {
        if (tree->nodes[i].parent == parent && tree->nodes[i].kind == kind) {
            return &tree->nodes[i];
        }
    }
    return NULL;
}

static const struct observed_end *ended(const struct collected *tree, uint32_t parent,
                                        enum observed_kind kind) {
    for (size_t i = 0; i < tree->end_count; i++) {
        if (tree->ends[i].parent == parent && tree->ends[i].kind == kind) {
            return &tree->ends[i];
        }
    }
    return NULL;
}

/* Ks = ((n - 1) / (n + 1))^2 at normal incidence, from either side. */
static void reflectance_at_normal_incidence_is_that_of_the_formula(void **state) {
    (void)state;
    static const double indices[] = {0.75, 1.0001, 1.33, 1.5, 2, 2.5, 4};
    static struct collected tree;
    for (size_t i = 0; i < sizeof indices / sizeof indices[0]; i++) {
        for (int j = 0; j < ARITHMETICS; j++) {
            double n = indices[i];
            double expected = (n - 1) * (n - 1) / ((n + 1) * (n + 1));
            char material[200];
            snprintf(material, sizeof material, "glass = { colour = [0, 0, 0]; ior = %.17g; };", n);
            look(&tree, arithmetics[j], 0, 3, 0, material, SLAB);
            const struct observed_end *outside = ended(&tree, 1, OBSERVED_REFLECTED);
            const struct observed_node *inside = child(&tree, 1, OBSERVED_REFRACTED);
            assert_non_null(outside);
            assert_non_null(inside);
            assert_true(fabs(outside->weight[0] - expected) < noise[j]);
            const struct observed_node *echo = child(&tree, inside->number, OBSERVED_REFLECTED);
            assert_non_null(echo);
            assert_true(fabs(echo->weight[0] - expected * (1 - expected)) < 2 * noise[j]);
        }
    }
}

/* The angle behind a boundary, from the two places where the ray meets the slab. */
static void snells_law_holds_both_ways(void **state) {
    (void)state;
    static const double indices[] = {0.75, 1.33, 1.5, 2.5, 4};
    static struct collected tree;
    for (size_t i = 0; i < sizeof indices / sizeof indices[0]; i++) {
        for (double angle = 1; angle < 80; angle += 13) {
            for (int j = 0; j < ARITHMETICS; j++) {
                double n = indices[i], sine = sin(angle * acos(-1) / 180) / n;
                char material[200];
                snprintf(material, sizeof material, "glass = { colour = [0, 0, 0]; ior = %.17g; };",
                         n);
                look(&tree, arithmetics[j], angle, 3, 100, material, SLAB);
                const struct observed_node *far = child(&tree, 1, OBSERVED_REFRACTED);
                if (sine >= 1) {
                    assert_null(far);
                    assert_true(ended(&tree, 1, OBSERVED_REFRACTED)->why == OBSERVED_NOTHING);
                    continue;
                }
                assert_non_null(far);
                const double *from = tree.nodes[0].where, *to = far->where;
                double across = (from[0] - to[0]) / far->distance;
                assert_true(fabs(fabs(across) - sine) < 1e3 * noise[j]);
                /* and back again: the ray leaves at the angle at which it came, so that all of the
                 * background's 100 levels arrive, less what two surfaces reflect away */
                const struct observed_end *out = ended(&tree, far->number, OBSERVED_REFRACTED);
                assert_non_null(out);
                assert_int_equal(out->why, OBSERVED_LEFT);
                double ks = ended(&tree, 1, OBSERVED_REFLECTED)->weight[0];
                assert_true(fabs(out->weight[0] - (1 - ks) * (1 - ks)) < 100 * noise[j]);
            }
        }
    }
}

/* No node hands on more than it got, and all leaves together no more than the eye's 1. */
static void weights_never_grow(void **state) {
    (void)state;
    struct scene_error error;
    static struct collected tree;
    for (int j = 0; j < 3; j++) {
        struct scene_description *description = load_scene("fig4b", &error);
        assert_non_null(description);
        description->threshold = 1.0 / 512;
        struct loaded_scene loaded = load_description(description, arithmetics[j]);
        uint64_t seed = 4711;
        for (int pixel = 0; pixel < 40; pixel++) {
            const struct pixel_observer observer = {&tree, collect_node, collect_end};
            struct render_counts counts = {0};
            static double handed_on[NODES_MOST + 1];
            double leaves = 0;
            tree.node_count = tree.end_count = 0;
            memset(handed_on, 0, sizeof handed_on);
            loaded.arithmetic->pixel(loaded.scene, (uint16_t)(next_random(&seed) % 640),
                                     (uint16_t)(next_random(&seed) % 400), tree.intensity, &counts,
                                     &observer);
            for (size_t i = 0; i < tree.node_count; i++) {
                handed_on[tree.nodes[i].parent] += tree.nodes[i].weight[0];
            }
            for (size_t i = 0; i < tree.end_count; i++) {
                handed_on[tree.ends[i].parent] += tree.ends[i].weight[0];
                leaves += tree.ends[i].weight[0];
            }
            assert_true(handed_on[0] <= 1);
            for (size_t i = 0; i < tree.node_count; i++) {
                assert_true(handed_on[i + 1] <= tree.nodes[i].weight[0] + 10 * noise[j]);
            }
            assert_true(leaves <= 1 + 1000 * noise[j]);
        }
        unload(&loaded);
        scene_description_free(description);
    }
}

/* Z filters of transmittance T pass T^Z (Bouguer). */
static void a_stack_of_filters_passes_the_power_of_one(void **state) {
    (void)state;
    static struct collected tree;
    for (int filters = 1; filters <= 6; filters++) {
        char objects[2048] = "";
        for (int i = 0; i < filters; i++) {
            char slab[200];
            snprintf(slab, sizeof slab,
                     "%s{ material = \"glass\"; solid = { box = { min = (-9, -9, %d.0); max = (9, "
                     "9, %d.25); }; }; }",
                     i ? ", " : "", i, i);
            strcat(objects, slab);
        }
        for (int j = 0; j < ARITHMETICS; j++) {
            char text[8192];
            snprintf(text, sizeof text,
                     "version = 1; size = [1, 1]; depth = 20; threshold = 0.0; mixing = \"filter\";"
                     "background = [200, 200, 200]; camera = { eye = (0, 0, 20); look_at = (0, 0, "
                     "0); up = (0, 1, 0); field_of_view = 1; };"
                     "materials = { glass = { colour = (51, 127.5, 255); ior = 1.0; }; };"
                     "objects = ( %s );",
                     objects);
            grow(&tree, text, arithmetics[j], 0, 0);
            const double transmittance[3] = {0.2, 0.5, 1};
            for (int k = 0; k < 3; k++) {
                assert_true(fabs(tree.intensity[k] - 200 * pow(transmittance[k], filters)) <
                            1e-3 + 1e4 * noise[j]);
            }
        }
    }
}

/* exp(-alpha x) of the way x in the medium, by channel. */
static void a_slab_absorbs_exponentially(void **state) {
    (void)state;
    static struct collected tree;
    static const double alphas[] = {0, 0.01, 0.3, 1, 3, 12};
    for (size_t i = 0; i < sizeof alphas / sizeof alphas[0]; i++) {
        for (double angle = 0; angle < 70; angle += 23) {
            for (int j = 0; j < ARITHMETICS; j++) {
                char material[300];
                snprintf(
                    material, sizeof material,
                    "glass = { colour = [0, 0, 0]; ior = 1.0; absorption = (%.17g, %.17g, 0.0);"
                    " };",
                    alphas[i], alphas[i] / 2);
                look(&tree, arithmetics[j], angle, 5, 200, material, SLAB);
                double way = 1 / cos(angle * acos(-1) / 180);
                assert_true(fabs(tree.intensity[0] - 200 * exp(-alphas[i] * way)) <
                            1e-3 + 1e4 * noise[j]);
                assert_true(fabs(tree.intensity[1] - 200 * exp(-alphas[i] / 2 * way)) <
                            1e-3 + 1e4 * noise[j]);
                assert_true(fabs(tree.intensity[2] - 200) < 1e-3 + 1e4 * noise[j]);
            }
        }
    }
}

/* Beyond the critical angle everything is reflected, and nothing goes on. */
static void total_internal_reflection_loses_nothing(void **state) {
    (void)state;
    static struct collected tree;
    /* From within the glass: the eye is inside. asin(1 / 1.5) is 41.8 degrees. */
    static const char text[] =
        "version = 1; size = [1, 1]; depth = 1; threshold = 0.0; background = [80, 80, 80];"
        "camera = { eye = (0, 0, -5); look_at = (%.17g, 0, 0); up = (0, 1, 0); field_of_view = 1; "
        "};"
        "materials = { glass = { colour = [0, 0, 0]; ior = 1.5; }; };"
        "objects = ( { material = \"glass\"; solid = { box = { min = (-50, -50, -50); max = (50, "
        "50, "
        "0); }; }; } );";
    for (double angle = 35; angle < 80; angle += 1) {
        for (int j = 0; j < ARITHMETICS; j++) {
            char scene[2048];
            snprintf(scene, sizeof scene, text, 5 * tan(angle * acos(-1) / 180));
            grow(&tree, scene, arithmetics[j], 0, 0);
            assert_int_equal(tree.nodes[0].before, 1);
            const struct observed_end *through = ended(&tree, 1, OBSERVED_REFRACTED);
            const struct observed_node *mirrored = child(&tree, 1, OBSERVED_REFLECTED);
            assert_non_null(through);
            assert_non_null(mirrored);
            if (angle > 42) {
                assert_int_equal(through->why, OBSERVED_NOTHING);
                assert_true(fabs(mirrored->weight[0] - 1) <= 0);
            } else if (angle < 41.5) {
                assert_int_equal(through->why, OBSERVED_LEFT);
                assert_true(mirrored->weight[0] < 1);
            }
        }
    }
}

/* Table 1 (c) with three equal indices is (b), bit for bit. */
static void equal_wavelengths_give_the_picture_without_dispersion(void **state) {
    (void)state;
    struct scene_error error;
    for (int j = 0; j < ARITHMETICS; j++) {
        struct scene_description *description = load_scene("fig4b", &error);
        assert_non_null(description);
        struct loaded_scene plain = load_description(description, arithmetics[j]);
        description->model = MODEL_WAVELENGTH;
        struct loaded_scene waves = load_description(description, arithmetics[j]);
        struct render_counts counts = {0};
        for (int x = 5; x < 640; x += 61) {
            for (int y = 3; y < 400; y += 53) {
                double a[3], b[3];
                plain.arithmetic->pixel(plain.scene, (uint16_t)x, (uint16_t)y, a, &counts, NULL);
                waves.arithmetic->pixel(waves.scene, (uint16_t)x, (uint16_t)y, b, &counts, NULL);
                assert_memory_equal(a, b, sizeof a);
            }
        }
        unload(&plain);
        unload(&waves);
        scene_description_free(description);
    }
}

/* Model (a): straight on, tau at each boundary, no reflection. */
static void the_simple_model_goes_straight_and_weighs_tau(void **state) {
    (void)state;
    static struct collected tree;
    for (int j = 0; j < ARITHMETICS; j++) {
        grow(&tree,
             "version = 1; size = [1, 1]; depth = 9; threshold = 0.0; background = [100, 100, 100];"
             "model = \"simple\"; camera = { eye = (7, 0, 9); look_at = (0, 0, 0); up = (0, 1, 0); "
             "field_of_view = 1; };"
             "materials = { glass = { colour = [0, 0, 0]; ior = 2.0; transmittance = 0.75; }; };"
             "objects = ( " SLAB " );",
             arithmetics[j], 0, 0);
        assert_int_equal(tree.node_count, 2);
        assert_true(fabs(tree.intensity[0] - 100 * 0.75 * 0.75) < 1e-3);
    }
}

/* Table 1 (c): each primary is refracted by its own index, and weighed by its own factors. */
static void each_primary_has_its_own_index_and_factors(void **state) {
    (void)state;
    static struct collected tree;
    static const double n[3] = {1.4, 1.5, 1.7}, factor[3] = {0.5, 0.75, 1};
    for (int j = 0; j < ARITHMETICS; j++) {
        grow(
            &tree,
            "version = 1; size = [1, 1]; depth = 3; threshold = 0.0; model = \"wavelength\";"
            "camera = { eye = (8, 0, 6); look_at = (0, 0, 0); up = (0, 1, 0); field_of_view = 1; };"
            "materials = { glass = { colour = [0, 0, 0]; ior = [1.4, 1.5, 1.7];"
            " transmittance_factors = (0.5, 0.75, 1.0); }; }; objects = ( " SLAB " );",
            arithmetics[j], 0, 0);
        const struct observed_end *mirrored = ended(&tree, 1, OBSERVED_REFLECTED);
        assert_non_null(mirrored);
        for (int i = 0; i < 3; i++) {
            const struct observed_node *through = NULL;
            for (size_t k = 0; k < tree.node_count; k++) {
                if (tree.nodes[k].parent == 1 && tree.nodes[k].channel == i) {
                    through = &tree.nodes[k];
                }
            }
            assert_non_null(through);
            double across = (tree.nodes[0].where[0] - through->where[0]) / through->distance;
            assert_true(fabs(across - 0.8 / n[i]) < 1e3 * noise[j]);
            double kt = (1 - mirrored->weight[i]) * factor[i];
            for (int channel = 0; channel < 3; channel++) {
                double expected = channel == i ? kt : 0;
                assert_true(fabs(through->weight[channel] - expected) < 10 * noise[j]);
            }
        }
    }
}

/* w(theta) at 17 angles; between them straight lines in the cosine. */
static void a_table_of_w_is_linear_in_the_cosine(void **state) {
    (void)state;
    static struct collected tree;
    const double step = acos(-1) / 32;
    for (double angle = 0; angle < 89; angle += 3.7) {
        double table[17], theta = angle * acos(-1) / 180;
        char material[1000] = "glass = { colour = [0, 0, 0]; specular = (";
        for (int i = 0; i < 17; i++) {
            table[i] = 0.1 + 0.05 * ((7 * i) % 17);
            sprintf(material + strlen(material), "%s%.17g", i ? ", " : "", table[i]);
        }
        strcat(material, "); };");
        int i = (int)(theta / step);
        double high = cos(i * step), low = cos((i + 1) * step);
        double share = (cos(theta) - low) / (high - low);
        double expected = table[i] * share + table[i + 1] * (1 - share);
        for (int j = 0; j < ARITHMETICS; j++) {
            look(&tree, arithmetics[j], angle, 3, 100, material, SLAB);
            const struct observed_end *mirrored = ended(&tree, 1, OBSERVED_REFLECTED);
            assert_non_null(mirrored);
            assert_true(fabs(mirrored->weight[0] - expected) < 100 * noise[j]);
        }
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(reflectance_at_normal_incidence_is_that_of_the_formula),
        cmocka_unit_test(snells_law_holds_both_ways),
        cmocka_unit_test(weights_never_grow),
        cmocka_unit_test(a_stack_of_filters_passes_the_power_of_one),
        cmocka_unit_test(a_slab_absorbs_exponentially),
        cmocka_unit_test(total_internal_reflection_loses_nothing),
        cmocka_unit_test(equal_wavelengths_give_the_picture_without_dispersion),
        cmocka_unit_test(each_primary_has_its_own_index_and_factors),
        cmocka_unit_test(a_table_of_w_is_linear_in_the_cosine),
        cmocka_unit_test(the_simple_model_goes_straight_and_weighs_tau),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
