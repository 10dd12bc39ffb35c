/* SPDX-License-Identifier: MIT */
/* The validator: checks what stands between a surface and a light. */
#include <math.h>

#include "validate/validate_internal.h"

/* Crossings nearer together than this, along a path to a light, count as one place. */
#define SHORT_WAY 0x1p-16

/* Places on a way are passed over so that no more parts are asked for them. */
enum { PLACES_MOST = 1 << 16 };

/* The distance before and behind a boundary at which the objects on its sides are looked up. */
#define ASIDE 0x1p-18

static double dot(const double a[3], const double b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void along(const struct sight_line *line, double t, double point[3]) {
    for (int i = 0; i < 3; i++) {
        point[i] = line->origin[i] + t * line->direction[i];
    }
}

/* ---- The sets ------------------------------------------------------------------------------- */

/* Checks which primitives each object uses, and which primitives are tried for shadows. */
void validate_shadow_sets(struct validator *validator) {
    const struct compiled_scene *scene = validator->scene;
    struct compiled_set tried = {NULL, 0};
    bool has_memory = true;
    for (uint32_t i = 1; i < scene->object_count && has_memory; i++) {
        const struct compiled_object *object = &scene->objects[i];
        struct compiled_set uses = {NULL, 0};
        for (uint32_t j = 0; j < object->length && has_memory; j++) {
            const uint32_t code = scene->programs[object->program + j];
            has_memory = code >= COMPILED_UNION ||
                         (compiled_set_include(&uses, code) &&
                          (!object->in_shadow_test || compiled_set_include(&tried, code)));
        }
        if (has_memory && !compiled_sets_are_equal(&uses, &object->uses)) {
            validate_fault(validator, NULL, "object '%s' uses other solids than it is said to",
                           scene->object_names[i]);
        }
        compiled_set_clear(&uses);
    }
    if (has_memory && !compiled_sets_are_equal(&tried, &scene->shadow_primitives)) {
        validate_fault(validator, NULL,
                       "other solids are tried for shadows than those of objects "
                       "that can cast one");
    }
    compiled_set_clear(&tried);
}

/* ---- Paths to lights ------------------------------------------------------------------------ */

/* Tells whether the tables' shadow test finds something at a point that keeps light off. */
static bool test_finds(const struct validator *validator, const double point[3]) {
    const struct compiled_scene *scene = validator->scene;
    bool *inside = validator->inside;
    table_inside(&validator->table, point, inside);
    for (uint32_t i = 0; i < scene->primitive_count; i++) {
        inside[i] = inside[i] && compiled_set_has(&scene->shadow_primitives, i);
    }
    for (uint32_t i = scene->object_count - 1; i > 0; i--) {
        if (scene->objects[i].in_shadow_test && table_object_holds(&validator->table, i, inside)) {
            return scene->materials[scene->objects[i].material].casts_shadow;
        }
    }
    return false;
}

/* Compares at one place on a path what the description has there with what the shadow test
 * finds. */
static void check_place(struct validator *validator, uint32_t light, const double point[3]) {
    const struct described *described = &validator->described;
    const int part = described_filler(described, point);
    const bool casts =
        part >= 0 &&
        described->description->materials[described->parts[part].material].casts_shadow;
    const bool found =
        validator->scene->lights[light].casts_shadows && test_finds(validator, point);
    if (part != -2 && casts != found) {
        validate_fault(validator, point, "light %u: %s", light + 1,
                       casts ? "what keeps it off here is not tried"
                             : "something is said to keep it off here");
    }
}

static void check_way(struct validator *validator, uint32_t light, const struct sight_line *way,
                      double distance) {
    struct table_crossing crossings[TABLE_CROSSINGS_MOST];
    const int count = table_crossings(&validator->table, way, 0, crossings);
    const int step = 1 + count * validator->described.part_count / PLACES_MOST;
    double before = 0;
    for (int i = 0; i <= count && before < distance; i++) {
        const double t = fmin(i < count ? crossings[i].t : HUGE_VAL, distance);
        double point[3];
        along(way, before + (t - before) / 2, point);
        if (i % step == 0 && t - before > SHORT_WAY && validate_is_in_world(point)) {
            check_place(validator, light, point);
        }
        before = fmax(before, t);
    }
}

/* Checks the path from a boundary to a light, on the side that `normal` points to. There is none if
 * the light is behind the boundary. */
static void check_light(struct validator *validator, uint32_t light, const double from[3],
                        const double normal[3]) {
    const struct compiled_scene *scene = validator->scene;
    const struct scene_light *source =
        &validator->described.description->lights[validator->scene->lights[light].file];
    struct sight_line way = {{0, 0, 0}, {0, 0, 0}, true};
    double distance = VALIDATE_WORLD;
    for (int i = 0; i < 3; i++) {
        way.origin[i] = from[i];
        way.direction[i] =
            source->parallel
                ? -source->direction[i]
                : ldexp(source->position[i] - scene->centre[i], scene->exponent) - from[i];
    }
    const double length = sqrt(dot(way.direction, way.direction));
    if (!source->parallel) {
        distance = length;
    }
    for (int i = 0; i < 3; i++) {
        way.direction[i] /= length;
    }
    if (dot(way.direction, normal) > 1e-3) {
        check_way(validator, light, &way, distance);
    }
}

static bool lets_through(const struct described *described, int part) {
    return part == -1 ||
           (part >= 0 &&
            described->description->materials[described->parts[part].material].transparent);
}

void validate_shadow(struct validator *validator, const struct sight_line *line,
                     const struct table_crossing *crossing) {
    const struct described *described = &validator->described;
    double before[3], behind[3], normal[3];
    along(line, crossing->t - ASIDE, before);
    along(line, crossing->t + ASIDE, behind);
    const int here = described_filler(described, before),
              there = described_filler(described, behind);
    if (here == -2 || there == -2 || here == there) {
        return;
    }
    face_gradient(crossing->face, crossing->point, normal);
    const double length = sqrt(dot(normal, normal));
    const double back = dot(normal, line->direction) > 0 ? -1 : 1;
    const bool sides[2] = {lets_through(described, here), lets_through(described, there)};
    const uint32_t light =
        (uint32_t)dice_below(&validator->dice, (int)validator->scene->light_count);
    for (int i = 0; i < 2; i++) {
        double outward[3];
        for (int j = 0; j < 3; j++) {
            outward[j] = (i == 0 ? back : -back) * normal[j] / length;
        }
        if (sides[i]) {
            check_light(validator, light, crossing->point, outward);
        }
    }
}
