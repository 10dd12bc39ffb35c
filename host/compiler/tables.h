/* SPDX-License-Identifier: MIT */
/* A compiled scene before it takes on an arithmetic: the firmware's tables, in doubles. */
#ifndef SUPERFRAME_COMPILED_SCENE_H
#define SUPERFRAME_COMPILED_SCENE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "compiler/bounds.h"
#include "scene/description.h"
#include "scene/overrides.h"
#include "scene_constants.h"
#include "scene_fields.h"

/* The tables have what firmware/scene_fields.h lists; read the comments there. Lengths are scaled
 * already. host/render/per_arithmetic/load.c turns the tables into those in memory,
 * host/compiler/emit.c into C source. */

enum {
    COMPILED_MATERIALS_MOST = 64, /* the air is one */
    COMPILED_NEAR_MOST = 16,
    COMPILED_BITS_MOST = 64,  /* primitives of a scene for images whose sets are bits */
    COMPILED_LEVELS_MOST = 36 /* nodes of a hierarchy of bounds, from its root to any primitive */
};

/* All other tables have as many entries as memory has room for. Numbers have 32 bits. Those below
 * stand for no entry, or for an operation of a program. The low bits of each are the number that
 * an image with fewer bits has for the same. */
#define COMPILED_NONE           UINT32_MAX
#define COMPILED_FRAME_WORLD    COMPILED_NONE
#define COMPILED_ENCLOSURE_NONE COMPILED_NONE
#define COMPILED_UNION          (UINT32_MAX - 2)
#define COMPILED_INTERSECTION   (UINT32_MAX - 1)
#define COMPILED_DIFFERENCE     UINT32_MAX
#define COMPILED_NODE_NONE      COMPILED_NONE
#define COMPILED_PLACE_ROOT     COMPILED_NONE /* is above a program's last code */

/* In front of the number of a primitive, among a node's children. */
#define COMPILED_NODE_PRIMITIVE UINT32_C(0x80000000)

/* Ends what has no end, so far from the middle, in scaled units. */
#define COMPILED_WORLD 1024.0

/* A set of primitives: their numbers in ascending order, each once. All zero: the empty set. */
struct compiled_set {
    uint32_t *members; /* grows as base/grow.h says */
    uint32_t count;
};

/* The types of members, by the roles of firmware/scene_fields.h: all numbers are doubles. */
#define COMPILED_MEMBER(role, name) COMPILED_##role(name)
#define COMPILED_POINT(name)        double name[3];
#define COMPILED_DIRECTION(name)    double name[3];
#define COMPILED_DIRECTIONS(name)   double name[3][3];
#define COMPILED_LENGTH(name)       double name;
#define COMPILED_AREA(name)         double name;
#define COMPILED_UNIT_STEPS(name)   double name[SPECULAR_STEPS];
#define COMPILED_COLOURS(name)      double name[3];
#define COMPILED_ENERGIES(name)     double name[3];
#define COMPILED_ENERGY(name)       double name;
#define COMPILED_ENERGY_STEPS(name) double name[SPECULAR_STEPS];
#define COMPILED_INDICES(name)      double name[3];
#define COMPILED_EXTINCTIONS(name)  double name[3];
#define COMPILED_BYTE(name)         uint8_t name;
#define COMPILED_WORD(name)         uint16_t name;
#define COMPILED_LONG(name)         uint32_t name;
#define COMPILED_SIGNED(name)       int8_t name;
#define COMPILED_TRUTH(name)        bool name;
#define COMPILED_ENTRY(name)        uint32_t name;
#define COMPILED_SURFACE(name)      uint32_t name;
#define COMPILED_SURFACES(name)     uint32_t name[6];
#define COMPILED_FIRST(name)        uint32_t name;
#define COMPILED_COUNT(name)        uint32_t name;
#define COMPILED_PLACES(name)       double name[3][NODE_WIDTH];
#define COMPILED_CHILDREN(name)     uint32_t name[NODE_WIDTH];
#define COMPILED_SET(name)          struct compiled_set name;
#define COMPILED_MARKS(name)        struct compiled_set name;

/* What stands below the fields of a table is no part of the firmware's. */

struct compiled_frame {
    FRAME_FIELDS(COMPILED_MEMBER)
};

struct compiled_primitive {
    enum primitive_kind kind;
    PRIMITIVE_FIELDS(COMPILED_MEMBER)
    unsigned line; /* of the scene file, for what an arithmetic may find wrong with it */
};

struct compiled_box {
    BOX_FIELDS(COMPILED_MEMBER)
};

struct compiled_ball {
    BALL_FIELDS_BEFORE(COMPILED_MEMBER)
    BALL_FIELDS_AFTER(COMPILED_MEMBER)
    double radius;
};

struct compiled_plane {
    PLANE_FIELDS(COMPILED_MEMBER)
};

struct compiled_polyhedron {
    POLYHEDRON_FIELDS(COMPILED_MEMBER)
    double low[3], high[3]; /* bounds, perhaps infinite */
};

