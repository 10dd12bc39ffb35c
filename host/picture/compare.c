/* SPDX-License-Identifier: MIT */
/* How far two pictures are apart: pure measures over R, G, B bytes. */
#include "picture/compare.h"

#include <math.h>
#include <string.h>

enum { LEVELS = 256, CHANNELS = 3 };

void compare_pictures(const uint8_t *a, const uint8_t *b, size_t pixels,
                      struct comparison *comparison) {
    memset(comparison, 0, sizeof *comparison);
    comparison->pixels = pixels;
    for (size_t pixel = 0; pixel < pixels; pixel++) {
        unsigned worst = 0;
        for (size_t i = pixel * CHANNELS; i < (pixel + 1) * CHANNELS; i++) {
            unsigned difference = a[i] > b[i] ? (unsigned)(a[i] - b[i]) : (unsigned)(b[i] - a[i]);
            comparison->square_sum += (uint64_t)difference * difference;
            worst = difference > worst ? difference : worst;
        }
        comparison->by_difference[worst]++;
    }
}

unsigned comparison_largest(const struct comparison *comparison) {
    unsigned largest = LEVELS - 1;
    while (largest > 0 && comparison->by_difference[largest] == 0) {
        largest--;
    }
    return largest;
}

double comparison_rmse(const struct comparison *comparison) {
    double values = (double)comparison->pixels * CHANNELS;
    return comparison->pixels == 0 ? 0 : sqrt((double)comparison->square_sum / values);
}

double comparison_psnr(const struct comparison *comparison) {
    double rmse = comparison_rmse(comparison);
    return rmse > 0 ? 20 * log10((LEVELS - 1) / rmse) : INFINITY;
}

uint64_t comparison_within(const struct comparison *comparison, unsigned within) {
    uint64_t count = 0;
    for (unsigned difference = 0; difference <= within && difference < LEVELS; difference++) {
        count += comparison->by_difference[difference];
    }
    return count;
}

double comparison_share(const struct comparison *comparison, unsigned within) {
    return comparison->pixels == 0
               ? 100
               : 100.0 * (double)comparison_within(comparison, within) / (double)comparison->pixels;
}

bool comparison_holds(const struct comparison *comparison, unsigned within, double share) {
    /* Both sides are counts of pixels. A thousandth of a pixel is far below what tells two counts
     * apart, and far above the rounding of share / 100. */
    double needed = share / 100 * (double)comparison->pixels;
    return (double)comparison_within(comparison, within) >= needed - 1e-3;
}
