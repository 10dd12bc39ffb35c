/* SPDX-License-Identifier: MIT */
/* The strict check: what a run relied on that a board is not known to do. */
#ifndef SUPERFRAME_STRICT_H
#define SUPERFRAME_STRICT_H

#include <stdbool.h>

#include "board.h"

/* Tells whether a behaviour breaks a strict check. A violation of the profile does; with a grade,
 * so does a behaviour that is no better known than that grade. */
bool strict_minds(const struct board *board, enum board_behaviour behaviour, bool has_grade,
                  enum board_grade grade);

/* Tells whether the strict check holds for all that the board was made to do. What breaks the check
 * is printed to standard error, a line for each behaviour. */
bool strict_holds(const struct board *board, bool has_grade, enum board_grade grade);

#endif
