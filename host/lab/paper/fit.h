/* SPDX-License-Identifier: MIT */
/* The paper's formula for the cost against the depth level, fitted to measured values. */
#ifndef SUPERFRAME_PAPER_FIT_H
#define SUPERFRAME_PAPER_FIT_H

#include <stddef.h>

enum { PAPER_C1_MOST = 100, PAPER_C2_MOST = 9 };

/* Two whole numbers, C1 1..100 and C2 1..9, and how well they do. R^2 is 1 at best, and below 0
 * where the mean of the values does better. */
struct paper_fit {
    int c1, c2;
    double r_squared;
};

/* Computes log10(C1 N^C2 + 1) + 1. */
double paper_form(int c1, int c2, double depth);

/* Finds the C1 and C2 with the least squared error of the form against the values. All pairs are
 * tried; of equals the first is taken. R^2 is 0 where the values don't vary. count: at least 1. */
struct paper_fit paper_fit_form(const double *depths, const double *values, size_t count);

#endif
