/* SPDX-License-Identifier: MIT */
/* What a frame of 640 x 400 spends on ports and board, and on the PNG: CPU milliseconds. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "board/port_chain.h"
#include "picture/sink.h"
#include "render/arithmetic.h"
#include "scene/load.h"

/* usage: frame SCENE FOLDER
 * Standard output gets a line: writes of a frame, then CPU milliseconds of ports and board, of the
 * same with the hash that --stats asks for, and of the PNG with its file, each the median of FRAMES
 * and the largest. The rows come ready-made from the scene at depth level 5, so that no ray is
 * traced meanwhile; each frame has a chain of its own, whose memory is touched for the first time,
 * as in a run of the program. */

enum { FRAMES = 15, DEPTH = 5, WIDTH = 640, HEIGHT = 400, LINE = WIDTH * 3 };

struct measured {
    double ports[FRAMES], observed[FRAMES], png[FRAMES]; /* milliseconds */
    uint64_t writes;
};

static double milliseconds(void) {
    struct timespec now = {0, 0};
    (void)clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return (double)now.tv_sec * 1e3 + (double)now.tv_nsec * 1e-6;
}

static bool copy_row(void *context, uint16_t y, uint8_t *rgb) {
    memcpy(rgb, (const uint8_t *)context + (size_t)y * LINE, LINE);
    return true;
}

static struct scene *load(const char *name) {
    struct scene_overrides overrides;
    struct scene_error error = {""};
    memset(&overrides, 0, sizeof overrides);
    overrides.has_size = overrides.has_depth = true;
    overrides.width = WIDTH;
    overrides.height = HEIGHT;
    overrides.depth = DEPTH;
    struct compiled_scene *compiled = load_compiled_scene(name, &overrides, &error);
    struct scene *scene = compiled != NULL ? arithmetic_f64.load(compiled, &error) : NULL;
    compiled_scene_free(compiled);
    if (scene == NULL) {
        (void)fprintf(stderr, "frame: %s\n", error.text);
    }
    return scene;
}

/* Draws a frame into a chain of its own, NULL if there is no memory, and says how long it took. */
static struct port_chain *draw_frame(const struct scene *scene, uint8_t *rgb, bool is_observed,
                                     double *took) {
    const struct board_desc desc = board_default_desc(BOARD_1987);
    const struct drawing drawing = {
        .base = desc.base, .last = HEIGHT, .source = copy_row, .context = rgb};
    double began = milliseconds();
    struct port_chain *chain = port_chain_new(&desc, true);
    if (chain != NULL) {
        (void)bus_bind(port_chain_bus(chain, is_observed));
        arithmetic_f64.image->draw(scene, &drawing);
        *took = milliseconds() - began;
    }
    return chain;
}

static bool write_png_file(struct port_chain *chain, const char *path, double *took) {
    double began = milliseconds();
    const uint8_t *screen = picture_in_memory(&chain->board, NULL);
    bool is_written =
        screen != NULL && write_png_picture(path, screen, PICTURE_WIDTH, PICTURE_HEIGHT);
    *took = milliseconds() - began;
    return is_written;
}

static bool measure_frame(const struct scene *scene, uint8_t *rgb, const char *path,
                          struct measured *measured, int i) {
    struct port_chain *chain = draw_frame(scene, rgb, true, &measured->observed[i]);
    if (chain == NULL) {
        return false;
    }
    measured->writes = port_chain_writes(chain);
    port_chain_free(chain);
    chain = draw_frame(scene, rgb, false, &measured->ports[i]);
    bool is_written = chain != NULL && write_png_file(chain, path, &measured->png[i]);
    port_chain_free(chain);
    return is_written;
}

static int by_size(const void *a, const void *b) {
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static void print_times(double times[FRAMES]) {
    qsort(times, FRAMES, sizeof times[0], by_size);
    (void)printf(" %.3f %.3f", times[FRAMES / 2], times[FRAMES - 1]);
}

int main(int argc, char **argv) {
    char path[512];
    struct measured measured;
    struct scene *scene = argc == 3 ? load(argv[1]) : NULL;
    uint8_t *rgb = malloc((size_t)HEIGHT * LINE);
    bool is_good = scene != NULL && rgb != NULL;
    for (unsigned y = 0; is_good && y < HEIGHT; y++) {
        struct render_counts ignored = {0};
        arithmetic_f64.image->row(scene, (uint16_t)y, rgb + (size_t)y * LINE, &ignored);
    }
    for (int i = 0; is_good && i < FRAMES; i++) {
        (void)snprintf(path, sizeof path, "%s/frame.png", argv[2]);
        is_good = measure_frame(scene, rgb, path, &measured, i);
    }
    if (is_good) {
        (void)printf("%lu", (unsigned long)measured.writes);
        print_times(measured.ports);
        print_times(measured.observed);
        print_times(measured.png);
        (void)printf("\n");
    } else if (argc != 3) {
        (void)fprintf(stderr, "usage: frame SCENE FOLDER\n");
    }
    free(rgb);
    free(scene);
    return is_good ? 0 : argc != 3 ? 2 : 1;
}
