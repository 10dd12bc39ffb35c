/* SPDX-License-Identifier: MIT */
/* A compiled scene as the firmware's tables in memory, in one arithmetic. */
#include <stdio.h>
#include <stdlib.h>

#include "compiler/tables.h"
#include "learn.h"
#include "render/arithmetic.h"
#include "render/per_arithmetic/holds.h"
#include "render/per_arithmetic/observe.h"
#include "scene.h"

/* Compiled once for each arithmetic and form of sets; the include path says which. */

#define NAME_JOIN(prefix, name)  NAME_JOIN_(prefix, name)
#define NAME_JOIN_(prefix, name) prefix##name
#define NAME_TEXT(name)          NAME_TEXT_(name)
#define NAME_TEXT_(name)         #name
#define IMAGE                    NAME_JOIN(image_, REAL_NAME)
#define ARITHMETIC               NAME_JOIN(NAME_JOIN(arithmetic_, REAL_NAME), SETS_SUFFIX)

/* The scene and its estimate, in one block with the tables. */
struct loaded {
    struct scene scene; /* first: the block is freed through it */
    struct estimate estimate;
};

static struct point point_of(const double p[3]) {
    struct point point = {REAL_LENGTH(p[0]), REAL_LENGTH(p[1]), REAL_LENGTH(p[2])};
    return point;
}

static struct direction direction_of(const double d[3]) {
    struct direction direction = {REAL_UNIT(d[0]), REAL_UNIT(d[1]), REAL_UNIT(d[2])};
    return direction;
}

static struct colours colours_of(const double c[3]) {
    struct colours colours = {REAL_COLOUR(c[0]), REAL_COLOUR(c[1]), REAL_COLOUR(c[2])};
    return colours;
}

static struct energies energies_of(const double e[3]) {
    struct energies energies = {REAL_ENERGY(e[0]), REAL_ENERGY(e[1]), REAL_ENERGY(e[2])};
    return energies;
}

static void directions_of(struct direction to[3], const double from[3][3]) {
    for (int i = 0; i < 3; i++) {
        to[i] = direction_of(from[i]);
    }
}

static void unit_steps_of(real_unit to[SPECULAR_STEPS], const double from[SPECULAR_STEPS]) {
    for (int i = 0; i < SPECULAR_STEPS; i++) {
        to[i] = REAL_UNIT(from[i]);
    }
}

static void energy_steps_of(real_energy to[SPECULAR_STEPS], const double from[SPECULAR_STEPS]) {
    for (int i = 0; i < SPECULAR_STEPS; i++) {
        to[i] = REAL_ENERGY(from[i]);
    }
}

static void indices_of(real_index to[3], const double from[3]) {
    for (int i = 0; i < 3; i++) {
        to[i] = REAL_INDEX(from[i]);
    }
}

static void extinctions_of(real_extinction to[3], const double from[3]) {
    for (int i = 0; i < 3; i++) {
        to[i] = REAL_EXTINCTION(from[i]);
    }
}

static void surfaces_of(surface_number to[6], const uint32_t from[6]) {
    for (int i = 0; i < 6; i++) {
        to[i] = (surface_number)from[i];
    }
}

