/* SPDX-License-Identifier: MIT */
/* The structural similarity of two pictures (SSIM). */
#ifndef SUPERFRAME_SIMILARITY_H
#define SUPERFRAME_SIMILARITY_H

#include <stdbool.h>
#include <stdint.h>

enum { SIMILARITY_WINDOW = 11 }; /* pixels, each way */

/* Measures the mean SSIM of Wang, Bovik, Sheikh and Simoncelli (2004) over all windows that lie in
 * the picture. Luma is 0.299 R + 0.587 G + 0.114 B. The window is a Gaussian of 11 x 11 pixels with
 * sigma 1.5; K1 = 0.01, K2 = 0.03, L = 255. *similarity is 1 for equal pictures, and NaN where a
 * side is shorter than the window. Returns false if memory is out. */
bool picture_similarity(const uint8_t *a, const uint8_t *b, unsigned width, unsigned height,
                        double *similarity);

#endif
