/* SPDX-License-Identifier: MIT */
/* The paper's figures and claims: what the parts of `superframe paper` share. */
#ifndef SUPERFRAME_PAPER_H
#define SUPERFRAME_PAPER_H

#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>

#include "board/camera.h"
#include "board/port_chain.h"
#include "lab/paper/claim.h"
#include "options/options.h"
#include "picture.h"
#include "render/arithmetic.h"
#include "render/progress.h"
#include "render/render.h"
#include "scene/overrides.h"

/* ---- Renders -------------------------------------------------------------------------------- */

/* A picture and what it took. */
struct paper_photo {
    struct render_totals totals; /* seconds: of processor time */
    unsigned width, height;      /* pixels; all zero where nothing was rendered */
    unsigned dots;               /* of the screen, along each side of a pixel */
    uint8_t rgb[PICTURE_BYTES];  /* the screen; of a multiple exposure the camera's picture */
};

/* Returns the R, G and B of a pixel. */
const uint8_t *paper_pixel(const struct paper_photo *photo, unsigned x, unsigned y);

/* What is done to a scene before it is rendered. */
enum paper_change {
    PAPER_AS_IT_IS,
    PAPER_SWAPPED,       /* the two colours of each pattern change places */
    PAPER_BARE,          /* transparent objects are left out */
    PAPER_BARE_SWAPPED,  /* both */
    PAPER_OUTLINE,       /* white where the line of sight meets one object, black elsewhere */
    PAPER_GLASS_OUTLINE, /* likewise for all transparent objects */
};

/* One render. */
struct paper_shot {
    const char *scene;
    enum paper_change change;
    const char *object; /* of PAPER_OUTLINE */
    bool is_large;      /* 640 x 400 instead of 320 x 200 */
    struct scene_overrides overrides;
};

/* ---- Figures -------------------------------------------------------------------------------- */

/* A picture of the paper. */
struct paper_figure {
    const char *file;    /* without .png */
    const char *label;   /* as in the paper */
    const char *caption; /* what is to be seen */
    struct paper_shot shot;
};

enum { PAPER_FIGURES_MOST = 24 };

extern const struct paper_figure paper_figures[]; /* ended by one without a file */

/* ---- Fig. 7 --------------------------------------------------------------------------------- */

enum { PAPER_CURVES = 4, PAPER_DEPTHS = 17 };

/* A cost against N = 0, 1, ... 16. */
struct paper_curve {
    const char *scene, *label;
    bool is_made;
    double rays[PAPER_DEPTHS];  /* eye, reflected, refracted and shadow rays */
    double tests[PAPER_DEPTHS]; /* a ray against a primitive */
};

/* ---- The whole ------------------------------------------------------------------------------ */

enum { PAPER_SCRATCH = 4 };

struct paper {
    const struct arithmetic *arithmetic;
    unsigned jobs;
    unsigned width, height; /* of what the paper has in 320 x 200 */
    const char *folder;     /* where files go; NULL while planning */

    bool is_planning; /* rows are counted, nothing is rendered */
    unsigned rows;    /* of all renders */
    struct progress_sum work;

    struct paper_photo *figures[PAPER_FIGURES_MOST]; /* by paper_figures; NULL: not made */
    struct paper_photo *scratch[PAPER_SCRATCH];      /* for the work at hand */
    struct paper_curve curves[PAPER_CURVES];
    struct paper_claim claims[PAPER_CLAIMS];
    bool has_plots;
};

/* Functions below that return an int return an exit status. Where that is not STATUS_DONE, the
 * reason has been printed. */

/* Renders a shot. While planning, only counts its rows and leaves an empty picture. */
int paper_shoot(struct paper *paper, const struct paper_shot *shot, struct paper_photo *photo);

int paper_make_figures(struct paper *paper);
int paper_make_curves(struct paper *paper);
int paper_make_claims(struct paper *paper);

/* Writes fig7.csv and fig7.gp, and by gnuplot the plots. Where gnuplot is missing, says what to
 * install and goes on. */
int paper_write_plots(struct paper *paper);

/* Writes the pictures and the contact sheet. */
int paper_write_pictures(const struct paper *paper);

/* Writes claims.md and index.html. */
int paper_write_report(const struct paper *paper);

/* Finds the photo of a figure by its file's name; NULL: the figure was not made. */
const struct paper_photo *paper_photo_of(const struct paper *paper, const char *file);

/* Opens a new file of the folder. Returns NULL, with the reason printed, on failure. */
FILE *paper_create(const struct paper *paper, const char *name);

/* Closes a file of the folder; STATUS_DONE if all was written. */
int paper_close(FILE *file, const char *name);

/* Makes figures, claims and report in a folder that does not appear before all are done. */
int paper_run(const struct options *options);

#endif
