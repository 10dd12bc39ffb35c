/* SPDX-License-Identifier: MIT */
/* Small scenes of solids and materials with names, and what is said that they require. */
#ifndef SUPERFRAME_REQUIRED_FIXTURE_H
#define SUPERFRAME_REQUIRED_FIXTURE_H

#include "scene_fixture.h"

#include "compiler/features.h"
#include "compiler/requirements.h"

enum { TEXT_SIZE = 8192 };

/* The eye is at (0, -6, 2) and looks at (0, 0, 1): 0.36 of the way to each side, 0.23 up and down.
 */
#define HEAD                                                                                       \
    "version = 1; size = [24, 15];\n"                                                              \
    "camera = { eye = (0, -6, 2); look_at = (0, 0, 1); field_of_view = 40; };\n"

#define LAMP       "{ position = (-4, -6, 9); }"
#define RED_LAMP   "{ position = (-4, -6, 9); colour = [255, 0, 0]; }"
#define BLACK_LAMP "{ position = (-4, -6, 9); colour = [0, 0, 0]; }"
#define DIM_LAMP   "{ position = (-4, -6, 9); colour = [0, 0, 1]; }"
#define FROM_BACK  "{ direction = (0, 1, 0); }"
#define FROM_FRONT "{ direction = (0, -1, 0); }"

#define CLAY   "clay = { colour = [200, 90, 40]; diffuse = 0.7; };"
#define OWN    "own = { colour = [9, 9, 9]; ambient = 1; ambient_is_own = true; };"
#define GLASS  "glass = { colour = [0, 0, 0]; ior = 1.5; absorption = 0.5; };"
#define GHOST  "ghost = { colour = [0, 0, 0]; ior = 1; absorption = 0.5; };"
#define MIRROR "mirror = { colour = [0, 0, 0]; specular = 0.5; };"
#define DULL   "dull = { colour = [0, 0, 0]; specular = 0.1; };"
#define SPECULAR_TABLE(a)                                                                          \
    "specular = (" a                                                                               \
    ", 0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5, 0.5); };"
#define TABLE(a)  "shiny = { colour = [0, 0, 0]; " SPECULAR_TABLE(a)
#define STRIPED   "pattern = { size = [1, 0, 0]; colour = [9, 9, 8]; }; };"
#define MATERIALS CLAY OWN GLASS GHOST MIRROR DULL

#define OF(material, solid) "{ material = \"" material "\"; solid = " solid "; }"
#define BALL_AT(x, y, z, radius)                                                                   \
    "{ ball = { centre = (" x ", " y ", " z "); radius = " radius "; }; }"
#define BALL                   BALL_AT("0", "0", "1", "1")
#define BESIDE                 BALL_AT("1.5", "1", "1", "0.4")
#define BEHIND                 BALL_AT("0", "-9", "1", "0.5")
#define BOX                    "{ box = { min = (-1, -1, 0); max = (1, 1, 2); }; }"
#define WITHIN                 BALL_AT("0", "0", "1", "0.5")
#define NAMED(material, solid) "{ name = \"it\"; material = \"" material "\"; solid = " solid "; }"

struct scene_case {
    const char *settings, *lights, *materials, *objects, *said;
    bool is_said;
};

static inline struct compiled_scene *compile_case(const struct scene_case *scene,
                                                  char text[TEXT_SIZE]) {
    (void)snprintf(text, TEXT_SIZE,
                   HEAD "%s\nlights = ( %s );\nmaterials = { %s };\nobjects = ( %s );\n",
                   scene->settings, scene->lights, scene->materials, scene->objects);
    struct scene_error error = {""};
    struct scene_description *description = read_text(text);
    struct compiled_scene *compiled = scene_compile(description, &error);
    scene_description_free(description);
    if (compiled == NULL) {
        fail_msg("not compiled: %s\n%s", error.text, text);
    }
    return compiled;
}

static inline void run_cases(const struct scene_case *cases, size_t count) {
    for (size_t i = 0; i < count; i++) {
        char text[TEXT_SIZE], said[TEXT_SIZE];
        struct compiled_scene *compiled = compile_case(&cases[i], text);
        FILE *file = tmpfile();
        assert_non_null(file);
        requirements_print(file, compiled);
        rewind(file);
        said[fread(said, 1, sizeof said - 1, file)] = '\0';
        (void)fclose(file);
        free(compiled);
        if ((strstr(said, cases[i].said) != NULL) != cases[i].is_said) {
            fail_msg("\"%s\" %s:\n%s\nof\n%s", cases[i].said,
                     cases[i].is_said ? "is not said" : "is said", said, text);
        }
    }
}

#define RUN(cases) run_cases(cases, sizeof(cases) / sizeof(cases)[0])

#endif
