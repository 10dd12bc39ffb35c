/* SPDX-License-Identifier: MIT */
/* The members of a scene's tables, each once: its role, and its name.
 *
 * firmware/scene.h makes the structs of an arithmetic from these lists. compiler/tables.h makes
 * those in doubles. per_arithmetic/load.c turns one into the other, and compiler/emit.c writes C
 * source.
 *
 * A role says what a member holds.
 * POINT, DIRECTION: three coordinates. DIRECTIONS: three directions.
 * LENGTH, AREA, ENERGY: a number of that meaning.
 * UNIT_STEPS, ENERGY_STEPS: SPECULAR_STEPS numbers.
 * COLOURS, ENERGIES, INDICES, EXTINCTIONS: three numbers, for red, green and blue.
 * BYTE, WORD, LONG: 8, 16 and 32 bits. SIGNED: 8 bits with a sign. TRUTH: a bool.
 * ENTRY: the number of an entry of a table. SURFACE: that of a surface. SURFACES: six of those.
 * FIRST, COUNT: where a run of entries begins, and how long the run is.
 * PLACES: NODE_WIDTH lengths for each axis. CHILDREN: what NODE_WIDTH bounds hold.
 * SET: a set of primitives. MARKS: a set that has room for all primitives. Where rays carry lists,
 * nothing goes by marks, and there are none.
 * Lengths are in scaled units. */
#ifndef SUPERFRAME_SCENE_FIELDS_H
#define SUPERFRAME_SCENE_FIELDS_H

/* A rotated system of coordinates: local = axes . (p - origin). Those of solids have their origin
 * where the scene has its own. */
#define FRAME_FIELDS(F)                                                                            \
    F(POINT, origin)                                                                               \
    F(DIRECTIONS, axis)

/* Names an entry of the table of its kind; the kind, an enum primitive_kind, comes first. */
#define PRIMITIVE_FIELDS(F)                                                                        \
    F(ENTRY, index)         /* into the table of that kind */                                      \
    F(ENTRY, frame)         /* into frames, or FRAME_WORLD */                                      \
    F(TRUTH, left_for_good) /* curved, convex: a ray that has left it never returns */             \
    F(ENTRY, enclosure)     /* the primitive that it lies strictly within, or ENCLOSURE_NONE */

/* The points with minimum <= p < maximum. Faces: 0 1 2 the low ones of x y z, 3 4 5 the high ones.
 */
#define BOX_FIELDS(F)                                                                              \
    F(POINT, minimum)                                                                              \
    F(POINT, maximum)                                                                              \
    F(SURFACES, surface)

/* normal . p < offset. */
#define PLANE_FIELDS(F)                                                                            \
    F(DIRECTION, normal)                                                                           \
    F(LENGTH, offset)                                                                              \
    F(SURFACE, surface)

/* The points behind all of its planes, at most 255; its faces are numbered like them. */
#define POLYHEDRON_FIELDS(F)                                                                       \
    F(FIRST, first) /* into planes */                                                              \
    F(BYTE, count)

/* |p - centre|^2 < radius^2. The firmware has square_radius between the two. */
#define BALL_FIELDS_BEFORE(F) F(POINT, centre)
#define BALL_FIELDS_AFTER(F)  F(SURFACE, surface)

/* square . (x^2, y^2, z^2) + 2 linear z + constant < 0. The centre is the origin of x y z, which
 * run along the frame's axes. The largest of |square| is 1. A box in the same frame may cut it: one
 * primitive. Its faces are the box's and then QUADRIC_FACE, the curved one. The firmware has
 * square_reach before the surface, and whether the quadric ends before left_for_good. */
#define QUADRIC_FIELDS_BEFORE(F)                                                                   \
    F(POINT, centre)                                                                               \
    F(DIRECTION, square) /* not of length 1 */                                                     \
    F(LENGTH, linear)                                                                              \
    F(AREA, constant)
#define QUADRIC_FIELDS_AMID(F)                                                                     \
    F(SURFACE, surface) /* the curved one */                                                       \
    F(ENTRY, box)       /* into boxes, if any of its faces cuts */                                 \
    F(BYTE, cuts)       /* bit 0, 1, 2: the box's faces across x, y, z cut */
