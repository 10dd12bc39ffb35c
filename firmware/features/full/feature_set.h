/* SPDX-License-Identifier: MIT */
/* What an image of the firmware holds: here everything. The include path chooses. */
#ifndef SUPERFRAME_FEATURE_SET_H
#define SUPERFRAME_FEATURE_SET_H

/* `superframe compile --minimal` writes such a page with what one scene requires; the compiler then
 * drops the rest. Each constant is used in plain conditions and array sizes, never by #if. */
enum {
    FEATURE_DEPTH = 255,         /* the largest depth level; the ray stack has room for it */
    FEATURE_WIDTH = 640,         /* the widest picture: a row is kept while it is sent */
    FEATURE_PRIMITIVE_WORDS = 4, /* 32 primitives a word */
    FEATURE_BOX = 1,
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
    FEATURE_TRANSPARENCY = 1,
    FEATURE_ABSORPTION = 1
};

#endif
