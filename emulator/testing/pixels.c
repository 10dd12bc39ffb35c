/* SPDX-License-Identifier: MIT */
/* Expected pixels against those that are there. */
#include "pixels.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "png_file.h"

enum { WHY_SIZE = 200 }; /* room behind a path for why it can't be written */

bool pixels_rectangle_fits(const struct superframe_rectangle *rectangle, char *report) {
    bool fits = rectangle->width >= 1 && rectangle->width <= BOARD_WIDTH &&
                rectangle->x <= BOARD_WIDTH - rectangle->width && rectangle->height >= 1 &&
                rectangle->height <= BOARD_MEMORY_HEIGHT &&
                rectangle->y <= BOARD_MEMORY_HEIGHT - rectangle->height;
    if (!fits) {
        (void)snprintf(report, PIXELS_REPORT_SIZE,
                       "%u x %u pixels at (%u, %u) don't lie in the frame memory of %d x %d\n",
                       rectangle->width, rectangle->height, rectangle->x, rectangle->y, BOARD_WIDTH,
                       BOARD_MEMORY_HEIGHT);
    }
    return fits;
}

uint8_t *pixels_of_memory(const struct board *board, const struct superframe_rectangle *rectangle) {
    size_t line = (size_t)rectangle->width * 3;
    uint8_t *rgb = malloc(line * rectangle->height);
    for (size_t y = 0; rgb != NULL && y < rectangle->height; y++) {
        memcpy(rgb + y * line,
               board->memory + ((rectangle->y + y) * BOARD_WIDTH + rectangle->x) * 3, line);
    }
    return rgb;
}

/* Writes NAME-KIND.png. path gets the file's path, and the reason if the file can't be written. */
static void write_picture(const struct pixels *pixels, const uint8_t *rgb, const char *name,
                          const char *kind, char path[PIXELS_PATH_SIZE]) {
    struct png_error error = {PNG_OK, ""};
    const char *folder = getenv("SUPERFRAME_TEST_FOLDER");
    bool is_named = folder != NULL && folder[0] != '\0';
    int length =
        snprintf(path, PIXELS_PATH_SIZE, "%s/%s-%s.png", is_named ? folder : ".", name, kind);
    if (length < 0 || length >= PIXELS_PATH_SIZE - WHY_SIZE) {
        (void)snprintf(path, PIXELS_PATH_SIZE, "(can't be written: the folder's name is too long)");
        return;
    }
    FILE *file = fopen(path, "wb");
    bool is_written = file != NULL && write_png(file, rgb, pixels->place.width,
                                                pixels->place.height, &error) == PNG_OK;
    is_written = file != NULL && fclose(file) == 0 && is_written;
    if (!is_written) {
        (void)snprintf(path + length, WHY_SIZE, " (can't be written: %s)",
                       error.status != PNG_OK ? error.message : strerror(errno));
    }
}

static void report_difference(const struct pixels *pixels, size_t count, size_t first,
                              unsigned largest, const char *name, char *report) {
    char expected_path[PIXELS_PATH_SIZE], found_path[PIXELS_PATH_SIZE];
    const uint8_t *expected = pixels->expected + first * 3, *found = pixels->found + first * 3;
    write_picture(pixels, pixels->expected, name, "expected", expected_path);
    write_picture(pixels, pixels->found, name, "found", found_path);
    (void)snprintf(report, PIXELS_REPORT_SIZE,
                   "%zu of %u x %u pixels differ, by %u at most (allowed: %u)\n"
                   "the first is at (%u, %u): expected %02X%02X%02X, found %02X%02X%02X\n"
                   "expected: %s\nfound:    %s\n",
                   count, pixels->place.width, pixels->place.height, largest, pixels->within,
                   pixels->place.x + (unsigned)(first % pixels->place.width),
                   pixels->place.y + (unsigned)(first / pixels->place.width), expected[0],
                   expected[1], expected[2], found[0], found[1], found[2], expected_path,
                   found_path);
}

bool pixels_equal(const struct pixels *pixels, const char *name, char *report) {
    size_t all = (size_t)pixels->place.width * pixels->place.height, first = 0, count = 0;
    unsigned largest = 0;
    for (size_t i = 0; i < all; i++) {
        unsigned worst = 0;
        for (size_t j = i * 3; j < i * 3 + 3; j++) {
            int difference = pixels->expected[j] - pixels->found[j];
            unsigned size = (unsigned)(difference < 0 ? -difference : difference);
            worst = size > worst ? size : worst;
        }
        if (worst > pixels->within) {
            first = count == 0 ? i : first;
            count++;
        }
        largest = worst > largest ? worst : largest;
    }
    if (count > 0) {
        report_difference(pixels, count, first, largest, name, report);
    }
    return count == 0;
}
