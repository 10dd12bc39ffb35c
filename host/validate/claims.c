/* SPDX-License-Identifier: MIT */
/* The validator: checks what the tables claim of primitives and surfaces at points of these. */
#include <math.h>
#include <stdlib.h>

#include "compiler/affine.h"
#include "compiler/extents.h"
#include "validate/validate_internal.h"

/* The distance by which faces of one surface may differ: COMPILE_SAME in each number, at the
 * world's end. */
#define ONE_SURFACE 0x1p-26

/* Faces that agree at a point to this, in distance and direction, are of one surface. */
#define COINCIDENT 0x1p-41

/* Crossings of a line are passed over so that no more faces are looked at. */
enum { LOOKS_MOST = 1 << 17 };

/* ---- How far things reach ------------------------------------------------------------------- */

static void check_along(struct validator *validator, uint32_t primitive, const double point[3],
                        const double direction[3]) {
    const double reach = primitive_reach(validator->scene, primitive, direction);
    if (!(vector_dot(point, direction) <= reach + VALIDATE_NEAR)) {
        validate_fault(validator, point,
                       "the solid of line %u reaches farther than its reach along (%.3g, %.3g, "
                       "%.3g) says",
                       validate_line(validator, primitive), direction[0], direction[1],
                       direction[2]);
    }
}

/* Chooses a direction along which bounds are checked: an axis of the world or the frame, a face's
 * own, or any. */
static void choose_direction(struct validator *validator, uint32_t primitive, const double point[3],
                             double direction[3]) {
    const struct table *table = &validator->table;
    const uint32_t frame = validator->scene->primitives[primitive].frame;
    const int choice = dice_below(&validator->dice, 14);
    if (choice < 12) {
        const double *axis =
            compiled_axis(validator->scene, choice < 6 ? COMPILED_FRAME_WORLD : frame, choice % 3);
        for (int j = 0; j < 3; j++) {
            direction[j] = choice / 3 % 2 == 0 ? axis[j] : -axis[j];
        }
        return;
    }
    dice_direction(&validator->dice, direction);
    if (choice == 12) {
        const uint32_t face = (uint32_t)dice_below(&validator->dice, (int)table->count[primitive]);
        face_gradient(&table->faces[table->first[primitive] + face], point, direction);
        vector_normalise(direction);
    }
}

static bool is_in(const double low[3], const double high[3], const double point[3]) {
    for (int i = 0; i < 3; i++) {
        if (!(point[i] >= low[i] - VALIDATE_NEAR && point[i] <= high[i] + VALIDATE_NEAR)) {
            return false;
        }
    }
    return true;
}

static void check_quadric(struct validator *validator, uint32_t primitive, const double point[3]) {
    const struct compiled_scene *scene = validator->scene;
    const struct compiled_primitive *entry = &scene->primitives[primitive];
    const struct compiled_quadric *quadric = &scene->quadrics[entry->index];
    double low[3], high[3], from[3], turned[3];
    quadric_extent(scene, quadric, &scene->boxes[quadric->box], entry->frame, low, high);
    for (int i = 0; i < 3; i++) {
        from[i] = point[i] - quadric->centre[i];
    }
    for (int i = 0; i < 3; i++) {
        turned[i] = vector_dot(from, compiled_axis(scene, entry->frame, i));
    }
    if (!is_in(low, high, turned)) {
        validate_fault(validator, point, "the solid of line %u goes beyond its extent",
                       validate_line(validator, primitive));
    }
    const double far = vector_length(from);
    if (far > quadric_ball(quadric, low, high) + VALIDATE_NEAR ||
        (validator->step >= STEP_COMPACT && quadric->reach > 0 && far >= quadric->reach)) {
        validate_fault(validator, point, "the solid of line %u goes beyond the ball about it",
                       validate_line(validator, primitive));
    }
}

void validate_reach(struct validator *validator, uint32_t primitive, const double point[3],
                    int directions) {
    const struct compiled_scene *scene = validator->scene;
    const struct compiled_primitive *entry = &scene->primitives[primitive];
    if (entry->kind == PRIMITIVE_POLYHEDRON &&
        !is_in(scene->polyhedra[entry->index].low, scene->polyhedra[entry->index].high, point)) {
        validate_fault(validator, point, "the polyhedron of line %u goes beyond its bounds",
                       validate_line(validator, primitive));
    }
    if (entry->kind == PRIMITIVE_QUADRIC) {
        check_quadric(validator, primitive, point);
    }
    for (int i = 0; i < directions; i++) {
        double direction[3];
        choose_direction(validator, primitive, point, direction);
        check_along(validator, primitive, point, direction);
    }
}

