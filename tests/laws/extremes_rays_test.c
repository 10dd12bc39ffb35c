/* SPDX-License-Identifier: MIT */
/* Extremes of a ray's way: along a face, touching a ball, through a tip, at the critical angle. */
#include "extremes_fixture.h"

static const char plain_head[] =
    "version = 1; size = [%d, %d]; depth = 20; background = [100, 100, 100];\n"
    "camera = { eye = (%.17g, %.17g, %.17g); look_at = (%.17g, %.17g, %.17g); up = (0, 0, 1);"
    " field_of_view = 1; };\n"
    "materials = { red = { colour = [200, 0, 0]; ambient = 1; ambient_is_own = true; };\n"
    "  blue = { colour = [0, 0, 200]; ambient = 1; ambient_is_own = true; };\n"
    "  glass = { colour = [0, 0, 0]; ior = 1.5; }; };\nobjects = ( %s );\n";

static void look(struct picture *picture, const char *arithmetic, int width, int height,
                 const double eye[3], const double look_at[3], const char *objects) {
    char text[EXTREME_TEXT_SIZE];
    snprintf(text, sizeof text, plain_head, width, height, eye[0], eye[1], eye[2], look_at[0],
             look_at[1], look_at[2], objects);
    render_text(picture, text, arithmetic);
}

/* A ray in the plane where a red and a blue solid meet sees one of them, never the world behind; a
 * ray in an outer face's plane, parallel to it, sees the solid or what is behind it, and no more.
 */
static void a_ray_in_a_faces_plane_finds_no_crack(void **state) {
    (void)state;
    static const char *const stacks[] = {
        "{ material = \"red\"; solid = { box = { min = (-1, -1, -1); max = (1, 1, 0); }; }; },"
        "{ material = \"blue\"; solid = { box = { min = (-1, -1, 0); max = (1, 1, 1); }; }; }",
        "{ material = \"red\"; solid = { polyhedron = { planes = ( { normal = (0, 0, 1); offset = "
        "0; "
        "}, { normal = (1, 0, -0.5); offset = 1; }, { normal = (-1, 0, -0.5); offset = 1; },"
        " { normal = (0, 1, -0.5); offset = 1; }, { normal = (0, -1, -0.5); offset = 1; },"
        " { normal = (0, 0, -1); offset = 1; } ); }; }; },"
        "{ material = \"blue\"; solid = { polyhedron = { planes = ( { normal = (0, 0, -1); offset "
        "= "
        "0; }, { normal = (1, 0, 0.5); offset = 1; }, { normal = (-1, 0, 0.5); offset = 1; },"
        " { normal = (0, 1, 0.5); offset = 1; }, { normal = (0, -1, 0.5); offset = 1; },"
        " { normal = (0, 0, 1); offset = 1; } ); }; }; }",
        "{ material = \"red\"; solid = { cylinder = { from = (0, 0, -1); to = (0, 0, 0); radius = "
        "1; "
        "}; }; }, { material = \"blue\"; solid = { cylinder = { from = (0, 0, 0); to = (0, 0, 1);"
        " radius = 1; }; }; }",
        "{ material = \"red\"; solid = { half_space = { normal = (0, 0, 1); offset = 0; }; }; },"
        "{ material = \"blue\"; solid = { box = { min = (-1, -1, 0); max = (1, 1, 1); }; }; }",
    };
    static const double eyes[][3] = {{0.25, -7, 0}, {0.25, 7, 0}, {-7, 0.25, 0}, {7, -0.25, 0}};
    static struct picture seen;
    for (size_t i = 0; i < sizeof stacks / sizeof stacks[0]; i++) {
        for (size_t j = 0; j < sizeof eyes / sizeof eyes[0]; j++) {
            double first[3] = {0, 0, 0};
            for (int k = 0; k < EXTREME_ARITHMETICS; k++) {
                const double ahead[3] = {j < 2 ? 0.25 : 0, j < 2 ? 0 : eyes[j][1], 0};
                look(&seen, extreme_arithmetics[k], 1, 1, eyes[j], ahead, stacks[i]);
                bool red = seen.level[0][0] > 199, blue = seen.level[0][2] > 199;
                if (red == blue) {
                    fail_msg("stack %d from %d in %s: (%g %g %g)", (int)i, (int)j,
                             extreme_arithmetics[k], seen.level[0][0], seen.level[0][1],
                             seen.level[0][2]);
                }
                if (k == 0) {
                    memcpy(first, seen.level[0], sizeof first);
                }
                assert_memory_equal(first, seen.level[0], sizeof first);
            }
        }
    }
}