struct compiled_quadric {
    QUADRIC_FIELDS_BEFORE(COMPILED_MEMBER)
    QUADRIC_FIELDS_AMID(COMPILED_MEMBER)
    QUADRIC_FIELDS_AFTER(COMPILED_MEMBER)
    double reach; /* 0: it has no end */
};

struct compiled_object {
    OBJECT_FIELDS(COMPILED_MEMBER)
    unsigned line; /* of the scene file */
    uint32_t part; /* of the file's objects, in the order in which they are taken apart */
    struct bounds bounds;
};

struct compiled_pattern {
    PATTERN_FIELDS(COMPILED_MEMBER)
    unsigned line; /* of the material's, in the file */
};

struct compiled_pattern_face {
    PATTERN_FACE_FIELDS(COMPILED_MEMBER)
};

struct compiled_material {
    MATERIAL_FIELDS(COMPILED_MEMBER)
    uint8_t file; /* its number in the file, from 0 */
};

struct compiled_specular_table {
    SPECULAR_TABLE_FIELDS(COMPILED_MEMBER)
};

struct compiled_light {
    LIGHT_FIELDS(COMPILED_MEMBER)
    uint32_t file; /* its number in the file */
};

struct compiled_camera {
    CAMERA_FIELDS(COMPILED_MEMBER)
};

struct compiled_node {
    NODE_FIELDS(COMPILED_MEMBER)
};

struct compiled_lead {
    LEAD_FIELDS(COMPILED_MEMBER)
};

struct compiled_use {
    USE_FIELDS(COMPILED_MEMBER)
};

/* What leads rays through a scene whose sets are lists (firmware/sets/list): hierarchies of bounds,
 * and which objects a primitive takes part in. */
struct compiled_hierarchy {
    SCENE_HIERARCHY_FIELDS(COMPILED_MEMBER)
    uint32_t node_count, lead_count, key_count, use_count, parent_count;
    unsigned levels; /* of nodes, in the deepest hierarchy */
    struct compiled_node *nodes;
    uint32_t *endless;
    struct compiled_lead *leads; /* by primitive */
    uint32_t *keys;
    struct compiled_use *uses;
    uint32_t *parents; /* by code of the programs */
};

/* What the compiler made of the file's solids. */
struct compiled_report {
    unsigned shared;     /* solids that are the same as another one */
    unsigned simplified; /* operations of CSG that change nothing */
    unsigned fused;      /* solids that a neighbour has taken in */
    unsigned bounded;    /* solids cut off where nothing is to be seen of them */
    unsigned hidden;     /* pairs of primitives of which one is not met from within the other */
};

/* Two faces that do not count as one, though they are nearer to each other than seems to be
 * meant. */
struct compiled_near {
    unsigned line, other_line; /* of their solids */
    double distance;           /* in the file's unit */
};

/* A part of the file that can't change the picture and is not in the tables, described for
 * people. */
struct compiled_dead {
    char what[80];
    const char *why;
};

struct compiled_scene {
    SCENE_FIELDS_BEFORE(COMPILED_MEMBER)
    SCENE_FIELDS_AMID(COMPILED_MEMBER)
    SCENE_FIELDS_AFTER(COMPILED_MEMBER)
    SCENE_FIELDS_SHOWN(COMPILED_MEMBER)
    double error; /* levels; 0: none is asked for */
    struct compiled_camera camera;

    char path[256];           /* of the scene file, for messages */
    char (*object_names)[32]; /* of the file's object that each is part of */

    /* How the file's coordinates became these: scaled = (p - centre) * 2^exponent. */
    double centre[3];
    int exponent;

    uint32_t primitive_count, frame_count, box_count, ball_count, polyhedron_count, quadric_count;
    uint32_t object_count, pattern_count, material_count, light_count, specular_table_count;
    uint32_t surface_count, program_length, plane_count, pattern_face_count;
    struct compiled_frame *frames;
    struct compiled_primitive *primitives;
    struct compiled_box *boxes;
    struct compiled_ball *balls;
    struct compiled_polyhedron *polyhedra;
    struct compiled_plane *planes;
    struct compiled_quadric *quadrics;
    struct compiled_set *surfaces;  /* the primitives that each bounds; NULL before compacting */
    struct compiled_set *hidden_by; /* by primitive; NULL: more than COMPILED_BITS_MOST of them */
    uint32_t *programs;
    struct compiled_object *objects;
    struct compiled_material materials[COMPILED_MATERIALS_MOST];
    struct compiled_pattern patterns[COMPILED_MATERIALS_MOST];
    struct compiled_pattern_face *pattern_faces;
    struct compiled_specular_table specular_tables[COMPILED_MATERIALS_MOST];
    struct compiled_light *lights;
    struct compiled_hierarchy hierarchy;

    /* Parts of the file's objects, and whether the picture does not need each; no part of the
     * firmware's tables. */
    uint32_t part_count;
    bool *is_left_out;