/* ---- Surfaces ------------------------------------------------------------------------------- */

static bool are_parallel(const struct table_face *a, const struct table_face *b,
                         const double point[3]) {
    double one[3], other[3], cross[3];
    face_gradient(a, point, one);
    face_gradient(b, point, other);
    vector_normalise(one);
    vector_normalise(other);
    vector_cross(one, other, cross);
    return vector_length(cross) < COINCIDENT;
}

/* Checks a point of one face against all other faces. Faces of its surface must go through the
 * point; those that touch the face there must be of its surface. */
static void check_surface(struct validator *validator, const struct sight_line *line,
                          const struct table_crossing *crossing) {
    const struct table *table = &validator->table;
    for (uint32_t i = 0; i < validator->scene->primitive_count; i++) {
        for (uint32_t j = 0; j < table->count[i]; j++) {
            const struct table_face *face = &table->faces[table->first[i] + j];
            const double apart = fabs(face_distance(face, crossing->point));
            if (face->surface == crossing->face->surface && apart > ONE_SURFACE) {
                validate_fault(validator, crossing->point,
                               "a face of the solid of line %u has the number of a surface of line "
                               "%u that it does not lie on",
                               validate_line(validator, i),
                               validate_line(validator, crossing->primitive));
            }
            if (face->surface != crossing->face->surface && line->random && apart < COINCIDENT &&
                are_parallel(face, crossing->face, crossing->point)) {
                validate_fault(validator, crossing->point,
                               "faces of the solids of lines %u and %u coincide and are two "
                               "surfaces",
                               validate_line(validator, i),
                               validate_line(validator, crossing->primitive));
            }
        }
    }
}

void validate_surface_sets(struct validator *validator) {
    const struct compiled_scene *scene = validator->scene;
    const struct table *table = &validator->table;
    struct compiled_set *sets = calloc((size_t)scene->surface_count + 1, sizeof *sets);
    bool is_done = sets != NULL; /* where memory is out, nothing is compared */
    for (uint32_t i = 0; i < scene->primitive_count && is_done; i++) {
        for (uint32_t j = 0; j < table->count[i] && is_done; j++) {
            const uint32_t surface = table->faces[table->first[i] + j].surface;
            if (surface >= scene->surface_count) {
                validate_fault(validator, NULL, "a face of the solid of line %u has no surface",
                               validate_line(validator, i));
                is_done = false;
            } else {
                is_done = compiled_set_include(&sets[surface], i);
            }
        }
    }
    for (uint32_t i = 0; i < scene->surface_count && is_done; i++) {
        if (!compiled_sets_are_equal(&sets[i], &scene->surfaces[i]) || sets[i].count == 0) {
            validate_fault(validator, NULL,
                           "surface %u does not bound the solids that have faces on it", i);
        }
    }
    for (uint32_t i = 0; i < scene->surface_count && sets != NULL; i++) {
        compiled_set_clear(&sets[i]);
    }
    free(sets);
}

/* ---- What is met after what ----------------------------------------------------------------- */

static bool is_left_for_good(const struct compiled_scene *scene, uint32_t primitive,
                             const struct table_face *face) {
    const struct compiled_primitive *entry = &scene->primitives[primitive];
    return entry->left_for_good || (entry->kind == PRIMITIVE_QUADRIC && face->curved &&
                                    scene->quadrics[entry->index].left_for_good);
}

/* Checks a primitive with a face on the surface that a ray starts on. Once outside of the
 * primitive, the ray must not come back to it. */
static void check_return(struct validator *validator, const struct sight_line *line,
                         const struct table_crossing *crossings, int count, int start,
                         uint32_t primitive) {
    const double from = crossings[start].t;
    int next = start + 1;
    while (next < count && (crossings[next].primitive != primitive ||
                            crossings[next].t < from + 2 * VALIDATE_NEAR)) {
        next++;
    }
    double between[3];
    for (int i = 0; i < 3 && next < count; i++) {
        between[i] = line->origin[i] + (from + crossings[next].t) / 2 * line->direction[i];
    }
    if (next < count && crossings[next].clean &&
        table_distance(&validator->table, primitive, between) > VALIDATE_NEAR) {
        validate_fault(validator, crossings[next].point,
                       "a ray comes back to the solid of line %u, which is left for good",
                       validate_line(validator, primitive));
    }
}

