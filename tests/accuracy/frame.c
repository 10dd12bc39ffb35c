/* SPDX-License-Identifier: MIT */
/* Pictures in levels, neither rounded nor clamped, and the converged ones they are held against. */
#include "frame.h"

#include <math.h>
#include <pthread.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "render/rows.h"

enum { THREADS = 2, PATH_SIZE = 512 };

/* What of the pixels is asked for. */
enum detail { DETAIL_SHOWN, DETAIL_EXACT, DETAIL_CUT };

/* What the threads share: bands of rows are handed out one by one. */
struct frame_work {
    pthread_mutex_t lock;
    const struct arithmetic *arithmetic;
    const struct scene *scene;
    struct frame *frame;
    enum detail detail;
    int next_row;
    double rays;
    unsigned long leaked, exhausted;
};

static void ignore_node(void *context, const struct observed_node *node) {
    (void)context;
    (void)node;
}

static void note_end(void *context, const struct observed_end *end) {
    struct frame_pixel *pixel = context;
    for (int i = 0; i < 3; i++) {
        if (end->why == OBSERVED_THRESHOLD) {
            pixel->cut[i] += end->weight[i];
        } else if (end->why == OBSERVED_DEPTH) {
            pixel->ended[i] += end->weight[i];
        }
    }
}

static void add_counts(struct render_counts *sums, const struct render_counts *counts) {
    sums->rays += counts->rays;
    sums->leaked_rays += counts->leaked_rays;
    sums->exhausted_pixels += counts->exhausted_pixels;
}

static void render_row(struct frame_work *work, int row, struct render_counts *sums) {
    struct frame *frame = work->frame;
    for (int x = 0; x < frame->width; x++) {
        struct frame_pixel *pixel = &frame->pixels[row * frame->width + x];
        const struct pixel_observer observer = {pixel, ignore_node, note_end};
        struct render_counts counts;
        memset(&counts, 0, sizeof counts);
        work->arithmetic->pixel(work->scene, (uint16_t)x, (uint16_t)row, pixel->level, &counts,
                                work->detail == DETAIL_CUT ? &observer : NULL);
        pixel->uncertainty = counts.estimated_error / 65536.0;
        add_counts(sums, &counts);
    }
}

/* As the screen has them: by streams of rays where the host has them, which is faster. */
static void render_shown(struct frame_work *work, struct band *band, int first, int rows,
                         uint8_t *rgb, struct render_counts *counts) {
    struct frame *frame = work->frame;
    struct frame_pixel *pixels = &frame->pixels[first * frame->width];
    band_render(band, (unsigned)first, (unsigned)rows, 3 * (size_t)frame->width, rgb, counts);
    for (int i = 0; i < rows * frame->width; i++) {
        for (int j = 0; j < 3; j++) {
            pixels[i].level[j] = rgb[3 * i + j];
        }
    }
}

/* The number of rows of the next band, 0 after the last one. */
static int take_band(struct frame_work *work, int *first) {
    pthread_mutex_lock(&work->lock);
    int left = work->frame->height - work->next_row, rows = left < BAND_ROWS ? left : BAND_ROWS;
    *first = work->next_row;
    work->next_row += rows;
    pthread_mutex_unlock(&work->lock);
    return rows;
}

/* With memory for a band, or none where pixels are rendered one by one. */
static void render_bands(struct frame_work *work, struct band *band, uint8_t *rgb) {
    int first, rows;
    while ((rows = take_band(work, &first)) > 0) {
        struct render_counts counts;
        memset(&counts, 0, sizeof counts);
        if (rgb) {
            render_shown(work, band, first, rows, rgb, &counts);
        } else {
            for (int i = 0; i < rows; i++) {
                render_row(work, first + i, &counts);
            }
        }
        pthread_mutex_lock(&work->lock);
        work->rays += (double)counts.rays;
        work->leaked += counts.leaked_rays;
        work->exhausted += counts.exhausted_pixels;
        pthread_mutex_unlock(&work->lock);
    }
}

