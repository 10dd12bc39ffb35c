/* SPDX-License-Identifier: MIT */
/* Placements as the scene format defines them, reckoned apart from the compiler's. */
#ifndef SUPERFRAME_RELATIONS_PLACE_H
#define SUPERFRAME_RELATIONS_PLACE_H

#include "syntax.h"

/* p = map q + move, q being the solid's own coordinates. */
struct place {
    double map[3][3], move[3];
};

/* Returns a solid's placement below that of what surrounds the solid. */
struct place place_inner(const struct place *outer, const struct syntax_solid *solid);

/* Inverts a placement: q = inverse->map p + inverse->move. */
void place_invert(const struct place *place, struct place *inverse);

/* Maps a point; image is another array than point. */
void place_point(const struct place *place, const double point[3], double image[3]);

#endif
