/* SPDX-License-Identifier: MIT */
/* A bar on a terminal that says how far a render has come. */
#ifndef SUPERFRAME_PROGRESS_H
#define SUPERFRAME_PROGRESS_H

#include <stdbool.h>
#include <stddef.h>

#include "render/render.h"

/* The line on the terminal. */
struct progress {
    bool is_shown;
    unsigned rows;     /* to be drawn in all */
    double last_drawn; /* seconds since the start when the line was last drawn */
};

/* Prepares the bar for so many rows. The bar is shown only if standard error is a terminal and
 * `quiet` is false. */
void progress_begin(struct progress *progress, unsigned rows, bool quiet);

/* Draws the line again, some ten times a second at most, as `progress` of a struct render_job.
 * context is the struct progress. */
void progress_show(void *context, const struct render_totals *so_far);

/* Removes the line from the terminal. */
void progress_end(struct progress *progress);

enum { PROGRESS_LINE_SIZE = 128 };

/* Writes the text of the line, for `rows` rows in all. */
void progress_line(char line[PROGRESS_LINE_SIZE], unsigned rows,
                   const struct render_totals *so_far);

#endif
