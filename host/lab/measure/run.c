/* SPDX-License-Identifier: MIT */
/* Measures the points that are missing, one rendering after the other, against one picture each. */
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "base/complain.h"
#include "base/interrupt.h"
#include "base/stopwatch.h"
#include "lab/measure/measure.h"
#include "picture/ciede2000.h"
#include "picture/compare.h"
#include "render/arithmetic.h"

enum { ORACLE_WIDTH = 48, ORACLE_HEIGHT = 30, ORACLE_DEPTH = 10, TWINS_MOST = 64 };

/* A picture in dots. */
struct dots_picture {
    uint8_t *rgb;
    unsigned width, height;
};

/* Tells whether two points are measured against the same picture. */
static bool share_reference(const struct measure_point *a, const struct measure_point *b) {
    return strcmp(a->scene, b->scene) == 0 && strcmp(a->model, b->model) == 0 &&
           a->width == b->width && a->height == b->height;
}

static int shoot(struct measure *measure, const struct measure_scene *scene,
                 struct measure_point *point, struct dots_picture *picture) {
    unsigned dots;
    int status = measure_shoot(measure, scene->operand, point, &picture->rgb, &dots);
    picture->width = point->width * dots;
    picture->height = point->height * dots;
    return status;
}

/* ---- The oracle ----------------------------------------------------------------------------- */

static int compare_oracle(struct measure *measure, struct measure_scene *scene,
                          struct measure_point point) {
    struct dots_picture wide = {NULL, 0, 0}, narrow = {NULL, 0, 0};
    struct comparison comparison;
    point.width = ORACLE_WIDTH;
    point.height = ORACLE_HEIGHT;
    point.depth = ORACLE_DEPTH;
    point.threshold = 1.0 / 4096;
    point.error = 0;
    strcpy(point.colour, "full");
    strcpy(point.arithmetic, "f128");
    int status = shoot(measure, scene, &point, &wide);
    strcpy(point.arithmetic, "f64");
    if (status == STATUS_DONE) {
        status = shoot(measure, scene, &point, &narrow);
    }
    if (status == STATUS_DONE) {
        compare_pictures(wide.rgb, narrow.rgb, (size_t)wide.width * wide.height, &comparison);
        scene->oracle = comparison_share(&comparison, 0);
    }
    free(wide.rgb);
    free(narrow.rgb);
    return status;
}

/* ---- Double with the same settings ---------------------------------------------------------- */

/* Pictures of one group that double has made, to hold other arithmetics against. */
struct twins {
    size_t count;
    struct measure_point point[TWINS_MOST];
    struct dots_picture picture[TWINS_MOST];
};

static void free_twins(struct twins *twins) {
    for (size_t i = 0; i < twins->count; i++) {
        free(twins->picture[i].rgb);
    }
    free(twins);
}

/* Tells whether two points have the same picture by double. */
static bool are_twins(const struct measure_point *a, const struct measure_point *b) {
    struct measure_point one = *a, other = *b;
    char key[MEASURE_KEY_SIZE], other_key[MEASURE_KEY_SIZE];
    one.arithmetic[0] = other.arithmetic[0] = '\0';
    measure_key(&one, key);
    measure_key(&other, other_key);
    return strcmp(key, other_key) == 0;
}

/* Finds double's picture with the settings of a point, or renders that picture. Where all places
 * are taken, the last picture gives way. Returns an exit status. */
static int find_twin(struct measure *measure, const struct measure_scene *scene,
                     const struct measure_point *like, struct twins *twins, size_t *found) {
    struct measure_point point = *like;
    for (*found = 0; *found < twins->count; ++*found) {
        if (are_twins(like, &twins->point[*found])) {
            return STATUS_DONE;
        }
    }
    if (twins->count == TWINS_MOST) {
        free(twins->picture[--twins->count].rgb);
        *found = twins->count;
    }
    strcpy(point.arithmetic, "f64");
    int status = shoot(measure, scene, &point, &twins->picture[twins->count]);
    if (status == STATUS_DONE) {
        twins->point[twins->count++] = point;
    }
    return status;
}

