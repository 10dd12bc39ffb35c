/* SPDX-License-Identifier: MIT */
/* The validator: reads the tables a second time: faces, programs, crossings of a line. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "validate/validate_internal.h"

static double dot(const double a[3], const double b[3]) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* ---- Faces ---------------------------------------------------------------------------------- */

static void axes_of(const struct compiled_scene *scene, uint32_t frame, double axis[3][3]) {
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j < 3; j++) {
            axis[i][j] = frame == COMPILED_FRAME_WORLD ? i == j : scene->frames[frame].axis[i][j];
        }
    }
}

static struct table_face *new_face(struct table *table, uint32_t surface) {
    struct table_face *face = &table->faces[table->face_count++];
    memset(face, 0, sizeof *face);
    face->surface = surface;
    return face;
}

/* Adds the faces of a box across `axes`: bit i stands for axis i. */
static void read_box(struct table *table, const struct compiled_primitive *primitive,
                     const struct compiled_box *box, unsigned axes) {
    double axis[3][3];
    axes_of(table->scene, primitive->frame, axis);
    for (int i = 0; i < 6; i++) {
        const double sign = i < 3 ? -1 : 1;
        if ((axes >> i % 3 & 1) == 0) {
            continue;
        }
        struct table_face *face = new_face(table, box->surface[i]);
        for (int j = 0; j < 3; j++) {
            face->normal[j] = sign * axis[i % 3][j];
        }
        face->offset = i < 3 ? -box->minimum[i] : box->maximum[i - 3];
    }
}

static void read_ball(struct table *table, const struct compiled_ball *ball) {
    struct table_face *face = new_face(table, ball->surface);
    face->curved = true;
    axes_of(table->scene, COMPILED_FRAME_WORLD, face->axis);
    memcpy(face->centre, ball->centre, sizeof face->centre);
    face->square[0] = face->square[1] = face->square[2] = 1;
    face->constant = -ball->radius * ball->radius;
}

static void read_polyhedron(struct table *table, const struct compiled_polyhedron *polyhedron) {
    for (uint32_t i = polyhedron->first; i < polyhedron->first + polyhedron->count; i++) {
        const struct compiled_plane *plane = &table->scene->planes[i];
        struct table_face *face = new_face(table, plane->surface);
        memcpy(face->normal, plane->normal, sizeof face->normal);
        face->offset = plane->offset;
    }
}

static void read_quadric(struct table *table, const struct compiled_primitive *primitive) {
    const struct compiled_quadric *quadric = &table->scene->quadrics[primitive->index];
    struct table_face *face = new_face(table, quadric->surface);
    face->curved = true;
    axes_of(table->scene, primitive->frame, face->axis);
    memcpy(face->centre, quadric->centre, sizeof face->centre);
    memcpy(face->square, quadric->square, sizeof face->square);
    face->linear = quadric->linear;
    face->constant = quadric->constant;
    if (quadric->cuts != 0) {
        read_box(table, primitive, &table->scene->boxes[quadric->box], quadric->cuts);
    }
}

static void read_primitive(struct table *table, const struct compiled_primitive *primitive) {
    switch (primitive->kind) {
    case PRIMITIVE_BOX:
        read_box(table, primitive, &table->scene->boxes[primitive->index], 7);
        break;
    case PRIMITIVE_BALL:
        read_ball(table, &table->scene->balls[primitive->index]);
        break;
    case PRIMITIVE_POLYHEDRON:
        read_polyhedron(table, &table->scene->polyhedra[primitive->index]);
        break;
    case PRIMITIVE_QUADRIC:
        read_quadric(table, primitive);
        break;
    }
}

bool table_read(struct table *table, const struct compiled_scene *scene) {
    const size_t entries = (size_t)scene->primitive_count + 1;
    size_t most = 7 * entries;
    memset(table, 0, sizeof *table);
    table->scene = scene;
    for (uint32_t i = 0; i < scene->primitive_count; i++) {
        if (scene->primitives[i].kind == PRIMITIVE_POLYHEDRON) {
            most += scene->polyhedra[scene->primitives[i].index].count;
        }
    }
    table->faces = malloc(most * sizeof *table->faces);
    table->first = calloc(entries, sizeof *table->first);
    table->count = calloc(entries, sizeof *table->count);
    table->used = calloc(entries, sizeof *table->used);
    if (table->faces == NULL || table->first == NULL || table->count == NULL ||
        table->used == NULL) {
        return false;
    }
    for (uint32_t i = 1; i < scene->object_count; i++) {
        for (uint32_t j = 0; j < scene->objects[i].length; j++) {
            const uint32_t code = scene->programs[scene->objects[i].program + j];
            if (code < scene->primitive_count) {
                table->used[code] = true;
            }
        }
    }
    for (uint32_t i = 0; i < scene->primitive_count; i++) {
        table->first[i] = table->face_count;
        if (table->used[i]) {
            read_primitive(table, &scene->primitives[i]);
        }
        table->count[i] = table->face_count - table->first[i];
    }
    return true;
}

