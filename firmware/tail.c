/* SPDX-License-Identifier: MIT */
/* What is left out of a pixel: what it is worth, how sure that is, and what bounds it. */
#include "tail.h"

/* The uncertainty is so many standard deviations: 121/16 is the square of 2.75. */
enum { SURENESS_TIMES = 121, SURENESS_PARTS = 16 };

/* In levels^2: what is deeper strays so much more from what was seen of the pixel. */
enum { DRIFT_VARIANCE = 100 };

/* A next look goes at most so many half octaves farther. */
enum { FARTHER_MOST = 16 };

/* A mean is at most so many levels, in steps of 2^-8. */
static const int32_t mean_most = INT32_C(1023) << 8;

void tail_clear(struct tail *tail) {
    for (uint8_t i = 0; i < 3; i++) {
        for (uint8_t place = 0; place < TAIL_PLACES; place++) {
            tail->gathered[place][i] = 0;
        }
        for (uint8_t way = 0; way < WAYS; way++) {
            tail->watched[way][i] = tail->rest[way][i] = tail->cut[way][i] = 0;
        }
        tail->reach[i] = 0;
    }
    tail->watched_squares[WAY_DOWN] = tail->watched_squares[WAY_UP] = tail->cut_squares = 0;
    tail->above_white = 0;
}

struct tail_thresholds tail_thresholds_at(const struct scene *scene, uint8_t steps) {
    struct tail_thresholds at = {REAL_ENERGY(1.0), scene->threshold};
    for (uint8_t i = 0; i < steps / 2; i++) {
        at.fine = energy_product(at.fine, REAL_ENERGY(0.5));
    }
    if (steps % 2 != 0) {
        at.fine = energy_product(at.fine, REAL_ENERGY(0.75));
    }
    /* The coarse threshold is 16 times that. */
    if (energy_less(at.fine, REAL_ENERGY(0.0625))) {
        at.coarse = at.fine;
        for (uint8_t i = 0; i < 4; i++) {
            at.coarse = energy_add(at.coarse, at.coarse);
        }
    }
    return at;
}

/* 1 / d for d > 0, as factor 2^-(46 + shift), with 16 bits. */
struct inverse {
    int8_t shift;
    int64_t factor;
};

/* Returns a >> bits, or a << -bits. */
static int64_t shifted(int64_t a, int8_t bits) {
    return bits >= 0 ? a >> bits : a << -bits;
}

static struct inverse inverse_of(int64_t d) {
    struct inverse inverse = {0, 0};
    while (d >> inverse.shift >= (int64_t)1 << 31) {
        inverse.shift++;
    }
    while (shifted(d, inverse.shift) < (int64_t)1 << 30) {
        inverse.shift--;
    }
    /* 2^46 by a number of 31 bits, bit by bit: no library's division is called. */
    const uint32_t by = (uint32_t)shifted(d, inverse.shift);
    uint32_t rest = (uint32_t)1 << 30, factor = 0;
    for (uint8_t i = 0; i <= 16; i++) {
        factor <<= 1;
        if (rest >= by) {
            rest -= by;
            factor |= 1;
        }
        rest <<= 1;
    }
    inverse.factor = factor;
    return inverse;
}

/* The estimated radiance of one way and channel in a pixel, in steps of 2^-8 level, and its
 * variance in levels^2. */
struct pixel_mean {
    int64_t mean, variance;
};

/* Weighs what the pixel itself has seen of that way against what the training pass says. `seen` is
 * the weight that was followed to its end, in steps of 2^-18. `noise` is the square of the weight
 * of which the training pass is worth as much, in steps of 2^-36. */
static struct pixel_mean mean_of(int64_t gathered, int64_t seen, int64_t noise, int32_t learned,
                                 int32_t variance) {
    int64_t before = learned >> 8 < mean_most ? learned >> 8 : mean_most;
    struct pixel_mean result = {before, variance};
    if (seen > 0) {
        int64_t together = seen * seen + noise;
        const struct inverse inverse = inverse_of(together);
        /* Of 1024 levels and more, 1024 count: then neither product leaves 64 bits. */
        int64_t part = gathered < seen ? (gathered < 0 ? 0 : gathered) * seen : seen * seen;
        int64_t share = (shifted(noise, inverse.shift) * inverse.factor) >> 30;
        result.mean = (shifted(part, inverse.shift) * inverse.factor) >> 28;
        result.mean += (before * share) >> 16;
        result.variance = ((variance * share) >> 16) + DRIFT_VARIANCE;
    }
    return result;
}

/* Adds what is cut in one channel at its estimated radiance, in steps of 2^-16 level. Returns the
 * variance of that, in steps of 2^-36 level^2. */
