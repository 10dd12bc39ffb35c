/* SPDX-License-Identifier: MIT */
/* The structural similarity of two pictures (SSIM). */
#ifndef SUPERFRAME_SIMILARITY_H
#define SUPERFRAME_SIMILARITY_H

#include <stdbool.h>
#include <stdint.h>

enum { SIMILARITY_WINDOW = 11 }; /* pixels, each way */

/* The mean SSIM of Wang, Bovik, Sheikh and Simoncelli (2004): luma 0.299 R + 0.587 G + 0.114 B,
 * a Gaussian window of 11 x 11 pixels with sigma 1.5, K1 = 0.01, K2 = 0.03, L = 255, over all
 * windows that lie in the picture. 1: equal. NaN where a side is shorter than the window. False:
 * memory is out. */
bool picture_similarity(const uint8_t *a, const uint8_t *b, unsigned width, unsigned height,
                        double *similarity);

#endif
