/* SPDX-License-Identifier: MIT */
/* Declarations that the parts of the scene compiler share. */
#ifndef SUPERFRAME_COMPILE_INTERNAL_H
#define SUPERFRAME_COMPILE_INTERNAL_H

#include "compiler/affine.h"
#include "compiler/bounds.h"
#include "compiler/buckets.h"
#include "compiler/extents.h"
#include "compiler/neighbours.h"
#include "compiler/quadric_form.h"
#include "compiler/tables.h"

/* Bounded content lies within COMPILE_EXTENT; what is unbounded ends at twice that
 * (firmware/scene.h). */
#define COMPILE_EXTENT 512.0
#define COMPILE_WORLD  COMPILED_WORLD

/* Surfaces and coordinates nearer to each other than this, in scaled units, are one. So are those
 * nearer than the file's own numbers resolve. At 512 that is 32 units in the last place of a
 * double, for placements that are composed one after the other. */
#define COMPILE_SAME 0x1p-38

/* Faces that are farther apart than this never become one. */
#define COMPILE_WELD_MOST 0x1p-5

/* What is strictly inside is so by more than this: no arithmetic's rounding can put it outside. */
#define COMPILE_STRICTLY 0x1p-30

/* The distance between what can be seen of a solid and faces that are there only to end it. It is
 * more than any arithmetic's rounding. */
#define COMPILE_MARGIN 0x1p-4

/* Solids farther apart than this are apart in every arithmetic: no rounding lets a ray be in
 * both. */
#define COMPILE_GAP 0x1p-6

/* All lengths of the firmware end here (LENGTH_FAR). */
#define COMPILE_FAR 2047.0

/* A plane in scaled world coordinates, for finding faces that coincide. */
struct compile_plane {
    double normal[3];
    double offset;
};

/* The reasons why things of the file can't change its picture, by their numbers there; NULL: they
 * may. */
struct compile_dead {
    const char **part;  /* objects fall apart into one part a material */
    const char **light; /* for each light of the file */
    const char *material[COMPILED_MATERIALS_MOST];
    /* Of a material that is not dead. Its look is all of it but its shadow; the rest are parts of
     * its look. */
    const char *look[COMPILED_MATERIALS_MOST], *pattern[COMPILED_MATERIALS_MOST];
    const char *table[COMPILED_MATERIALS_MOST]; /* of w(theta): a constant does as well */
    const char *highlight[COMPILED_MATERIALS_MOST], *absorption[COMPILED_MATERIALS_MOST];
    unsigned count; /* of all these */
    size_t *object_of_part;
    uint32_t part_count;
    bool keeps_scale;  /* what is left does not fit its own scale */
    bool has_endless;  /* something endless can be seen, whose end the dead ones decide, too */
    bool lacks_memory; /* not all could be listed */
};

/* What is found again by the hash of its numbers. */
enum known {
    KNOWN_DIRECTION,
    KNOWN_PLANE,
    KNOWN_FRAME,
    KNOWN_BOX,
    KNOWN_POLYHEDRON,
    KNOWN_QUADRIC
};

/* Primitives with a curved surface. Those of `along` go on along one of the world's axes alone:
 * their bounds have that axis at 0. */
struct curves {
    struct neighbours ended, along[3];
    struct endless_curve *endless; /* the others; grows as base/grow.h says */
    uint32_t endless_count;
};

struct endless_curve {
    struct quadric_axes form;
    uint32_t primitive;
};

struct compiler {
    const struct scene_description *description;
    struct compiled_scene *scene;
    struct scene_error *error;
    const struct compile_observer *observer; /* NULL: none */
    struct compile_dead *dead;
    uint8_t material_of[COMPILED_MATERIALS_MOST]; /* a material of the file: its number here */
    struct affine scaling;                        /* the file's coordinates to scaled ones */
    double same;             /* lengths that differ by no more are one, in scaled units */
    unsigned line;           /* of the node or object at work */
    unsigned lost_line;      /* of a half-space of the object that lies out of the world; 0: none */
    const char *object_name; /* of the object at work */
    size_t object;           /* its number in the file */
    struct compile_plane *planes; /* by surface; normal null: no plane */
    double (*directions)[3];      /* the world's axes, and others that were met, up to their sign */
    uint32_t direction_count;
    struct buckets known; /* directions, planes, frames and solids, by enum known */
    struct curves curves;
    struct neighbours solids; /* all primitives, when the tables are done */
};

/* Records why the scene is refused (line 0: of the whole file) and returns false. */
bool compile_fail(struct compiler *compiler, unsigned line, const char *format, ...)
#if defined(__GNUC__)
    __attribute__((format(printf, 3, 4)))