static void *render_frame(void *argument) {
    struct frame_work *work = argument;
    struct band band;
    uint8_t *rgb = NULL;
    if (work->detail == DETAIL_SHOWN) {
        rgb = malloc((size_t)3 * BAND_ROWS * (size_t)work->frame->width);
        band_start(&band, work->arithmetic, work->scene);
    }
    render_bands(work, &band, rgb);
    if (work->detail == DETAIL_SHOWN) {
        band_end(&band);
        free(rgb);
    }
    return NULL;
}

static bool run_threads(struct frame_work *work) {
    pthread_t threads[THREADS];
    int started = 0;
    while (started < THREADS && pthread_create(&threads[started], NULL, render_frame, work) == 0) {
        started++;
    }
    for (int i = 0; i < started; i++) {
        pthread_join(threads[i], NULL);
    }
    if (started == 0 || work->leaked > 0) {
        fprintf(stderr, "no thread could be started, or %lu rays leaked\n", work->leaked);
        return false;
    }
    return true;
}

static struct compiled_scene *compiled_of(const struct frame_settings *settings) {
    struct scene_error error;
    struct compiled_scene *compiled = NULL;
    struct scene_description *description = load_scene(settings->scene, &error);
    if (description) {
        description->width = settings->width;
        description->height = settings->height;
        description->colour = COLOUR_FULL;
        description->depth = FRAME_DEPTH;
        description->threshold = settings->threshold;
        description->error = settings->error;
        description->estimates = settings->estimates;
        compiled = scene_compile(description, &error);
        scene_description_free(description);
    }
    if (!compiled) {
        fprintf(stderr, "%s\n", error.text);
    }
    return compiled;
}

/* Loads the scene and learns, as far as its settings ask for that. */
static struct scene *load(const struct frame_settings *settings, struct frame *frame) {
    struct scene_error error;
    struct render_counts counts;
    struct compiled_scene *compiled = compiled_of(settings);
    const struct arithmetic *arithmetic = arithmetic_find(settings->arithmetic);
    struct scene *scene = compiled ? arithmetic->load(compiled, &error) : NULL;
    memset(&counts, 0, sizeof counts);
    memset(frame, 0, sizeof *frame);
    frame->width = settings->width;
    frame->height = settings->height;
    if (scene) {
        arithmetic->learn(scene, &frame->estimate, &counts);
        frame->learning_rays = (double)counts.rays / ((double)settings->width * settings->height);
    }
    compiled_scene_free(compiled);
    return scene;
}

static bool render_scene(const struct frame_settings *settings, enum detail detail,
                         struct frame *frame) {
    struct scene *scene = load(settings, frame);
    size_t pixels = (size_t)settings->width * (size_t)settings->height;
    frame->pixels = calloc(pixels, sizeof *frame->pixels);
    bool good = scene && frame->pixels;
    if (good) {
        struct frame_work work = {PTHREAD_MUTEX_INITIALIZER,
                                  arithmetic_find(settings->arithmetic),
                                  scene,
                                  frame,
                                  detail,
                                  0,
                                  0,
                                  0,
                                  0};
        good = run_threads(&work);
        frame->rays = frame->learning_rays + work.rays / (double)pixels;
        frame->exhausted_pixels = work.exhausted;
    }
    free(scene);
    return good;
}

bool frame_render(const struct frame_settings *settings, struct frame *frame) {
    return render_scene(settings, settings->shown ? DETAIL_SHOWN : DETAIL_EXACT, frame);
}

/* The radiance of pruned branches, learned at a threshold where that is quick. */
static bool learn_mean(const struct frame_settings *settings, double mean[3]) {
    struct frame_settings coarse = *settings;
    struct frame frame;
    coarse.threshold = 1.0 / 4096;
    coarse.estimates = true;
    struct scene *scene = load(&coarse, &frame);
    bool good = scene != NULL;
    for (int i = 0; i < 3; i++) {
        mean[i] = frame.estimate.mean[WAY_ANY][i] / 65536.0;
    }
    free(scene);
    return good;
}

