/* SPDX-License-Identifier: MIT */
/* How far solids of the abstract syntax reach along the axes. */
#ifndef SUPERFRAME_RELATIONS_EXTENT_H
#define SUPERFRAME_RELATIONS_EXTENT_H

#include "syntax.h"

struct extent {
    double low[3], high[3]; /* infinite where the solid has no end */
};

/* Returns an extent that holds the solid, in the coordinates of what surrounds it. */
struct extent extent_of(const struct syntax *syntax, int solid);

/* Checks whether no two points of the two are nearer to each other than `gap`. */
bool extent_are_apart(const struct extent *a, const struct extent *b, double gap);

/* Checks whether all of it lies within -most .. most. */
bool extent_is_within(const struct extent *extent, double most);

#endif