/* In a glass cube's outer face: nothing is lost, no medium stays open. */
static void a_ray_in_a_glass_face_keeps_its_energy(void **state) {
    (void)state;
    static const char *const solids[] = {
        "{ material = \"glass\"; solid = { box = { min = (-1, -1, -1); max = (1, 1, 0); }; }; }",
        "{ material = \"glass\"; solid = { box = { min = (-1, -1, 0); max = (1, 1, 1); }; }; }",
        "{ material = \"glass\"; solid = { box = { min = (-1, -1, -1); max = (1, 1, 0); };"
        " rotate = (0, 0, 30); }; }",
        "{ material = \"glass\"; solid = { cylinder = { from = (0, 0, -1); to = (0, 0, 0);"
        " radius = 1; }; }; }",
        /* in two faces at once: along an edge */
        "{ material = \"glass\"; solid = { box = { min = (0.25, -1, -1); max = (1, 1, 0); }; }; }",
        "{ material = \"glass\"; solid = { difference = ( { box = { min = (-1, -1, -1);"
        " max = (1, 1, 1); }; }, { box = { min = (-2, -2, 0); max = (2, 2, 2); }; } ); }; }",
    };
    static const double eye[3] = {0.25, -7, 0}, ahead[3] = {0.25, 0, 0};
    static struct picture seen;
    for (size_t i = 0; i < sizeof solids / sizeof solids[0]; i++) {
        for (int k = 0; k < EXTREME_ARITHMETICS; k++) {
            look(&seen, extreme_arithmetics[k], 9, 9, eye, ahead, solids[i]);
            for (int pixel = 0; pixel < 81; pixel++) {
                assert_true(fabs(seen.weight_at_ends[pixel] - 1) < 1e-5);
            }
        }
    }
}

/* The ball fills 0 <= y; its silhouette is at x = 1. The eye looks along y from x = 1 + k steps of
 * the last bit: a hit has a discriminant near 0 on either side. */
static void a_tangent_ray_passes_or_grazes(void **state) {
    (void)state;
    static const double step[EXTREME_ARITHMETICS] = {0x1p-23, 0x1p-23, 0x1p-52};
    static const char *const solids[] = {
        "{ material = \"%s\"; solid = { ball = { radius = 1; }; }; }",
        "{ material = \"%s\"; solid = { ellipsoid = { radii = (1, 2, 0.5); }; }; }",
        ("{ material = \"%s\"; solid = { cylinder = { from = (0, 0, -1); to = (0, 0, 1);"
         " radius = 1; }; }; }"),
    };
    static struct picture seen;
    for (size_t i = 0; i < sizeof solids / sizeof solids[0]; i++) {
        for (int k = 0; k < EXTREME_ARITHMETICS; k++) {
            bool hit_before = true;
            for (int steps = -40; steps <= 40; steps++) {
                char objects[512];
                const double eye[3] = {1 + steps * step[k], -7, 0};
                const double ahead[3] = {1 + steps * step[k], 0, 0};
                snprintf(objects, sizeof objects, solids[i], "red");
                look(&seen, extreme_arithmetics[k], 1, 1, eye, ahead, objects);
                bool hit = seen.level[0][0] > 199;
                assert_true(hit || fabs(seen.level[0][0] - 100) <= 0);
                assert_true(hit_before || !hit); /* once past the silhouette, never again */
                assert_true(hit || steps > -30);
                assert_true(!hit || steps < 30);
                hit_before = hit;
                snprintf(objects, sizeof objects, solids[i], "glass");
                look(&seen, extreme_arithmetics[k], 1, 1, eye, ahead, objects);
                assert_true(fabs(seen.weight_at_ends[0] - 1) < 1e-5);
            }
        }
    }
}

