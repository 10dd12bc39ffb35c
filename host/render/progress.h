/* SPDX-License-Identifier: MIT */
/* A bar on a terminal that shows the progress of a render. */
#ifndef SUPERFRAME_PROGRESS_H
#define SUPERFRAME_PROGRESS_H

#include <stdbool.h>
#include <stddef.h>
#include <time.h>

#include "render/render.h"

/* The line on the terminal. */
struct progress {
    bool is_shown;
    unsigned columns;  /* of the terminal */
    unsigned rows;     /* to be drawn in all */
    double last_drawn; /* seconds since the start when the line was last drawn */

    /* What a person counts the work by, where that is not rows; NULL: rows. The caller sets these
     * after progress_begin(), and goes on with units_done. */
    const char *unit;
    unsigned units, units_done;
};

/* Prepares the bar for so many rows. The bar is shown on a terminal only, and not if `quiet`. A
 * terminal whose TERM is "dumb" or unset can't erase a line, and gets no bar. */
void progress_begin(struct progress *progress, unsigned rows, bool quiet);

/* Draws the line again, some ten times a second at most, as `progress` of a struct render_job.
 * context is the struct progress. */
void progress_show(void *context, const struct render_totals *so_far);

/* One bar over many renders. All zero but `progress` and `began`: nothing was rendered yet. */
struct progress_sum {
    struct progress progress;
    struct timespec began;
    struct render_totals before, now; /* of the renders that are done; with the one at work */
};

/* Adds a render at work to those that are done, and draws the line, as `progress` of a struct
 * render_job. context is the struct progress_sum. After each render the caller sets `before`. */
void progress_show_sum(void *context, const struct render_totals *so_far);

/* Removes the line from the terminal. */
void progress_end(struct progress *progress);

enum { PROGRESS_LINE_SIZE = 128 };

/* Writes the text of the line, shorter than the terminal has columns. What has no room is left out:
 * first the bar, then the rays a second, then the time that is left. */
void progress_line(char line[PROGRESS_LINE_SIZE], const struct progress *progress,
                   const struct render_totals *so_far);

#endif
