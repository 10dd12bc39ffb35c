/* SPDX-License-Identifier: MIT */
/* What is proved of a pixel holds where what is left out is as bright, or as dark, as it can be.
 * The relation `proved` holds the same on scenes that chance has made. */
#include "scene_fixture.h"

enum { WIDTH = 12, HEIGHT = 8, TEXT_SIZE = 4096 };

static const char *const arithmetics[] = {"f64", "f32", "fx"};
enum { ARITHMETICS = sizeof arithmetics / sizeof arithmetics[0] };

/* In levels; the coarsest leaves out as much as there may be. */
static const double errors[] = {64, 8, 1};
enum { ERRORS = sizeof errors / sizeof errors[0] };

static const char head[] =
    "version = 1; size = [12, 8]; depth = %d; threshold = 0.0; background = [%d, %d, %d];\n%s\n"
    "camera = { eye = (0.31, %g, 0.23); look_at = (0.3, 9, 0.2); field_of_view = 30; };\n"
    "materials = { black = { colour = [0, 0, 0]; };\n"
    "  glass = { colour = [0, 0, 0]; ior = 1.5; };\n%s };\nobjects = (\n%s );\n";

struct case_scene {
    const char *name;
    int depth, background;
    const char *light;     /* keys of the scene */
    double eye;            /* y */
    const char *materials; /* besides black and glass */
    const char *objects;
};

/* A closed room, and in it black with a pane of glass before it. The pane shows a little of the
 * room. */
#define ROOM                                                                                       \
    "{ material = \"wall\"; solid = { difference = (\n"                                            \
    "  { box = { min = (-5, -5, -5); max = (5, 5, 5); }; },\n"                                     \
    "  { box = { min = (-4, -4, -4); max = (4, 4, 4); }; } ); }; },\n"
#define PANE                                                                                       \
    "{ material = \"black\"; solid = { box = { min = (-1, 1, -1); max = (1, 2, 1); }; }; },\n"     \
    "{ material = \"glass\"; solid = { box = { min = (-1, 0.9, -1); max = (1, 1, 1); }; }; }"

static const struct case_scene cases[] = {
    {"mirrors that shine", 24, 0, "", -3,
     "wall = { colour = [30, 20, 10]; ambient = 1.0; ambient_is_own = true; specular = 0.9; };",
     ROOM PANE},
    {"perfect mirrors that shine", 24, 0, "", -3,
     "wall = { colour = [30, 20, 10]; ambient = 1.0; ambient_is_own = true; specular = 1; };",
     ROOM PANE},
    {"mirrors by a table", 24, 0, "", -3,
     "wall = { colour = [30, 20, 10]; ambient = 1.0; ambient_is_own = true;\n"
     "  specular = [1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1]; };",
     ROOM PANE},
    {"a highlight", 24, 0,
     "lights = ( { position = (0.3, -1, 0.9); colour = [2000, 1000, 500]; } );", -3,
     "wall = { colour = [0, 0, 0]; specular = 0.5; gloss = 1; };", ROOM PANE},
    {"a lit wall", 24, 0,
     "lights = ( { position = (0.3, -1, 0.9); colour = [2000, 1000, 500]; } );", -3,
     "wall = { colour = [255, 128, 64]; diffuse = 1; };", ROOM PANE},
    {"a pattern", 24, 0, "", -3,
     "wall = { colour = [0, 0, 0]; ambient = 1.0; ambient_is_own = true;\n"
     "  pattern = { size = (8.5, 8.5, 8.5); origin = (4.25, 4.25, 4.25); colour = [250, 200, 90]; "
     "}; };",
     ROOM PANE},
    {"light that fades, next to the eye", 24, 0,
     "attenuation = { constant = 0; };\n"
     "lights = ( { direction = (0, -1, 0.05); colour = [1, 1, 1]; } );",
     0.8999, "wall = { colour = [255, 255, 255]; diffuse = 1; };",
     "{ material = \"wall\"; solid = { box = { min = (-4, 0.8, -4); max = (4, 0.8998, 4); }; }; "
     "},\n"
     "{ material = \"glass\"; solid = { box = { min = (-1, 0.9, -1); max = (1, 1, 1); }; }; }"},
    {"glass that shines before a pane", 24, 0, "", -3,
     "shining = { colour = [90, 60, 30]; ambient = 1.0; ambient_is_own = true; ior = 4; };",
     "{ material = \"shining\"; solid = { box = { min = (-3, -6, -3); max = (3, -4, 3); }; }; "
     "},\n" PANE},
    {"the dark of a medium that absorbs", 1, 60, "", 0.85,

     "back = { colour = [60, 60, 60]; ambient = 1.0; ambient_is_own = true; };\n"
     "ink = { colour = [60, 60, 60]; ambient = 1.0; ambient_is_own = true; ior = 1.0;\n"
     "  absorption = (3, 3, 3); };\n"
     "clear = { colour = [60, 60, 60]; ambient = 1.0; ambient_is_own = true; ior = 1.5; };",
     "{ material = \"ink\"; solid = { box = { min = (-4, -4, -4); max = (4, 4, 4); }; }; },\n"
     "{ material = \"clear\"; solid = { box = { min = (-1, 0.9, -1); max = (1, 1, 1); }; }; },\n"
     "{ material = \"back\"; solid = { box = { min = (-1, 1, -1); max = (1, 2, 1); }; }; }"},
};
enum { CASES = sizeof cases / sizeof cases[0] };

