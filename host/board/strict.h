/* SPDX-License-Identifier: MIT */
/* The strict check: what a run relied on that a board is not known to do. */
#ifndef SUPERFRAME_STRICT_H
#define SUPERFRAME_STRICT_H

#include <stdbool.h>

#include "board.h"

/* Whether a behaviour breaks a strict check: a violation of the profile or, with a grade, something
 * no better known than that. */
bool strict_minds(const struct board *board, enum board_behaviour behaviour, bool has_grade,
                  enum board_grade grade);

/* Whether the strict check holds for all that the board was made to do. What does not is printed to
 * standard error, a line for each behaviour. */
bool strict_holds(const struct board *board, bool has_grade, enum board_grade grade);

#endif
