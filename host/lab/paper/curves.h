/* SPDX-License-Identifier: MIT */
/* Fig. 7: cost against the depth level, both readings of the formula, and their plots. */
#ifndef SUPERFRAME_PAPER_CURVES_H
#define SUPERFRAME_PAPER_CURVES_H

#include "lab/paper/fit.h"
#include "lab/paper/paper.h"

/* What a cost is counted in. */
enum paper_cost { PAPER_RAYS, PAPER_TESTS, PAPER_COSTS };

/* Returns "rays" or "solid tests". */
const char *paper_cost_name(enum paper_cost cost);

/* Returns a curve's costs by N, 0..PAPER_DEPTHS-1. */
const double *paper_costs(const struct paper_curve *curve, enum paper_cost cost);

/* How the formula is read: as the relative cost T(N)/T(0), or as that cost's log10, plus 1. */
enum paper_reading { PAPER_READING_RATIO, PAPER_READING_LOG, PAPER_READINGS };

/* Fits the formula to a curve, by one reading. */
struct paper_fit paper_fit_curve(const struct paper_curve *curve, enum paper_cost cost,
                                 enum paper_reading reading);

#endif
