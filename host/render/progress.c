/* SPDX-License-Identifier: MIT */
/* A bar on a terminal that shows the progress of a render. */
#include "render/progress.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include "base/stopwatch.h"

enum { BAR_WIDTH = 24, SECONDS_SHOWN_MOST = 359999, COLUMNS_USUAL = 80 };

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

/* Writes "1:02 left". Rows differ in what they take; the mean so far is the honest guess. */
static void left_text(char *text, size_t size, unsigned rows, const struct render_totals *so_far) {
    double left = so_far->rows == 0 ? SECONDS_SHOWN_MOST
                                    : so_far->seconds / so_far->rows * (rows - so_far->rows);
    unsigned seconds = left < SECONDS_SHOWN_MOST ? (unsigned)(left + 0.5) : SECONDS_SHOWN_MOST;
    (void)snprintf(text, size, "%u:%02u left", seconds / 60, seconds % 60);
}

/* Writes "[####......]". */
static void bar_text(char text[BAR_WIDTH + 4], unsigned rows, unsigned done) {
    unsigned full = rows == 0 ? BAR_WIDTH : (unsigned)((uint64_t)done * BAR_WIDTH / rows);
    char *bar = text;
    *bar++ = '[';
    for (unsigned i = 0; i < BAR_WIDTH; i++) {
        *bar++ = i < full ? '#' : '.';
    }
    (void)memcpy(bar, "] ", sizeof "] ");
}

void progress_line(char line[PROGRESS_LINE_SIZE], const struct progress *progress,
                   const struct render_totals *so_far) {
    char bar[BAR_WIDTH + 4], rate[32], rays[48], left[32], done[64];
    double seconds = so_far->seconds > 0 ? so_far->seconds : 1e-9;
    bar_text(bar, progress->rows, so_far->rows);
    rate_text(rate, sizeof rate, (double)(so_far->rays + so_far->shadow_rays) / seconds);
    (void)snprintf(rays, sizeof rays, ", %s rays/s", rate);
    left_text(left, sizeof left, progress->rows, so_far);
    (void)snprintf(done, sizeof done, "%s %u of %u",
                   progress->unit != NULL ? progress->unit : "row",
                   progress->unit != NULL ? progress->units_done : so_far->rows,
                   progress->unit != NULL ? progress->units : progress->rows);
    const char *const forms[][4] = {
        {bar, done, rays, left}, {"", done, rays, left}, {"", done, "", left}, {"", done, "", ""}};
    for (size_t i = 0; i < sizeof forms / sizeof forms[0]; i++) {
        int length = snprintf(line, PROGRESS_LINE_SIZE, "%s%s%s%s%s", forms[i][0], forms[i][1],
                              forms[i][2], forms[i][3][0] != '\0' ? ", " : "", forms[i][3]);
        if ((unsigned)length < progress->columns) {
            return;
        }
    }
    line[progress->columns > 0 ? progress->columns - 1 : 0] = '\0';
}

/* Returns the columns of the terminal that is standard error; 80 where it does not say. */
static unsigned terminal_columns(void) {
    struct winsize size;
    return ioctl(STDERR_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 ? size.ws_col
                                                                           : COLUMNS_USUAL;
}

void progress_begin(struct progress *progress, unsigned rows, bool quiet) {
    const char *terminal = getenv("TERM");
    memset(progress, 0, sizeof *progress);
    progress->is_shown = !quiet && isatty(STDERR_FILENO) == 1 && terminal != NULL &&
                         terminal[0] != '\0' && strcmp(terminal, "dumb") != 0;
    progress->rows = rows;
}

void progress_show(void *context, const struct render_totals *so_far) {
    struct progress *progress = context;
    char line[PROGRESS_LINE_SIZE];
    if (!progress->is_shown || so_far->seconds - progress->last_drawn < SECONDS_BETWEEN) {
        return;
    }
    progress->last_drawn = so_far->seconds;
    progress->columns = terminal_columns(); /* a window may be made narrower meanwhile */
    progress_line(line, progress, so_far);
    (void)fprintf(stderr, "\r%s\033[K", line); /* erases what is right of the line */
    (void)fflush(stderr);
}

void progress_show_sum(void *context, const struct render_totals *so_far) {
    struct progress_sum *sum = context;
    sum->now.rays = sum->before.rays + so_far->rays;
    sum->now.shadow_rays = sum->before.shadow_rays + so_far->shadow_rays;
    sum->now.rows = sum->before.rows + so_far->rows;
    sum->now.seconds = stopwatch_seconds(&sum->began);
    progress_show(&sum->progress, &sum->now);
}

void progress_end(struct progress *progress) {
    if (progress->is_shown && progress->last_drawn > 0) {
        (void)fputs("\r\033[K", stderr);
        (void)fflush(stderr);
    }
    progress->is_shown = false;
}