static int64_t add_worth(const struct scene *scene, const struct tail *tail, uint8_t channel,
                         int64_t *sum) {
    const struct estimate *estimate = scene->estimate;
    int64_t variance = 0;
    for (uint8_t way = 0; way < WAYS; way++) {
        int64_t weight = tail->cut[way][channel] >> 12;
        if (weight > 0) {
            int64_t noise = ((tail->watched_squares[way] >> 16) * estimate->noise) >> 8;
            const struct pixel_mean mean =
                mean_of(tail->gathered[tail_place_of((enum estimate_way)way)][channel] >> 8,
                        (tail->watched[way][channel] - tail->rest[way][channel]) >> 12, noise,
                        estimate->mean[way][channel], estimate->mean_variance);
            *sum += (mean.mean * weight) >> 10;
            variance += mean.variance * weight * weight;
        }
    }
    return variance;
}

/* Returns a sum in steps of 2^-16 level as a screen shows it: neither below black nor above
 * white. */
static int64_t shown(int64_t sum) {
    const int64_t white = (int64_t)255 << 16;
    return sum < 0 ? 0 : sum < white ? sum : white;
}

static int64_t larger(int64_t a, int64_t b) {
    return a > b ? a : b;
}

/* Keeps an estimate within what the channel can be, and returns how far off it is at most. What is
 * known was rounded once a ray, by at most half a step. */
static int64_t bound(const struct scene *scene, const struct tail *tail, uint8_t channel,
                     int64_t known, uint64_t rays, int64_t *sum) {
    int64_t weight = tail->cut[WAY_DOWN][channel] + tail->cut[WAY_UP][channel];
    int64_t low = known + ((weight * scene->darkest) >> 14);
    int64_t high = known + ((weight * scene->brightest) >> 14) +
                   ((tail->reach[channel] * scene->brightest_each) >> 14) + 1;
    int64_t rounded = (int64_t)(rays / 2) + 1;
    *sum = *sum < low ? low : *sum > high ? high : *sum;
    return larger(shown(high + rounded) - shown(*sum), shown(*sum) - shown(low - rounded));
}

/* Returns the root of a number that is not negative, rounded down. */
static uint32_t root_of(int64_t square) {
    uint32_t root = 0;
    for (int8_t i = 30; i >= 0; i--) {
        uint32_t larger_root = root | (uint32_t)1 << i;
        if ((int64_t)larger_root * larger_root <= square) {
            root = larger_root;
        }
    }
    return root;
}

/* Returns the square of the uncertainty that two variances make, all in steps of 2^-36 level^2. */
static int64_t square_of(int64_t variance, int64_t deviation) {
    return (variance + deviation) / SURENESS_PARTS * SURENESS_TIMES;
}

/* Returns how many half octaves farther down the uncertainty is expected to be as asked for. Each
 * takes a quarter more rays, for which there has to be room. */
static uint8_t steps_farther(const struct scene *scene, int64_t variance, int64_t deviation,
                             const struct tail_rays *rays) {
    const int64_t asked = ((int64_t)scene->error * scene->error) << 4;
    uint64_t of_look = rays->of_look;
    uint8_t farther = 0;
    while (farther < FARTHER_MOST && square_of(variance, deviation) > asked) {
        variance -= (variance >> 2) + (variance >> 5);
        deviation -= (deviation >> 2) + (deviation >> 3);
        of_look += of_look >> 2;
        if (of_look > rays->budget - rays->in_all) {
            break;
        }
        farther++;
    }
    return farther;
}

void tail_judge(const struct scene *scene, const struct tail *tail, uint8_t steps,
                const struct tail_rays *rays, struct tail_verdict *verdict) {
    /* Of the means, and of the branches about them, in steps of 2^-36 level^2. */
    const int64_t deviation = (tail->cut_squares >> 16) * scene->estimate->branch_variance;
    int64_t variance = 0, proved = 0;
    for (uint8_t i = 0; i < 3; i++) {
        int64_t known = tail->gathered[TAIL_NEAR][i] + tail->gathered[TAIL_DOWN][i] +
                        tail->gathered[TAIL_UP][i];
        int64_t sum = known;
        variance = larger(variance, add_worth(scene, tail, i, &sum));
        proved = larger(proved, bound(scene, tail, i, known, rays->of_look, &sum));
        verdict->colour[i] = sum < INT32_MAX ? (int32_t)sum : INT32_MAX;
    }
    uint32_t uncertainty = root_of(square_of(variance, deviation)) >> 2;
    verdict->proved = (uint32_t)proved;
    verdict->uncertainty = uncertainty < verdict->proved ? uncertainty : verdict->proved;
    verdict->steps = TAIL_STEPS;
    if (verdict->uncertainty > scene->error && rays->in_all < rays->budget) {
        uint8_t next = (uint8_t)(steps + steps_farther(scene, variance, deviation, rays));
        uint8_t last = TAIL_STEPS - 1;
        if (next > steps && steps < last) {
            verdict->steps = next < last ? next : last;
        }
    }
}

bool tail_note(const struct scene *scene, const struct tail_verdict *verdict,
               struct render_counts *counts) {
    const bool is_worst = verdict->uncertainty > counts->estimated_error;
    if (is_worst) {
        counts->estimated_error = verdict->uncertainty;
    }
    if (verdict->proved > counts->proved_error) {
        counts->proved_error = verdict->proved;
    }
    counts->unreached_pixels += verdict->uncertainty > scene->error;
    return is_worst;
}
