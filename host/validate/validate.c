/* SPDX-License-Identifier: MIT */
/* The validator: checks one step of the scene compiler against the description. */
#include "validate/validate.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "validate/validate_internal.h"

/* The numbers of points and of lines that are drawn: fewer where there is more to check for
 * each. */
enum { POINTS_MOST = 2048, POINTS_LEAST = 128, LINES_MOST = 1024, LINES_LEAST = 32 };
enum { LEAVES_ASKED = 500000, FACES_ASKED = 100000 };

const char *compile_step_name(enum compile_step step) {
    static const char *const names[STEP_COUNT] = {[STEP_OBJECTS] = "objects",
                                                  [STEP_SIMPLIFY] = "simplify",
                                                  [STEP_FUSE] = "fuse",
                                                  [STEP_SIMPLIFY_FUSED] = "simplify fused",
                                                  [STEP_BOUND] = "bound",
                                                  [STEP_COMPACT] = "compact",
                                                  [STEP_VIEW] = "view",
                                                  [STEP_SHADOWS] = "shadows",
                                                  [STEP_ENCLOSURES] = "enclosures"};
    return names[step];
}

/* ---- Points --------------------------------------------------------------------------------- */

static void fault_of_part(struct validator *validator, int part, const double point[3],
                          const char *what) {
    const struct scene_description *description = validator->described.description;
    const struct part *entry = &validator->described.parts[part];
    const struct scene_object *object = &description->objects[entry->object];
    validate_fault(validator, point, "object '%.40s' of line %u, material '%.40s': %s",
                   object->name, object->line, description->materials[entry->material].name, what);
}

/* Checks that a point of an object lies within its bounds. */
static void check_bounds(struct validator *validator, int part, uint32_t object,
                         const double point[3]) {
    const struct bounds *bounds = &validator->scene->objects[object].bounds;
    for (int i = 0; i < 3; i++) {
        if (!(point[i] >= bounds->low[i] - VALIDATE_NEAR &&
              point[i] <= bounds->high[i] + VALIDATE_NEAR)) {
            fault_of_part(validator, part, point, "a point of it lies out of its bounds");
            return;
        }
    }
}

void validate_point(struct validator *validator, const double point[3]) {
    bool *inside = validator->inside;
    if (!validate_is_in_world(point)) {
        return;
    }
    table_inside(&validator->table, point, inside);
    validator->validation->points++;
    for (int i = 0; i < validator->described.part_count; i++) {
        if (validator->described.parts[i].is_left_out) {
            continue;
        }
        const enum side side = part_side(&validator->described, i, point);
        const uint32_t object = validator->object_of_part[i];
        const bool holds =
            object != COMPILED_NONE && table_object_holds(&validator->table, object, inside);
        if (side == SIDE_NEAR) {
            validator->validation->near++;
        } else if (holds != (side == SIDE_INSIDE)) {
            fault_of_part(validator, i, point,
                          holds ? "the tables have a point in it that is not"
                                : "the tables lack a point of it");
        } else if (holds) {
            check_bounds(validator, i, object, point);
        }
    }
    for (uint32_t i = 0; i < validator->scene->primitive_count; i++) {
        if (inside[i]) {
            validate_reach(validator, i, point, 1);
        }
    }
}

static unsigned within(int asked, int each, int least, int most) {
    const int count = asked / (each > 0 ? each : 1);
    return (unsigned)(count < least ? least : count > most ? most : count);
}

static void check_points(struct validator *validator) {
    const unsigned count =
        within(LEAVES_ASKED, validator->described.leaf_count, POINTS_LEAST, POINTS_MOST);
    for (unsigned i = 0; i < count; i++) {
        double point[3];
        described_sample(&validator->described, &validator->dice, i, point);
        validate_point(validator, point);
    }
}

/* ---- Lines ---------------------------------------------------------------------------------- */

/* Checks a point on either side of a crossing, at a random distance of any size. */
static void check_sides(struct validator *validator, const struct sight_line *line,
                        const struct table_crossing *crossing) {
    const double distance =
        ldexp(dice_between(&validator->dice, 4, 8), -dice_below(&validator->dice, 26));
    for (int side = -1; side <= 1; side += 2) {
        double point[3];
        for (int i = 0; i < 3; i++) {
            point[i] = crossing->point[i] + side * distance * line->direction[i];
        }
        validate_point(validator, point);
    }
}

