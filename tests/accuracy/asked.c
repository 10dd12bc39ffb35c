/* SPDX-License-Identifier: MIT */
/* What --error reaches, and what it takes, as a table: asked FOLDER WIDTHxHEIGHT [SCENE...]
 *
 * FOLDER holds the converged pictures of earlier runs; the caller empties it when the renderer has
 * changed. Exit status: 0 every picture is as accurate as was asked for, for its rays; 1 one is
 * not; 2 bad usage. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "frame.h"

static const char *const scenes[] = {"fig3",  "fig4a",         "fig4b",        "fig5", "fig6a",
                                     "fig6b", "fig7-isolated", "fig7-frustum", "figA"};

/* In levels, the coarsest first: the next one is to take more rays. */
static const double asked[] = {2, 1, 0.5};

/* Within so many times the error that was asked for are to be so many per cent of the pixels, for
 * so many times the rays of the best threshold that does as well. */
static const double error_most = 1.5, share_least = 99.9, rays_most = 1.3;

/* Thresholds that are tried: 2^-(4 + i/4). */
enum { THRESHOLDS = 60 };

/* One scene, and the frames that were rendered with one threshold for all pixels. */
struct subject {
    const char *scene;
    int width, height;
    struct frame converged, uniform[THRESHOLDS];
};

static const struct frame *uniform(struct subject *subject, int number) {
    struct frame *frame = &subject->uniform[number];
    if (!frame->pixels) {
        const struct frame_settings settings = {
            subject->scene,          "fx", subject->width, subject->height,
            exp2(-4 - number / 4.0), 0,    true,           false};
        if (!frame_render(&settings, frame)) {
            exit(2);
        }
    }
    return frame;
}

static bool is_enough(struct subject *subject, int number, double most, double share) {
    struct frame_errors errors;
    frame_compare(uniform(subject, number), &subject->converged, most, &errors);
    return fmax(errors.share, errors.open) >= share;
}

/* A search for a threshold ends where that takes so many times the rays. */
static const double search_most = 2;

/* The largest threshold with which that share is within that error, whichever way the light beyond
 * the depth level is counted; if none does, one that takes too many rays. By octaves from the
 * largest one on, for small ones take long. */
static int best_uniform(struct subject *subject, double most, double share, double rays) {
    int low = -1, high = 0;
    while (high < THRESHOLDS - 1 && uniform(subject, high)->rays < search_most * rays &&
           !is_enough(subject, high, most, share)) {
        low = high;
        high = high + 4 < THRESHOLDS ? high + 4 : THRESHOLDS - 1;
    }
    while (high - low > 1) {
        int middle = (low + high) / 2;
        if (is_enough(subject, middle, most, share)) {
            high = middle;
        } else {
            low = middle;
        }
    }
    return high;
}

static bool judge(struct subject *subject, double error, double *rays) {
    const struct frame_settings settings = {
        subject->scene, "fx", subject->width, subject->height, 0, error, true, false};
    struct frame frame;
    struct frame_errors errors;
    if (!frame_render(&settings, &frame)) {
        exit(2);
    }
    frame_compare(&frame, &subject->converged, error_most * error, &errors);
    int same = best_uniform(subject, error_most * error, errors.share, frame.rays);
    int enough = best_uniform(subject, error_most * error, share_least, frame.rays);
    double same_rays = uniform(subject, same)->rays, enough_rays = uniform(subject, enough)->rays;
    bool good =
        errors.share >= share_least && frame.rays <= rays_most * same_rays && frame.rays > *rays;
    printf("| %s | %g | %.3f | %.3f | %.2f | %.1f at %d, %d | %.1f | %lu | %.1f (%.1f) | %.1f, "
           "%.2f | %.1f, %.2f |%s\n",
           subject->scene, error, errors.share, errors.open, errors.square, errors.worst,
           errors.worst_x, errors.worst_y, errors.doubted, frame.exhausted_pixels, frame.rays,
           frame.learning_rays, same_rays, frame.rays / same_rays, enough_rays,
           frame.rays / enough_rays, good ? "" : " **not reached**");
    fflush(stdout);
    *rays = frame.rays;
    free(frame.pixels);
    return good;
}

static bool measure(const char *folder, const char *scene, int width, int height) {
    static struct subject subject;
    double rays = 0;
    bool good = true;
    memset(&subject, 0, sizeof subject);
    subject.scene = scene;
    subject.width = width;
    subject.height = height;
    if (!frame_converged(folder, scene, width, height, &subject.converged)) {
        exit(2);
    }
    for (size_t i = 0; i < sizeof asked / sizeof asked[0]; i++) {
        good &= judge(&subject, asked[i], &rays);
    }
    free(subject.converged.pixels);
    for (int i = 0; i < THRESHOLDS; i++) {
        free(subject.uniform[i].pixels);
    }
    return good;
}

static bool is_named(const char *scene, char **names, int count) {
    bool named = count == 0;
    for (int i = 0; i < count; i++) {
        named = named || strcmp(scene, names[i]) == 0;
    }
    return named;
}

int main(int argc, char **argv) {
    int width, height;
    bool good = true;
    if (argc < 3 || sscanf(argv[2], "%dx%d", &width, &height) != 2 || width < 1 || width > 640 ||
        height < 1 || height > 400) {
        fprintf(stderr, "usage: asked FOLDER WIDTHxHEIGHT [SCENE...]\n");
        return 2;
    }
    printf(
        "| scene, %d × %d | error asked for | %% within 1.5 of it | the light beyond N counted | "
        "RMSE | worst pixel | %% within their estimate | out of rays | rays a pixel (pre-pass) | "
        "uniform, as accurate: rays, ratio | uniform, 99.9 %%: rays, ratio |\n"
        "|---|---|---|---|---|---|---|---|---|---|---|\n",
        width, height);
    for (size_t i = 0; i < sizeof scenes / sizeof scenes[0]; i++) {
        if (is_named(scenes[i], argv + 3, argc - 3)) {
            good &= measure(argv[1], scenes[i], width, height);
        }
    }
    return good ? 0 : 1;
}