/* ---- Points --------------------------------------------------------------------------------- */

static double percent_off(const struct dots_picture *a, const struct dots_picture *b) {
    struct comparison comparison;
    size_t dots = (size_t)a->width * a->height;
    compare_pictures(a->rgb, b->rgb, dots, &comparison);
    return 100.0 * (double)(dots - comparison_within(&comparison, 1)) / (double)dots;
}

static int judge_point(struct measure_point *point, const struct dots_picture *reference,
                       const struct dots_picture *picture) {
    struct comparison comparison;
    struct colour_differences colours;
    size_t dots = (size_t)picture->width * picture->height;
    compare_pictures(reference->rgb, picture->rgb, dots, &comparison);
    if (!colour_differences(reference->rgb, picture->rgb, dots, &colours)) {
        return failure("out of memory");
    }
    point->wrong = percent_off(reference, picture);
    point->largest = comparison_largest(&comparison);
    point->rmse = comparison_rmse(&comparison);
    point->psnr = comparison_psnr(&comparison);
    point->colour_mean = colours.mean;
    point->colour_high = colours.high;
    return STATUS_DONE;
}

static int measure_point(struct measure *measure, const struct measure_scene *scene,
                         struct measure_point *point, const struct dots_picture *reference,
                         struct twins *twins, FILE *log) {
    struct dots_picture picture = {NULL, 0, 0};
    size_t twin = 0;
    int status = shoot(measure, scene, point, &picture);
    if (status == STATUS_DONE) {
        status = judge_point(point, reference, &picture);
    }
    if (status == STATUS_DONE) {
        status = find_twin(measure, scene, point, twins, &twin);
    }
    if (status == STATUS_DONE) {
        point->apart = percent_off(&twins->picture[twin], &picture);
    }
    if (status == STATUS_DONE && share_reference(point, &measure->points.points[0])) {
        status = measure_show(measure, point, reference->rgb, picture.rgb, picture.width,
                              picture.height);
    }
    free(picture.rgb);
    if (status != STATUS_DONE) {
        return status;
    }
    point->is_done = true;
    measure->work.progress.units_done++;
    measure_write_point(measure, log, point);
    if (fflush(log) != 0) {
        return failure("%s: cannot be written: %s", measure->points_path, strerror(errno));
    }
    return STATUS_DONE;
}

/* Measures all points that share the reference of the given one, which is the first of them. */
static int measure_group(struct measure *measure, const struct measure_scene *scene, size_t first,
                         FILE *log) {
    struct measure_point like = measure->points.points[first];
    struct dots_picture reference = {NULL, 0, 0};
    strcpy(like.arithmetic, "f64");
    strcpy(like.colour, "full");
    strcpy(like.tail, "estimate");
    like.depth = MEASURE_CONVERGED_DEPTH;
    like.threshold = MEASURE_CONVERGED_THRESHOLD;
    like.error = 0;
    struct twins *twins = calloc(1, sizeof *twins);
    if (twins == NULL) {
        return failure("out of memory");
    }
    int status = shoot(measure, scene, &like, &reference);
    for (size_t i = first; i < measure->points.count && status == STATUS_DONE; i++) {
        struct measure_point *point = &measure->points.points[i];
        if (!point->is_done && share_reference(point, &like)) {
            status = measure_point(measure, scene, point, &reference, twins, log);
        }
    }
    free_twins(twins);
    free(reference.rgb);
    return status;
}

/* Tells whether no unfinished point before point i has the same twin. */
static bool is_first_of_twins(const struct measure *measure, size_t i) {
    const struct measure_point *points = measure->points.points;
    size_t j = 0;
    while (j < i && (points[j].is_done || !are_twins(&points[i], &points[j]))) {
        j++;
    }
    return j == i;
}

