/* SPDX-License-Identifier: MIT */
/* The pictures of the error that the report shows: what a setting draws, and where it is off. */
#include <stdlib.h>
#include <string.h>

#include "base/complain.h"
#include "base/path.h"
#include "lab/measure/measure.h"
#include "picture/error_map.h"
#include "picture/sink.h"

enum { HALF_WIDTH = 320, GAP = 8, GREY = 128 };

static const char *const files[MEASURE_SHOWN] = {"difference-paper.png",
                                                 "difference-q16-epsilon.png", "difference-fx.png",
                                                 "difference-error.png"};

/* Returns the place of a point's picture among the files, or -1: the point is not shown. All shown
 * are of the first scene. Place 0 is the paper's setting, 1 the example that is to be avoided.
 * Place 2 is the most exact fx of the plan, 3 fx where an accuracy of 1 LSB is asked for. */
static int shown_place(const struct measure *measure, const struct measure_point *point) {
    bool is_deep = point->depth == 64 && point->threshold > 0 && point->threshold < 1e-4 / 2;
    bool is_fx = strcmp(point->arithmetic, "fx") == 0;
    if (strcmp(point->scene, measure->scenes[0].name) != 0 || strcmp(point->colour, "full") != 0) {
        return -1;
    }
    if (point->error > 0) {
        return is_fx && point->error >= 1 && point->error <= 1 ? 3 : -1;
    }
    if (strcmp(point->tail, "black") != 0) {
        return -1;
    }
    if (is_fx && point->depth == 10 && !(point->threshold > 0)) {
        return 0;
    }
    return !is_deep ? -1 : strcmp(point->arithmetic, "q16_epsilon") == 0 ? 1 : is_fx ? 2 : -1;
}

/* Copies a picture, each dot `factor` times as large, to column x of a wider one. */
static void place(uint8_t *wide, unsigned wide_width, unsigned x, const uint8_t *rgb,
                  unsigned width, unsigned height, unsigned factor) {
    for (unsigned row = 0; row < height * factor; row++) {
        for (unsigned column = 0; column < width * factor; column++) {
            memcpy(wide + ((size_t)row * wide_width + x + column) * 3,
                   rgb + ((size_t)(row / factor) * width + column / factor) * 3, 3);
        }
    }
}

static int write_file(const struct measure *measure, const char *name, const uint8_t *rgb,
                      unsigned width, unsigned height) {
    char *path = path_join(measure->folder, name);
    if (path == NULL) {
        return failure("out of memory");
    }
    bool is_written = write_png_picture(path, rgb, width, height);
    free(path);
    return is_written ? STATUS_DONE : STATUS_FAILED;
}

int measure_show(const struct measure *measure, const struct measure_point *point,
                 const uint8_t *reference, const uint8_t *picture, unsigned width,
                 unsigned height) {
    int shown = shown_place(measure, point);
    if (shown < 0) {
        return STATUS_DONE;
    }
    unsigned factor = width < HALF_WIDTH ? HALF_WIDTH / width : 1;
    unsigned wide = 2 * width * factor + GAP;
    uint8_t *difference = malloc((size_t)width * height * 3);
    uint8_t *both = malloc((size_t)wide * height * factor * 3);
    int status = STATUS_FAILED;
    if (difference != NULL && both != NULL) {
        memset(both, GREY, (size_t)wide * height * factor * 3);
        difference_picture(reference, picture, (size_t)width * height, difference);
        place(both, wide, 0, picture, width, height, factor);
        place(both, wide, width * factor + GAP, difference, width, height, factor);
        status = write_file(measure, files[shown], both, wide, height * factor);
    } else {
        complain("out of memory");
    }
    free(difference);
    free(both);
    return status;
}
