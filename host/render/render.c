/* SPDX-License-Identifier: MIT */
/* The render job: rows from worker threads, drawn in order through the firmware's driver. */
#include "render/render.h"

#include <pthread.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "base/stopwatch.h"
#include "board_ports.h"
#include "bus.h"
#include "render/rows.h"

enum { BANDS_AHEAD = 3 }; /* of the drawing, for each worker: so that none waits for a slow one */

/* A place for one row of the window. */
struct row_slot {
    bool is_ready;
    struct render_counts counts;
    uint8_t *rgb;
};

/* One render at work. The window is the rows that may be computed ahead of the drawing. */
struct renderer {
    const struct render_job *job;
    const struct arithmetic *arithmetic; /* the job's, with room for the scene */
    const struct scene *scene;
    struct render_totals totals;
    struct timespec began;

    pthread_mutex_t mutex; /* guards what follows, and is_ready of the slots */
    pthread_cond_t row_is_ready, window_moved;
    unsigned next;  /* the row where the next idle worker's band begins */
    unsigned drawn; /* rows before it are drawn: the window begins here */
    bool is_over;

    unsigned window; /* its size in rows */
    struct row_slot *slots;
    uint8_t *pixels; /* of all slots */

    struct band band; /* of one job */
    uint8_t *kept;    /* all rows from job->first_row on, to be drawn again; NULL: drawn once */
};

static void add_row(struct renderer *renderer, const struct render_counts *counts) {
    struct render_totals *totals = &renderer->totals;
    totals->rays += counts->rays;
    totals->shadow_rays += counts->shadow_rays;
    totals->nodes += counts->nodes;
    totals->solid_tests += counts->solid_tests;
    totals->leaked_rays += counts->leaked_rays;
    totals->exhausted_pixels += counts->exhausted_pixels;
    totals->unreached_pixels += counts->unreached_pixels;
    if (counts->estimated_error > totals->estimated_error) {
        totals->estimated_error = counts->estimated_error;
        totals->worst_x = counts->worst_x;
        totals->worst_y = counts->worst_y;
    }
    if (counts->proved_error > totals->proved_error) {
        totals->proved_error = counts->proved_error;
    }
    totals->rows++;
    totals->seconds = stopwatch_seconds(&renderer->began);
    if (renderer->job->progress != NULL) {
        renderer->job->progress(renderer->job->context, totals);
    }
}

static bool must_stop(const struct renderer *renderer) {
    const volatile sig_atomic_t *stop = renderer->job->stop;
    return (stop != NULL && *stop != 0) || bus_bound_status() != BUS_OK;
}

static size_t row_bytes(const struct renderer *renderer) {
    return (size_t)renderer->job->scene->width * 3;
}

/* Returns the place where row y is kept. */
static uint8_t *kept_row(const struct renderer *renderer, unsigned y) {
    return renderer->kept + (y - renderer->job->first_row) * row_bytes(renderer);
}

static void keep_row(struct renderer *renderer, unsigned y, const uint8_t *rgb) {
    if (renderer->kept != NULL) {
        memcpy(kept_row(renderer, y), rgb, row_bytes(renderer));
    }
}

/* Copies a kept row: the row_source of drawings after the first. */
static bool repeat_row(void *context, uint16_t y, uint8_t *rgb) {
    const struct renderer *renderer = context;
    memcpy(rgb, kept_row(renderer, y), row_bytes(renderer));
    return bus_bound_status() == BUS_OK;
}

/* Returns how many rows the band has that begins at row `first`. */
static unsigned band_rows(const struct renderer *renderer, unsigned first) {
    unsigned left = renderer->job->last_row - first;
    return left < BAND_ROWS ? left : BAND_ROWS;
}

/* Returns the place of a row in `pixels`, where one job works alone. */
static uint8_t *band_row(const struct renderer *renderer, unsigned y) {
    return renderer->pixels + (y - renderer->job->first_row) % BAND_ROWS * row_bytes(renderer);
}

/* Computes a band in the drawing thread when its first row is asked for: the row_source of one
 * job. */
static bool compute_row(void *context, uint16_t y, uint8_t *rgb) {
    struct renderer *renderer = context;
    struct render_counts counts = {0};
    if (must_stop(renderer)) {
        return false;
    }
    if ((y - renderer->job->first_row) % BAND_ROWS == 0) {
        band_render(&renderer->band, y, band_rows(renderer, y), row_bytes(renderer),
                    renderer->pixels, &counts);
    }
    memcpy(rgb, band_row(renderer, y), row_bytes(renderer));
    keep_row(renderer, y, rgb);
    add_row(renderer, &counts);
    return true;
}

