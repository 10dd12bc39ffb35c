/* SPDX-License-Identifier: MIT */
/* Declarations that the parts of the validator share. */
#ifndef SUPERFRAME_VALIDATE_INTERNAL_H
#define SUPERFRAME_VALIDATE_INTERNAL_H

#include <stdint.h>

#include "compiler/tables.h"
#include "validate/validate.h"

/* The validator works out places, forms, bounds and roots anew, without the code that it checks.
 * Where it reads the description, it does so in long double. Coordinates are scaled ones. */

/* Faces nearer than this, in scaled units, are one place to the validator. */
#define VALIDATE_NEAR 0x1p-26

/* The least distance between solids that are strictly within one another, or apart. */
#define VALIDATE_STRICTLY 0x1p-32

/* Samples stay within this: the world ends at 1024, and whatever has no end is cut off there. */
#define VALIDATE_WORLD 1020.0

static inline bool validate_is_in_world(const double point[3]) {
    return point[0] > -VALIDATE_WORLD && point[0] < VALIDATE_WORLD && point[1] > -VALIDATE_WORLD &&
           point[1] < VALIDATE_WORLD && point[2] > -VALIDATE_WORLD && point[2] < VALIDATE_WORLD;
}

/* ---- Random numbers ------------------------------------------------------------------------- */

struct dice {
    uint64_t state;
};

double dice_between(struct dice *dice, double low, double high);
int dice_below(struct dice *dice, int count);

/* Fills a direction of length 1. */
void dice_direction(struct dice *dice, double direction[3]);

/* ---- The description ------------------------------------------------------------------------ */

/* Ordered so that a union is the most of its parts and an intersection the least. */
enum side { SIDE_OUTSIDE, SIDE_NEAR, SIDE_INSIDE };

struct exact_map {
    long double m[3][4];
};

/* A node of the description at one of its places, with all placements around it. */
struct shape {
    const struct solid_node *node;
    struct exact_map to_local, from_local; /* between scaled and the node's own coordinates */
    long double slack;  /* of a leaf: points nearer to its surface than this are near */
    int child, sibling; /* -1: none */
    bool finite;        /* a leaf with the bounds below, in its own coordinates */
    long double low[3], high[3];
    int corner, corners; /* of a box or polyhedron: its corners, in its own coordinates */
};

/* A solid that is cut off a part, or to which the part is restricted. */
struct trim {
    bool outside;
    int shape, next; /* -1: none */
};

/* A solid of one material: an object of the file, or a piece of one that has several. Later parts
 * fill the place of earlier ones. */
struct part {
    int object, material; /* of the description */
    int shape, trim;
    bool is_left_out; /* of the tables: what is drawn does not need it */
};

enum { CORNERS_OF_NODE = 16 };

struct described {
    const struct scene_description *description;
    struct shape *shapes;
    struct trim *trims;
    struct part *parts;
    int *leaves;
    long double (*corners)[3];
    int shape_count, trim_count, part_count, leaf_count, corner_count;
    int shapes_most, corners_most; /* of which there is room; trims, parts and leaves like shapes */
};

/* Unfolds a description as seen through a scaling; false if memory is out. Call described_free() in
 * either case. */
bool described_unfold(struct described *described, const struct scene_description *description,
                      const double centre[3], int exponent);
void described_free(struct described *described);

/* Returns on which side of a part, or of a leaf, a point lies. */
enum side part_side(const struct described *described, int part, const double point[3]);
enum side leaf_side(const struct shape *leaf, const double point[3]);

/* Finds the part that fills a point, of those that are in the tables. Returns -1 for the air, -2 if
 * the point lies too near to a face. */
int described_filler(const struct described *described, const double point[3]);

/* Maps a point of a leaf's own coordinates to scaled ones. */
void leaf_place(const struct shape *leaf, const long double local[3], double point[3]);

/* ---- Samples -------------------------------------------------------------------------------- */

/* Finds bounds and corners of all leaves; samples and rays are drawn from these. */
void described_measure(struct described *described);

/* Makes the sample of that number. Samples lie all over the scene, near each leaf, on both sides of
 * its faces, near corners and edges. Some lie far away, or along the axes. */
