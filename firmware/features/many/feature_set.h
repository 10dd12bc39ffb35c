/* SPDX-License-Identifier: MIT */
/* The features that an image of the firmware holds: here all, with sets as lists. Scenes of more
 * primitives than bits have room for need these. The include path chooses the file. */
#ifndef SUPERFRAME_FEATURE_SET_H
#define SUPERFRAME_FEATURE_SET_H

#include "features/all.h"

enum {
    FEATURE_NESTING = 64, /* the most primitives that a place is inside of */
    FEATURE_LEVELS = 36   /* of nodes, in a hierarchy of bounds */
};

#include "sets/list/primitive_set.h"

#endif
