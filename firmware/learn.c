/* SPDX-License-Identifier: MIT */
/* What a branch that is cut is worth: learned from a few hundred pixels. */
#include "learn.h"

#include "camera.h"
#include "growth.h"

/* The pixels looked at: a grid over the whole picture. */
enum { COLUMNS = 32, ROWS = 20 };

/* How much deeper than the picture they are followed. */
enum { MORE_EVENTS = 16 };

/* a / b for a, b >= 0, bit by bit: no library's 64-bit division is called. b = 0 gives 0. */
static int64_t quotient(int64_t a, int64_t b) {
    int64_t result = 0, rest = 0;
    if (b <= 0) {
        return 0;
    }
    for (int8_t i = 62; i >= 0; i--) {
        rest = rest << 1 | ((a >> i) & 1);
        if (rest >= b) {
            rest -= b;
            result |= (int64_t)1 << i;
        }
    }
    return result;
}

/* worth (steps of 2^-16 level) over weight (steps of 2^-30) as steps of 2^-16 level: 2^20 of the
 * weight's 2^30 are brought over to the worth, which trapped light can make too large for that. */
static int32_t per_weight(int64_t worth, int64_t weight) {
    while (worth >= (int64_t)1 << 42) {
        worth >>= 1;
        weight >>= 1;
    }
    int64_t mean = quotient(worth << 20, weight >> 10);
    return mean > INT32_MAX ? INT32_MAX : (int32_t)mean;
}

static void look_at(const struct scene *scene, struct lesson *lesson, uint16_t cell,
                    struct render_counts *counts) {
    /* The middle of the cell; a 16-bit int holds 2 * 31 + 1 times 640. */
    uint16_t column = (uint16_t)(cell % COLUMNS), row = (uint16_t)(cell / COLUMNS);
    uint16_t x = (uint16_t)((uint32_t)(2u * column + 1) * scene->width / (2u * COLUMNS));
    uint16_t y = (uint16_t)((uint32_t)(2u * row + 1) * scene->height / (2u * ROWS));
    const struct ray ray = camera_ray(scene, x, y);
    struct tree tree;
    growth_start(&tree, scene, &ray, counts);
    tree.lesson = lesson;
    growth_finish(&tree);
}

static void clear(struct lesson *lesson, const struct scene *scene) {
    for (uint8_t i = 0; i < 3; i++) {
        lesson->worth[i] = lesson->weight[i] = lesson->rest[i] = 0;
    }
    uint16_t depth = (uint16_t)(scene->depth + MORE_EVENTS);
    lesson->last_depth = (uint8_t)(depth < FEATURE_DEPTH ? depth : FEATURE_DEPTH);
    lesson->last_threshold = energy_product(scene->threshold, REAL_ENERGY(0.125));
}

/* What ended unseen beyond the cut is worth the mean too: worth + rest * mean = weight * mean. */
static void conclude(const struct lesson *lesson, struct estimate *estimate) {
    for (uint8_t i = 0; i < 3; i++) {
        estimate->mean[i] = per_weight(lesson->worth[i], lesson->weight[i] - lesson->rest[i]);
    }
}

static int64_t magnitude(int64_t a) {
    return a < 0 ? -a : a;
}

/* How far one pixel's cut branches stray from the mean, the largest of the channels. */
static int64_t strayed(const struct lesson *lesson, const struct estimate *estimate) {
    int64_t most = 0;
    for (uint8_t i = 0; i < 3; i++) {
        /* At most 2^16 steps of 2^-15: the weights of a pixel sum to no more than 1. */
        int64_t seen = (lesson->weight[i] - lesson->rest[i]) >> 15;
        int64_t away = magnitude(lesson->worth[i] - ((seen * estimate->mean[i]) >> 15));
        most = away > most ? away : most;
    }
    return most;
}

void learn_estimate(const struct scene *scene, struct estimate *estimate,
                    struct render_counts *counts) {
    struct lesson lesson;
    int64_t strays = 0, weight = 0;
    clear(&lesson, scene);
    for (uint16_t i = 0; i < COLUMNS * ROWS; i++) {
        look_at(scene, &lesson, i, counts);
    }
    conclude(&lesson, estimate);
    estimate->spread = 0;
    if (FEATURE_KEPT == 0 || scene->error == 0) {
        return;
    }
    for (uint16_t i = 0; i < COLUMNS * ROWS; i++) {
        clear(&lesson, scene);
        look_at(scene, &lesson, i, counts);
        strays += strayed(&lesson, estimate);
        weight += lesson.weight[1] - lesson.rest[1];
    }
    estimate->spread = per_weight(strays, weight);
}