static void check_returns(struct validator *validator, const struct sight_line *line,
                          const struct table_crossing *crossings, int count, int start) {
    const struct table *table = &validator->table;
    for (uint32_t i = 0; i < validator->scene->primitive_count; i++) {
        for (uint32_t j = 0; j < table->count[i]; j++) {
            const struct table_face *face = &table->faces[table->first[i] + j];
            if (face->surface == crossings[start].face->surface &&
                is_left_for_good(validator->scene, i, face)) {
                check_return(validator, line, crossings, count, start, i);
            }
        }
    }
}

/* Checks a point of a primitive's surface against the primitives that hide it and the one that
 * encloses it. */
static void check_order(struct validator *validator, const struct table_crossing *crossing) {
    const struct compiled_scene *scene = validator->scene;
    const uint32_t primitive = crossing->primitive;
    const uint32_t enclosure = scene->primitives[primitive].enclosure;
    for (uint32_t i = 0; i < scene->primitive_count; i++) {
        if (scene->hidden_by != NULL && compiled_set_has(&scene->hidden_by[primitive], i) &&
            table_distance(&validator->table, i, crossing->point) < VALIDATE_STRICTLY) {
            validate_fault(validator, crossing->point,
                           "the solid of line %u is said to hide that of line %u, and they meet",
                           validate_line(validator, i), validate_line(validator, primitive));
        }
    }
    if (enclosure != COMPILED_ENCLOSURE_NONE &&
        (enclosure >= scene->primitive_count ||
         table_distance(&validator->table, enclosure, crossing->point) > -VALIDATE_STRICTLY)) {
        validate_fault(validator, crossing->point,
                       "the solid of line %u does not lie within the one that is said to enclose "
                       "it",
                       validate_line(validator, primitive));
    }
}

void validate_crossings(struct validator *validator, const struct sight_line *line,
                        const struct table_crossing *crossings, int count) {
    const unsigned looks = (unsigned)count * validator->table.face_count;
    const int step = 1 + (int)(looks / LOOKS_MOST);
    for (int i = 0; i < count; i += step) {
        if (!crossings[i].clean) {
            continue;
        }
        validate_reach(validator, crossings[i].primitive, crossings[i].point, 8);
        check_surface(validator, line, &crossings[i]);
        if (validator->step >= STEP_COMPACT) {
            check_returns(validator, line, crossings, count, i);
        }
        if (validator->step >= STEP_ENCLOSURES) {
            check_order(validator, &crossings[i]);
        }
    }
}

/* ---- The eye -------------------------------------------------------------------------------- */

/* Returns how far a compiled place lies from where the file has it: the most over the axes. Along
 * each axis, the distance is divided by 1 plus the scaled centre's magnitude. */
static double displacement(const struct validator *validator, const double file[3],
                           const double scaled[3]) {
    const struct compiled_scene *scene = validator->scene;
    double most = 0;
    for (int i = 0; i < 3; i++) {
        const double there = ldexp(file[i] - scene->centre[i], scene->exponent);
        most = fmax(most,
                    fabs(there - scaled[i]) / (1 + fabs(ldexp(scene->centre[i], scene->exponent))));
    }
    return most;
}

void validate_eye(struct validator *validator) {
    const struct compiled_scene *scene = validator->scene;
    const struct compiled_camera *camera = &scene->camera;
    const int part = described_filler(&validator->described, camera->eye);
    if (displacement(validator, validator->described.description->camera.eye, camera->eye) >
        0x1p-40) {
        validate_fault(validator, camera->eye, "the eye is elsewhere");
    }
    for (uint32_t i = 0; i < scene->primitive_count; i++) {
        const double distance = table_distance(&validator->table, i, camera->eye);
        if (fabs(distance) > VALIDATE_NEAR &&
            compiled_set_has(&camera->inside, i) != (distance < 0)) {
            validate_fault(validator, camera->eye,
                           "the tables have the eye %s the solid of line %u",
                           distance < 0 ? "outside of" : "in", validate_line(validator, i));
        }
    }
    if (camera->inside.count > 0 &&
        camera->inside.members[camera->inside.count - 1] >= scene->primitive_count) {
        validate_fault(validator, camera->eye, "the tables have the eye in a solid that is none");
    }
    const bool is_there = part == -1 ? camera->object == 0
                                     : camera->object > 0 && camera->object < scene->object_count &&
                                           scene->objects[camera->object].part == (uint32_t)part;
    if (part != -2 && !is_there) {
        validate_fault(validator, camera->eye,
                       "the tables have the eye in object %u, which is not there", camera->object);
    }
}
