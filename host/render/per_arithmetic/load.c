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

/* What compiler/tables.h repeats of scene.h. */
typedef char compiled_scene_matches_scene
    [(int)KIND_BOX == (int)PRIMITIVE_BOX && (int)KIND_BALL == (int)PRIMITIVE_BALL &&
             (int)KIND_POLYHEDRON == (int)PRIMITIVE_POLYHEDRON &&
             (int)KIND_QUADRIC == (int)PRIMITIVE_QUADRIC && (int)CURVED_FACE == (int)QUADRIC_FACE &&
             (int)CODE_UNION == (int)PROGRAM_UNION &&
             (int)CODE_INTERSECTION == (int)PROGRAM_INTERSECTION &&
             (int)CODE_DIFFERENCE == (int)PROGRAM_DIFFERENCE &&
             (int)NO_TABLE == (int)SPECULAR_CONSTANT && (int)NO_ENCLOSURE == (int)ENCLOSURE_NONE &&
             (int)SCENE_SPECULAR_STEPS == (int)SPECULAR_STEPS &&
             (int)COMPILED_BITS == (int)SHOW_BITS && (int)COMPILED_DITHER == (int)SHOW_DITHER &&
             (int)COMPILED_EXPOSURES == (int)SHOW_EXPOSURES &&
             (int)WORLD_FRAME == (int)FRAME_WORLD && (int)NO_PATTERN == (int)PATTERN_NONE &&
             (int)COMPILED_PRIMITIVES_MOST == (int)PRIMITIVES_MOST
         ? 1
         : -1];

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
    struct light lights[SCENE_LIGHTS_MOST];
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

static void load_solids(struct loaded *to, const struct compiled_scene *from) {
    for (int i = 0; i < from->frame_count; i++) {
        to->frames[i].origin = point_of(from->frames[i].origin);
        for (int j = 0; j < 3; j++) {
            to->frames[i].axis[j] = direction_of(from->frames[i].axis[j]);
        }
    }
    for (int i = 0; i < from->primitive_count; i++) {
        const struct compiled_primitive *primitive = &from->primitives[i];
        to->primitives[i].kind = (uint8_t)primitive->kind;
        to->primitives[i].index = primitive->index;
        to->primitives[i].frame = primitive->frame;
        to->primitives[i].enclosure = primitive->enclosure;
        to->hidden_by[i] = set_of(&from->hidden_by[i]);
        to->primitives[i].left_for_good = primitive->left_for_good;
    }
    for (int i = 0; i < from->box_count; i++) {
        to->boxes[i].minimum = point_of(from->boxes[i].minimum);
        to->boxes[i].maximum = point_of(from->boxes[i].maximum);
        for (int j = 0; j < 6; j++) {
            to->boxes[i].surface[j] = from->boxes[i].surface[j];
        }
    }
    for (int i = 0; i < from->ball_count; i++) {
        const struct compiled_ball *ball = &from->balls[i];
        to->balls[i].centre = point_of(ball->centre);
        to->balls[i].square_radius = REAL_AREA(ball->radius * ball->radius);
        to->balls[i].surface = ball->surface;
    }
    for (int i = 0; i < from->polyhedron_count; i++) {
        to->polyhedra[i].first = from->polyhedra[i].first;
        to->polyhedra[i].count = from->polyhedra[i].count;
    }
    for (int i = 0; i < from->plane_count; i++) {
        to->planes[i].normal = direction_of(from->planes[i].normal);
        to->planes[i].offset = REAL_LENGTH(from->planes[i].offset);
        to->planes[i].surface = from->planes[i].surface;
    }
    for (int i = 0; i < from->quadric_count; i++) {
        const struct compiled_quadric *quadric = &from->quadrics[i];
        to->quadrics[i].centre = point_of(quadric->centre);
        to->quadrics[i].square = direction_of(quadric->square);
        to->quadrics[i].linear = REAL_LENGTH(quadric->linear);
        to->quadrics[i].constant = REAL_AREA(quadric->constant);
        to->quadrics[i].square_reach = REAL_AREA(quadric->reach * quadric->reach);
        to->quadrics[i].surface = quadric->surface;
        to->quadrics[i].box = quadric->box;
        to->quadrics[i].cuts = quadric->cuts;
        to->quadrics[i].ends = quadric->reach > 0;
        to->quadrics[i].left_for_good = quadric->left_for_good;
    }
    for (int i = 0; i < from->surface_count; i++) {
        to->surfaces[i] = set_of(&from->surfaces[i]);
    }
}

static void load_objects(struct loaded *to, const struct compiled_scene *from) {
    for (int i = 0; i < from->program_length; i++) {
        to->programs[i] = from->programs[i];
    }
    for (int i = 0; i < from->object_count; i++) {
        to->objects[i].program = from->objects[i].program;
        to->objects[i].length = from->objects[i].length;
        to->objects[i].material = from->objects[i].material;
        to->objects[i].uses = set_of(&from->objects[i].uses);
        to->objects[i].in_shadow_test = from->objects[i].in_shadow_test;
    }
}

