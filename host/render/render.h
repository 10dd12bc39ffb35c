/* SPDX-License-Identifier: MIT */
/* The render job: rows from worker threads, drawn in order through the firmware's driver. */
#ifndef SUPERFRAME_RENDER_H
#define SUPERFRAME_RENDER_H

#include <signal.h>
#include <stdbool.h>
#include <stdint.h>

#include "render/arithmetic.h"

/* What a render took so far. */
struct render_totals {
    uint64_t rays, shadow_rays, nodes, solid_tests, leaked_rays; /* as in struct render_counts */
    uint64_t learning_rays;                                      /* of rays: for the estimate */
    uint64_t exhausted_pixels, unreached_pixels;                 /* as in struct render_counts */
    uint32_t estimated_error, proved_error;                      /* the worst pixel's */
    unsigned worst_x, worst_y;                                   /* where estimated_error is */
    struct estimate estimate;                                    /* of pruned branches */
    unsigned rows;                                               /* drawn */
    double seconds;
};

/* What is to be rendered, and how. All port accesses go to the bound bus, from the caller's thread.
 * Their order is the same for any number of jobs. */
struct render_job {
    const struct arithmetic *arithmetic;
    const struct compiled_scene *scene;
    uint16_t base;                /* the board's base address */
    unsigned first_row, last_row; /* rows first .. last-1, within the scene's height */
    unsigned jobs;                /* threads that compute: 1..256; 1: the caller's own thread */

    /* Not zero: the render ends after the row that is being drawn. NULL: the render can't be
     * stopped. */
    const volatile sig_atomic_t *stop;

    /* Called from the caller's thread after each row; NULL: nobody looks. */
    void (*progress)(void *context, const struct render_totals *so_far);
    void *context;

    /* Where a scene is shown by exposures: called from the caller's thread after each of the eight
     * drawings, 0..7. The board then shows that exposure. NULL: nobody looks. */
    void (*exposed)(void *exposed_context, unsigned exposure);
    void *exposed_context;
};

enum { RENDER_EXPOSURES = 8 };

/* Renders a job. A scene that is shown by exposures is computed once and drawn eight times. After a
 * stop, the rows computed by then are drawn so. The render ends early if it is stopped or the bus
 * fails, as bus_bound_status() says. totals->rows says how far the render came. Returns false with
 * *error filled if the arithmetic can't hold the scene, or memory or threads are out. */
bool render(const struct render_job *job, struct render_totals *totals, struct scene_error *error);

#endif