/* Members of *to from those of *from, by the roles of scene_fields.h. */
#define LOAD_MEMBER(role, name) LOAD_##role(name)
#define LOAD_POINT(name)        to->name = point_of(from->name);
#define LOAD_DIRECTION(name)    to->name = direction_of(from->name);
#define LOAD_DIRECTIONS(name)   directions_of(to->name, from->name);
#define LOAD_LENGTH(name)       to->name = REAL_LENGTH(from->name);
#define LOAD_AREA(name)         to->name = REAL_AREA(from->name);
#define LOAD_UNIT_STEPS(name)   unit_steps_of(to->name, from->name);
#define LOAD_COLOURS(name)      to->name = colours_of(from->name);
#define LOAD_ENERGIES(name)     to->name = energies_of(from->name);
#define LOAD_ENERGY(name)       to->name = REAL_ENERGY(from->name);
#define LOAD_ENERGY_STEPS(name) energy_steps_of(to->name, from->name);
#define LOAD_INDICES(name)      indices_of(to->name, from->name);
#define LOAD_EXTINCTIONS(name)  extinctions_of(to->name, from->name);
#define LOAD_BYTE(name)         to->name = from->name;
#define LOAD_WORD(name)         to->name = from->name;
#define LOAD_LONG(name)         to->name = from->name;
#define LOAD_SIGNED(name)       to->name = from->name;
#define LOAD_TRUTH(name)        to->name = from->name;
#define LOAD_ENTRY(name)        to->name = (entry_number)from->name;
#define LOAD_SURFACE(name)      to->name = (surface_number)from->name;
#define LOAD_SURFACES(name)     surfaces_of(to->name, from->name);
#define LOAD_FIRST(name)        to->name = (run_first)from->name;
#define LOAD_COUNT(name)        to->name = (run_count)from->name;

/* LOAD_SET, LOAD_MARKS and the tables of sets. */
#include "load_sets.h"

static void load_frame(struct frame *to, const struct compiled_frame *from) {
    FRAME_FIELDS(LOAD_MEMBER)
}

static void load_primitive(struct primitive *to, const struct compiled_primitive *from) {
    to->kind = (uint8_t)from->kind;
    PRIMITIVE_FIELDS(LOAD_MEMBER)
}

static void load_box(struct box *to, const struct compiled_box *from) {
    BOX_FIELDS(LOAD_MEMBER)
}

static void load_ball(struct ball *to, const struct compiled_ball *from) {
    BALL_FIELDS_BEFORE(LOAD_MEMBER)
    BALL_FIELDS_AFTER(LOAD_MEMBER)
    to->square_radius = REAL_AREA(from->radius * from->radius);
}

static void load_polyhedron(struct polyhedron *to, const struct compiled_polyhedron *from) {
    POLYHEDRON_FIELDS(LOAD_MEMBER)
}

static void load_plane(struct plane *to, const struct compiled_plane *from) {
    PLANE_FIELDS(LOAD_MEMBER)
}

static void load_quadric(struct quadric *to, const struct compiled_quadric *from) {
    QUADRIC_FIELDS_BEFORE(LOAD_MEMBER)
    QUADRIC_FIELDS_AMID(LOAD_MEMBER)
    QUADRIC_FIELDS_AFTER(LOAD_MEMBER)
    to->square_reach = REAL_AREA(from->reach * from->reach);
    to->ends = from->reach > 0;
}

static void load_object(struct object *to, const struct compiled_object *from) {
    OBJECT_FIELDS(LOAD_MEMBER)
}

static void load_material(struct material *to, const struct compiled_material *from) {
    MATERIAL_FIELDS(LOAD_MEMBER)
}

static void load_pattern(struct pattern *to, const struct compiled_pattern *from) {
    PATTERN_FIELDS(LOAD_MEMBER)
}

static void load_pattern_face(struct pattern_face *to, const struct compiled_pattern_face *from) {
    PATTERN_FACE_FIELDS(LOAD_MEMBER)
}

static void load_specular_table(struct specular_table *to,
                                const struct compiled_specular_table *from) {
    SPECULAR_TABLE_FIELDS(LOAD_MEMBER)
}

static void load_light(struct light *to, const struct compiled_light *from) {
    LIGHT_FIELDS(LOAD_MEMBER)
}

static void load_camera(struct camera *to, const struct compiled_camera *from) {
    CAMERA_FIELDS(LOAD_MEMBER)
}

static void load_code(program_code *to, const uint32_t *from) {
    *to = (program_code)*from;
}

