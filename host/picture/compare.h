/* SPDX-License-Identifier: MIT */
/* How far two pictures are apart: pure measures over R, G, B bytes. */
#ifndef SUPERFRAME_COMPARE_H
#define SUPERFRAME_COMPARE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

enum { COMPARE_FAR = 8 }; /* LSB: a pixel further off than this is counted apart */

/* One LSB is a step of 1/255. A pixel's difference is that of its worst channel. */
struct comparison {
    uint64_t pixels;
    uint64_t by_difference[256]; /* pixels whose difference is exactly that */
    uint64_t square_sum;         /* over all channels of all pixels, LSB squared */
};

/* Measures `pixels` pixels of 3 bytes each. */
void compare_pictures(const uint8_t *a, const uint8_t *b, size_t pixels,
                      struct comparison *comparison);

/* Returns the largest difference, in LSB; 0 for no pixels. */
unsigned comparison_largest(const struct comparison *comparison);

/* Returns the root of the mean square over all channels, in LSB; 0 for no pixels. */
double comparison_rmse(const struct comparison *comparison);

/* Returns the peak signal-to-noise ratio, 20 log10(255 / rmse), in dB; infinite for equal
 * pictures. */
double comparison_psnr(const struct comparison *comparison);

/* Returns how many pixels have a difference of at most `within` LSB, 0..255. */
uint64_t comparison_within(const struct comparison *comparison, unsigned within);

/* Returns the share of the pixels with a difference of at most `within` LSB, in per cent; 100 for
 * no pixels. */
double comparison_share(const struct comparison *comparison, unsigned within);

/* Tells whether at least `share` per cent of the pixels have a difference of at most `within`
 * LSB. The answer is exact also where share is a decimal fraction that a double can only come
 * close to. */
bool comparison_holds(const struct comparison *comparison, unsigned within, double share);

#endif
