/* SPDX-License-Identifier: MIT */
/* The const tables of a compiled scene: all that the renderer knows. scene_fields.h has their
 * members, with what each means. */
#ifndef SUPERFRAME_SCENE_H
#define SUPERFRAME_SCENE_H

#include <stdbool.h>
#include <stdint.h>

#include "feature_set.h"
#include "scene_constants.h"
#include "scene_fields.h"
#include "vector.h"

/* Written by the scene compiler, for one arithmetic. Lengths are in scaled units: the file's, less
 * a centre, times a power of two. Whatever is bounded lies within +-512. */

/* The types of members, by their roles. */
#define SCENE_MEMBER(role, name) SCENE_##role(name)
#define SCENE_POINT(name)        struct point name;
#define SCENE_DIRECTION(name)    struct direction name;
#define SCENE_DIRECTIONS(name)   struct direction name[3];
#define SCENE_LENGTH(name)       real_length name;
#define SCENE_AREA(name)         real_area name;
#define SCENE_UNIT_STEPS(name)   real_unit name[SPECULAR_STEPS];
#define SCENE_COLOURS(name)      struct colours name;
#define SCENE_ENERGIES(name)     struct energies name;
#define SCENE_ENERGY(name)       real_energy name;
#define SCENE_ENERGY_STEPS(name) real_energy name[SPECULAR_STEPS];
#define SCENE_INDICES(name)      real_index name[3];
#define SCENE_EXTINCTIONS(name)  real_extinction name[3];
#define SCENE_BYTE(name)         uint8_t name;
#define SCENE_WORD(name)         uint16_t name;
#define SCENE_LONG(name)         uint32_t name;
#define SCENE_SIGNED(name)       int8_t name;
#define SCENE_TRUTH(name)        bool name;
#define SCENE_ENTRY(name)        entry_number name;
#define SCENE_SURFACE(name)      surface_number name;
#define SCENE_SURFACES(name)     surface_number name[6];
#define SCENE_FIRST(name)        run_first name;
#define SCENE_COUNT(name)        run_count name;
#define SCENE_PLACES(name)       real_length name[3][NODE_WIDTH];
#define SCENE_CHILDREN(name)     run_first name[NODE_WIDTH];
#define SCENE_SET(name)          struct primitive_set name;
#define SCENE_MARKS(name)        PRIMITIVE_MARKS(name)

struct frame {
    FRAME_FIELDS(SCENE_MEMBER)
};

struct primitive {
    uint8_t kind; /* enum primitive_kind */
    PRIMITIVE_FIELDS(SCENE_MEMBER)
};

struct box {
    BOX_FIELDS(SCENE_MEMBER)
};

struct ball {
    BALL_FIELDS_BEFORE(SCENE_MEMBER)
    real_area square_radius;
    BALL_FIELDS_AFTER(SCENE_MEMBER)
};

struct plane {
    PLANE_FIELDS(SCENE_MEMBER)
};

struct polyhedron {
    POLYHEDRON_FIELDS(SCENE_MEMBER)
};

struct quadric {
    QUADRIC_FIELDS_BEFORE(SCENE_MEMBER)
    real_area square_reach; /* where it ends: no point of it is as far as that from its centre */
    QUADRIC_FIELDS_AMID(SCENE_MEMBER)
    bool ends; /* it lies within its reach */
    QUADRIC_FIELDS_AFTER(SCENE_MEMBER)
};

struct object {
    OBJECT_FIELDS(SCENE_MEMBER)
};

struct bounds_node {
    NODE_FIELDS(SCENE_MEMBER)
};

struct lead {
    LEAD_FIELDS(SCENE_MEMBER)
};

struct use {
    USE_FIELDS(SCENE_MEMBER)
};

struct pattern {
    PATTERN_FIELDS(SCENE_MEMBER)
};

struct pattern_face {
    PATTERN_FACE_FIELDS(SCENE_MEMBER)
};

struct specular_table {
    SPECULAR_TABLE_FIELDS(SCENE_MEMBER)
};

struct material {
    MATERIAL_FIELDS(SCENE_MEMBER)
};

struct light {
    LIGHT_FIELDS(SCENE_MEMBER)
};

struct camera {
    CAMERA_FIELDS(SCENE_MEMBER)
};

struct scene {
    SCENE_FIELDS_BEFORE(SCENE_MEMBER)
    const struct estimate *estimate; /* what a pruned branch counts as; NULL: black */
    SCENE_FIELDS_AMID(SCENE_MEMBER)
    uint32_t error; /* the accuracy asked for, in steps of 2^-16 level; 0: none */
    SCENE_FIELDS_AFTER(SCENE_MEMBER)
    struct camera camera;

    entry_number primitive_count, object_count, light_count;
    const struct frame *frames;
    const struct primitive *primitives;
    const struct box *boxes;
    const struct ball *balls;
    const struct polyhedron *polyhedra;
    const struct plane *planes;
    const struct quadric *quadrics;
    PRIMITIVE_TABLES /* by which rays are led to primitives */
        const program_code *programs;
    const struct object *objects;     /* [OBJECT_AIR] first */
    const struct material *materials; /* [MATERIAL_AIR] first */
    const struct pattern *patterns;
    const struct pattern_face *pattern_faces;
    const struct specular_table *specular_tables;
    const struct light *lights;

    SCENE_FIELDS_SHOWN(SCENE_MEMBER)
};

#endif
