/* SPDX-License-Identifier: MIT */
/* The scene reader: what good files give, field by field, and files changed at random. */
#include <setjmp.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "scene/builtin.h"
#include "scene/description.h"
#include "scene_reader_example.h"

static struct scene_description *read_good(const char *path, const char *text, size_t length) {
    struct scene_error error = {""};
    struct scene_description *scene = scene_description_read(path, text, length, &error);
    assert_string_equal(error.text, "");
    assert_non_null(scene);
    return scene;
}

static struct scene_description *read_example(void) {
    return read_good("example", SCENE_EXAMPLE, strlen(SCENE_EXAMPLE));
}

static void assert_number(double value, double wanted) {
    assert_true(value >= wanted - 1e-12 && value <= wanted + 1e-12);
}

static void assert_vector(const double value[3], double x, double y, double z) {
    assert_number(value[0], x);
    assert_number(value[1], y);
    assert_number(value[2], z);
}

static void reads_the_settings(void **state) {
    (void)state;
    struct scene_description *scene = read_example();
    assert_string_equal(scene->path, "example");
    assert_string_equal(scene->title, "A \"test\"");
    assert_int_equal(scene->model, MODEL_WAVELENGTH);
    assert_int_equal(scene->highlight, HIGHLIGHT_BLINN);
    assert_int_equal(scene->mixing, MIXING_FILTER);
    assert_int_equal(scene->colour, COLOUR_BITS);
    assert_int_equal(scene->colour_bits, 4);
    assert_int_equal(scene->width, 64);
    assert_int_equal(scene->height, 40);
    assert_int_equal(scene->depth, 3);
    assert_number(scene->threshold, 0.25);
    assert_vector(scene->background, 1, 2, 3);
    assert_vector(scene->ambient, 4, 5.5, 6);
    assert_true(scene->has_attenuation);
    assert_number(scene->attenuation_constant, 2);
    assert_int_equal(scene->camera.line, 14);
    assert_vector(scene->camera.eye, 0, -10, 3);
    assert_vector(scene->camera.look_at, 0, 0, 0);
    assert_vector(scene->camera.up, 0, 1, 1);
    assert_number(scene->camera.field_of_view, 30.5);
    assert_int_equal(scene->light_count, 2);
    assert_false(scene->lights[0].parallel);
    assert_vector(scene->lights[0].position, 1, 2, 3);
    assert_vector(scene->lights[0].colour, 300, 200, 100);
    assert_true(scene->lights[1].parallel);
    assert_vector(scene->lights[1].direction, 0, 0, -1);
    assert_vector(scene->lights[1].colour, 255, 255, 255);
    assert_int_equal(scene->lights[1].line, 22);
    scene_description_free(scene);
}

static void reads_the_materials(void **state) {
    (void)state;
    struct scene_description *scene = read_example();
    assert_int_equal(scene->material_count, 3);
    const struct scene_material *glass = &scene->materials[0], *flint = &scene->materials[1],
                                *floor = &scene->materials[2];
    assert_string_equal(glass->name, "glass");
    assert_int_equal(glass->line, 25);
    assert_vector(glass->colour, 0, 32, 64);
    assert_number(glass->ambient, 0.5);
    assert_true(glass->ambient_is_own);
    assert_number(glass->diffuse, 0.3);
    assert_number(glass->specular, 0.2);
    assert_int_equal(glass->gloss, 70);
    assert_true(glass->transparent);
    assert_number(glass->ior, 1.51);
    assert_vector(glass->ior_by_channel, 1.5, 1.51, 1.53);
    assert_number(glass->transmittance, 0.9);
    assert_vector(glass->reflectance_by_channel, 0.75, 0.75, 0.75);
    assert_vector(glass->transmittance_by_channel, 1, 0.5, 0);
    assert_vector(glass->absorption, 0.125, 0.125, 0.125);
    assert_true(glass->casts_shadow);
    assert_false(glass->pattern.present);
    assert_true(flint->transparent);
    assert_false(flint->casts_shadow);
    assert_number(flint->ior, 1.54);
    assert_vector(flint->ior_by_channel, 1.5 + 0.0121 / 0.4225, 1.54, 1.5 + 0.0121 / 0.2025);
    assert_number(flint->transmittance, 1 - (0.54 / 2.54) * (0.54 / 2.54));
    assert_int_equal(flint->gloss, 32);
    assert_false(floor->transparent);
    assert_true(floor->casts_shadow);
    assert_number(floor->ior, 1);
    assert_true(floor->has_specular_table);
    assert_number(floor->specular_table[1], 0.1);
    assert_number(floor->specular_table[16], 1);
    assert_true(floor->pattern.present);
    assert_vector(floor->pattern.size, 0.5, 0, 2);
    assert_vector(floor->pattern.origin, 1, 2, 3);
    assert_vector(floor->pattern.colour, 9, 8, 7);
    scene_description_free(scene);
}

