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

/* Tells whether two pictures are the same within what is allowed. On false, report says how many
 * pixels differ, which is the first, and by how much. Two PNG files are then written, and report
 * names them: NAME-expected.png and NAME-found.png. Their folder is the one that
 * SUPERFRAME_TEST_FOLDER names, or the current one if the variable names none. */
bool pixels_equal(const struct pixels *pixels, const char *name, char *report);

/* Checks that a rectangle has pixels and lies in the frame memory. If not, report says so. */
bool pixels_rectangle_fits(const struct superframe_rectangle *rectangle, char *report);

/* Copies the bytes of a rectangle of the frame memory. The caller frees the copy. Returns NULL if
 * out of memory. */
uint8_t *pixels_of_memory(const struct board *board, const struct superframe_rectangle *rectangle);

#endif
