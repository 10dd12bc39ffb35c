/* SPDX-License-Identifier: MIT */
/* What a scene file says, checked value by value, before anything is computed from it. */
#ifndef SUPERFRAME_SCENE_DESCRIPTION_H
#define SUPERFRAME_SCENE_DESCRIPTION_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "scene/tree.h"
#include "scene_constants.h"

/* Lengths are in the file's own unit, colours in levels (255 = white), angles in degrees. Every
 * number is finite. `line` is a line number in the file, from 1, for later error messages. */

enum {
    SCENE_DEPTH_MOST = 255,
    SCENE_ERROR_DEPTH = 64,  /* the depth level if an accuracy is asked for, but no depth */
    SCENE_NESTING_MOST = 24, /* levels of CSG nodes of an object, those of parts included */
    SCENE_PLANES_MOST = 64,  /* half-spaces of a polyhedron */
    SCENE_INSTANCES_MOST = 1024 * 1024
};

/* The finest accuracy that can be asked for, in levels. */
#define SCENE_ERROR_LEAST 0.01

enum scene_model { MODEL_SIMPLE, MODEL_FRESNEL, MODEL_WAVELENGTH };
enum scene_highlight { HIGHLIGHT_PHONG, HIGHLIGHT_BLINN };
enum scene_mixing { MIXING_ADDITIVE, MIXING_FILTER };
enum scene_colour { COLOUR_FULL, COLOUR_BITS, COLOUR_DITHER, COLOUR_EXPOSURES };

enum solid_kind {
    /* Leaves, in their own coordinates. */
    SOLID_BOX,         /* minimum, maximum */
    SOLID_BALL,        /* centre, radius */
    SOLID_CYLINDER,    /* from, to, radius */
    SOLID_CONE,        /* from, to, radius at from, radius at to (0 allowed at one of them) */
    SOLID_ELLIPSOID,   /* centre, radii */
    SOLID_PARABOLOID,  /* from (the apex), to, radius at to */
    SOLID_HYPERBOLOID, /* from, to, radius at the ends; sheets 1: radius at the waist, sheets 2: the
                          gap between the two tips; see docs/scene-format.md */
    SOLID_QUADRIC,     /* coefficients: the points where the form is <= 0 */
    SOLID_HALF_SPACE,  /* one plane: the points where normal . p <= offset */
    SOLID_POLYHEDRON,  /* planes, 4 or more: the intersection of their half-spaces */
    /* Nodes. */
    SOLID_UNION,
    SOLID_INTERSECTION,
    SOLID_DIFFERENCE, /* the first child less all others */
    SOLID_PART        /* one child: the named part */
};

/* p -> m[.][0..2] p + m[.][3]. */
struct affine {
    double m[3][4];
};

struct scene_plane {
    double normal[3]; /* unit length */
    double offset;
};

struct solid_node {
    enum solid_kind kind;
    unsigned line;
    struct affine placement; /* scale, then rotate (about x, y, z), then translate, as given */
    int material;            /* index into materials, or -1: the parent's */
    /* Leaves. The list of kinds above names the members that each uses; the others are 0. */
    double a[3];     /* minimum, centre, from */
    double b[3];     /* maximum, radii, to */
    double radius;   /* radius, radius at from, waist, gap */
    double radius_b; /* radius at to, at the ends */
    int sheets;      /* hyperboloid: 1 or 2 */
    double form[10]; /* quadric: xx yy zz xy yz zx x y z 1 */
    struct scene_plane *planes;
    size_t plane_count;
    /* Nodes: indices into nodes, always less than the node's own index. */
    const int *children;
    size_t child_count;
};

struct scene_pattern {
    bool present;
    double size[3];   /* of a cell along each axis; 0: no change along it */
    double origin[3]; /* a corner of a cell */
    double colour[3]; /* of the odd cells; the material's colour is that of the even ones */
};

