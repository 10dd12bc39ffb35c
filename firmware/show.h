/* SPDX-License-Identifier: MIT */
/* What is shown of a row of full colours: all of it, the upper bits, 8 colours by dither or bit. */
#ifndef SUPERFRAME_SHOW_H
#define SUPERFRAME_SHOW_H

#include <stdint.h>

#include "scene.h"

/* Turns row y (scene->width pixels, R G B each) in place into what is drawn of it.
 *
 * SHOW_FULL       the row as it is.
 * SHOW_BITS       the upper scene->show_bits bits of each level, the others 0.
 * SHOW_EXPOSURES  255 where bit `exposure` (0..7) of the level is set, else 0.
 * SHOW_DITHER     each level becomes the set of its pixel's 2 x 2 dots that are lit: bit
 *                 2 * line + column. board_dots() draws such a row.
 *
 * In a dither each dot of each primary draws a number 0..254 of its own. The dot is lit where that
 * number is less than the level. So the number of lit dots is binomial, 4 times level/255 on the
 * average. Level 0 lights no dot, level 255 all. Each of the 255 numbers has a probability of 1/255
 * to within 2^-16. The draw depends on the seed and on the dot's place, not on what was drawn
 * before. So rows may be made in any order. */
void show_row(const struct scene *scene, uint16_t y, uint8_t exposure, uint8_t *rgb);

#endif