#define QUADRIC_FIELDS_AFTER(F)                                                                    \
    F(TRUTH, left_for_good) /* by its curved face, though not by the others */

/* A CSG object: a Boolean function of the primitives that a point is in, as a postfix program.
 * Where objects overlap, the later one in the table fills the place. */
#define OBJECT_FIELDS(F)                                                                           \
    F(FIRST, program) /* first code in programs */                                                 \
    F(COUNT, length)                                                                               \
    F(BYTE, material)                                                                              \
    F(TRUTH, in_shadow_test) /* it, or what it may cut away from, can keep light off a surface */  \
    F(MARKS, uses)           /* the primitives of its program */

/* A node of a hierarchy: NODE_WIDTH bounds, each a little larger than what it holds. A bound holds
 * another node, or the primitive NODE_PRIMITIVE + number, or nothing: then low is above high. The
 * places of low and high faces stand by axis, then by bound. */
#define NODE_FIELDS(F)                                                                             \
    F(PLACES, low)                                                                                 \
    F(PLACES, high)                                                                                \
    F(CHILDREN, child)

/* Leads a search on from within a primitive, and names the objects that the primitive is part of.
 * An object holds no place that is in none of its keys. */
#define LEAD_FIELDS(F)                                                                             \
    /* The hierarchies of what lies strictly within the primitive and not within one of those. The \
     * second has what can keep off light. NODE_NONE: there is nothing. */                         \
    F(FIRST, within)                                                                               \
    F(FIRST, within_shadow)                                                                        \
    F(TRUTH, in_shadow_test) /* the primitive is one of shadow_primitives */                       \
    F(TRUTH, stands_apart)   /* from all that is neither within it nor around it */                \
    F(FIRST, key)            /* into keys: the objects that it is a key of */                      \
    F(COUNT, key_count)                                                                            \
    F(FIRST, use) /* into uses: its places in all programs, by object and place */                 \
    F(COUNT, use_count)

#define USE_FIELDS(F)                                                                              \
    F(ENTRY, object)                                                                               \
    F(FIRST, place) /* from the program's first code */

/* Cells of two colours, along the world's axes. */
#define PATTERN_FIELDS(F)                                                                          \
    F(BYTE, axes) /* bit 0, 1, 2: the colour changes along x, y, z */                              \
    F(COUNT, face_count)                                                                           \
    F(FIRST, first_face) /* into pattern_faces */                                                  \
    F(POINT, origin)                                                                               \
    F(POINT, size)                                                                                 \
    F(COLOURS, colour) /* of the odd cells */

/* A plane face across an axis of a pattern, in which cells end, or nearly. A point of such a face
 * is rounded to either cell. So the side of the face says which cell the face has. */
#define PATTERN_FACE_FIELDS(F)                                                                     \
    F(SURFACE, surface)                                                                            \
    F(BYTE, axis)                                                                                  \
    F(TRUTH, odd_above) /* the cell along that axis where the solid is above */                    \
    F(TRUTH, odd_below) /* or below */

/* w(theta) at equal steps of theta; between them it is linear in cos(theta). */
#define SPECULAR_TABLE_FIELDS(F)                                                                   \
    F(UNIT_STEPS, cosine) /* of theta = 0 .. 90 degrees: from 1 down to 0 */                       \
    F(ENERGY_STEPS, specular)

#define MATERIAL_FIELDS(F)                                                                         \
    F(COLOURS, colour)       /* Ic */                                                              \
    F(COLOURS, ambient)      /* the ambient term a Ia; 0 where it is a Ic */                       \
    F(ENERGY, ambient_share) /* a, where the ambient term is a Ic; else 0 */                       \
    F(ENERGY, diffuse)       /* rho_d */                                                           \
    F(ENERGY, specular)      /* rho_s; the mirror coefficient w of an opaque material */           \
    F(WORD, gloss)           /* g */                                                               \
    F(TRUTH, transparent)                                                                          \
    F(TRUTH, casts_shadow)                                                                         \
    F(TRUTH, absorbs)                                                                              \
    F(TRUTH, disperses)      /* the three indices differ */                                        \
    F(TRUTH, tints)          /* the factors below are not all 1 */                                 \
    F(BYTE, specular_table)  /* into specular_tables, or SPECULAR_CONSTANT */                      \
    F(BYTE, pattern)         /* into patterns, or PATTERN_NONE */                                  \
    F(BYTE, optical)         /* equal for two materials if their indices are */                    \
    F(INDICES, ior)          /* n */                                                               \
    F(INDICES, inverse_ior)  /* 1 / n */                                                           \
    F(ENERGY, transmittance) /* tau of the simplified model (Table 1 (a)) */                       \
    F(ENERGIES, reflects)    /* factors of Ks and Kt (Table 1 (c)) */                              \
    F(ENERGIES, transmits)                                                                         \
    F(ENERGIES, filter) /* what mixing by filters multiplies by: Ic / white */                     \
    F(EXTINCTIONS, absorption)