static void load_tables(struct block *block, struct scene *to, const struct compiled_scene *from) {
    LOAD_TABLE(struct frame, from->frame_count, frames, from->frames, load_frame)
    LOAD_TABLE(struct primitive, from->primitive_count, primitives, from->primitives,
               load_primitive)
    LOAD_TABLE(struct box, from->box_count, boxes, from->boxes, load_box)
    LOAD_TABLE(struct ball, from->ball_count, balls, from->balls, load_ball)
    LOAD_TABLE(struct polyhedron, from->polyhedron_count, polyhedra, from->polyhedra,
               load_polyhedron)
    LOAD_TABLE(struct plane, from->plane_count, planes, from->planes, load_plane)
    LOAD_TABLE(struct quadric, from->quadric_count, quadrics, from->quadrics, load_quadric)
    LOAD_TABLE(program_code, from->program_length, programs, from->programs, load_code)
    LOAD_TABLE(struct object, from->object_count, objects, from->objects, load_object)
    LOAD_TABLE(struct material, from->material_count, materials, from->materials, load_material)
    LOAD_TABLE(struct pattern, from->pattern_count, patterns, from->patterns, load_pattern)
    LOAD_TABLE(struct pattern_face, from->pattern_face_count, pattern_faces, from->pattern_faces,
               load_pattern_face)
    LOAD_TABLE(struct specular_table, from->specular_table_count, specular_tables,
               from->specular_tables, load_specular_table)
    LOAD_TABLE(struct light, from->light_count, lights, from->lights, load_light)
}

static void load_scene(struct scene *to, const struct compiled_scene *from) {
    SCENE_FIELDS_BEFORE(LOAD_MEMBER)
    SCENE_FIELDS_AMID(LOAD_MEMBER)
    SCENE_FIELDS_AFTER(LOAD_MEMBER)
    SCENE_FIELDS_SHOWN(LOAD_MEMBER)
    to->error = (uint32_t)(from->error * 65536 + 0.5);
    to->primitive_count = (entry_number)from->primitive_count;
    to->object_count = (entry_number)from->object_count;
    to->light_count = (entry_number)from->light_count;
    load_camera(&to->camera, &from->camera);
}

/* Puts all tables into a block. */
static void load_all(struct block *block, struct scene *to, const struct compiled_scene *from) {
    load_scene(to, from);
    load_tables(block, to, from);
    sets_load(block, to, from);
}

/* Loads twice: the first time, the block is measured. */
static struct scene *load_block(const struct compiled_scene *from) {
    struct block block = {NULL, 0};
    struct loaded *loaded;
    struct scene measured;
    (void)block_take(&block, 1, sizeof *loaded);
    load_all(&block, &measured, from);
    block.memory = calloc(1, block.used);
    if (block.memory == NULL) {
        return NULL;
    }
    block.used = 0;
    loaded = block_take(&block, 1, sizeof *loaded);
    load_all(&block, &loaded->scene, from);
    return &loaded->scene;
}

static struct scene *load(const struct compiled_scene *from, struct scene_error *error) {
    if (!sets_fit(from, error) || !arithmetic_holds(from, error)) {
        return NULL;
    }
    struct scene *scene = load_block(from);
    if (scene == NULL) {
        snprintf(error->text, sizeof error->text, "%.200s: out of memory", from->path);
    }
    return scene;
}

static void learn(struct scene *scene, struct estimate *estimate, struct render_counts *counts) {
    struct loaded *loaded = (struct loaded *)scene;
    if (scene->estimates) {
        scene->estimate = 0;
        learn_estimate(scene, &loaded->estimate, counts);
        scene->estimate = &loaded->estimate;
    }
    *estimate = loaded->estimate;
}

extern const struct image IMAGE;

const struct arithmetic ARITHMETIC = {&IMAGE,
                                      NAME_TEXT(NAME_JOIN(REAL_NAME, SETS_SUFFIX)),
                                      LENGTH_VALUE(LENGTH_NOISE),
                                      sets_have_room,
                                      load,
                                      learn,
                                      observe_pixel};
