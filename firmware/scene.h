/* SPDX-License-Identifier: MIT */
/* The const tables of a compiled scene: all that the renderer knows. */
#ifndef SUPERFRAME_SCENE_H
#define SUPERFRAME_SCENE_H

#include <stdbool.h>
#include <stdint.h>

#include "primitive_set.h"
#include "vector.h"

/* Written by the scene compiler, for one arithmetic. Lengths are in scaled units: the file's, less
 * a centre, times a power of two. Whatever is bounded lies within +-512. */

#define SURFACE_NONE UINT16_C(0xFFFF) /* more than an int of 16 bits holds: no enumerator */

/* What is around everything: object 0, which no program describes, of material 0. */
enum { OBJECT_AIR = 0, MATERIAL_AIR = 0 };

/* A rotated system of coordinates: local = axes . (p - origin). Those of solids have their origin
 * where the scene has its own. */
struct frame {
    struct point origin;
    struct direction axis[3];
};

enum { FRAME_WORLD = 0xFF };

enum primitive_kind { PRIMITIVE_BOX, PRIMITIVE_BALL, PRIMITIVE_POLYHEDRON, PRIMITIVE_QUADRIC };

/* Names an entry of the table of its kind. */
struct primitive {
    uint8_t kind;       /* enum primitive_kind */
    uint8_t index;      /* into the table of that kind */
    uint8_t frame;      /* into frames, or FRAME_WORLD */
    bool left_for_good; /* curved and convex: a ray that has left its surfaces never returns */
    uint8_t enclosure;  /* the primitive that it lies strictly within, or ENCLOSURE_NONE */
};

enum { ENCLOSURE_NONE = 0xFF };

/* The points with minimum <= p < maximum. Faces: 0 1 2 the low ones of x y z, 3 4 5 the high ones.
 */
struct box {
    struct point minimum, maximum;
    uint16_t surface[6];
};

/* |p - centre|^2 < square_radius. */
struct ball {
    struct point centre;
    real_area square_radius;
    uint16_t surface;
};

/* normal . p < offset. */
struct plane {
    struct direction normal;
    real_length offset;
    uint16_t surface;
};

/* The points behind all of its planes, at most 255; its faces are numbered like them. */
struct polyhedron {
    uint16_t first; /* into planes */
    uint8_t count;
};

/* square . (x^2, y^2, z^2) + 2 linear z + constant < 0. The centre is the origin of x y z, which
 * run along the frame's axes. The largest of |square| is 1. A box in the same frame may cut it: one
 * primitive. Its faces are the box's and then QUADRIC_FACE, the curved one. */
struct quadric {
    struct point centre;
    struct direction square; /* not of length 1 */
    real_length linear;
    real_area constant;
    real_area square_reach; /* where it ends: no point of it is as far as that from its centre */
    uint16_t surface;       /* the curved one */
    uint8_t box;            /* into boxes, if any of its faces cuts */
    uint8_t cuts;           /* bit 0, 1, 2: the box's faces across x, y, z cut */
    bool ends;              /* it lies within its reach */
    bool left_for_good;     /* by its curved face, though not by the others */
};

enum { QUADRIC_FACE = 6 };

/* A CSG object: a Boolean function of the primitives that a point is in, as a postfix program.
 * Where objects overlap, the later one in the table fills the place. */
struct object {
    uint16_t program; /* first byte in programs */
    uint8_t length;
    uint8_t material;
    bool in_shadow_test;       /* it, or what it may cut away from, can keep light off a surface */
    struct primitive_set uses; /* the primitives of its program */
};

/* Bytes of a program: below PROGRAM_UNION the number of a primitive. */
enum { PROGRAM_UNION = 0xFD, PROGRAM_INTERSECTION = 0xFE, PROGRAM_DIFFERENCE = 0xFF };

/* Cells of two colours, along the world's axes. */
struct pattern {
    uint8_t axes; /* bit 0, 1, 2: the colour changes along x, y, z */
    uint8_t face_count;
    uint16_t first_face; /* into pattern_faces */
    struct point origin;
    struct point size;
    struct colours colour; /* of the odd cells */
};

/* A plane face across an axis of a pattern, in which cells end, or nearly. A point of such a face
 * is rounded to either cell. So the side of the face says which cell the face has. */
struct pattern_face {
    uint16_t surface;
    uint8_t axis;
    bool odd_above, odd_below; /* the cell along that axis where the solid is above, or below */
};

enum { PATTERN_NONE = 0xFF };

/* w(theta) at equal steps of theta; between them it is linear in cos(theta). */
enum { SPECULAR_STEPS = 17 };