#define LIGHT_FIELDS(F)                                                                            \
    F(TRUTH, parallel)                                                                             \
    F(TRUTH, casts_shadows) /* something may stand between it and a surface */                     \
    F(DIRECTION, towards)   /* parallel: where the light comes from */                             \
    F(POINT, position)      /* otherwise */                                                        \
    F(COLOURS, colour)      /* Ip */

/* The ray of dot (x, y) of a w x h picture: forward + (2x+1-w) column + (2y+1-h) row, normalised.
 * column and row are scaled up by 2^shift. */
#define CAMERA_FIELDS(F)                                                                           \
    F(POINT, eye)                                                                                  \
    F(DIRECTION, forward) /* shorter than 1 where pixels are far apart; then column and row are */ \
    F(DIRECTION, column)  /* not of length 1: half the pixel pitch times 2^shift */                \
    F(DIRECTION, row)                                                                              \
    F(DIRECTION, up) /* in space, of length 1, wherever the eye looks */                           \
    F(BYTE, shift)                                                                                 \
    F(SET, inside)   /* the primitives that the eye is strictly inside of */                       \
    F(ENTRY, object) /* and the object there */

/* Lists the scene's own members that stand before the estimate of pruned branches. */
#define SCENE_FIELDS_BEFORE(F)                                                                     \
    F(WORD, width)                                                                                 \
    F(WORD, height)                                                                                \
    F(BYTE, depth)       /* the paper's N */                                                       \
    F(ENERGY, threshold) /* a branch that weighs less is not followed */

/* Behind it. The firmware has the accuracy that is asked for after these. */
#define SCENE_FIELDS_AMID(F) F(TRUTH, estimates) /* an estimate is to be learned first */

#define SCENE_FIELDS_AFTER(F)                                                                      \
    F(LONG, ray_budget) /* of a pixel: what is left then is cut */                                 \
    /* A branch that may meet n boundaries gathers darkest to brightest + (n - 1) brightest_each   \
     * levels a weight of 1. */                                                                    \
    F(WORD, darkest)                                                                               \
    F(LONG, brightest)                                                                             \
    F(LONG, brightest_each)                                                                        \
    F(COLOURS, background)                                                                         \
    F(TRUTH, simple)         /* Table 1 (a): transmittance alone, straight on */                   \
    F(TRUTH, filters)        /* transparent colours multiply instead of adding */                  \
    F(TRUTH, blinn)          /* highlight by beta instead of alpha */                              \
    F(TRUTH, fades)          /* C + D is there */                                                  \
    F(LENGTH, fade_start)    /* C */                                                               \
    F(SIGNED, fade_exponent) /* 2^this scaled units make one of the file's */

/* The hierarchies that are not within a primitive, and how many primitives have no end. */
#define SCENE_HIERARCHY_FIELDS(F)                                                                  \
    F(FIRST, root)                                                                                 \
    F(FIRST, shadow_root)                                                                          \
    F(COUNT, endless_count)

/* At its end. */
#define SCENE_FIELDS_SHOWN(F)                                                                      \
    F(MARKS, shadow_primitives) /* of the objects that are marked in_shadow_test */                \
    F(BYTE, show)               /* enum show */                                                    \
    F(BYTE, show_bits)          /* 1..8, of SHOW_BITS; 8 otherwise */                              \
    F(LONG, seed)               /* of SHOW_DITHER */

#endif