/* Waits until the next band is in the window, and gives it to a worker; false when none is left. */
static bool take_band(struct renderer *renderer, unsigned *first) {
    (void)pthread_mutex_lock(&renderer->mutex);
    while (!renderer->is_over && renderer->next < renderer->job->last_row &&
           renderer->next + band_rows(renderer, renderer->next) >
               renderer->drawn + renderer->window) {
        (void)pthread_cond_wait(&renderer->window_moved, &renderer->mutex);
    }
    bool has_band = !renderer->is_over && renderer->next < renderer->job->last_row;
    if (has_band) {
        *first = renderer->next;
        renderer->next += band_rows(renderer, renderer->next);
    }
    (void)pthread_mutex_unlock(&renderer->mutex);
    return has_band;
}

/* Returns the slot of a row; the slots of a band lie side by side. */
static struct row_slot *slot_of(const struct renderer *renderer, unsigned y) {
    return &renderer->slots[(y - renderer->job->first_row) % renderer->window];
}

static void *work(void *context) {
    struct renderer *renderer = context;
    struct band band;
    unsigned first;
    band_start(&band, renderer->arithmetic, renderer->scene);
    while (take_band(renderer, &first)) {
        unsigned rows = band_rows(renderer, first);
        struct row_slot *slot = slot_of(renderer, first);
        for (unsigned i = 0; i < rows; i++) {
            memset(&slot[i].counts, 0, sizeof slot[i].counts);
        }
        band_render(&band, first, rows, row_bytes(renderer), slot->rgb, &slot->counts);
        (void)pthread_mutex_lock(&renderer->mutex);
        for (unsigned i = 0; i < rows; i++) {
            slot[i].is_ready = true;
        }
        (void)pthread_cond_signal(&renderer->row_is_ready);
        (void)pthread_mutex_unlock(&renderer->mutex);
    }
    band_end(&band);
    return NULL;
}

/* Waits for a row and makes room in the window: the row_source of several jobs. The driver asks for
 * each row once, from the first to the last. */
static bool fetch_row(void *context, uint16_t y, uint8_t *rgb) {
    struct renderer *renderer = context;
    struct row_slot *slot = slot_of(renderer, y);
    if (must_stop(renderer)) {
        return false;
    }
    (void)pthread_mutex_lock(&renderer->mutex);
    while (!slot->is_ready) {
        (void)pthread_cond_wait(&renderer->row_is_ready, &renderer->mutex);
    }
    memcpy(rgb, slot->rgb, row_bytes(renderer));
    struct render_counts counts = slot->counts;
    slot->is_ready = false;
    renderer->drawn = (unsigned)y + 1;
    (void)pthread_cond_broadcast(&renderer->window_moved);
    (void)pthread_mutex_unlock(&renderer->mutex);
    keep_row(renderer, y, rgb);
    add_row(renderer, &counts);
    return true;
}

/* Draws the rows up to last - 1 once. */
static void draw_once(struct renderer *renderer, row_source *source, unsigned last,
                      unsigned exposure) {
    const struct render_job *job = renderer->job;
    const struct drawing drawing = {.base = job->base,
                                    .first = (uint16_t)job->first_row,
                                    .last = (uint16_t)last,
                                    .source = source,
                                    .context = renderer,
                                    .exposure = (uint8_t)exposure};
    renderer->arithmetic->image->draw(renderer->scene, &drawing);
    if (renderer->kept != NULL && job->exposed != NULL) {
        job->exposed(job->exposed_context, exposure);
    }
}

static void draw(struct renderer *renderer, row_source *source) {
    draw_once(renderer, source, renderer->job->last_row, 0);
    unsigned last = renderer->job->first_row + renderer->totals.rows;
    for (unsigned exposure = 1;
         renderer->kept != NULL && exposure < RENDER_EXPOSURES && bus_bound_status() == BUS_OK;
         exposure++) {
        draw_once(renderer, repeat_row, last, exposure);
    }
}

static bool draw_alone(struct renderer *renderer) {
    renderer->pixels = malloc(BAND_ROWS * row_bytes(renderer));
    if (renderer->pixels == NULL) {
        return false;
    }
    band_start(&renderer->band, renderer->arithmetic, renderer->scene);
    draw(renderer, compute_row);
    band_end(&renderer->band);
    return true;
}