static void reads_parts_and_placements(void **state) {
    (void)state;
    struct scene_description *scene = read_example();
    assert_int_equal(scene->object_count, 3);
    assert_string_equal(scene->objects[0].name, "pairs");
    assert_int_equal(scene->objects[0].line, 56);
    const struct solid_node *pair_use = &scene->nodes[scene->objects[0].solid];
    assert_int_equal(pair_use->kind, SOLID_PART);
    assert_int_equal(pair_use->material, 0);
    const struct solid_node *pair = &scene->nodes[pair_use->children[0]];
    assert_int_equal(pair->kind, SOLID_UNION);
    assert_int_equal(pair->child_count, 2);
    const struct solid_node *second = &scene->nodes[pair->children[1]];
    assert_int_equal(second->kind, SOLID_PART);
    assert_int_equal(second->material, 1);
    assert_int_equal(second->line, 49);
    assert_number(second->placement.m[2][3], 9);
    const struct solid_node *shell = &scene->nodes[second->children[0]];
    assert_int_equal(shell->kind, SOLID_DIFFERENCE);
    assert_int_equal(shell->material, -1);
    assert_int_equal(second->children[0], scene->nodes[pair->children[0]].children[0]);
    const struct solid_node *ball = &scene->nodes[shell->children[0]];
    assert_int_equal(ball->kind, SOLID_BALL);
    assert_vector(ball->a, 1, 2, 3);
    assert_number(ball->radius, 4);

    assert_string_equal(scene->objects[1].name, "");
    const struct solid_node *box = &scene->nodes[scene->objects[1].solid];
    static const double turned[3][4] = {{0, -2, 0, 10}, {2, 0, 0, 20}, {0, 0, 2, 30}};
    assert_int_equal(box->kind, SOLID_BOX);
    assert_int_equal(box->material, 2);
    assert_vector(box->a, -1, -2, -3);
    assert_vector(box->b, 1, 2, 3);
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 4; j++) { /* right angles are exact */
            assert_memory_equal(&box->placement.m[i][j], &turned[i][j], sizeof(double));
        }
    }
    scene_description_free(scene);
}

