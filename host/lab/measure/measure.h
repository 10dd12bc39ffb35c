/* SPDX-License-Identifier: MIT */
/* Speed against accuracy: what the parts of `superframe measure` share. */
#ifndef SUPERFRAME_MEASURE_H
#define SUPERFRAME_MEASURE_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include "base/output.h"
#include "compiler/emit.h"
#include "options/options.h"
#include "picture.h"
#include "render/progress.h"
#include "stats/cost_model.h"

/* ---- Points --------------------------------------------------------------------------------- */

/* One rendering that is measured. Its key, the members before is_done, is what was asked for; the
 * rest is what the rendering gave. */
struct measure_point {
    char scene[32]; /* short name */
    char arithmetic[16], colour[16], model[16], tail[16];
    unsigned depth, width, height;
    double threshold; /* 0 where an accuracy is asked for */
    double error;     /* the accuracy asked for, in levels; 0: none */

    bool is_done;
    struct cost_events events;
    uint64_t leaked_rays, port_writes;
    double seconds; /* on the machine that measured, with --jobs threads */
    double wrong;   /* per cent of the pixels that are more than 1 LSB off */
    double apart;   /* per cent that are more than 1 LSB off double's with the same settings */
    unsigned largest;
    double rmse, psnr, colour_mean, colour_high; /* psnr infinite for equal pictures */
};

enum { MEASURE_KEY_SIZE = 160 };

/* Writes a point's key as text, with which the point's line in points.csv begins. */
void measure_key(const struct measure_point *point, char key[MEASURE_KEY_SIZE]);

/* A list that grows. All zero: the list is empty. */
struct measure_list {
    struct measure_point *points;
    size_t count, room;
};

/* Appends a copy of a point. Returns false where memory is out. */
bool measure_list_add(struct measure_list *list, const struct measure_point *point);

/* Finds the point whose key is that of `like`; NULL: there is none. */
struct measure_point *measure_list_find(const struct measure_list *list,
                                        const struct measure_point *like);

/* ---- Settings ------------------------------------------------------------------------------- */

enum { MEASURE_TARGETS_MOST = 16 };

/* Arithmetic, depth, threshold and tail, over all scenes: what a user chooses. */
struct measure_setting {
    char arithmetic[16], tail[16];
    unsigned depth;
    double threshold, error;
    double wrong, worst; /* per cent: the scenes' mean, and the scene that is worst */
    double apart;        /* the scenes' mean */
    double rays;         /* a pixel, shadow rays counted */
    double seconds[MEASURE_TARGETS_MOST]; /* by cost_targets: the scenes' mean; NaN: no entry */
};

struct measure_settings {
    struct measure_setting *settings;
    size_t count;
};

/* ---- The whole ------------------------------------------------------------------------------ */

enum { MEASURE_SCENES_MOST = 32, MEASURE_SHOWN = 4 };

/* The reference for all measurements: double, with nothing cut that could be seen. Light that is
 * cut there counts as the mean: as black, such light would make fig4a darker by up to 2 levels. */
#define MEASURE_CONVERGED_THRESHOLD (1.0 / 262144)
enum { MEASURE_CONVERGED_DEPTH = 255 };

struct measure_scene {
    const char *operand; /* as it was asked for */
    char name[32];
    char digest[SCENE_DIGEST_SIZE]; /* of the scene as compiled: a changed file is noticed */
    struct cost_mix mix;            /* the kinds of its primitives */
    double oracle;                  /* per cent of pixels in which f64 and f128 are equal */
};

struct measure {
    const struct options *options;
    const char *folder;
    char *points_path; /* FOLDER/points.csv */
    struct measure_scene scenes[MEASURE_SCENES_MOST];
    size_t scene_count;
    struct measure_list points;
    size_t kept; /* points that were there already */
    struct measure_settings settings;
    struct progress_sum work;
};

/* Functions below that return an int return an exit status. Where that is not STATUS_DONE, the
 * reason has been printed. */

/* Fills the list of points with all that are to be measured. */
int measure_plan(struct measure *measure);

/* Takes over what points.csv in the folder holds already. */
int measure_resume(struct measure *measure);

/* Measures the points that are missing; each is written to points.csv as soon as it is done. */
int measure_run(struct measure *measure);

/* Tells how to go on after a signal. Returns the exit status of it. */
int measure_interrupted(void);

/* Writes a finished point as one line, with the digest of its scene. */
void measure_write_point(const struct measure *measure, FILE *file,
                         const struct measure_point *point);

/* Finds the scene of that name; NULL: there is none. */
const struct measure_scene *measure_scene_of(const struct measure *measure, const char *name);

/* Writes the picture beside its difference from the reference, for the MEASURE_SHOWN points that
 * the report shows; else nothing. width and height are in dots. Both are enlarged by a whole
 * factor, as long as each is at most 320 dots wide. */
int measure_show(const struct measure *measure, const struct measure_point *point,
                 const uint8_t *reference, const uint8_t *picture, unsigned width, unsigned height);

/* How a points.csv begins. MEASURE_BEGUN: with the line of column names. MEASURE_EMPTY: with
 * nothing or a part of that line, whose writing was cut off. MEASURE_FOREIGN: otherwise. */
enum measure_beginning { MEASURE_BEGUN, MEASURE_EMPTY, MEASURE_FOREIGN };

/* Reads the line of column names, or what stands in its place, and tells how the file begins. */
enum measure_beginning measure_read_head(FILE *file);

/* Writes the line of column names and flushes the file. Returns false where that failed. */
bool measure_write_head(FILE *file);

/* Gathers the measured points of the grid by setting, anew each time; the caller frees
 * settings.settings. */
int measure_gather(struct measure *measure);

/* Tells whether a point is of the grid: of its scene's first size, colours and model. */
bool measure_is_of_grid(const struct measure *measure, const struct measure_point *point);

/* Finds the cheapest setting on a machine with a mean over the scenes of at most wrong_most per
 * cent wrong; NULL: none. */
const struct measure_setting *measure_cheapest(const struct measure_settings *settings,
                                               size_t target, double wrong_most);

/* Tells whether no other setting is at least as good in time and error, and better in one of them.
 * Settings without an entry in the cost table are passed over, and are not on the front. */
bool measure_is_on_front(const struct measure_settings *settings, size_t i, size_t target);

/* Writes the plots' script and, with gnuplot, the plots. */
int measure_plot(struct measure *measure);

/* Writes table.csv, report.md and report.html. */
int measure_report(struct measure *measure);

/* Prints scenes, settings and points as a JSON object to standard output, if --json asks for it. */
int measure_print(struct measure *measure);

/* A file of the report's folder while it is written. */
struct measure_file {
    struct output output;
    char *path;
};

/* Opens FOLDER/name for writing. False, with the reason printed, on failure. */
bool measure_create(struct measure_file *file, const struct measure *measure, const char *name);

/* Puts a file into its place. On failure prints the reason and leaves there what was there
 * before. */
int measure_close(struct measure_file *file);

/* Frees a file, and gives it up where it was not put into its place. */
void measure_discard(struct measure_file *file);

/* Predicts the seconds that a point takes on a machine; NaN where the cost table has no entry. */
double measure_predict(const struct measure *measure, const struct measure_point *point,
                       const struct cost_target *target);

/* Renders a point onto the emulated board. *rgb gets width x height pixels of *dots x *dots dots;
 * the caller frees it. Stands in picture.c. */
int measure_shoot(struct measure *measure, const char *operand, struct measure_point *point,
                  uint8_t **rgb, unsigned *dots);

#endif
