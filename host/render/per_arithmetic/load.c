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

/* The widest image holds what the compiler makes. */
typedef char compiled_sets_fit[(int)COMPILED_PRIMITIVES_MOST == (int)PRIMITIVES_MOST ? 1 : -1];

/* Compiled once for each arithmetic; the include path says which. */

#define NAME_JOIN(prefix, name)  NAME_JOIN_(prefix, name)
#define NAME_JOIN_(prefix, name) prefix##name
#define IMAGE                    NAME_JOIN(image_, REAL_NAME)
#define ARITHMETIC               NAME_JOIN(arithmetic_, REAL_NAME)

/* The tables and the scene that points to them, in one block. */
struct loaded {
    struct scene scene; /* first: the block is freed through it */
    struct estimate estimate;
    struct frame frames[COMPILED_FRAMES_MOST];
    struct primitive primitives[COMPILED_PRIMITIVES_MOST];
    struct box boxes[2 * COMPILED_PRIMITIVES_MOST];
    struct ball balls[COMPILED_PRIMITIVES_MOST];
    struct polyhedron polyhedra[COMPILED_PRIMITIVES_MOST];
    struct plane planes[COMPILED_PLANES_MOST];
    struct quadric quadrics[COMPILED_PRIMITIVES_MOST];
    struct primitive_set surfaces[COMPILED_SURFACES_MOST];
    struct primitive_set hidden_by[COMPILED_PRIMITIVES_MOST];
    uint8_t programs[COMPILED_PROGRAM_BYTES_MOST];
    struct object objects[COMPILED_OBJECTS_MOST];
    struct material materials[COMPILED_MATERIALS_MOST];
    struct pattern patterns[COMPILED_MATERIALS_MOST];
    struct pattern_face pattern_faces[COMPILED_PATTERN_FACES_MOST];
    struct specular_table specular_tables[COMPILED_MATERIALS_MOST];
    struct light lights[COMPILED_LIGHTS_MOST];
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

static struct primitive_set set_of(const struct compiled_set *from) {
    struct primitive_set set;
    for (int i = 0; i < FEATURE_PRIMITIVE_WORDS; i++) {
        set.word[i] = from->word[i];
    }
    return set;
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

static void surfaces_of(uint16_t to[6], const uint16_t from[6]) {
    for (int i = 0; i < 6; i++) {
        to[i] = from[i];
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
#define LOAD_SURFACES(name)     surfaces_of(to->name, from->name);
#define LOAD_SET(name)          to->name = set_of(&from->name);

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

/* Loads all entries of a table. */
#define LOAD_TABLE(count, table, load_entry)                                                       \
    for (int i = 0; i < from->count; i++) {                                                        \
        load_entry(&to->table[i], &from->table[i]);                                                \
    }

static void load_set(struct primitive_set *to, const struct compiled_set *from) {
    *to = set_of(from);
}

static void load_byte(uint8_t *to, const uint8_t *from) {
    *to = *from;
}

static void load_tables(struct loaded *to, const struct compiled_scene *from) {
    LOAD_TABLE(frame_count, frames, load_frame)
    LOAD_TABLE(primitive_count, primitives, load_primitive)
    LOAD_TABLE(box_count, boxes, load_box)
    LOAD_TABLE(ball_count, balls, load_ball)
    LOAD_TABLE(polyhedron_count, polyhedra, load_polyhedron)
    LOAD_TABLE(plane_count, planes, load_plane)
    LOAD_TABLE(quadric_count, quadrics, load_quadric)
    LOAD_TABLE(surface_count, surfaces, load_set)
    LOAD_TABLE(primitive_count, hidden_by, load_set)
    LOAD_TABLE(program_length, programs, load_byte)
    LOAD_TABLE(object_count, objects, load_object)
    LOAD_TABLE(material_count, materials, load_material)
    LOAD_TABLE(pattern_count, patterns, load_pattern)
    LOAD_TABLE(pattern_face_count, pattern_faces, load_pattern_face)
    LOAD_TABLE(specular_table_count, specular_tables, load_specular_table)
    LOAD_TABLE(light_count, lights, load_light)
}

static void load_scene(struct scene *to, const struct compiled_scene *from) {
    SCENE_FIELDS_BEFORE(LOAD_MEMBER)
    SCENE_FIELDS_AMID(LOAD_MEMBER)
    SCENE_FIELDS_AFTER(LOAD_MEMBER)
    SCENE_FIELDS_SHOWN(LOAD_MEMBER)
    to->error = (uint32_t)(from->error * 65536 + 0.5);
    to->primitive_count = from->primitive_count;
    to->object_count = from->object_count;
    to->light_count = from->light_count;
    load_camera(&to->camera, &from->camera);
}

static void point_at_tables(struct loaded *loaded) {
    struct scene *scene = &loaded->scene;
    scene->frames = loaded->frames;
    scene->primitives = loaded->primitives;
    scene->boxes = loaded->boxes;
    scene->balls = loaded->balls;
    scene->polyhedra = loaded->polyhedra;
    scene->planes = loaded->planes;
    scene->quadrics = loaded->quadrics;
    scene->surfaces = loaded->surfaces;
    scene->hidden_by = loaded->hidden_by;
    scene->programs = loaded->programs;
    scene->objects = loaded->objects;
    scene->materials = loaded->materials;
    scene->patterns = loaded->patterns;
    scene->pattern_faces = loaded->pattern_faces;
    scene->specular_tables = loaded->specular_tables;
    scene->lights = loaded->lights;
}

static struct scene *load(const struct compiled_scene *from, struct scene_error *error) {
    if (!arithmetic_holds(from, error)) {
        return NULL;
    }
    struct loaded *loaded = calloc(1, sizeof *loaded);
    if (!loaded) {
        snprintf(error->text, sizeof error->text, "%.200s: out of memory", from->path);
        return NULL;
    }
    load_scene(&loaded->scene, from);
    load_tables(loaded, from);
    point_at_tables(loaded);
    return &loaded->scene;
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

const struct arithmetic ARITHMETIC = {&IMAGE, LENGTH_VALUE(LENGTH_NOISE), load, learn,
                                      observe_pixel};
