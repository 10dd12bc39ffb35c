/* SPDX-License-Identifier: MIT */
/* Relations: the list of objects, parts and lights. */
#include <string.h>

#include "chance.h"
#include "extent.h"
#include "generate.h"
#include "relation.h"

/* Checks whether two neighbours in the list may change places: they are apart, or of one material.
 * Where transparent objects touch, the later one's surface is seen. */
static bool may_change_places(const struct syntax *scene, int first) {
    const struct syntax_object *a = &scene->objects[first], *b = a + 1;
    bool are_plain =
        !syntax_names_material(scene, a->solid) && !syntax_names_material(scene, b->solid);
    struct extent left = extent_of(scene, a->solid), right = extent_of(scene, b->solid);
    return extent_are_apart(&left, &right, 1e-3) || (are_plain && a->material == b->material);
}

bool rewrite_object_order(struct syntax *scene, uint64_t *random) {
    bool has_changed = false;
    for (int i = 0; i < 40 && scene->object_count > 1; i++) {
        int first = chance_pick(random, scene->object_count - 1);
        if (may_change_places(scene, first)) {
            struct syntax_object object = scene->objects[first];
            scene->objects[first] = scene->objects[first + 1];
            scene->objects[first + 1] = object;
            has_changed = true;
        }
    }
    return has_changed;
}

/* Returns an object that has an end, or -1. */
static int bounded_object(const struct syntax *scene, uint64_t *random) {
    int object = chance_pick(random, scene->object_count);
    return scene->solids[scene->objects[object].solid].kind == SYNTAX_HALF_SPACE ? -1 : object;
}

bool rewrite_halves(struct syntax *scene, uint64_t *random) {
    int object = bounded_object(scene, random);
    if (object < 0) {
        return false;
    }
    int solid = scene->objects[object].solid, material = scene->objects[object].material;
    int cutter = generate_any_cutter(scene, random);
    int inner = syntax_combine(scene, SYNTAX_INTERSECTION, solid, cutter);
    int outer = syntax_combine(scene, SYNTAX_DIFFERENCE, syntax_copy(scene, solid),
                               syntax_copy(scene, cutter));
    scene->objects[object].solid = inner;
    syntax_insert_object(scene, object + 1, material, outer);
    return true;
}

/* Adds an object that is empty: a solid less itself, or less more than itself. */
bool rewrite_empty(struct syntax *scene, uint64_t *random) {
    int object = bounded_object(scene, random);
    if (object < 0) {
        return false;
    }
    int solid = syntax_copy(scene, scene->objects[object].solid);
    int cutter = syntax_copy(scene, solid);
    if (chance_is(random, 50)) {
        cutter = syntax_combine(scene, SYNTAX_UNION, generate_any_cutter(scene, random), cutter);
    }
    syntax_insert_object(scene, chance_pick(random, scene->object_count + 1),
                         chance_pick(random, scene->material_count),
                         syntax_combine(scene, SYNTAX_DIFFERENCE, solid, cutter));
    return true;
}

/* Adds a solid of index 1 and without a colour below all others. As a filter it lets all through.
 */
bool rewrite_ghost(struct syntax *scene, uint64_t *random) {
    if (scene->material_count == SYNTAX_MATERIALS_MOST || (scene->motifs >> MOTIF_AROUND_EYE & 1)) {
        return false;
    }
    struct syntax_material *ghost = &scene->materials[scene->material_count];
    memset(ghost, 0, sizeof *ghost);
    ghost->transparent = true;
    for (int i = 0; i < 3; i++) {
        ghost->ior[i] = ghost->reflects[i] = ghost->transmits[i] = 1;
        ghost->colour[i] = scene->filters ? 255 : 0;
    }
    int solid = generate_tree(scene, random, 1);
    int wrapper = syntax_add(scene, SYNTAX_UNION);
    syntax_adopt(scene, wrapper, solid);
    scene->solids[wrapper].translate[2] = 1.25;
    syntax_insert_object(scene, 0, scene->material_count++, wrapper);
    return true;
}

/* Makes a part of a solid and uses it in the solid's place. */
bool rewrite_as_part(struct syntax *scene, uint64_t *random) {
    if (scene->part_count == SYNTAX_PARTS_MOST) {
        return false;
    }
    for (int i = 0; i < scene->object_count; i++) {
        if (scene->part_count < SYNTAX_PARTS_MOST && (i == 0 || chance_is(random, 70))) {
            int use = syntax_add(scene, SYNTAX_PART);
            scene->solids[use].part = syntax_add_part(scene, scene->objects[i].solid);
            scene->objects[i].solid = use;
        }
    }
    return true;
}

/* Writes every part out where it is used; parts may use those before them. */
bool rewrite_written_out(struct syntax *scene, uint64_t *random) {
    (void)random;
    bool has_parts = false;
    for (int i = 0; i < scene->solid_count && !scene->is_full; i++) {
        if (scene->solids[i].kind == SYNTAX_PART) {
            int copy = syntax_copy(scene, scene->parts[scene->solids[i].part]);
            scene->solids[i].kind = SYNTAX_UNION;
            syntax_adopt(scene, i, copy);
            has_parts = true;
        }
    }
    scene->part_count = 0;
    return has_parts;
}

bool rewrite_light(struct syntax *scene, uint64_t *random) {
    if (scene->light_count == 0 || scene->light_count == SYNTAX_LIGHTS_MOST) {
        return false;
    }
    struct syntax_light *light = &scene->lights[chance_pick(random, scene->light_count)];
    for (int i = 0; i < 3; i++) {
        light->colour[i] /= 2;
    }
    *syntax_add_light(scene) = *light;
    return true;
}
