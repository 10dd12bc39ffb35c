/* SPDX-License-Identifier: MIT */
/* Expected pixels against those that are there, without any test library. */
#ifndef SUPERFRAME_TESTKIT_PIXELS_H
#define SUPERFRAME_TESTKIT_PIXELS_H

#include "testing.h"

/* Longest path of a picture, with its 0. */
enum { PIXELS_PATH_SIZE = 4096, PIXELS_REPORT_SIZE = 2 * PIXELS_PATH_SIZE + 512 };

/* Two pictures of one size, R, G, B from the top left, and where the upper left pixel lies. */
struct pixels {
    struct superframe_rectangle place;
    const uint8_t *expected, *found;
    unsigned within; /* steps of 0..255 that each primary may be off */
};

/* True if they are the same within what is allowed. False: report says how many differ, which is
 * the first, and by how much, and names the two PNG files that it has written: NAME-expected.png
 * and NAME-found.png in the folder that SUPERFRAME_TEST_FOLDER names, or in the current one if it
 * names none. */
bool pixels_equal(const struct pixels *pixels, const char *name, char *report);

/* True if a rectangle has pixels and lies in the frame memory; else report says so. */
bool pixels_rectangle_fits(const struct superframe_rectangle *rectangle, char *report);

/* The bytes of a rectangle of the frame memory; NULL if out of memory. To be freed. */
uint8_t *pixels_of_memory(const struct board *board, const struct superframe_rectangle *rectangle);

#endif