/* Straight at the tip, from above, from the side and from below; the normal is undefined there. */
static void a_ray_through_a_cones_apex_goes_on(void **state) {
    (void)state;
    static const char cone[] =
        "{ material = \"%s\"; solid = { cone = { from = (0, 0, -1); to = (0, 0, 0);"
        " from_radius = 0.5; }; }; }";
    static const double eyes[][3] = {
        {1e-9, 0, 7}, {0, -7, 0}, {3, -4, -5}, {0.001, 0, -7}, {4, 2, 3}};
    static const double apex[3] = {0, 0, 0};
    static struct picture seen;
    for (size_t i = 0; i < sizeof eyes / sizeof eyes[0]; i++) {
        for (int k = 0; k < EXTREME_ARITHMETICS; k++) {
            char objects[512];
            snprintf(objects, sizeof objects, cone, "glass");
            double eye[3] = {eyes[i][0], eyes[i][1], eyes[i][2]};
            if (i == 0) {
                eye[0] = 0.001; /* straight down is along `up` */
            }
            look(&seen, extreme_arithmetics[k], 9, 9, eye, apex, objects);
            for (int pixel = 0; pixel < 81; pixel++) {
                assert_true(fabs(seen.weight_at_ends[pixel] - 1) < 1e-5);
            }
            snprintf(objects, sizeof objects, cone, "red");
            look(&seen, extreme_arithmetics[k], 9, 9, eye, apex, objects);
            for (int pixel = 0; pixel < 81; pixel++) {
                bool hit = seen.level[pixel][0] > 199;
                assert_true(hit || fabs(seen.level[pixel][0] - 100) <= 0);
            }
        }
    }
}

/* Everything of a bright world comes back out of black glass, whatever the way: at grazing
 * incidence, near edges and corners, and after many echoes. */
static void glass_in_a_furnace_cannot_be_seen(void **state) {
    (void)state;
    static const char *const solids[] = {
        "box = { min = (-1, -1, -1); max = (1, 1, 1); }; rotate = (45, 35.264389682754654, 0);",
        "ball = { radius = 1; };",
        "cone = { from = (0, 0, -1); to = (0, 0, 1); from_radius = 1; };",
        "difference = ( { ball = { radius = 1; }; }, { ball = { radius = 0.999; }; } );",
        "hyperboloid = { from = (0, 0, -1); to = (0, 0, 1); radius = 1; gap = 0.5; };",
        "cylinder = { from = (0, 0, -0.001); to = (0, 0, 0.001); radius = 1; };",
    };
    static struct picture seen;
    for (size_t i = 0; i < sizeof solids / sizeof solids[0]; i++) {
        for (int k = 0; k < EXTREME_ARITHMETICS; k++) {
            char text[EXTREME_TEXT_SIZE];
            snprintf(text, sizeof text,
                     "version = 1; size = [33, 25]; depth = 30; background = [100, 100, 100];"
                     "camera = { eye = (2, -5, 2); look_at = (0, 0, 0); field_of_view = 26; };"
                     "materials = { glass = { colour = [0, 0, 0]; ior = 2.5; }; };"
                     "objects = ( { material = \"glass\"; solid = { %s }; } );",
                     solids[i]);
            render_text(&seen, text, extreme_arithmetics[k]);
            for (int pixel = 0; pixel < 33 * 25; pixel++) {
                if (fabs(seen.weight_at_ends[pixel] - 1) > 1e-4) {
                    fail_msg("solid %d in %s, pixel %d %d: %.9g", (int)i, extreme_arithmetics[k],
                             pixel % 33, pixel / 33, seen.weight_at_ends[pixel]);
                }
                assert_true(seen.level[pixel][0] <= 100.01);
            }
        }
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_ray_in_a_faces_plane_finds_no_crack),
        cmocka_unit_test(a_ray_in_a_glass_face_keeps_its_energy),
        cmocka_unit_test(a_tangent_ray_passes_or_grazes),
        cmocka_unit_test(a_ray_through_a_cones_apex_goes_on),
        cmocka_unit_test(glass_in_a_furnace_cannot_be_seen),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
