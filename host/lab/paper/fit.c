/* SPDX-License-Identifier: MIT */
/* The paper's formula for the cost against the depth level, fitted to measured values. */
#include "lab/paper/fit.h"

#include <math.h>

double paper_form(int c1, int c2, double depth) {
    return log10(c1 * pow(depth, c2) + 1) + 1;
}

static double square_error(int c1, int c2, const double *depths, const double *values,
                           size_t count) {
    double sum = 0;
    for (size_t i = 0; i < count; i++) {
        double error = paper_form(c1, c2, depths[i]) - values[i];
        sum += error * error;
    }
    return sum;
}

/* Sums the squares of the differences of values from their mean. */
static double square_spread(const double *values, size_t count) {
    double mean = 0, sum = 0;
    for (size_t i = 0; i < count; i++) {
        mean += values[i] / (double)count;
    }
    for (size_t i = 0; i < count; i++) {
        sum += (values[i] - mean) * (values[i] - mean);
    }
    return sum;
}

struct paper_fit paper_fit_form(const double *depths, const double *values, size_t count) {
    struct paper_fit best = {1, 1, 0};
    double least = HUGE_VAL, spread = square_spread(values, count);
    for (int c1 = 1; c1 <= PAPER_C1_MOST; c1++) {
        for (int c2 = 1; c2 <= PAPER_C2_MOST; c2++) {
            double error = square_error(c1, c2, depths, values, count);
            if (error < least) {
                least = error;
                best.c1 = c1;
                best.c2 = c2;
            }
        }
    }
    best.r_squared = spread > 0 ? 1 - least / spread : 0;
    return best;
}