    struct compiled_report report;
    unsigned near_count; /* of all; the first ones are kept */
    struct compiled_near near[COMPILED_NEAR_MOST];
    bool has_shadows; /* some light casts them; no part of the firmware's tables */
    uint32_t nesting; /* no point is strictly inside of more primitives; nor is this in those */

    /* No part of the firmware's tables either. */
    bool has_world;      /* the file says how far the world goes */
    bool has_branches;   /* paths go on behind some surface, if the depth level lets them */
    uint8_t depth_asked; /* depth is as much of it as paths can use */
    struct compiled_dead *dead;
    uint32_t dead_count;
};

/* The steps of the scene compiler, in their order. After each of them the tables describe the same
 * scene; simplifying and fusing are three passes. */
enum compile_step {
    STEP_OBJECTS,
    STEP_SIMPLIFY,
    STEP_FUSE,
    STEP_SIMPLIFY_FUSED,
    STEP_BOUND,
    STEP_COMPACT,
    STEP_VIEW,
    STEP_SHADOWS,
    STEP_ENCLOSURES,
    STEP_COUNT
};

/* Looks at the tables after each step. The tables are valid during the call only. */
struct compile_observer {
    void (*look)(void *context, enum compile_step step, const struct compiled_scene *scene);
    void *context;
};

/* Flattens, centres, scales and analyses a scene. Returns NULL with *error filled where the scene
 * cannot be rendered; the line is that of the culprit. The caller frees the result with
 * compiled_scene_free(). */
struct compiled_scene *scene_compile(const struct scene_description *description,
                                     struct scene_error *error);

/* Loads a scene as load_scene() does, puts the overrides in and compiles the scene. The caller
 * frees the result with compiled_scene_free(). */
struct compiled_scene *load_compiled_scene(const char *name_or_path,
                                           const struct scene_overrides *overrides,
                                           struct scene_error *error);

/* Compiles as scene_compile() does and shows the tables to an observer, which may be NULL. */
struct compiled_scene *scene_compile_observed(const struct scene_description *description,
                                              const struct compile_observer *observer,
                                              struct scene_error *error);

/* A plane face of a primitive, in scaled world coordinates: normal . p < offset inside. */
struct compiled_face {
    double normal[3];
    double offset;
    uint32_t surface;
};

enum { COMPILED_FACES_MOST = SCENE_PLANES_MOST + 6 };

/* Lists the plane faces of a primitive; returns their number, which may be 0. */
int compiled_faces(const struct compiled_scene *scene, uint32_t primitive,
                   struct compiled_face faces[COMPILED_FACES_MOST]);

/* Returns an axis of a frame, or of the world for COMPILED_FRAME_WORLD. */
const double *compiled_axis(const struct compiled_scene *scene, uint32_t frame, int axis);

/* Returns the curved surface of a primitive; COMPILED_NONE if the primitive has none. */
uint32_t compiled_curve(const struct compiled_scene *scene, uint32_t primitive);

/* Measures how far, at most, the surface of one quadric lies from that of another, both in one
 * frame. The distance is taken at points spread over the part of the surface that lies in the
 * world. Returns 0 where no part does. */
double compiled_quadric_strays(const struct compiled_scene *scene, uint32_t frame,
                               const struct compiled_quadric *from,
                               const struct compiled_quadric *other);

/* Tells whether a point, in scaled coordinates, is strictly inside a primitive. */
bool compiled_primitive_holds(const struct compiled_scene *scene, uint32_t index,
                              const double point[3]);

/* Tells whether a point, in scaled coordinates, is strictly inside an object as its program has it.
 * Other objects may fill the place. */
bool compiled_object_holds(const struct compiled_scene *scene, uint32_t index,
                           const double point[3]);

/* Returns the box that cuts a quadric; NULL where none does. */
const struct compiled_box *compiled_box_of(const struct compiled_scene *scene,
                                           const struct compiled_quadric *quadric);

/* Tells whether a set has a primitive. */
bool compiled_set_has(const struct compiled_set *set, uint32_t primitive);

/* Puts a primitive into a set; false if memory is out. */
bool compiled_set_include(struct compiled_set *set, uint32_t primitive);

bool compiled_sets_are_equal(const struct compiled_set *a, const struct compiled_set *b);

/* Empties a set and frees its memory. */
void compiled_set_clear(struct compiled_set *set);

/* Returns 32 bits of a set: bit i of that word stands for primitive 32 word + i. */
uint32_t compiled_set_word(const struct compiled_set *set, uint32_t word);

/* Tells whether images whose sets are bits can hold a scene. Such an image has small numbers for
 * all that the tables have. */
bool compiled_fits_bits(const struct compiled_scene *scene);

/* Frees the tables and leaves an empty scene. */
void compiled_scene_clear(struct compiled_scene *scene);

/* Frees a scene with its tables; NULL: nothing is done. */
void compiled_scene_free(struct compiled_scene *scene);

#endif