static void load_materials(struct loaded *to, const struct compiled_scene *from) {
    for (int i = 0; i < from->material_count; i++) {
        const struct compiled_material *source = &from->materials[i];
        struct material *material = &to->materials[i];
        material->colour = colours_of(source->colour);
        material->ambient = colours_of(source->ambient);
        material->ambient_share = REAL_ENERGY(source->ambient_share);
        material->diffuse = REAL_ENERGY(source->diffuse);
        material->specular = REAL_ENERGY(source->specular);
        material->gloss = source->gloss;
        material->transparent = source->transparent;
        material->casts_shadow = source->casts_shadow;
        material->absorbs = source->absorbs;
        material->disperses = source->disperses;
        material->tints = source->tints;
        material->specular_table = source->specular_table;
        material->pattern = source->pattern;
        material->optical = source->optical;
        material->transmittance = REAL_ENERGY(source->transmittance);
        material->reflects = energies_of(source->reflects);
        material->transmits = energies_of(source->transmits);
        material->filter = energies_of(source->filter);
        for (int j = 0; j < 3; j++) {
            material->ior[j] = REAL_INDEX(source->ior[j]);
            material->inverse_ior[j] = REAL_INDEX(source->inverse_ior[j]);
            material->absorption[j] = REAL_EXTINCTION(source->absorption[j]);
        }
    }
    for (int i = 0; i < from->pattern_count; i++) {
        const struct compiled_pattern *source = &from->patterns[i];
        to->patterns[i].axes = source->axes;
        to->patterns[i].face_count = source->face_count;
        to->patterns[i].first_face = source->first_face;
        to->patterns[i].origin = point_of(source->origin);
        to->patterns[i].size = point_of(source->size);
        to->patterns[i].colour = colours_of(source->colour);
    }
}

static void load_pattern_faces(struct loaded *to, const struct compiled_scene *from) {
    for (int i = 0; i < from->pattern_face_count; i++) {
        to->pattern_faces[i].surface = from->pattern_faces[i].surface;
        to->pattern_faces[i].axis = from->pattern_faces[i].axis;
        to->pattern_faces[i].odd_above = from->pattern_faces[i].odd_above;
        to->pattern_faces[i].odd_below = from->pattern_faces[i].odd_below;
    }
}

static void load_specular_tables(struct loaded *to, const struct compiled_scene *from) {
    for (int i = 0; i < from->specular_table_count; i++) {
        for (int j = 0; j < SPECULAR_STEPS; j++) {
            to->specular_tables[i].cosine[j] = REAL_UNIT(from->specular_tables[i].cosine[j]);
            to->specular_tables[i].specular[j] = REAL_ENERGY(from->specular_tables[i].specular[j]);
        }
    }
}

static void load_lights(struct loaded *to, const struct compiled_scene *from) {
    for (int i = 0; i < from->light_count; i++) {
        to->lights[i].parallel = from->lights[i].parallel;
        to->lights[i].casts_shadows = from->lights[i].casts_shadows;
        to->lights[i].towards = direction_of(from->lights[i].towards);
        to->lights[i].position = point_of(from->lights[i].position);
        to->lights[i].colour = colours_of(from->lights[i].colour);
    }
}

static void load_camera(struct camera *camera, const struct compiled_camera *from) {
    camera->eye = point_of(from->eye);
    camera->forward = direction_of(from->forward);
    camera->column = direction_of(from->column);
    camera->row = direction_of(from->row);
    camera->up = direction_of(from->up);
    camera->shift = from->shift;
    camera->inside = set_of(&from->inside);
    camera->object = from->object;
}

static void load_scene(struct loaded *to, const struct compiled_scene *from) {
    struct scene *scene = &to->scene;
    scene->width = from->width;
    scene->height = from->height;
    scene->depth = from->depth;
    scene->threshold = REAL_ENERGY(from->threshold);
    scene->estimates = from->estimates;
    scene->error = (uint32_t)(from->error * 65536 + 0.5);
    scene->ray_budget = from->ray_budget;
    scene->brightest = from->brightest;
    scene->background = colours_of(from->background);
    scene->simple = from->simple;
    scene->filters = from->filters;
    scene->blinn = from->blinn;
    scene->fades = from->fades;
    scene->fade_start = REAL_LENGTH(from->fade_start);
    scene->fade_exponent = from->fade_exponent;
    load_camera(&scene->camera, &from->camera);
    scene->primitive_count = from->primitive_count;
    scene->object_count = from->object_count;
    scene->light_count = from->light_count;
    scene->frames = to->frames;
    scene->primitives = to->primitives;
    scene->boxes = to->boxes;
    scene->balls = to->balls;
    scene->polyhedra = to->polyhedra;
    scene->planes = to->planes;
    scene->quadrics = to->quadrics;
    scene->surfaces = to->surfaces;
    scene->hidden_by = to->hidden_by;
    scene->programs = to->programs;
    scene->objects = to->objects;
    scene->materials = to->materials;
    scene->patterns = to->patterns;
    scene->pattern_faces = to->pattern_faces;
    scene->specular_tables = to->specular_tables;
    scene->lights = to->lights;
    scene->shadow_primitives = set_of(&from->shadow_primitives);
    scene->show = from->show;
    scene->show_bits = from->show_bits;
    scene->seed = from->seed;
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
    load_scene(loaded, from);
    load_solids(loaded, from);
    load_objects(loaded, from);
    load_materials(loaded, from);
    load_pattern_faces(loaded, from);
    load_specular_tables(loaded, from);
    load_lights(loaded, from);
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