void described_sample(const struct described *described, struct dice *dice, unsigned number,
                      double point[3]);

struct sight_line {
    double origin[3], direction[3];
    bool random; /* no face can lie across it in a special place */
};

/* Makes the ray of that number: a line through a point in or about some leaf. */
void described_ray(const struct described *described, struct dice *dice, unsigned number,
                   struct sight_line *ray);

/* ---- The tables ----------------------------------------------------------------------------- */

/* One face of a primitive, as a function that is negative inside. A plane has no square. */
struct table_face {
    bool curved;
    double normal[3], offset;
    double centre[3], axis[3][3], square[3], linear, constant;
    uint32_t surface;
};

struct table {
    const struct compiled_scene *scene;
    struct table_face *faces;
    uint32_t face_count;
    uint32_t *first, *count; /* faces of each primitive */
    bool *used;              /* some program names it */
};

/* Reads the faces of all primitives that programs name; false if memory is out. */
bool table_read(struct table *table, const struct compiled_scene *scene);
void table_free(struct table *table);

/* Returns true if nothing is wrong with the tables' indices, counts and programs; else text[] says
 * what is. Only whole tables may be read. */
bool table_is_whole(const struct compiled_scene *scene, char text[200]);

/* Estimates how far a point lies outside of a face, or of a primitive; the distance is below 0
 * inside. */
double face_distance(const struct table_face *face, const double point[3]);
double table_distance(const struct table *table, uint32_t primitive, const double point[3]);

/* Computes a face's outward direction at a point, not of length 1. */
void face_gradient(const struct table_face *face, const double point[3], double gradient[3]);

/* Tells for each primitive in use whether it holds a point. */
void table_inside(const struct table *table, const double point[3], bool inside[]);

bool table_object_holds(const struct table *table, uint32_t object, const bool inside[]);

/* A place where a ray crosses a primitive. */
struct table_crossing {
    double t, point[3];
    uint32_t primitive;
    const struct table_face *face;
    bool clean; /* found exactly, neither grazing nor near to an edge */
};

enum { TABLE_CROSSINGS_MOST = 1024 };

/* The firmware evaluates a program with so many places. */
enum { TABLE_DEPTH_MOST = 32 };

/* Finds the crossings of a line beyond the distance `from`, in order. Returns their number. */
int table_crossings(const struct table *table, const struct sight_line *line, double from,
                    struct table_crossing crossings[TABLE_CROSSINGS_MOST]);

/* ---- The checks ----------------------------------------------------------------------------- */

struct validator {
    const struct compiled_scene *scene;
    struct described described;
    struct table table;
    enum compile_step step;
    uint32_t *object_of_part; /* COMPILED_NONE: it was left out */
    bool *inside;             /* by primitive: whether it holds the point at work */
    struct dice dice;
    struct validation *validation;
};

/* Counts a fault, and keeps the words of the first one. A place may be NULL. */
void validate_fault(struct validator *validator, const double place[3], const char *format, ...)
#if defined(__GNUC__)
    __attribute__((format(printf, 3, 4)))
#endif
    ;

/* Returns the line of the file that a primitive comes from; 0 where there is no such primitive. */
unsigned validate_line(const struct validator *validator, uint32_t primitive);

/* Compares one point in the description and the tables. */
void validate_point(struct validator *validator, const double point[3]);

/* Checks the tables' claims at the crossings of one ray. */
void validate_crossings(struct validator *validator, const struct sight_line *ray,
                        const struct table_crossing *crossings, int count);

/* Checks a primitive's bounds, and its reach along so many directions, at a point of the
 * primitive. */
void validate_reach(struct validator *validator, uint32_t primitive, const double point[3],
                    int directions);

/* Checks what the tables say as a whole: the sets of surfaces, the eye. */
void validate_surface_sets(struct validator *validator);
void validate_eye(struct validator *validator);

/* Checks the path from a crossing to some light, or the set of primitives that the shadow test
 * uses. */
void validate_shadow(struct validator *validator, const struct sight_line *ray,
                     const struct table_crossing *crossing);
void validate_shadow_sets(struct validator *validator);

#endif
