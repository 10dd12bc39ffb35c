/* SPDX-License-Identifier: MIT */
/* Relations: the whole scene is moved, and the eye with it. */
#include <math.h>
#include <string.h>

#include "chance.h"
#include "place.h"
#include "relation.h"

/* Puts every object below a new solid with that placement. */
static void wrap_objects(struct syntax *scene, const struct syntax_solid *placement) {
    for (int i = 0; i < scene->object_count; i++) {
        int wrapper = syntax_add(scene, SYNTAX_UNION);
        syntax_adopt(scene, wrapper, scene->objects[i].solid);
        struct syntax_solid *solid = &scene->solids[wrapper];
        memcpy(solid->scale, placement->scale, sizeof solid->scale);
        memcpy(solid->rotate, placement->rotate, sizeof solid->rotate);
        memcpy(solid->translate, placement->translate, sizeof solid->translate);
        scene->objects[i].solid = wrapper;
    }
}

static const struct syntax_solid unplaced = {.scale = {1, 1, 1}};

/* Maps what is in the world's coordinates but no solid. Directions are not moved. */
static void map_world(struct syntax *scene, const struct syntax_solid *placement) {
    static const struct place identity = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {0, 0, 0}};
    const struct place place = place_inner(&identity, placement);
    struct place turn = place;
    double image[3];
    memset(turn.move, 0, sizeof turn.move);
    place_point(&place, scene->eye, image);
    memcpy(scene->eye, image, sizeof image);
    place_point(&place, scene->look_at, image);
    memcpy(scene->look_at, image, sizeof image);
    place_point(&turn, scene->up, image);
    memcpy(scene->up, image, sizeof image);
    for (int i = 0; i < scene->light_count; i++) {
        struct syntax_light *light = &scene->lights[i];
        place_point(light->parallel ? &turn : &place, light->place, image);
        memcpy(light->place, image, sizeof image);
    }
}

static void mirror_solid(struct syntax_solid *solid) {
    double low = -solid->b[0];
    solid->translate[0] = -solid->translate[0];
    solid->rotate[1] = -solid->rotate[1];
    solid->rotate[2] = -solid->rotate[2];
    if (solid->kind == SYNTAX_BOX) {
        solid->b[0] = -solid->a[0];
        solid->a[0] = low;
    } else {
        solid->a[0] = -solid->a[0];
        solid->b[0] = solid->kind == SYNTAX_ELLIPSOID ? solid->b[0] : low;
    }
    solid->form[3] = -solid->form[3];
    solid->form[5] = -solid->form[5];
    solid->form[6] = -solid->form[6];
    for (int i = 0; i < solid->plane_count; i++) {
        solid->planes[i].normal[0] = -solid->planes[i].normal[0];
    }
}

/* Mirrors the scene, by a placement or in every number. Cells keep their parity: -u lies in the
 * cell -floor(u) - 1, and the origin goes one cell on for that. */
bool rewrite_mirror(struct syntax *scene, uint64_t *random) {
    struct syntax_solid mirror = unplaced;
    mirror.scale[0] = -1;
    if (chance_is(random, 50)) {
        wrap_objects(scene, &mirror);
    } else {
        for (int i = 0; i < scene->solid_count; i++) {
            mirror_solid(&scene->solids[i]);
        }
    }
    map_world(scene, &mirror);
    for (int i = 0; i < scene->material_count; i++) {
        struct syntax_pattern *pattern = &scene->materials[i].pattern;
        pattern->origin[0] = pattern->size[0] - pattern->origin[0];
    }
    return true;
}

/* Moves the scene by about 10^6 of its size, by a number that keeps sums exact. */
bool rewrite_move(struct syntax *scene, uint64_t *random) {
    struct syntax_solid move = unplaced;
    for (int i = 0; i < 3; i++) {
        move.translate[i] = 65536.0 * (chance_pick(random, 400) - 200);
    }
    wrap_objects(scene, &move);
    map_world(scene, &move);
    for (int i = 0; i < scene->material_count; i++) {
        for (int j = 0; j < 3; j++) {
            scene->materials[i].pattern.origin[j] += move.translate[j];
        }
    }
    return true;
}

static void scale_solid(struct syntax_solid *solid, double factor) {
    for (int i = 0; i < 3; i++) {
        solid->translate[i] *= factor;
        solid->a[i] *= factor;
        solid->b[i] *= factor;
        solid->form[6 + i] *= factor;
    }
    solid->form[9] *= factor * factor;
    solid->radius *= factor;
    solid->radius_b *= factor;
    for (int i = 0; i < solid->plane_count; i++) {
        solid->planes[i].offset *= factor;
    }
}

/* Scales the scene; absorption and fading go by the unit. */
bool rewrite_scale(struct syntax *scene, uint64_t *random) {
    struct syntax_solid scale = unplaced;
    double factor = scene->fades || chance_is(random, 50) ? 1e-4 : 1e4;
    scale.scale[0] = scale.scale[1] = scale.scale[2] = factor;
    if (chance_is(random, 50)) {
        wrap_objects(scene, &scale);
    } else {
        for (int i = 0; i < scene->solid_count; i++) {
            scale_solid(&scene->solids[i], factor);
        }
    }
    map_world(scene, &scale);
    scene->fade_constant *= factor;
    for (int i = 0; i < scene->light_count && scene->fades; i++) {
        for (int j = 0; j < 3; j++) {
            scene->lights[i].colour[j] *= factor;
        }
    }
    for (int i = 0; i < scene->material_count; i++) {
        for (int j = 0; j < 3; j++) {
            scene->materials[i].absorption[j] /= factor;
            scene->materials[i].pattern.size[j] *= factor;
            scene->materials[i].pattern.origin[j] *= factor;
        }
    }
    return !syntax_has_endless(scene);
}

/* Leaves out patterns, which lie in the world and do not turn. */
bool prepare_turn(struct syntax *scene, uint64_t *random) {
    (void)random;
    for (int i = 0; i < scene->material_count; i++) {
        scene->materials[i].pattern.present = false;
    }
    for (int i = 0; i < scene->light_count; i++) {
        struct syntax_light *light = &scene->lights[i];
        if (light->parallel && light->place[0] == 0 && light->place[1] == 0) {
            light->place[0] = 0.25; /* along a wall, rounding decides whether the wall is lit */
        }
    }
    return !syntax_has_endless(scene);
}

bool rewrite_turn(struct syntax *scene, uint64_t *random) {
    struct syntax_solid turn = unplaced;
    bool is_right = chance_is(random, 25);
    for (int i = 0; i < 3; i++) {
        turn.rotate[i] =
            is_right ? 90 * chance_pick(random, 4) : 10 * chance_pick(random, 36) + 0.25 * i;
    }
    wrap_objects(scene, &turn);
    map_world(scene, &turn);
    return true;
}

bool rewrite_roll(struct syntax *scene, uint64_t *random) {
    (void)random;
    for (int i = 0; i < 3; i++) {
        scene->up[i] = -scene->up[i];
    }
    return true;
}
