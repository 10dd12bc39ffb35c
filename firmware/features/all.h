/* SPDX-License-Identifier: MIT */
/* All features but the form of sets, for the images that hold them all. */
#ifndef SUPERFRAME_FEATURES_ALL_H
#define SUPERFRAME_FEATURES_ALL_H

#include "board_ports.h"

/* `superframe compile --minimal` writes such a file with what one scene requires. The compiler then
 * drops the rest. Each constant is used in plain conditions and array sizes, never by #if. */
enum {
    FEATURE_DEPTH = 255,         /* the largest depth level; the ray stack has room for it */
    FEATURE_WIDTH = BOARD_WIDTH, /* the widest picture: a row is kept while it is sent */
    FEATURE_BOX = 1,             /* named by scenes that hold one; no code depends on it */
    FEATURE_BALL = 1,
    FEATURE_POLYHEDRON = 1,
    FEATURE_QUADRIC = 1,
    FEATURE_ROTATION = 1, /* primitives in frames of their own */
    FEATURE_CSG = 1,      /* objects of more than one primitive */
    FEATURE_LIGHTS = 1,
    FEATURE_POINT_LIGHTS = 1,
    FEATURE_HIGHLIGHT_BLINN = 1,
    FEATURE_SHADOWS = 1,
    FEATURE_FADING = 1, /* C + D */
    FEATURE_PATTERN = 1,
    FEATURE_PATTERN_FACES = 1, /* faces in which a pattern's cells end */
    FEATURE_TRANSPARENCY = 1,
    FEATURE_ABSORPTION = 1,
    FEATURE_ESTIMATE = 1,       /* pruned branches count as their estimated radiance */
    FEATURE_ACCURACY = 1,       /* an accuracy may be asked for */
    FEATURE_SIMPLE = 1,         /* Table 1 (a) */
    FEATURE_DISPERSION = 1,     /* Table 1 (c): directions by wavelength */
    FEATURE_TINT = 1,           /* Table 1 (c): reflectance and transmittance by wavelength */
    FEATURE_FILTER = 1,         /* mixing by filters */
    FEATURE_SPECULAR_TABLE = 1, /* w(theta) */
    FEATURE_OBSERVER = 1,       /* an observer may follow the growth of a tree */
    FEATURE_SHOW = 1            /* ways to show colours other than in full */
};

#endif
