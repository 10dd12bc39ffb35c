/* SPDX-License-Identifier: MIT */
/* All of the paper from scratch: planned, rendered, measured, written, and put into its place. */
#include <stdlib.h>
#include <string.h>

#include "base/complain.h"
#include "base/interrupt.h"
#include "base/output_folder.h"
#include "base/stopwatch.h"
#include "lab/paper/paper.h"

static int render_all(struct paper *paper) {
    int status = paper_make_figures(paper);
    if (status == STATUS_DONE) {
        status = paper_make_curves(paper);
    }
    return status == STATUS_DONE ? paper_make_claims(paper) : status;
}

/* Does all the work twice: first only to count rows, so that one bar shows the progress of the
 * whole. */
static int plan_and_render(struct paper *paper, bool quiet) {
    paper->is_planning = true;
    int status = render_all(paper);
    if (status != STATUS_DONE) {
        return status;
    }
    paper->is_planning = false;
    paper->work.began = stopwatch_start();
    progress_begin(&paper->work.progress, paper->rows, quiet);
    status = render_all(paper);
    progress_end(&paper->work.progress);
    return status;
}

static int write_all(struct paper *paper) {
    int status = paper_write_pictures(paper);
    if (status == STATUS_DONE) {
        status = paper_write_plots(paper);
    }
    return status == STATUS_DONE ? paper_write_report(paper) : status;
}

static bool make_scratch(struct paper *paper) {
    for (int i = 0; i < PAPER_SCRATCH; i++) {
        paper->scratch[i] = malloc(sizeof *paper->scratch[i]);
        if (paper->scratch[i] == NULL) {
            complain("out of memory");
            return false;
        }
    }
    return true;
}

static void free_photos(struct paper *paper) {
    for (int i = 0; i < PAPER_FIGURES_MOST; i++) {
        free(paper->figures[i]);
    }
    for (int i = 0; i < PAPER_SCRATCH; i++) {
        free(paper->scratch[i]);
    }
}

static int make_paper(struct paper *paper, const struct options *options) {
    struct paper_folder folder;
    interrupt_catch();
    if (!make_scratch(paper) || !paper_folder_open(&folder, options->output)) {
        return STATUS_FAILED;
    }
    paper->folder = folder.temporary;
    int status = plan_and_render(paper, options->quiet);
    if (status == STATUS_DONE) {
        status = write_all(paper);
    }
    if (status != STATUS_DONE) {
        paper_folder_discard(&folder);
        return status;
    }
    return paper_folder_commit(&folder) ? STATUS_DONE : STATUS_FAILED;
}

int paper_run(const struct options *options) {
    struct paper *paper = calloc(1, sizeof *paper);
    if (paper == NULL) {
        return failure("out of memory");
    }
    paper->arithmetic = arithmetic_find(options->arithmetic);
    paper->jobs = options->jobs;
    paper->width = (unsigned)options->overrides.width;
    paper->height = (unsigned)options->overrides.height;
    int status = make_paper(paper, options);
    free_photos(paper);
    free(paper);
    return status;
}
