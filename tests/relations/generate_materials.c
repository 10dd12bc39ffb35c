/* SPDX-License-Identifier: MIT */
/* Random scenes: materials. */
#include "generate.h"

#include <string.h>

#include "chance.h"

static void any_colour(uint64_t *random, double colour[3]) {
    for (int i = 0; i < 3; i++) {
        colour[i] = chance_pick(random, 256);
    }
}

static void start(struct syntax_material *material, uint64_t *random) {
    memset(material, 0, sizeof *material);
    any_colour(random, material->colour);
    material->ambient = chance_pick(random, 5) / 8.0;
    material->ambient_is_own = chance_is(random, 70);
    material->diffuse = chance_pick(random, 9) / 8.0;
    material->specular = 0;
    material->gloss = 1 + chance_pick(random, 60);
    for (int i = 0; i < 3; i++) {
        material->ior[i] = 1.5;
        material->reflects[i] = material->transmits[i] = 1;
    }
}

/* Gives cells; their borders lie in faces now and then, where the solid's side decides. */
static void add_pattern(struct syntax_pattern *pattern, uint64_t *random) {
    pattern->present = true;
    int axes = 1 + chance_pick(random, 7);
    bool is_plain = chance_is(random, 30);
    for (int i = 0; i < 3; i++) {
        pattern->size[i] = (axes >> i & 1) != 0 ? 0.5 + chance_step(random, 0, 1) : 0;
        pattern->origin[i] = is_plain ? 0 : chance_odd(random, 0, 1) / 16;
        if (is_plain && pattern->size[i] > 0) {
            pattern->size[i] = 0.5 * (1 + chance_pick(random, 3));
        }
    }
    any_colour(random, pattern->colour);
}

/* Makes a transparent material; bodies of glass are darker than opaque ones. */
static void make_transparent(struct syntax_material *material, uint64_t *random, double ior) {
    material->transparent = true;
    material->specular = chance_pick(random, 3) / 4.0;
    for (int i = 0; i < 3; i++) {
        material->ior[i] = ior;
        material->colour[i] /= 8;
    }
}

static void make_dispersing(struct syntax_material *material, uint64_t *random,
                            enum syntax_model model) {
    make_transparent(material, random, 1.25);
    material->disperses = model == SYNTAX_WAVELENGTH || chance_is(random, 30);
    for (int i = 0; i < 3 && material->disperses; i++) {
        material->ior[i] = 1.375 + 0.0625 * i;
    }
    if (chance_is(random, 50)) {
        material->reflects[1] = 0.75;
        material->transmits[2] = 0.875;
    }
}

void generate_materials(struct syntax *syntax, uint64_t *random) {
    syntax->material_count = GENERATED_MATERIALS;
    for (int i = 0; i < GENERATED_MATERIALS; i++) {
        start(&syntax->materials[i], random);
        if (i == GENERATED_FLOOR || chance_is(random, 12)) {
            add_pattern(&syntax->materials[i].pattern, random);
        }
    }
    syntax->materials[GENERATED_CLAY].specular = chance_is(random, 30) ? 0.25 : 0;
    syntax->materials[GENERATED_MIRROR].specular = 0.5 + chance_pick(random, 4) / 8.0;
    struct syntax_material *table = &syntax->materials[GENERATED_TABLE];
    table->has_table = chance_is(random, 50);
    for (int i = 0; i < SYNTAX_TABLE; i++) {
        table->table[i] = i * i / 256.0;
    }
    make_transparent(&syntax->materials[GENERATED_GLASS], random, 1.5);
    struct syntax_material *tinted = &syntax->materials[GENERATED_TINTED];
    make_transparent(tinted, random, chance_is(random, 50) ? 1.125 : 0.8125);
    for (int i = 0; i < 3; i++) {
        tinted->absorption[i] = chance_pick(random, 5) / 8.0;
    }
    make_dispersing(&syntax->materials[GENERATED_DISPERSING], random, syntax->model);
    struct syntax_material *screen = &syntax->materials[GENERATED_SCREEN];
    make_transparent(screen, random, 1);
    screen->casts_shadow = chance_is(random, 50);
}
