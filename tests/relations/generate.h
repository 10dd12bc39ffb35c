/* SPDX-License-Identifier: MIT */
/* Random scenes: small, and full of what is hard. */
#ifndef SUPERFRAME_RELATIONS_GENERATE_H
#define SUPERFRAME_RELATIONS_GENERATE_H

#include "syntax.h"

/* Fills *syntax with the scene of a seed. */
void generate_scene(struct syntax *syntax, uint64_t seed);

/* Materials of a generated scene, by number. */
enum generated_material {
    GENERATED_FLOOR,
    GENERATED_CLAY,
    GENERATED_MIRROR,
    GENERATED_TABLE,
    GENERATED_GLASS,
    GENERATED_TINTED,
    GENERATED_DISPERSING,
    GENERATED_SCREEN,
    GENERATED_MATERIALS
};

/* Fills in the scene's materials, all of enum generated_material. */
void generate_materials(struct syntax *syntax, uint64_t *random);

/* Appends a random bounded leaf about the origin. */
int generate_leaf(struct syntax *syntax, uint64_t *random);

/* Appends a quadric by its coefficients, off its centre. */
int generate_quadric(struct syntax *syntax, uint64_t *random);

/* Appends a solid that may have no end, such as a half-space or a quadric. */
int generate_cutter(struct syntax *syntax, uint64_t *random);

/* Appends such a solid somewhere among the objects. */
int generate_any_cutter(struct syntax *syntax, uint64_t *random);

/* Appends a box by its corners. */
int generate_box(struct syntax *syntax, double x0, double y0, double z0, double x1, double y1,
                 double z1);

/* Appends a ball. */
int generate_ball(struct syntax *syntax, double x, double y, double z, double radius);

/* Appends a solid with an upright axis, z0 at its `from`. */
int generate_upright(struct syntax *syntax, enum syntax_kind kind, double x, double y, double z0,
                     double z1, double radius);

/* Appends a bounded tree of operations, `levels` deep at most. */
int generate_tree(struct syntax *syntax, uint64_t *random, int levels);

/* Places a solid at random; turned, stretched and mirrored now and then. */
void generate_placement(struct syntax *syntax, uint64_t *random, int solid);

/* Adds the objects of one motif. */
void generate_motif(struct syntax *syntax, uint64_t *random, enum motif motif);

#endif