#endif
    ;

/* Records that memory is out and returns false. */
bool compile_fail_memory(struct compiler *compiler);

/* Records the same, where an entry was to be made; returns COMPILED_NONE. */
uint32_t compile_fail_room(struct compiler *compiler);

/* Returns what the keys of a kind begin with. */
uint64_t compile_key(enum known kind);

/* Notes an entry under the key of what it is, and returns the entry. Returns COMPILED_NONE for
 * COMPILED_NONE, or with the failure recorded. */
uint32_t compile_note(struct compiler *compiler, uint64_t key, uint32_t entry);

/* Shows the tables to the observer, if there is one. */
void compile_show(const struct compiler *compiler, enum compile_step step);

/* Finds centre and scale from the bounds of bounded solids, the eye and the point lights. */
bool compile_scaling(struct compiler *compiler);

/* Compiles how the colours are shown; false with the failure recorded. */
bool compile_colour(struct compiler *compiler);

/* Compiles the objects, with their programs, primitives and surfaces. */
bool compile_objects(struct compiler *compiler);

/* Appends a code to the program of the object at work. */
bool compile_append(struct compiler *compiler, uint32_t code);

/* Appends a leaf's program: one primitive, or a quadric and the slab that ends it. The placement
 * maps the leaf's own coordinates to scaled ones. A solid that is there already gives the same
 * primitive. */
bool compile_leaf(struct compiler *compiler, const struct solid_node *leaf,
                  const struct affine *placement);

/* Adds a primitive of that kind, or finds the one of the same solid. Returns its number, or
 * COMPILED_NONE with the failure recorded. */
uint32_t compile_box(struct compiler *compiler, const struct solid_node *leaf,
                     const struct affine *placement);
uint32_t compile_box_in(struct compiler *compiler, uint32_t frame, const double low[3],
                        const double high[3]);
uint32_t compile_world_box(struct compiler *compiler, const double low[3], const double high[3]);
uint32_t compile_half_space(struct compiler *compiler, const struct scene_plane *plane,
                            const struct affine *placement);
uint32_t compile_placed_half_space(struct compiler *compiler, const struct scene_plane *plane);
uint32_t compile_polyhedron(struct compiler *compiler, const struct scene_plane *planes,
                            size_t count, const struct affine *placement);
uint32_t compile_placed_polyhedron(struct compiler *compiler, const struct scene_plane *planes,
                                   size_t count);
uint32_t compile_quadric(struct compiler *compiler, const struct solid_node *leaf,
                         const struct affine *placement);

/* Appends the program of a quadric that is given by its coefficients, which may be those of two
 * parallel planes. */
bool compile_general_quadric(struct compiler *compiler, const struct solid_node *leaf,
                             const struct affine *placement);

/* Adds an entry to the table of primitives, with what is common to all kinds. Returns its number,
 * or COMPILED_NONE with the failure recorded. */
uint32_t compile_new_primitive(struct compiler *compiler, enum primitive_kind kind, uint32_t index,
                               uint32_t frame, bool left_for_good);

/* Returns the key under which quadrics with that surface and those cuts are noted. */
uint64_t compile_quadric_key(const struct compiled_quadric *quadric, uint32_t frame,
                             const struct compiled_box *box);

/* Adds a quadric, likewise. */
uint32_t compile_new_quadric(struct compiler *compiler, const struct compiled_quadric *quadric,
                             uint32_t frame, bool left_for_good);

/* Tells whether two scaled lengths are one to the compiler. */
bool compile_same(const struct compiler *compiler, double a, double b);

/* Replaces a direction of length 1 by one that was met before, or by its opposite, if the two count
 * as one. Coincident faces thus have the same normal to the last bit. Returns false with the
 * failure recorded. */
bool compile_direction(struct compiler *compiler, double direction[3]);

/* Finds or adds the frame with these axes, up to their order and signs. A solid of the frame has to
 * follow these. permutation[i] is the axis that became axis i of the frame, sign[i] its sign. With
 * third_stays, axis 2 is to be axis 2 of the frame. *frame is COMPILED_FRAME_WORLD if the axes are
 * the world's. Returns false with the failure recorded. */
bool compile_frame(struct compiler *compiler, double axis[3][3], bool third_stays,
                   int permutation[3], double sign[3], uint32_t *frame);

/* Places a plane by its normal, of length 1, and one of its points; false with the failure
 * recorded.
 */
