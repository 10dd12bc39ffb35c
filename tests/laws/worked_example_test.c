/* SPDX-License-Identifier: MIT */
/* The paper's worked example, Fig. 1 and 2 and Eq. (2): five nodes, worked out by hand. */
#include "scene_fixture.h"

/* The ray starts at 45 degrees downwards and stays in the plane y = 0. Three opaque mirrors: the
 * floor at P1 = (1, 0, 0), a ceiling at P2 = (3, 0, 2), the floor again at P3 = (5, 0, 0), which is
 * another object; then a pane of glass, met at P4 = (5.5, 0, 0.5) and left at P5. Light comes from
 * the upper left, at 45 degrees: P2 looks away from it, and two boxes high up keep it off P3 and
 * P5. So I2, I3 and I5 are missing, as in the paper. */
static const char text[] =
    "version = 1; size = [1, 1]; depth = 4; threshold = 0.0; background = [0, 0, 0];\n"
    "camera = { eye = (0, 0, 1); look_at = (1, 0, 0); up = (0, 1, 0); field_of_view = 1; };\n"
    "lights = ( { direction = (1, 0, -1); colour = [255, 255, 255]; } );\n"
    "materials = {\n"
    "  first = { colour = [100, 40, 20]; diffuse = 0.5; specular = 0.9; gloss = 50; };\n"
    "  second = { colour = [90, 90, 90]; diffuse = 0.5; specular = 0.8; gloss = 50; };\n"
    "  third = { colour = [80, 80, 80]; diffuse = 0.5; specular = 0.7; gloss = 50; };\n"
    "  pane = { colour = [30, 200, 60]; diffuse = 0.4; ior = 1.5; };\n"
    "};\n"
    "objects = (\n"
    "  { material = \"first\"; solid = { box = { min = (-1, -3, -1); max = (2, 3, 0); }; }; },\n"
    "  { material = \"second\"; solid = { box = { min = (2.5, -3, 2); max = (3.5, 3, 2.2); }; }; "
    "},\n"
    "  { material = \"third\"; solid = { box = { min = (4, -3, -1); max = (5.4, 3, 0); }; }; },\n"
    "  { material = \"pane\"; solid = { box = { min = (5.5, -3, -1); max = (6.1, 3, 3); }; }; },\n"
    "  { material = \"first\"; solid = { box = { min = (-7.3, -1, 12); max = (-6.9, 1, 12.1); }; "
    "}; },\n"
    "  { material = \"first\"; solid = { box = { min = (-5.4, -1, 12); max = (-4.8, 1, 12.1); }; "
    "}; }\n"
    ");\n";

struct nodes {
    struct observed_node node[16];
    unsigned count;
    unsigned ends;
};

static void keep_node(void *context, const struct observed_node *node) {
    struct nodes *nodes = context;
    assert_true(nodes->count < 16);
    nodes->node[nodes->count++] = *node;
}

static void keep_end(void *context, const struct observed_end *end) {
    struct nodes *nodes = context;
    (void)end;
    nodes->ends++;
}

/* Fresnel's formula in its first form, with sines and tangents: not the one that is rendered. */
static double fresnel(double p, double n) {
    double q = asin(sin(p) / n);
    double s = sin(p - q) / sin(p + q), t = tan(p - q) / tan(p + q);
    return (s * s + t * t) / 2;
}

static void the_five_nodes_sum_as_equation_2_says(void **state) {
    (void)state;
    static const char *const arithmetics[] = {"fx", "f32", "f64", "f128"};
    static const double first[3] = {100, 40, 20}, pane[3] = {30, 200, 60};
    const double cosine = sqrt(0.5);
    const double tau4 = 1 - fresnel(asin(cosine), 1.5);
    for (int i = 0; i < 4; i++) {
        struct loaded_scene loaded = load_text(text, arithmetics[i]);
        struct render_counts counts = {0};
        struct nodes nodes = {{{0}}, 0, 0};
        const struct pixel_observer observer = {&nodes, keep_node, keep_end};
        double intensity[3];
        loaded.arithmetic->pixel(loaded.scene, 0, 0, intensity, &counts, &observer);
        assert_int_equal(nodes.count, 5);
        assert_int_equal(nodes.ends, 3); /* S4 leaves the scene; S5 and T5 are cut */
        for (unsigned j = 0; j < 5; j++) {
            static const enum observed_kind kinds[] = {OBSERVED_EYE, OBSERVED_REFLECTED,
                                                       OBSERVED_REFLECTED, OBSERVED_REFLECTED,
                                                       OBSERVED_REFRACTED};
            assert_int_equal(nodes.node[j].parent, j);
            assert_int_equal(nodes.node[j].kind, kinds[j]);
            assert_int_equal(nodes.node[j].events, j);
        }
        for (int j = 0; j < 3; j++) {
            double i1 = 0.5 * cosine * first[j], i4 = 0.4 * cosine * pane[j];
            double t4 = 0; /* (I5) + rho5 S5 + tau5 T5: nothing there, and N cuts the rest */
            double s4 = 0; /* the background is black */
            double s3 = i4 + (1 - tau4) * s4 + tau4 * t4;
            double s2 = 0.7 * s3; /* (I3) + rho3 S3 */
            double s1 = 0.8 * s2; /* (I2) + rho2 S2 */
            assert_true(fabs(intensity[j] - (i1 + 0.9 * s1)) < 0.01);
            assert_true(fabs(nodes.node[0].local[j] - i1) < 0.01);
            assert_true(fabs(nodes.node[1].local[j]) < 0.01);
            assert_true(fabs(nodes.node[2].local[j]) < 0.01);
            assert_true(fabs(nodes.node[3].local[j] - i4) < 0.01);
            assert_true(fabs(nodes.node[4].local[j]) < 0.01);
            assert_true(fabs(nodes.node[3].weight[j] - 0.9 * 0.8 * 0.7) < 1e-5);
            assert_true(fabs(nodes.node[4].weight[j] - 0.9 * 0.8 * 0.7 * tau4) < 1e-5);
        }
        unload(&loaded);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {cmocka_unit_test(the_five_nodes_sum_as_equation_2_says)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
