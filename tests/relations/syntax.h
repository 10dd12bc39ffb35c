/* SPDX-License-Identifier: MIT */
/* The abstract syntax of a generated scene: what relations rewrite before it becomes text. */
#ifndef SUPERFRAME_RELATIONS_SYNTAX_H
#define SUPERFRAME_RELATIONS_SYNTAX_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum syntax_kind {
    SYNTAX_BOX, /* a: minimum, b: maximum */
    SYNTAX_BALL,
    SYNTAX_CYLINDER,   /* a: from, b: to, as for the next three kinds but one */
    SYNTAX_CONE,       /* radius at from, radius_b at to */
    SYNTAX_ELLIPSOID,  /* a: centre, b: radii */
    SYNTAX_PARABOLOID, /* a: apex */
    SYNTAX_ONE_SHEET,  /* radius at the ends, radius_b: waist */
    SYNTAX_TWO_SHEETS, /* radius at the ends, radius_b: gap */
    SYNTAX_QUADRIC,    /* form */
    SYNTAX_HALF_SPACE, /* planes[0] */
    SYNTAX_POLYHEDRON, /* planes */
    SYNTAX_UNION,      /* children, as for the next two kinds */
    SYNTAX_INTERSECTION,
    SYNTAX_DIFFERENCE,
    SYNTAX_PART, /* part */
    SYNTAX_KINDS
};

enum {
    SYNTAX_SOLIDS_MOST = 320,
    SYNTAX_CHILDREN_MOST = 6,
    SYNTAX_PLANES_MOST = 8,
    SYNTAX_OBJECTS_MOST = 16,
    SYNTAX_LIGHTS_MOST = 8,
    SYNTAX_MATERIALS_MOST = 10,
    SYNTAX_PARTS_MOST = 6,
    SYNTAX_TABLE = 17
};

struct syntax_plane {
    double normal[3], offset;
};

/* What the generator makes meet on purpose. */
enum motif {
    MOTIF_TOUCHING,   /* two solids with a common face */
    MOTIF_STANDING,   /* a solid's face in the floor's */
    MOTIF_REWORDED,   /* one surface in two wordings */
    MOTIF_COAXIAL,    /* cylinders with from and to swapped */
    MOTIF_CUT_TWICE,  /* a cut solid used in two objects */
    MOTIF_OFF_CENTRE, /* a quadric whose middle is not its origin */
    MOTIF_NESTED,     /* solids strictly within others */
    MOTIF_OVERLAP,    /* objects of several materials in one place */
    MOTIF_TURNED,     /* common faces below one rotation */
    MOTIF_MIXED,      /* one object of several materials, cut as a whole */
    MOTIF_MIRRORED,   /* a part and its mirror image */
    MOTIF_TREE,       /* a random tree of operations */
    MOTIF_AROUND_EYE, /* the eye in a transparent solid */
    MOTIF_EYE_AMID,   /* the eye where the solids are, within some of them or just beside */
    MOTIF_CROWD,      /* dozens of small solids */
    MOTIFS
};

/* A placement scales, then rotates about x, y and z, then moves. */
struct syntax_solid {
    enum syntax_kind kind;
    int material; /* -1: the surrounding solid's, or the object's */
    double scale[3], rotate[3], translate[3];
    double a[3], b[3], radius, radius_b;
    double form[10]; /* xx yy zz xy yz zx x y z 1 */
    struct syntax_plane planes[SYNTAX_PLANES_MOST];
    int plane_count;
    int children[SYNTAX_CHILDREN_MOST];
    int child_count;
    int part;
};

struct syntax_pattern {
    bool present;
    double size[3], origin[3], colour[3];
};

struct syntax_material {
    double colour[3], ambient, diffuse, specular;
    bool ambient_is_own, has_table;
    double table[SYNTAX_TABLE];
    int gloss;
    struct syntax_pattern pattern;
    bool transparent, casts_shadow, disperses;
    double ior[3]; /* one alone counts unless the material disperses */
    double absorption[3], reflects[3], transmits[3];
};

struct syntax_light {
    bool parallel;
    double place[3]; /* a point light's position, or the direction of parallel light */
    double colour[3];
};

struct syntax_object {
    int material, solid;
};

enum syntax_model { SYNTAX_SIMPLE, SYNTAX_FRESNEL, SYNTAX_WAVELENGTH };

struct syntax {
    int width, height, depth;
    double threshold;
    double error; /* in levels, asked for instead of a threshold; 0: none is */
    enum syntax_model model;
    bool blinn, filters, fades;
    double fade_constant;
    double background[3], ambient[3];
    double eye[3], look_at[3], up[3], field_of_view;
    struct syntax_light lights[SYNTAX_LIGHTS_MOST];
    int light_count;
    struct syntax_material materials[SYNTAX_MATERIALS_MOST];
    int material_count;
    int parts[SYNTAX_PARTS_MOST]; /* solids; each may use the parts before it */
    int part_count;
    struct syntax_object objects[SYNTAX_OBJECTS_MOST];
    int object_count;
    struct syntax_solid solids[SYNTAX_SOLIDS_MOST];
    int solid_count;

    bool is_full;    /* something did not fit: the scene is of no use */
    unsigned motifs; /* bits of enum motif: what the generator put in */
};

static inline bool syntax_is_leaf(enum syntax_kind kind) {
    return kind < SYNTAX_UNION;
}

/* Appends a solid of that kind, placed where it is; returns its index. */
int syntax_add(struct syntax *syntax, enum syntax_kind kind);

/* Appends an operation of two solids. */
int syntax_combine(struct syntax *syntax, enum syntax_kind kind, int left, int right);

/* Appends a child to an operation. */
void syntax_adopt(struct syntax *syntax, int parent, int child);

/* Copies a solid with all below it; returns the copy's index. */
int syntax_copy(struct syntax *syntax, int solid);

/* Moves a solid to a new index and leaves an operation without children or placement in its place.
 * Returns the new index. */
int syntax_push_down(struct syntax *syntax, int solid, enum syntax_kind kind);

/* Appends a plane to a polyhedron, or sets the one of a half-space. */
void syntax_plane(struct syntax *syntax, int solid, double x, double y, double z, double offset);

/* Appends an object; returns its index. */
int syntax_add_object(struct syntax *syntax, int material, int solid);

/* Inserts an object before number `at`. */
void syntax_insert_object(struct syntax *syntax, int at, int material, int solid);

/* Appends a part; returns its index. */
int syntax_add_part(struct syntax *syntax, int solid);

/* Appends a light like another one; returns it. */
struct syntax_light *syntax_add_light(struct syntax *syntax);

/* Lists the solids that objects use, those of parts included: their number. */
int syntax_list(const struct syntax *syntax, int list[SYNTAX_SOLIDS_MOST]);

/* Checks whether any solid below this one, or the solid itself, names a material. */
bool syntax_names_material(const struct syntax *syntax, int solid);

/* Checks whether any object or solid is of that material. */
bool syntax_uses_material(const struct syntax *syntax, int material);

/* Checks whether an object is an endless half-space: the world's size shows then. */
bool syntax_has_endless(const struct syntax *syntax);

#endif
