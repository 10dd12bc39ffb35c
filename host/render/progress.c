/* SPDX-License-Identifier: MIT */
/* A bar on a terminal that says how far a render has come. */
#include "render/progress.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

enum { BAR_WIDTH = 24, SECONDS_SHOWN_MOST = 359999 };

#define SECONDS_BETWEEN 0.1

/* Writes a rate as "1234", "56.7 k" or "8.90 M". */
static void rate_text(char *text, size_t size, double rate) {
    if (rate < 1e4) {
        (void)snprintf(text, size, "%.0f", rate);
    } else if (rate < 1e6) {
        (void)snprintf(text, size, "%.1f k", rate / 1e3);
    } else {
        (void)snprintf(text, size, "%.2f M", rate / 1e6);
    }
}

void progress_line(char line[PROGRESS_LINE_SIZE], unsigned rows,
                   const struct render_totals *so_far) {
    char bar[BAR_WIDTH + 1], rate[32];
    double seconds = so_far->seconds > 0 ? so_far->seconds : 1e-9;
    unsigned done = rows == 0 ? BAR_WIDTH : so_far->rows * BAR_WIDTH / rows;
    for (unsigned i = 0; i < BAR_WIDTH; i++) {
        bar[i] = i < done ? '#' : '.';
    }
    bar[BAR_WIDTH] = '\0';
    /* Rows differ in what they take; the mean so far is the honest guess. */
    double left =
        so_far->rows == 0 ? SECONDS_SHOWN_MOST : seconds / so_far->rows * (rows - so_far->rows);
    unsigned left_seconds = left < SECONDS_SHOWN_MOST ? (unsigned)(left + 0.5) : SECONDS_SHOWN_MOST;
    rate_text(rate, sizeof rate, (double)(so_far->rays + so_far->shadow_rays) / seconds);
    (void)snprintf(line, PROGRESS_LINE_SIZE, "[%s] row %u of %u, %s rays/s, %u:%02u left", bar,
                   so_far->rows, rows, rate, left_seconds / 60, left_seconds % 60);
}

void progress_begin(struct progress *progress, unsigned rows, bool quiet) {
    memset(progress, 0, sizeof *progress);
    progress->is_shown = !quiet && isatty(STDERR_FILENO) == 1;
    progress->rows = rows;
}

void progress_show(void *context, const struct render_totals *so_far) {
    struct progress *progress = context;
    char line[PROGRESS_LINE_SIZE];
    if (!progress->is_shown || so_far->seconds - progress->last_drawn < SECONDS_BETWEEN) {
        return;
    }
    progress->last_drawn = so_far->seconds;
    progress_line(line, progress->rows, so_far);
    (void)fprintf(stderr, "\r%s\033[K", line); /* erases what is right of the line */
    (void)fflush(stderr);
}

void progress_end(struct progress *progress) {
    if (progress->is_shown && progress->last_drawn > 0) {
        (void)fputs("\r\033[K", stderr);
        (void)fflush(stderr);
    }
    progress->is_shown = false;
}