static bool render_converged(const struct frame_settings *settings, struct frame *frame) {
    double mean[3];
    if (!learn_mean(settings, mean) || !render_scene(settings, DETAIL_CUT, frame)) {
        return false;
    }
    for (int i = 0; i < frame->width * frame->height; i++) {
        struct frame_pixel *pixel = &frame->pixels[i];
        for (int j = 0; j < 3; j++) {
            pixel->level[j] += mean[j] * pixel->cut[j];
            pixel->ended[j] *= mean[j];
        }
    }
    return true;
}

bool frame_converged(const char *folder, const char *scene, int width, int height,
                     struct frame *frame) {
    const struct frame_settings settings = {scene,           "f64", width, height,
                                            1.0 / (1 << 20), 0,     false, false};
    char path[PATH_SIZE];
    size_t pixels = (size_t)width * (size_t)height;
    snprintf(path, sizeof path, "%s/%s_%dx%d.frame", folder, scene, width, height);
    memset(frame, 0, sizeof *frame);
    frame->width = width;
    frame->height = height;
    frame->pixels = calloc(pixels, sizeof *frame->pixels);
    FILE *file = fopen(path, "rb");
    bool good = file && frame->pixels &&
                fread(frame->pixels, sizeof *frame->pixels, pixels, file) == pixels;
    if (file) {
        fclose(file);
    }
    if (good) {
        return true;
    }
    free(frame->pixels);
    good = render_converged(&settings, frame);
    file = good ? fopen(path, "wb") : NULL;
    if (file) {
        bool written = fwrite(frame->pixels, sizeof *frame->pixels, pixels, file) == pixels;
        if (fclose(file) != 0 || !written) {
            remove(path); /* a picture that could not be kept is rendered again */
        }
    }
    return good;
}

static double clamped(double level) {
    return fmin(fmax(level, 0), 255);
}

/* The largest difference of a channel; `open` counts the mean beyond the depth level. */
static double distance(const struct frame_pixel *pixel, const struct frame_pixel *exact,
                       bool open) {
    double most = 0;
    for (int i = 0; i < 3; i++) {
        double right = exact->level[i] + (open ? exact->ended[i] : 0);
        most = fmax(most, fabs(clamped(pixel->level[i]) - clamped(right)));
    }
    return most;
}

void frame_compare(const struct frame *frame, const struct frame *converged, double most,
                   struct frame_errors *errors) {
    int pixels = frame->width * frame->height, within = 0, within_open = 0, doubted = 0;
    memset(errors, 0, sizeof *errors);
    for (int i = 0; i < pixels; i++) {
        double black = distance(&frame->pixels[i], &converged->pixels[i], false);
        within += black <= most;
        within_open += distance(&frame->pixels[i], &converged->pixels[i], true) <= most;
        doubted += black <= frame->pixels[i].uncertainty + 0.01;
        errors->square += black * black / pixels;
        if (black > errors->worst) {
            errors->worst = black;
            errors->worst_x = i % frame->width;
            errors->worst_y = i / frame->width;
        }
    }
    errors->square = sqrt(errors->square);
    errors->share = 100.0 * within / pixels;
    errors->open = 100.0 * within_open / pixels;
    errors->doubted = 100.0 * doubted / pixels;
}

double frame_share_of_levels(const struct frame *frame, const struct frame *converged) {
    int pixels = frame->width * frame->height, within[2] = {0, 0};
    for (int i = 0; i < pixels; i++) {
        for (int open = 0; open < 2; open++) {
            bool near = true;
            for (int j = 0; j < 3; j++) {
                const struct frame_pixel *exact = &converged->pixels[i];
                double right = exact->level[j] + (open ? exact->ended[j] : 0);
                near = near && fabs(floor(clamped(frame->pixels[i].level[j]) + 0.5) -
                                    floor(clamped(right) + 0.5)) <= 1;
            }
            within[open] += near;
        }
    }
    return 100.0 * (within[0] > within[1] ? within[0] : within[1]) / pixels;
}
