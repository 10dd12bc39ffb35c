/* SPDX-License-Identifier: MIT */
/* Scenes for tests: from texts or built-in names to an arithmetic's tables, and their pixels. */
#ifndef SUPERFRAME_SCENE_FIXTURE_H
#define SUPERFRAME_SCENE_FIXTURE_H

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "render/arithmetic.h"
#include "scene/load.h"

/* A light, and a striped board, glass and an opaque material, for texts of scenes. */
#define SCENE_LIGHT_AND_MATERIALS                                                                  \
    "lights = ( { position = (-4.0, -6.0, 9.0); colour = [255, 255, 255]; } );\n"                  \
    "materials = {\n"                                                                              \
    "  board = { colour = [200, 200, 200]; ambient = 0.3; ambient_is_own = true; diffuse = 0.6;\n" \
    "            pattern = { size = (0.7, 0.7, 0); colour = [40, 20, 60]; }; };\n"                 \
    "  glass = { colour = [10, 30, 20]; ambient = 0.4; ambient_is_own = true; diffuse = 0.3;\n"    \
    "            specular = 0.4; gloss = 50; ior = 1.5; };\n"                                      \
    "  clay = { colour = [200, 90, 40]; ambient = 0.3; ambient_is_own = true; diffuse = 0.7; };\n" \
    "};\n"

/* A scene in one arithmetic. */
struct loaded_scene {
    const struct arithmetic *arithmetic;
    struct compiled_scene *compiled;
    struct scene *scene;
};

/* The description of a text; fails the test where it is refused. */
static inline struct scene_description *read_text(const char *text) {
    struct scene_error error = {""};
    struct scene_description *description =
        scene_description_read("test.scene", text, strlen(text), &error);
    if (!description) {
        fail_msg("refused: %s", error.text);
    }
    return description;
}

static inline struct loaded_scene load_description(const struct scene_description *description,
                                                   const char *arithmetic) {
    struct scene_error error = {""};
    struct loaded_scene loaded = {arithmetic_find(arithmetic), NULL, NULL};
    assert_non_null(loaded.arithmetic);
    loaded.compiled = scene_compile(description, &error);
    if (!loaded.compiled) {
        fail_msg("not compiled: %s", error.text);
    }
    loaded.scene = loaded.arithmetic->load(loaded.compiled, &error);
    if (!loaded.scene) {
        fail_msg("not loaded: %s", error.text);
    }
    return loaded;
}

static inline struct loaded_scene load_text(const char *text, const char *arithmetic) {
    struct scene_description *description = read_text(text);
    struct loaded_scene loaded = load_description(description, arithmetic);
    scene_description_free(description);
    return loaded;
}

static inline void unload(struct loaded_scene *loaded) {
    free(loaded->scene);
    free(loaded->compiled);
}

/* One pixel as the board would get it. */
static inline void pixel_levels(const struct loaded_scene *loaded, unsigned x, unsigned y,
                                int level[3], struct render_counts *counts) {
    double intensity[3];
    loaded->arithmetic->pixel(loaded->scene, (uint16_t)x, (uint16_t)y, intensity, counts, NULL);
    for (int i = 0; i < 3; i++) {
        level[i] = (int)floor(fmin(fmax(intensity[i], 0), 255) + 0.5);
    }
}

/* A generator of test arguments: xorshift64*, never 0. */
static inline uint32_t next_random(uint64_t *state) {
    *state ^= *state >> 12;
    *state ^= *state << 25;
    *state ^= *state >> 27;
    return (uint32_t)((*state * UINT64_C(2685821657736338717)) >> 32);
}

/* Uniform in low .. high. */
static inline double random_between(uint64_t *state, double low, double high) {
    return low + (high - low) * next_random(state) / 4294967295.0;
}

#endif