struct scene_material {
    const char *name;
    unsigned line;
    double colour[3];    /* Ic */
    double ambient;      /* a, 0..1 */
    bool ambient_is_own; /* the ambient term is a Ic, not a Ia */
    double diffuse;      /* rho_d, 0..1 */
    double specular;     /* rho_s; of an opaque material also its mirror coefficient w, 0..1 */
    bool has_specular_table;
    double specular_table[SPECULAR_STEPS]; /* w(theta), if given instead of a constant */
    int gloss;                             /* g, 0..65535 */
    bool transparent;
    double ior;               /* n of the green channel; 1 where a transmittance alone is given */
    double ior_by_channel[3]; /* model wavelength: n for R, G, B; equal to ior unless given */
    double transmittance;     /* model simple: tau, 0..1 */
    double reflectance_by_channel[3];   /* model wavelength: factors of Ks, 0..1 */
    double transmittance_by_channel[3]; /* model wavelength: factors of Kt, 0..1 */
    double absorption[3];               /* alpha for each of R, G, B, per unit of length, >= 0 */
    bool casts_shadow;                  /* always true of an opaque material */
    struct scene_pattern pattern;
};

struct scene_light {
    unsigned line;
    bool parallel;
    double position[3];  /* of a point light */
    double direction[3]; /* of a parallel light: where the light travels, unit length */
    double colour[3];    /* Ip */
};

struct scene_object {
    unsigned line;
    const char *name; /* "" if none is given */
    int solid;        /* index into nodes */
    /* Where objects overlap, the later one in the file fills the place. */
};

struct scene_camera {
    unsigned line;
    double eye[3];
    double look_at[3];
    double up[3];
    double field_of_view; /* horizontal, degrees, 1..170 */
};

struct scene_description {
    struct scene_memory memory; /* of all that the pointers here lead to, but the nodes */
    const char *path;           /* as it was given, for messages */
    const char *title;
    enum scene_model model;
    enum scene_highlight highlight;
    enum scene_mixing mixing;
    enum scene_colour colour;
    int colour_bits;   /* 1..8 for COLOUR_BITS */
    uint32_t seed;     /* of the random dither */
    int width, height; /* pixels rendered: 1..640, 1..400 */
    int depth;         /* the paper's N, 0..255 */
    double threshold;  /* 0..1 */
    bool estimates;    /* a pruned branch counts as its estimated radiance, not as black */
    double error;      /* the accuracy asked for, in levels; 0: none */
    double background[3];
    double ambient[3]; /* Ia */
    bool has_attenuation;
    double attenuation_constant; /* C of C + D, >= 0 */
    double weld;  /* faces nearer than this count as one; 0: only where rounding explains the gap */
    double world; /* how far from the middle what has no end goes on, at least; 0: as it comes */
    struct scene_camera camera;
    struct scene_light *lights;
    size_t light_count;
    struct scene_material *materials;
    size_t material_count;
    struct solid_node *nodes;
    size_t node_count;
    struct scene_object *objects;
    size_t object_count;
    size_t instances; /* nodes of all objects, a part's own counted at each use of the part */
};

enum {
    SCENE_REFUSALS_MOST = 20, /* of one file */
    SCENE_REFUSAL_MOST = 448  /* bytes of one */
};

/* Why something was refused: "FILE:LINE:COLUMN: what is wrong, and what is allowed". COLUMN is left
 * out where a whole line is at fault, LINE where none is. A file's reader gives all refusals of the
 * file, one a line, in the file's order. Below each stand two lines that begin with a blank: the
 * file's line, and a mark under the column. */
struct scene_error {
    char text[SCENE_REFUSALS_MOST * 2 * SCENE_REFUSAL_MOST];
};

/* Reads a scene file's text (length bytes; path is for messages only). Returns NULL with
 * *error filled where the text is no valid scene. The caller frees the result. */
struct scene_description *scene_description_read(const char *path, const char *text, size_t length,
                                                 struct scene_error *error);

struct scene_overrides;

/* Reads a text as scene_description_read() does, with what overrides->sets assign to its values. */
struct scene_description *scene_description_read_with(const char *path, const char *text,
                                                      size_t length,
                                                      const struct scene_overrides *overrides,
                                                      struct scene_error *error);

void scene_description_free(struct scene_description *description);

#endif