void table_free(struct table *table) {
    free(table->faces);
    free(table->first);
    free(table->count);
    free(table->used);
}

/* Computes a face's function and half its gradient at a point, in the face's own axes. */
static double curve_at(const struct table_face *face, const double point[3], double steepness[3]) {
    double value = face->constant;
    const double p[3] = {point[0] - face->centre[0], point[1] - face->centre[1],
                         point[2] - face->centre[2]};
    for (int i = 0; i < 3; i++) {
        const double x = dot(p, face->axis[i]), linear = i == 2 ? face->linear : 0;
        value += (face->square[i] * x + 2 * linear) * x;
        steepness[i] = face->square[i] * x + linear;
    }
    return value;
}

double face_distance(const struct table_face *face, const double point[3]) {
    double steepness[3];
    if (!face->curved) {
        return dot(face->normal, point) - face->offset;
    }
    const double value = curve_at(face, point, steepness);
    const double slope = 2 * sqrt(dot(steepness, steepness));
    return slope > 0 ? value / slope : value < 0 ? -HUGE_VAL : value > 0 ? HUGE_VAL : 0;
}

void face_gradient(const struct table_face *face, const double point[3], double gradient[3]) {
    double steepness[3];
    if (!face->curved) {
        memcpy(gradient, face->normal, sizeof face->normal);
        return;
    }
    (void)curve_at(face, point, steepness);
    for (int j = 0; j < 3; j++) {
        gradient[j] = 0;
        for (int i = 0; i < 3; i++) {
            gradient[j] += steepness[i] * face->axis[i][j];
        }
    }
}

double table_distance(const struct table *table, uint32_t primitive, const double point[3]) {
    double most = -HUGE_VAL;
    for (uint32_t i = 0; i < table->count[primitive]; i++) {
        most = fmax(most, face_distance(&table->faces[table->first[primitive] + i], point));
    }
    return most;
}

/* ---- Programs ------------------------------------------------------------------------------- */

void table_inside(const struct table *table, const double point[3], bool inside[]) {
    for (uint32_t i = 0; i < table->scene->primitive_count; i++) {
        inside[i] = table->used[i] && table_distance(table, i, point) < 0;
    }
}

bool table_object_holds(const struct table *table, uint32_t object, const bool inside[]) {
    const struct compiled_object *entry = &table->scene->objects[object];
    bool stack[TABLE_DEPTH_MOST] = {false};
    int depth = 0;
    for (uint32_t i = 0; i < entry->length; i++) {
        const uint32_t code = table->scene->programs[entry->program + i];
        if (code < COMPILED_UNION) {
            stack[depth++] = inside[code];
            continue;
        }
        const bool right = stack[--depth], left = stack[depth - 1];
        stack[depth - 1] = code == COMPILED_UNION          ? left || right
                           : code == COMPILED_INTERSECTION ? left && right
                                                           : left && !right;
    }
    return stack[0];
}

/* ---- Crossings ------------------------------------------------------------------------------ */

/* Finds the two places where a line crosses a face, infinite where there is none. The face's
 * function along the line is a t^2 + 2 b t + c. */
static void face_roots(const struct table_face *face, const struct sight_line *line,
                       double roots[2]) {
    double steepness[3], a = 0, b = 0;
    roots[0] = roots[1] = HUGE_VAL;
    if (!face->curved) {
        roots[0] = -face_distance(face, line->origin) / dot(face->normal, line->direction);
        return;
    }
    const double c = curve_at(face, line->origin, steepness);
    for (int i = 0; i < 3; i++) {
        const double along = dot(line->direction, face->axis[i]);
        a += face->square[i] * along * along;
        b += steepness[i] * along;
    }
    const double square = b * b - a * c;
    if (square > 0) {
        const double q = b < 0 ? sqrt(square) - b : -sqrt(square) - b;
        roots[0] = c / q;
        roots[1] = q / a;
    }
}

/* Moves a crossing by Newton's method onto its face, and sets whether the crossing is clean.
 * Returns false if it lies outside of another face of the primitive. */
static bool settle(const struct table *table, const struct sight_line *line,
                   struct table_crossing *crossing) {
    const struct table_face *face = crossing->face;
    double gradient[3], edge = -HUGE_VAL, slant = 0;
    for (int round = 0; round < 3; round++) {
        for (int j = 0; j < 3; j++) {
            crossing->point[j] = line->origin[j] + crossing->t * line->direction[j];
        }
        face_gradient(face, crossing->point, gradient);
        slant = dot(gradient, line->direction) / sqrt(dot(gradient, gradient));
        if (round < 2 && fabs(slant) > 1e-3) {
            crossing->t -= face_distance(face, crossing->point) / slant;
        }
    }
    for (uint32_t i = 0; i < table->count[crossing->primitive]; i++) {
        const struct table_face *other = &table->faces[table->first[crossing->primitive] + i];
        if (other != face) {
            edge = fmax(edge, face_distance(other, crossing->point));
        }
    }
    crossing->clean = fabs(slant) > 1e-2 && edge < -VALIDATE_NEAR &&
                      fabs(face_distance(face, crossing->point)) < VALIDATE_STRICTLY;
    return edge < VALIDATE_NEAR;
}