static void check_line(struct validator *validator, unsigned number) {
    struct table_crossing crossings[TABLE_CROSSINGS_MOST];
    struct sight_line line;
    described_ray(&validator->described, &validator->dice, number, &line);
    const int count = table_crossings(&validator->table, &line, -4096, crossings);
    validate_crossings(validator, &line, crossings, count);
    if (count == 0) {
        return;
    }
    const struct table_crossing *crossing = &crossings[dice_below(&validator->dice, count)];
    check_sides(validator, &line, crossing);
    if (crossing->clean && validator->step >= STEP_SHADOWS && validator->scene->light_count > 0) {
        validate_shadow(validator, &line, crossing);
    }
}

static void check_lines(struct validator *validator) {
    const unsigned count =
        within(FACES_ASKED, (int)validator->table.face_count, LINES_LEAST, LINES_MOST);
    for (unsigned i = 0; i < count; i++) {
        check_line(validator, i);
    }
}

/* ---- A step --------------------------------------------------------------------------------- */

/* Checks that an object of the tables has the material and the name of the part that it says it
 * is. */
static bool is_part(const struct validator *validator, uint32_t object, uint32_t part) {
    const struct compiled_scene *scene = validator->scene;
    const struct described *described = &validator->described;
    if (part >= scene->part_count) {
        return false;
    }
    const struct part *entry = &described->parts[part];
    const char *name = described->description->objects[entry->object].name;
    return scene->materials[scene->objects[object].material].file == entry->material &&
           strncmp(scene->object_names[object], name, sizeof scene->object_names[0] - 1) == 0;
}

/* Pairs the file's objects with those of the tables. */
static bool pair_parts(struct validator *validator) {
    const struct compiled_scene *scene = validator->scene;
    for (uint32_t i = 0; i < scene->part_count; i++) {
        validator->object_of_part[i] = COMPILED_NONE;
        validator->described.parts[i].is_left_out = scene->is_left_out[i];
    }
    for (uint32_t i = 1; i < scene->object_count; i++) {
        const uint32_t part = scene->objects[i].part;
        if (!is_part(validator, i, part)) {
            validate_fault(validator, NULL, "object '%s' of line %u is none of the file's",
                           scene->object_names[i], scene->objects[i].line);
            return false;
        }
        validator->object_of_part[part] = i;
    }
    return true;
}

static void check_all(struct validator *validator) {
    if ((uint32_t)validator->described.part_count != validator->scene->part_count) {
        validate_fault(validator, NULL, "%u parts of the file's objects, which has %d",
                       validator->scene->part_count, validator->described.part_count);
        return;
    }
    if (!pair_parts(validator)) {
        return;
    }
    check_points(validator);
    check_lines(validator);
    if (validator->step >= STEP_COMPACT) {
        validate_surface_sets(validator);
    }
    if (validator->step >= STEP_VIEW) {
        validate_eye(validator);
    }
    if (validator->step >= STEP_SHADOWS) {
        validate_shadow_sets(validator);
    }
}

bool compiled_scene_agrees(const struct scene_description *description,
                           const struct compiled_scene *scene, enum compile_step step,
                           struct validation *validation) {
    struct validator validator;
    char text[200];
    memset(&validator, 0, sizeof validator);
    memset(validation, 0, sizeof *validation);
    validator.scene = scene;
    validator.step = step;
    validator.validation = validation;
    validator.object_of_part = malloc(((size_t)scene->part_count + 1) * sizeof(uint32_t));
    validator.inside = malloc((size_t)scene->primitive_count + 1);
    if (!table_is_whole(scene, text)) {
        validate_fault(&validator, NULL, "%s", text);
    } else if (validator.object_of_part != NULL && validator.inside != NULL &&
               described_unfold(&validator.described, description, scene->centre,
                                scene->exponent) &&
               table_read(&validator.table, scene)) {
        described_measure(&validator.described);
        check_all(&validator);
    } else {
        validate_fault(&validator, NULL, "out of memory");
    }
    described_free(&validator.described);
    table_free(&validator.table);
    free(validator.object_of_part);
    free(validator.inside);
    return validation->faults == 0;
}

void validations_look(void *context, enum compile_step step, const struct compiled_scene *scene) {
    struct validations *validations = context;
    struct validation found, *sum = &validations->of[step];
    if (!compiled_scene_agrees(validations->description, scene, step, &found) && sum->faults == 0) {
        memcpy(sum->first, found.first, sizeof sum->first);
    }
    sum->points += found.points;
    sum->near += found.near;
    sum->faults += found.faults;
}
