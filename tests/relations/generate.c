/* SPDX-License-Identifier: MIT */
/* Random scenes: what there is to see, from where, in which light. */
#include "generate.h"

#include <math.h>
#include <string.h>

#include "chance.h"

/* Every so many seeds: crowds, which take longer than the rest, and light straight from above,
 * whose shadow rays run exactly along an axis. */
enum { CROWD_EVERY = 10, UPRIGHT_EVERY = 7 };

static void set_model(struct syntax *syntax, uint64_t *random) {
    int width = 24 + 8 * (chance_pick(random, 100) / 50) + 16 * (chance_pick(random, 100) / 90);
    syntax->width = width;
    syntax->height = width * 5 / 8;
    static const int depths[] = {0, 1, 2, 3, 4, 5, 6, 8, 10, 10};
    syntax->depth = depths[chance_pick(random, 10)];
    syntax->threshold = chance_is(random, 70) ? 1.0 / 1024 : 1.0 / 4096;
    if (chance_is(random, 8) && syntax->depth <= 5) {
        syntax->threshold = 0;
    }
    int model = chance_pick(random, 10);
    syntax->model = model == 0 ? SYNTAX_SIMPLE : model == 1 ? SYNTAX_WAVELENGTH : SYNTAX_FRESNEL;
    syntax->blinn = chance_is(random, 25);
    syntax->filters = chance_is(random, 10);
    syntax->fades = chance_is(random, 10);
    syntax->fade_constant = 2 + chance_pick(random, 5);
    for (int i = 0; i < 3; i++) {
        syntax->background[i] = chance_pick(random, 200);
        syntax->ambient[i] = chance_pick(random, 128);
    }
}

static void set_camera(struct syntax *syntax, uint64_t *random) {
    double turn = chance_pick(random, 360) * 0.017453292519943295;
    double away = 7 + chance_pick(random, 4);
    syntax->eye[0] = floor(away * cos(turn)) + chance_odd(random, 0, 1);
    syntax->eye[1] = floor(away * sin(turn)) + chance_odd(random, 0, 1);
    syntax->eye[2] = chance_odd(random, 1, 6);
    for (int i = 0; i < 3; i++) {
        syntax->look_at[i] = chance_odd(random, 0, 1) + (i == 2 ? 0.5 : 0);
    }
    syntax->up[0] = syntax->up[1] = 0;
    syntax->up[2] = 1;
    if (chance_is(random, 20)) {
        syntax->up[0] = chance_step(random, -1, 1) / 2;
    }
    syntax->field_of_view = 30 + chance_pick(random, 20);
}

static void set_lights(struct syntax *syntax, uint64_t *random) {
    int count = 1 + chance_pick(random, 3);
    for (int i = 0; i < count; i++) {
        struct syntax_light *light = syntax_add_light(syntax);
        light->parallel = chance_is(random, 40);
        light->place[0] = chance_odd(random, -5, 5);
        light->place[1] = chance_odd(random, -5, 5);
        light->place[2] = chance_odd(random, 4, 9) * (light->parallel ? -1 : 1);
        for (int j = 0; j < 3; j++) {
            int share = chance_pick(random, 192) / (1 + i);
            double colour = 64 + share;
            light->colour[j] = syntax->fades ? 10 * colour : colour;
        }
    }
}

static void set_floor(struct syntax *syntax, uint64_t *random) {
    int choice = chance_pick(random, 10);
    if (choice == 0) {
        int floor_plane = syntax_add(syntax, SYNTAX_HALF_SPACE);
        syntax_plane(syntax, floor_plane, 0, 0, 1, 0);
        syntax_add_object(syntax, GENERATED_FLOOR, floor_plane);
    } else if (choice < 9) {
        syntax_add_object(syntax, GENERATED_FLOOR, generate_box(syntax, -6, -6, -0.5, 6, 6, 0));
    }
}

void generate_scene(struct syntax *syntax, uint64_t seed) {
    uint64_t state = seed, *random = &state;
    memset(syntax, 0, sizeof *syntax);
    set_model(syntax, random);
    set_camera(syntax, random);
    generate_materials(syntax, random);
    set_lights(syntax, random);
    if (seed % UPRIGHT_EVERY == 0) {
        struct syntax_light *light = &syntax->lights[0];
        light->parallel = true;
        light->place[0] = light->place[1] = 0;
        light->place[2] = -1;
    }
    set_floor(syntax, random);
    int count = 1 + chance_pick(random, 3);
    for (int i = 0; i < count; i++) {
        generate_motif(syntax, random, (enum motif)chance_pick(random, MOTIF_AROUND_EYE));
    }
    if (chance_is(random, 8) && !syntax_has_endless(syntax)) {
        generate_motif(syntax, random, MOTIF_AROUND_EYE);
    }
    if (chance_is(random, 12)) {
        generate_motif(syntax, random, MOTIF_EYE_AMID);
    }
    if (seed % CROWD_EVERY == CROWD_EVERY - 1 && syntax->part_count + 2 <= SYNTAX_PARTS_MOST) {
        generate_motif(syntax, random, MOTIF_CROWD);
    }
    if (syntax->object_count == 0) {
        generate_motif(syntax, random, MOTIF_TREE);
    }
}
