/* SPDX-License-Identifier: MIT */
/* The structural similarity of two pictures (SSIM). */
#include "picture/ssim.h"

#include <math.h>
#include <stddef.h>
#include <stdlib.h>

/* The windowed means that SSIM is made of. */
enum { MEAN_A, MEAN_B, SQUARE_A, SQUARE_B, PRODUCT, MEANS };

static double luma(const uint8_t *rgb) {
    return 0.299 * rgb[0] + 0.587 * rgb[1] + 0.114 * rgb[2];
}

static void make_window(double window[SIMILARITY_WINDOW]) {
    const int middle = SIMILARITY_WINDOW / 2;
    double sum = 0;
    for (int i = 0; i < SIMILARITY_WINDOW; i++) {
        double distance = i - middle;
        window[i] = exp(-distance * distance / (2 * 1.5 * 1.5));
        sum += window[i];
    }
    for (int i = 0; i < SIMILARITY_WINDOW; i++) {
        window[i] /= sum;
    }
}

/* Computes the five means along one line: the window is a product of one across and one down. */
static void mean_line(const double *window, const uint8_t *a, const uint8_t *b, unsigned columns,
                      double *line) {
    for (unsigned x = 0; x < columns; x++) {
        double *means = &line[(size_t)x * MEANS];
        for (int i = 0; i < MEANS; i++) {
            means[i] = 0;
        }
        for (unsigned i = 0; i < SIMILARITY_WINDOW; i++) {
            size_t at = 3 * ((size_t)x + i);
            double p = luma(&a[at]), q = luma(&b[at]);
            means[MEAN_A] += window[i] * p;
            means[MEAN_B] += window[i] * q;
            means[SQUARE_A] += window[i] * p * p;
            means[SQUARE_B] += window[i] * q * q;
            means[PRODUCT] += window[i] * p * q;
        }
    }
}

static double similarity_of(const double means[MEANS]) {
    const double c1 = 0.01 * 255 * 0.01 * 255, c2 = 0.03 * 255 * 0.03 * 255;
    double a = means[MEAN_A], b = means[MEAN_B];
    double variance_a = means[SQUARE_A] - a * a, variance_b = means[SQUARE_B] - b * b;
    double covariance = means[PRODUCT] - a * b;
    return (2 * a * b + c1) * (2 * covariance + c2) /
           ((a * a + b * b + c1) * (variance_a + variance_b + c2));
}

/* Returns the sum of the similarities of the windows whose first line is `top`; lines is a ring of
 * the lines' means. */
static double sum_row(const double *window, const double *lines, unsigned columns, unsigned top) {
    double sum = 0;
    for (unsigned x = 0; x < columns; x++) {
        double means[MEANS] = {0, 0, 0, 0, 0};
        for (unsigned i = 0; i < SIMILARITY_WINDOW; i++) {
            size_t line = (top + i) % SIMILARITY_WINDOW;
            const double *part = &lines[(line * columns + x) * MEANS];
            for (int j = 0; j < MEANS; j++) {
                means[j] += window[i] * part[j];
            }
        }
        sum += similarity_of(means);
    }
    return sum;
}

bool picture_similarity(const uint8_t *a, const uint8_t *b, unsigned width, unsigned height,
                        double *similarity) {
    double window[SIMILARITY_WINDOW], sum = 0;
    *similarity = NAN;
    if (width < SIMILARITY_WINDOW || height < SIMILARITY_WINDOW) {
        return true;
    }
    unsigned columns = width - SIMILARITY_WINDOW + 1, rows = height - SIMILARITY_WINDOW + 1;
    double *lines = calloc((size_t)SIMILARITY_WINDOW * columns * MEANS, sizeof *lines);
    if (lines == NULL) {
        return false;
    }
    make_window(window);
    for (unsigned y = 0; y < height; y++) {
        size_t start = (size_t)y * width * 3, line = y % SIMILARITY_WINDOW;
        mean_line(window, &a[start], &b[start], columns, &lines[line * columns * MEANS]);
        if (y + 1 >= SIMILARITY_WINDOW) {
            sum += sum_row(window, lines, columns, y + 1 - SIMILARITY_WINDOW);
        }
    }
    free(lines);
    *similarity = sum / ((double)columns * rows);
    return true;
}