static void reads_every_leaf(void **state) {
    (void)state;
    struct scene_description *scene = read_example();
    const struct solid_node *all = &scene->nodes[scene->objects[2].solid];
    assert_int_equal(all->kind, SOLID_INTERSECTION);
    assert_int_equal(all->child_count, 9);
    const struct solid_node *leaf[9];
    for (int i = 0; i < 9; i++) {
        assert_true(all->children[i] < scene->objects[2].solid);
        leaf[i] = &scene->nodes[all->children[i]];
        assert_int_equal(leaf[i]->line, 60 + i);
    }
    assert_int_equal(leaf[0]->kind, SOLID_CYLINDER);
    assert_vector(leaf[0]->b, 0, 0, 5);
    assert_number(leaf[0]->radius, 2);
    assert_int_equal(leaf[1]->kind, SOLID_CONE);
    assert_number(leaf[1]->radius, 2);
    assert_number(leaf[1]->radius_b, 1);
    assert_int_equal(leaf[2]->kind, SOLID_ELLIPSOID);
    assert_vector(leaf[2]->a, 1, 1, 1);
    assert_vector(leaf[2]->b, 3, 4, 5);
    assert_int_equal(leaf[3]->kind, SOLID_PARABOLOID);
    assert_number(leaf[3]->radius_b, 2);
    assert_int_equal(leaf[4]->kind, SOLID_HYPERBOLOID);
    assert_int_equal(leaf[4]->sheets, 1);
    assert_number(leaf[4]->radius, 1);
    assert_number(leaf[4]->radius_b, 2);
    assert_int_equal(leaf[5]->kind, SOLID_HYPERBOLOID);
    assert_int_equal(leaf[5]->sheets, 2);
    assert_int_equal(leaf[6]->kind, SOLID_QUADRIC);
    assert_number(leaf[6]->form[0], 1);
    assert_number(leaf[6]->form[9], -10);
    assert_int_equal(leaf[7]->kind, SOLID_HALF_SPACE);
    assert_int_equal(leaf[7]->plane_count, 1);
    assert_vector(leaf[7]->planes[0].normal, 0, 0, 1);
    assert_number(leaf[7]->planes[0].offset, 2.5);
    assert_int_equal(leaf[8]->kind, SOLID_POLYHEDRON);
    assert_int_equal(leaf[8]->plane_count, 4);
    assert_vector(leaf[8]->planes[3].normal, 0.6, 0, 0.8);
    assert_number(leaf[8]->planes[3].offset, 2.2);
    scene_description_free(scene);
}

static void fills_in_the_defaults(void **state) {
    (void)state;
    static const char text[] =
        "\xEF\xBB\xBFversion:1,camera:{eye:[0,-5,0],look_at:[0,0,0]}\r\n"
        "materials:{m:{colour:[0,0,0],transmittance:.5}}objects:({material:\"m\""
        "solid:{ball:{radius:1e0}}})";
    struct scene_description *scene = read_good("small", text, strlen(text));
    assert_string_equal(scene->title, "");
    assert_int_equal(scene->model, MODEL_FRESNEL);
    assert_int_equal(scene->highlight, HIGHLIGHT_PHONG);
    assert_int_equal(scene->mixing, MIXING_ADDITIVE);
    assert_int_equal(scene->colour, COLOUR_FULL);
    assert_int_equal(scene->width, 320);
    assert_int_equal(scene->height, 200);
    assert_int_equal(scene->depth, 10);
    assert_number(scene->threshold, 1.0 / 4096);
    assert_vector(scene->background, 0, 0, 0);
    assert_vector(scene->ambient, 0, 0, 0);
    assert_false(scene->has_attenuation);
    assert_int_equal(scene->light_count, 0);
    assert_vector(scene->camera.up, 0, 0, 1);
    assert_number(scene->camera.field_of_view, 40);
    assert_true(scene->materials[0].transparent);
    assert_number(scene->materials[0].ior, 1);
    assert_number(scene->materials[0].transmittance, 0.5);
    assert_vector(scene->nodes[0].a, 0, 0, 0);
    assert_number(scene->nodes[0].placement.m[1][1], 1);
    scene_description_free(scene);
}

static void reads_every_builtin_scene(void **state) {
    (void)state;
    assert_true(builtin_scene_count > 0);
    for (size_t i = 0; i < builtin_scene_count; i++) {
        const struct builtin_scene *builtin = &builtin_scenes[i];
        struct scene_description *scene = read_good(builtin->name, builtin->text, builtin->length);
        assert_true(scene->title[0] != '\0');
        scene_description_free(scene);
    }
}

/* ---- Files changed at random ---------------------------------------------------------------- */

enum { ROUNDS = 2000, EDITS_MOST = 6, TEXT_MOST = 16384 };

static uint32_t next_random(uint32_t *seed) {
    *seed ^= *seed << 13;
    *seed ^= *seed >> 17;
    *seed ^= *seed << 5;
    return *seed;
}

/* Replaces `removed` bytes at `at` by a piece of text. */
static size_t splice(char *text, size_t length, size_t at, size_t removed, const char *piece,
                     size_t size) {
    removed = removed < length - at ? removed : length - at;
    if (length - removed + size > TEXT_MOST) {
        return length;
    }
    memmove(text + at + size, text + at + removed, length - at - removed);
    memcpy(text + at, piece, size);
    return length - removed + size;
}