static int compare_crossings(const void *a, const void *b) {
    const double one = ((const struct table_crossing *)a)->t;
    const double other = ((const struct table_crossing *)b)->t;
    return (one > other) - (one < other);
}

int table_crossings(const struct table *table, const struct sight_line *line, double from,
                    struct table_crossing crossings[TABLE_CROSSINGS_MOST]) {
    int count = 0;
    for (uint32_t i = 0; i < table->scene->primitive_count; i++) {
        for (uint32_t j = 0; j < table->count[i]; j++) {
            double roots[2];
            const struct table_face *face = &table->faces[table->first[i] + j];
            face_roots(face, line, roots);
            for (int k = 0; k < 2 && count < TABLE_CROSSINGS_MOST; k++) {
                struct table_crossing *crossing = &crossings[count];
                crossing->t = roots[k];
                crossing->primitive = i;
                crossing->face = face;
                count +=
                    fabs(roots[k]) < 4096 && settle(table, line, crossing) && crossing->t > from;
            }
        }
    }
    qsort(crossings, (size_t)count, sizeof *crossings, compare_crossings);
    return count;
}

/* ---- Wholeness ------------------------------------------------------------------------------ */

static bool primitive_is_whole(const struct compiled_scene *scene, uint32_t index) {
    const struct compiled_primitive *primitive = &scene->primitives[index];
    const unsigned counts[4] = {scene->box_count, scene->ball_count, scene->polyhedron_count,
                                scene->quadric_count};
    if (primitive->kind > PRIMITIVE_QUADRIC || primitive->index >= counts[primitive->kind] ||
        (primitive->frame != COMPILED_FRAME_WORLD && primitive->frame >= scene->frame_count)) {
        return false;
    }
    if (primitive->kind == PRIMITIVE_POLYHEDRON) {
        const struct compiled_polyhedron *polyhedron = &scene->polyhedra[primitive->index];
        return polyhedron->count > 0 && polyhedron->first + polyhedron->count <= scene->plane_count;
    }
    if (primitive->kind != PRIMITIVE_QUADRIC) {
        return true;
    }
    const struct compiled_quadric *quadric = &scene->quadrics[primitive->index];
    return quadric->cuts == 0 || (quadric->cuts < 8 && quadric->box < scene->box_count);
}

/* Checks that a program leaves one value, and takes no value that is not there. */
static bool program_is_whole(const struct compiled_scene *scene,
                             const struct compiled_object *object) {
    int depth = 0;
    if (object->program > scene->program_length ||
        object->length > scene->program_length - object->program) {
        return false;
    }
    for (uint32_t i = 0; i < object->length; i++) {
        const uint32_t code = scene->programs[object->program + i];
        if (code < COMPILED_UNION && code >= scene->primitive_count) {
            return false;
        }
        depth += code < COMPILED_UNION ? 1 : -1;
        if (depth < 1 || depth > TABLE_DEPTH_MOST) {
            return false;
        }
    }
    return depth == 1;
}

static bool frame_is_whole(const struct compiled_frame *frame) {
    for (int i = 0; i < 3; i++) {
        for (int j = 0; j <= i; j++) {
            if (fabs(dot(frame->axis[i], frame->axis[j]) - (i == j)) > 1e-9) {
                return false;
            }
        }
    }
    return true;
}

static bool objects_are_whole(const struct compiled_scene *scene, char text[200]) {
    for (uint32_t i = 1; i < scene->object_count; i++) {
        const struct compiled_object *object = &scene->objects[i];
        if (!program_is_whole(scene, object)) {
            (void)snprintf(text, 200, "object '%s' of line %u: a broken program",
                           scene->object_names[i], object->line);
            return false;
        }
        if (i > 1 && object->part <= scene->objects[i - 1].part) {
            (void)snprintf(text, 200, "object '%s' of line %u: not in the file's order",
                           scene->object_names[i], object->line);
            return false;
        }
    }
    return true;
}

bool table_is_whole(const struct compiled_scene *scene, char text[200]) {
    for (uint32_t i = 0; i < scene->primitive_count; i++) {
        if (!primitive_is_whole(scene, i)) {
            (void)snprintf(text, 200, "the solid of line %u: no entry of its table",
                           scene->primitives[i].line);
            return false;
        }
    }
    for (uint32_t i = 0; i < scene->frame_count; i++) {
        if (!frame_is_whole(&scene->frames[i])) {
            (void)snprintf(text, 200, "frame %u: no three axes at right angles", i);
            return false;
        }
    }
    return objects_are_whole(scene, text);
}