static struct loaded_scene load_case(const struct case_scene *scene, const char *arithmetic,
                                     double error) {
    char text[TEXT_SIZE];
    struct estimate estimate;
    struct render_counts counts = {0};
    (void)snprintf(text, sizeof text, head, scene->depth, scene->background, scene->background,
                   scene->background, scene->light, scene->eye, scene->materials, scene->objects);
    struct scene_description *description = read_text(text);
    description->error = error;
    struct loaded_scene loaded = load_description(description, arithmetic);
    scene_description_free(description);
    loaded.arithmetic->learn(loaded.scene, &estimate, &counts);
    return loaded;
}

static struct render_counts trace(const struct loaded_scene *loaded, int pixel, double level[3]) {
    struct render_counts counts = {0};
    loaded->arithmetic->pixel(loaded->scene, (uint16_t)(pixel % WIDTH), (uint16_t)(pixel / WIDTH),
                              level, &counts, NULL);
    return counts;
}

/* As a screen shows both. */
static double distance(const double a[3], const double b[3]) {
    double most = 0;
    for (int i = 0; i < 3; i++) {
        most = fmax(most, fabs(fmin(a[i], 255) - fmin(b[i], 255)));
    }
    return most;
}

/* Holds all pixels to their proofs; returns how far off the worst is. */
static double hold(const struct case_scene *scene, const char *arithmetic, double error) {
    struct loaded_scene whole = load_case(scene, arithmetic, 0),
                        asked = load_case(scene, arithmetic, error);
    double worst = 0;
    for (int i = 0; i < WIDTH * HEIGHT; i++) {
        double exact[3], found[3];
        const struct render_counts exact_counts = trace(&whole, i, exact),
                                   counts = trace(&asked, i, found);
        assert_int_equal(exact_counts.exhausted_pixels, 0);
        const double rounding = (double)exact_counts.rays / 131072;
        const double off = distance(exact, found), proved = counts.proved_error / 65536.0;
        if (off > proved + rounding + 1e-9) {
            fail_msg("%s, %s, --error %g: pixel %d is off by %g, proved are %g", scene->name,
                     arithmetic, error, i, off, proved);
        }
        worst = fmax(worst, off);
    }
    unload(&asked);
    unload(&whole);
    return worst;
}

/* A coarse error leaves something out in each scene, or the scene says nothing. */
static void no_pixel_is_farther_off_than_is_proved(void **state) {
    (void)state;
    for (int i = 0; i < CASES; i++) {
        double worst = 0;
        for (int j = 0; j < ARITHMETICS * ERRORS; j++) {
            worst = fmax(worst, hold(&cases[i], arithmetics[j / ERRORS], errors[j % ERRORS]));
        }
        print_message("%s: off by %.3f levels at most\n", cases[i].name, worst);
        assert_true(worst > 1);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(no_pixel_is_farther_off_than_is_proved),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
