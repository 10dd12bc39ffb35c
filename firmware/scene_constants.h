/* SPDX-License-Identifier: MIT */
/* The numbers that the tables of a scene are made of. Neither an arithmetic nor a feature set is
 * needed, so that the scene compiler takes them from here, too. */
#ifndef SUPERFRAME_SCENE_CONSTANTS_H
#define SUPERFRAME_SCENE_CONSTANTS_H

/* Object 0 is around everything: no program describes it, and its material is 0. */
enum { OBJECT_AIR = 0, MATERIAL_AIR = 0 };

/* A switch over these has a case for each and no default. So the C compiler names the places that a
 * new kind has to be told of. */
enum primitive_kind { PRIMITIVE_BOX, PRIMITIVE_BALL, PRIMITIVE_POLYHEDRON, PRIMITIVE_QUADRIC };

/* The face of a quadric that is curved; the faces 0 to 5 are those of the box that cuts it. */
enum { QUADRIC_FACE = 6 };

/* These numbers stand for no entry of a table. */
enum { PATTERN_NONE = 0xFF, SPECULAR_CONSTANT = 0xFF };

/* A node of a hierarchy has so many bounds. Vectors of numbers are as wide. */
enum { NODE_WIDTH = 8 };

/* w(theta) is given at so many angles from 0 to 90 degrees. */
enum { SPECULAR_STEPS = 17 };

/* These ways show the colours (show.h). A dither goes up to half the screen's width and height, for
 * each of its pixels takes 2 x 2 dots. */
enum show { SHOW_FULL, SHOW_BITS, SHOW_DITHER, SHOW_EXPOSURES };

#endif