struct specular_table {
    real_unit cosine[SPECULAR_STEPS]; /* of theta = 0 .. 90 degrees: from 1 down to 0 */
    real_energy specular[SPECULAR_STEPS];
};

enum { SPECULAR_CONSTANT = 0xFF };

struct material {
    struct colours colour;     /* Ic */
    struct colours ambient;    /* the ambient term a Ia; 0 where it is a Ic */
    real_energy ambient_share; /* a, where the ambient term is a Ic; else 0 */
    real_energy diffuse;       /* rho_d */
    real_energy specular;      /* rho_s; the mirror coefficient w of an opaque material */
    uint16_t gloss;            /* g */
    bool transparent;
    bool casts_shadow;
    bool absorbs;
    bool disperses;            /* the three indices differ */
    bool tints;                /* the factors below are not all 1 */
    uint8_t specular_table;    /* into specular_tables, or SPECULAR_CONSTANT */
    uint8_t pattern;           /* into patterns, or PATTERN_NONE */
    uint8_t optical;           /* equal for two materials if their indices are */
    real_index ior[3];         /* n for red, green, blue */
    real_index inverse_ior[3]; /* 1 / n */
    real_energy transmittance; /* tau of the simplified model (Table 1 (a)) */
    struct energies reflects;  /* factors of Ks and Kt (Table 1 (c)) */
    struct energies transmits;
    struct energies filter; /* what mixing by filters multiplies by: Ic / white */
    real_extinction absorption[3];
};

struct light {
    bool parallel;
    bool casts_shadows;       /* something may stand between it and a surface */
    struct direction towards; /* parallel: where the light comes from */
    struct point position;    /* otherwise */
    struct colours colour;    /* Ip */
};

/* The ray of dot (x, y) of a w x h picture: forward + (2x+1-w) column + (2y+1-h) row, normalised.
 * column and row are scaled up by 2^shift. */
struct camera {
    struct point eye;
    struct direction
        forward; /* shorter than 1 where pixels are far apart; then column and row are */
    struct direction column, row; /* not of length 1: half the pixel pitch times 2^shift */
    struct direction up;          /* in space, of length 1, wherever the eye looks */
    uint8_t shift;
    struct primitive_set inside; /* the primitives that the eye is strictly inside of */
    uint8_t object;              /* and the object there */
};

/* How the colours are shown (show.h). A dither goes up to half the screen's width and height, for
 * each of its pixels takes 2 x 2 dots. */
enum show { SHOW_FULL, SHOW_BITS, SHOW_DITHER, SHOW_EXPOSURES };

struct scene {
    uint16_t width, height;
    uint8_t depth;                   /* the paper's N */
    real_energy threshold;           /* a branch that weighs less is not followed */
    const struct estimate *estimate; /* what a cut branch counts as; NULL: black */
    bool estimates;                  /* it is to be learned first */
    uint32_t error;                  /* the accuracy asked for, in steps of 2^-16 level; 0: none */
    uint32_t ray_budget;             /* of a pixel: what is left then is cut */
    uint16_t brightest;              /* no surface's own intensity is above this level */
    struct colours background;
    bool simple;            /* Table 1 (a): transmittance alone, straight on */
    bool filters;           /* transparent colours multiply instead of adding */
    bool blinn;             /* highlight by beta instead of alpha */
    bool fades;             /* C + D is there */
    real_length fade_start; /* C, in scaled units */
    int8_t fade_exponent;   /* 2^this scaled units make one of the file's */
    struct camera camera;

    uint8_t primitive_count, object_count, light_count;
    const struct frame *frames;
    const struct primitive *primitives;
    const struct box *boxes;
    const struct ball *balls;
    const struct polyhedron *polyhedra;
    const struct plane *planes;
    const struct quadric *quadrics;
    const struct primitive_set *surfaces; /* by surface: the primitives that it bounds */
    /* By primitive: those that a ray leaves before it can cross this one. */
    const struct primitive_set *hidden_by;
    const uint8_t *programs;
    const struct object *objects;     /* [OBJECT_AIR] first */
    const struct material *materials; /* [MATERIAL_AIR] first */
    const struct pattern *patterns;
    const struct pattern_face *pattern_faces;
    const struct specular_table *specular_tables;
    const struct light *lights;

    /* What can stand between a surface and a light: the primitives of the objects that are marked
     * in_shadow_test. */
    struct primitive_set shadow_primitives;

    uint8_t show;      /* enum show */
    uint8_t show_bits; /* 1..8, of SHOW_BITS; 8 otherwise */
    uint32_t seed;     /* of SHOW_DITHER */
};

#endif