/* Starts up to job->jobs workers; returns how many there are. Signals are blocked in the workers:
 * the drawing thread reads the flag. */
static unsigned start_workers(struct renderer *renderer, pthread_t *workers) {
    unsigned started = 0;
    sigset_t all, before;
    (void)sigfillset(&all);
    (void)pthread_sigmask(SIG_SETMASK, &all, &before);
    while (started < renderer->job->jobs &&
           pthread_create(&workers[started], NULL, work, renderer) == 0) {
        started++;
    }
    (void)pthread_sigmask(SIG_SETMASK, &before, NULL);
    return started;
}

static bool draw_with_workers(struct renderer *renderer) {
    pthread_t *workers = calloc(renderer->job->jobs, sizeof *workers);
    if (workers == NULL) {
        return false;
    }
    (void)pthread_mutex_init(&renderer->mutex, NULL);
    (void)pthread_cond_init(&renderer->row_is_ready, NULL);
    (void)pthread_cond_init(&renderer->window_moved, NULL);
    unsigned started = start_workers(renderer, workers);
    if (started > 0) {
        draw(renderer, fetch_row);
    }
    (void)pthread_mutex_lock(&renderer->mutex);
    renderer->is_over = true;
    (void)pthread_cond_broadcast(&renderer->window_moved);
    (void)pthread_mutex_unlock(&renderer->mutex);
    for (unsigned i = 0; i < started; i++) {
        (void)pthread_join(workers[i], NULL);
    }
    (void)pthread_cond_destroy(&renderer->window_moved);
    (void)pthread_cond_destroy(&renderer->row_is_ready);
    (void)pthread_mutex_destroy(&renderer->mutex);
    free(workers);
    return started > 0;
}

static bool make_window(struct renderer *renderer) {
    renderer->window = renderer->job->jobs * BANDS_AHEAD * BAND_ROWS;
    renderer->next = renderer->drawn = renderer->job->first_row;
    renderer->slots = calloc(renderer->window, sizeof *renderer->slots);
    renderer->pixels = malloc(renderer->window * row_bytes(renderer));
    if (renderer->slots == NULL || renderer->pixels == NULL) {
        return false;
    }
    for (unsigned i = 0; i < renderer->window; i++) {
        renderer->slots[i].rgb = renderer->pixels + i * row_bytes(renderer);
    }
    return true;
}

static bool make_kept_rows(struct renderer *renderer) {
    const struct render_job *job = renderer->job;
    if (job->scene->show != SHOW_EXPOSURES) {
        return true;
    }
    renderer->kept = malloc((job->last_row - job->first_row) * row_bytes(renderer));
    return renderer->kept != NULL;
}

static void learn(struct renderer *renderer, struct scene *scene) {
    struct render_totals *totals = &renderer->totals;
    struct render_counts counts = {0};
    renderer->arithmetic->learn(scene, &totals->estimate, &counts);
    totals->learning_rays = counts.rays;
    totals->rays += counts.rays;
    totals->shadow_rays += counts.shadow_rays;
    totals->nodes += counts.nodes;
    totals->solid_tests += counts.solid_tests;
    totals->leaked_rays += counts.leaked_rays;
}

bool render(const struct render_job *job, struct render_totals *totals, struct scene_error *error) {
    struct renderer renderer;
    const struct arithmetic *arithmetic = arithmetic_for(job->arithmetic, job->scene);
    struct scene *scene = arithmetic->load(job->scene, error);
    if (scene == NULL) {
        return false;
    }
    memset(&renderer, 0, sizeof renderer);
    renderer.job = job;
    renderer.arithmetic = arithmetic;
    renderer.scene = scene;
    renderer.began = stopwatch_start();
    learn(&renderer, scene);
    bool is_done = make_kept_rows(&renderer);
    if (is_done && job->jobs <= 1) {
        is_done = draw_alone(&renderer);
    } else if (is_done) {
        is_done = make_window(&renderer) && draw_with_workers(&renderer);
    }
    if (!is_done) {
        (void)snprintf(error->text, sizeof error->text,
                       "no memory or threads for --jobs %u; fewer are allowed", job->jobs);
    }
    renderer.totals.seconds = stopwatch_seconds(&renderer.began);
    *totals = renderer.totals;
    free(renderer.slots);
    free(renderer.pixels);
    free(renderer.kept);
    free(scene);
    return is_done;
}