/* Counts the rows that are still to be rendered, for the progress bar. */
static unsigned count_rows(const struct measure *measure) {
    unsigned rows = (unsigned)measure->scene_count * 2 * ORACLE_HEIGHT;
    for (size_t i = 0; i < measure->points.count; i++) {
        const struct measure_point *point = &measure->points.points[i];
        bool is_first = !point->is_done;
        for (size_t j = 0; j < i && is_first; j++) {
            const struct measure_point *other = &measure->points.points[j];
            is_first = other->is_done || !share_reference(point, other);
        }
        rows += point->is_done ? 0 : point->height;
        rows += !point->is_done && is_first_of_twins(measure, i) ? point->height : 0;
        rows += is_first ? point->height : 0;
    }
    return rows;
}

static unsigned count_done(const struct measure *measure) {
    unsigned done = 0;
    for (size_t i = 0; i < measure->points.count; i++) {
        done += measure->points.points[i].is_done;
    }
    return done;
}

/* Makes points.csv ready for further lines. A head that is missing or cut off is written anew; a
 * line that was cut off is ended. */
static bool begin_log(FILE *file) {
    if (measure_read_head(file) != MEASURE_BEGUN) {
        return ftruncate(fileno(file), 0) == 0 && fseek(file, 0, SEEK_END) == 0 &&
               measure_write_head(file);
    }
    bool is_begun = fseek(file, -1, SEEK_END) == 0;
    int last = fgetc(file);
    return is_begun && fseek(file, 0, SEEK_END) == 0 &&
           (last == '\n' || (fputc('\n', file) != EOF && fflush(file) == 0));
}

static FILE *open_log(const struct measure *measure) {
    const char *path = measure->points_path;
    FILE *file = fopen(path, "a+");
    if (file == NULL || !begin_log(file)) {
        complain("%s: cannot be written: %s", path, strerror(errno));
        if (file != NULL) {
            (void)fclose(file);
        }
        return NULL;
    }
    return file;
}

static int run_all(struct measure *measure, FILE *log) {
    int status = STATUS_DONE;
    for (size_t i = 0; i < measure->scene_count && status == STATUS_DONE; i++) {
        struct measure_scene *scene = &measure->scenes[i];
        struct measure_point like = measure->points.points[0];
        for (size_t j = 0; j < measure->points.count; j++) {
            if (strcmp(measure->points.points[j].scene, scene->name) == 0) {
                like = measure->points.points[j];
                break;
            }
        }
        if (arithmetic_find("f128") != NULL) {
            status = compare_oracle(measure, scene, like);
        }
    }
    for (size_t i = 0; i < measure->points.count && status == STATUS_DONE; i++) {
        const struct measure_point *point = &measure->points.points[i];
        if (!point->is_done) {
            status = measure_group(measure, measure_scene_of(measure, point->scene), i, log);
        }
    }
    return status;
}

int measure_interrupted(void) {
    complain("interrupted; started again with the same -o it goes on where it was");
    return STATUS_SIGNAL + *interrupt_noted();
}

int measure_run(struct measure *measure) {
    FILE *log = open_log(measure);
    if (log == NULL) {
        return STATUS_FAILED;
    }
    progress_begin(&measure->work.progress, count_rows(measure), measure->options->quiet);
    measure->work.progress.unit = "setting";
    measure->work.progress.units = (unsigned)measure->points.count;
    measure->work.progress.units_done = count_done(measure);
    measure->work.began = stopwatch_start();
    interrupt_catch();
    int status = run_all(measure, log);
    progress_end(&measure->work.progress);
    if (fclose(log) != 0 && status == STATUS_DONE) {
        status = failure("%s: cannot be written: %s", measure->points_path, strerror(errno));
    }
    return *interrupt_noted() != 0 ? measure_interrupted() : status;
}
