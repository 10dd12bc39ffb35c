/* SPDX-License-Identifier: MIT */
/* What a pruned branch counts as, threshold by threshold: tails FOLDER WIDTHxHEIGHT [SCENE...]
 *
 * FOLDER holds the converged pictures of earlier runs; the caller empties it when the renderer has
 * changed. Exit status: 0 the estimate is worth what is asked of it, 1 it is not, 2 bad usage. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "frame.h"

static const char *const scenes[] = {"fig3", "fig4a", "fig5"};
static const char *const arithmetics[] = {"fx", "f32", "f64"};

/* One over the thresholds. */
static const int divisors[] = {256, 512, 1024, 2048, 4096, 8192, 16384};
enum { DIVISORS = sizeof divisors / sizeof divisors[0] };

/* At this one, the estimate is to have so many per cent of the pixels within 1 LSB, for half of the
 * rays with which black has as many; on these scenes. */
enum { JUDGED_DIVISOR = 2048 };
static const double share_least = 99.9;
static const char *const judged[] = {"fig3", "fig5"};

/* Where black is looked for, to be as right: by quarters of an octave, down to 2^-18. */
enum { BLACK_FIRST = 4 * 11, BLACK_LAST = 4 * 18 };

struct point {
    double share, rays, learning;
};

static struct point measure_point(const char *scene, const char *arithmetic, double threshold,
                                  bool estimates, const struct frame *converged) {
    const struct frame_settings settings = {
        scene, arithmetic, converged->width, converged->height, threshold, 0, estimates, true};
    struct frame frame;
    struct point point = {0, 0, 0};
    if (!frame_render(&settings, &frame)) {
        exit(2);
    }
    point.share = frame_share_of_levels(&frame, converged);
    point.rays = frame.rays;
    point.learning = frame.learning_rays;
    free(frame.pixels);
    return point;
}

static void print_arithmetic(const char *scene, const char *arithmetic,
                             const struct frame *converged, struct point *judged_point) {
    for (int i = 0; i < DIVISORS; i++) {
        double threshold = 1.0 / divisors[i];
        struct point black = measure_point(scene, arithmetic, threshold, false, converged);
        struct point mean = measure_point(scene, arithmetic, threshold, true, converged);
        printf("| %s | %s | 1/%d | %.3f | %.1f | %.3f | %.1f (%.1f) |\n", scene, arithmetic,
               divisors[i], black.share, black.rays, mean.share, mean.rays, mean.learning);
        fflush(stdout);
        if (divisors[i] == JUDGED_DIVISOR) {
            *judged_point = mean;
        }
    }
}

/* What black takes to be as right as the estimate, in the firmware's own arithmetic. */
static bool judge(const char *scene, const struct point *mean, const struct frame *converged) {
    struct point black = {0, 0, 0};
    for (int i = BLACK_FIRST; i <= BLACK_LAST && black.share < mean->share; i++) {
        black = measure_point(scene, "fx", exp2(-i / 4.0), false, converged);
    }
    bool good = mean->share >= share_least && 2 * mean->rays <= black.rays;
    fprintf(stderr, "%s: %.3f %% for %.1f rays with the estimate, %.3f %% for %.1f with black%s\n",
            scene, mean->share, mean->rays, black.share, black.rays, good ? "" : ": too little");
    return good;
}

static bool is_in(const char *scene, const char *const *names, int count) {
    bool found = false;
    for (int i = 0; i < count; i++) {
        found = found || strcmp(scene, names[i]) == 0;
    }
    return found;
}

static bool measure(const char *folder, const char *scene, int width, int height) {
    struct frame converged;
    struct point found = {0, 0, 0}, other;
    if (!frame_converged(folder, scene, width, height, &converged)) {
        exit(2);
    }
    for (size_t i = 0; i < sizeof arithmetics / sizeof arithmetics[0]; i++) {
        print_arithmetic(scene, arithmetics[i], &converged, i == 0 ? &found : &other);
    }
    bool good = !is_in(scene, judged, 2) || judge(scene, &found, &converged);
    free(converged.pixels);
    return good;
}

int main(int argc, char **argv) {
    int width, height;
    bool good = true;
    if (argc < 3 || sscanf(argv[2], "%dx%d", &width, &height) != 2 || width < 1 || width > 640 ||
        height < 1 || height > 400) {
        fprintf(stderr, "usage: tails FOLDER WIDTHxHEIGHT [SCENE...]\n");
        return 2;
    }
    printf("| scene, %d × %d | arithmetic | threshold | black: %% within 1 LSB | rays a pixel | "
           "estimate: %% within 1 LSB | rays a pixel (pre-pass) |\n|---|---|---|---|---|---|---|\n",
           width, height);
    for (size_t i = 0; i < sizeof scenes / sizeof scenes[0]; i++) {
        if (argc == 3 || is_in(scenes[i], (const char *const *)argv + 3, argc - 3)) {
            good &= measure(argv[1], scenes[i], width, height);
        }
    }
    return good ? 0 : 1;
}
