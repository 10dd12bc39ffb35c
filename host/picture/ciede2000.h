/* SPDX-License-Identifier: MIT */
/* How different two colours look: CIEDE2000 between sRGB colours. */
#ifndef SUPERFRAME_COLOUR_DIFFERENCE_H
#define SUPERFRAME_COLOUR_DIFFERENCE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

/* CIELAB, white point D65: L* 0..100, a*, b*. */
struct lab {
    double lightness, a, b;
};

/* Returns an sRGB colour (IEC 61966-2-1, 2 degree observer) in CIELAB. */
struct lab lab_of_srgb(const uint8_t rgb[3]);

/* Returns the CIEDE2000 difference with kL = kC = kH = 1: about 1 is what an attentive viewer just
 * sees. The formula is that of Sharma, Wu and Dalal, "The CIEDE2000 Color-Difference Formula",
 * 2005. */
double colour_difference(struct lab one, struct lab other);

/* The colour differences of two pictures, pixel by pixel. */
struct colour_differences {
    double mean;
    double high; /* the 99.9th percentile: at most one pixel in a thousand is above */
    double largest;
};

/* Measures `pixels` pixels of R, G, B bytes; all differences are 0 for no pixels. Returns false if
 * memory is out. */
bool colour_differences(const uint8_t *a, const uint8_t *b, size_t pixels,
                        struct colour_differences *differences);

#endif