static size_t mutate(char *text, size_t length, uint32_t *seed) {
    static const char *const tokens[] = {
        "{",      "}",       "(",     ")",   "[",        "]",    ";",    ",",     "=",
        "\"",     "/*",      "*/",    "//",  "#",        "\n",   "0",    "-1",    "1e400",
        "1.5",    "1e-300",  "nan",   "inf", "@include", "true", "-",    "\\",    "99999999999",
        "box = ", "part = ", "union", "1L",  "0x7F",     "1e9",  "name", "\"a\"", "{ ball"};
    uint32_t choice = next_random(seed) % 6;
    size_t at = length ? next_random(seed) % length : 0;
    char byte = (char)(next_random(seed) >> 8 & 0xFF);
    const char *token = tokens[next_random(seed) % (sizeof tokens / sizeof *tokens)];
    switch (choice) {
    case 0:
        return splice(text, length, at, 1, &byte, 1);
    case 1:
        return splice(text, length, at, 0, &byte, 1);
    case 2:
        return splice(text, length, at, 1 + next_random(seed) % 40, "", 0);
    case 3:
        return splice(text, length, at, strcspn(text + at, " ;,\n"), token, strlen(token));
    case 4: { /* a piece from elsewhere */
        char piece[64];
        size_t from = length ? next_random(seed) % length : 0;
        size_t size = length - from < sizeof piece ? length - from : sizeof piece;
        memcpy(piece, text + from, size);
        return splice(text, length, at, 0, piece, size);
    }
    default:
        return splice(text, length, at, 0, token, strlen(token));
    }
}

/* Either a whole description or an error with a line of the file. */
static void assert_description_or_error(const char *text, size_t length) {
    struct scene_error error = {""};
    struct scene_description *scene = scene_description_read("m", text, length, &error);
    unsigned line = 0, lines = 1;
    int used = 0;
    for (size_t i = 0; i < length; i++) {
        lines += text[i] == '\n';
    }
    if (scene) {
        assert_string_equal(error.text, "");
        assert_true(scene->object_count > 0 && scene->material_count > 0);
        for (size_t i = 0; i < scene->node_count; i++) {
            const struct solid_node *node = &scene->nodes[i];
            assert_true(node->line >= 1 && node->line <= lines);
            for (size_t j = 0; j < node->child_count; j++) {
                assert_true(node->children[j] >= 0 && (size_t)node->children[j] < i);
            }
        }
    } else {
        assert_int_equal(sscanf(error.text, "m:%u:%*u: %n", &line, &used), 1);
        assert_true(used > 0 && strlen(error.text) > (size_t)used + 8);
        assert_true(line >= 1 && line <= lines);
    }
    scene_description_free(scene);
}

static void survives_random_changes(void **state) {
    (void)state;
    uint32_t seed = 19871107;
    for (int round = 0; round < ROUNDS; round++) {
        static char text[TEXT_MOST + 1];
        size_t which = next_random(&seed) % (builtin_scene_count + 1);
        bool example = which == builtin_scene_count;
        size_t length = example ? strlen(SCENE_EXAMPLE) : builtin_scenes[which].length;
        assert_true(length <= TEXT_MOST);
        memcpy(text, example ? SCENE_EXAMPLE : builtin_scenes[which].text, length);
        uint32_t edits = 1 + next_random(&seed) % EDITS_MOST;
        for (uint32_t i = 0; i < edits; i++) {
            text[length] = '\0';
            length = mutate(text, length, &seed);
        }
        char *exact = malloc(length ? length : 1); /* so that reading past its end is seen */
        assert_non_null(exact);
        memcpy(exact, text, length);
        assert_description_or_error(exact, length);
        free(exact);
    }
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(reads_the_settings),         cmocka_unit_test(reads_the_materials),
        cmocka_unit_test(reads_parts_and_placements), cmocka_unit_test(reads_every_leaf),
        cmocka_unit_test(fills_in_the_defaults),      cmocka_unit_test(reads_every_builtin_scene),
        cmocka_unit_test(survives_random_changes),
    };
    return cmocka_run_group_tests_name("scene_reader", tests, NULL, NULL);
}