bool compile_placed_plane(struct compiler *compiler, const double normal[3], const double point[3],
                          const struct affine *placement, struct scene_plane *placed);

/* Finds or adds the surface of a plane, which is given in scaled world coordinates. `normal` comes
 * from compile_direction(); a surface that coincides is found again. Returns its number, or
 * COMPILED_NONE with the failure recorded. */
uint32_t compile_plane_surface(struct compiler *compiler, const double normal[3], double offset);

/* Returns the coordinate at which the plane of a surface crosses an axis that it lies across. */
double compile_place_of_plane(const struct compiler *compiler, uint32_t surface,
                              const double axis[3]);

/* Finds the ball or quadric whose curved surface is that of a form. *twin becomes its
 * number, or COMPILED_NONE if there is none. *opposite says whether it lies on the other side of
 * that surface. Returns false with the failure recorded. */
bool compile_same_curve(struct compiler *compiler, const struct quadric_axes *form, uint32_t *twin,
                        bool *opposite);

/* Notes the curved surface of a primitive, for the function above to find, and returns the
 * primitive. Returns COMPILED_NONE for COMPILED_NONE, or with the failure recorded. */
uint32_t compile_note_curve(struct compiler *compiler, uint32_t primitive);

/* Frees all memory and leaves nothing in it. */
void curves_clear(struct curves *curves);

/* Records that faces of one solid have become one surface; returns COMPILED_NONE. */
uint32_t compile_fail_thin(struct compiler *compiler);

/* Adds a surface. Returns its number, or COMPILED_NONE with the failure recorded. */
uint32_t compile_new_surface(struct compiler *compiler);

/* Compiles the pattern of a material, if it has one; false with the failure recorded. */
bool compile_pattern(struct compiler *compiler, const struct scene_material *from,
                     struct compiled_material *material);

/* Notes the faces in which patterns' cells end, once surfaces have their final numbers. */
bool compile_pattern_faces(struct compiler *compiler);

/* Notes faces that are so near to each other that they were probably meant as one. Returns false
 * with the failure recorded. */
bool compile_near(struct compiler *compiler);

/* Points spread over the curved surface of a primitive; none where it has none. */
enum { CURVE_POINTS_MOST = 24 };
struct curve_sample {
    double points[CURVE_POINTS_MOST + 1][3];
    int count;
    uint32_t primitive;
};

void compile_sample_curve(const struct compiled_scene *scene, uint32_t primitive,
                          struct curve_sample *sample);

/* Returns the largest distance of a sample from the curved surface of another primitive. It is
 * infinite where one of the two has none or both have the same, and for too few points. */
double compile_curve_distance(const struct compiled_scene *scene, struct curve_sample *sample,
                              uint32_t other);

/* Returns the largest and the least level of a channel that the material's own colour has, or its
 * pattern's. */
double compiled_colour_most(const struct compiled_scene *scene,
                            const struct compiled_material *material, int channel);
double compiled_colour_least(const struct compiled_scene *scene,
                             const struct compiled_material *material, int channel);

/* Compiles a part of the scene: camera, materials, lights, bounds of light, what can throw
 * shadows. False with the failure recorded. */
bool compile_view(struct compiler *compiler);
bool compile_materials(struct compiler *compiler);
bool compile_lights(struct compiler *compiler);
void compile_light_bounds(struct compiler *compiler);
bool compile_shadows(struct compiler *compiler);

/* Makes the tables cheaper to render, and says so in the scene's report. */
bool compile_optimise(struct compiler *compiler);

/* Notes the bounds of all primitives in compiler->solids, so that each later step looks at those
 * that may meet. False with the failure recorded. */
bool compile_solids(struct compiler *compiler);

/* Finds how many primitives a point may be strictly inside of, at most; false with the failure
 * recorded. */
bool compile_nesting(struct compiler *compiler);

/* Finds which primitives lie within or apart from which, so that a ray need not be tried against
 * all. False with the failure recorded. */
bool compile_enclosures(struct compiler *compiler);

/* Builds the hierarchies of bounds; false with the failure recorded. */
bool compile_hierarchy(struct compiler *compiler);

/* Finds which objects each primitive takes part in, for the leads that the hierarchies have. False
 * with the failure recorded. */
bool compile_uses(struct compiler *compiler);

/* Tells whether one primitive lies strictly within a convex one, or whether two are more than
 * COMPILE_GAP apart. False may also mean that this was not found. */
bool primitive_is_within(const struct compiled_scene *scene, uint32_t inner, uint32_t outer);
bool primitives_are_apart(const struct compiled_scene *scene, uint32_t one, uint32_t other);

#endif
