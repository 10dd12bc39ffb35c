/* SPDX-License-Identifier: MIT */
/* The estimated radiance of pruned branches, learned from a few hundred pixels. */
#include "learn.h"

#include "camera.h"
#include "growth.h"

/* The pixels looked at: a grid over the whole picture. */
enum { COLUMNS = 32, ROWS = 20 };

/* Without an accuracy asked for, pruned branches are followed down to this part of the threshold.
 */
enum { LESS_WEIGHT_BITS = 5 };

/* With an accuracy asked for: the levels of the first look, and those that each next look adds. A
 * level is known when LEVELS_BELOW levels below it have been seen. */
enum { FIRST_LEVELS = 7, MORE_LEVELS = 3, LEVELS_BELOW = 4 };

/* A spread is so many standard deviations. The deviation of a branch is taken to be at least 255 /
 * 12^(1/2), because few pixels tell little. The deviation is that large if all levels from black to
 * white are equally likely. */
enum { SPREAD_DEVIATIONS = 3, DEVIATION_LEAST = 74 };

/* A pixel that is looked at has 1 / BUDGET_PART of the budget of rays. Light is trapped where more
 * than 1 / EXHAUSTED_PART of the pixels in which something is pruned use that budget up. Then more
 * levels would teach nothing. */
enum { BUDGET_PART = 8, EXHAUSTED_PART = 8 };

/* A way's mean is learned as if this part of all that was pruned had gone that way, too. So a way
 * that few branches went has nearly the mean of all. */
enum { SHARED_PART = 64 };

/* Pixels begin so many levels above the typical one: few branches are pruned there, and kept. */
enum { LEVELS_ABOVE = 8 };

/* Sums over pixels, of one level and one primary. */
struct level_sum {
    int64_t radiance[WAYS]; /* in steps of 2^-16 level */
    int64_t weight[WAYS];   /* whose radiance that is, in steps of 2^-30 */

    /* These products are summed over the pixels. A pixel has its radiance a, in steps of 2^-8
     * level. Its weights are b, down, and c, up, in steps of 2^-18. */
    int64_t aa, ab, ac, bb, bc, cc;
};

struct level_sums {
    struct level_sum of[3]; /* red, green, blue */
    int64_t squares;        /* in steps of 2^-52 */
    uint16_t pixels;        /* where something is pruned */
};

struct sums {
    uint8_t levels;
    uint16_t exhausted; /* pixels */
    const int32_t
        *rest_mean; /* what ends unseen is worth, in steps of 2^-16 level; NULL: unknown */
    struct level_sums level[TRAINING_LEVELS];
};

/* Returns a / b for a, b >= 0, bit by bit, so that no library's 64-bit division is called. b = 0
 * gives 0. */
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

/* Returns a 2^bits / b. Doublings that a has no room for become halvings of b. */
static int64_t scaled_quotient(int64_t a, int64_t b, uint8_t bits) {
    for (; bits > 0; bits--) {
        if (a < (int64_t)1 << 61) {
            a <<= 1;
        } else {
            b >>= 1;
        }
    }
    return quotient(a, b);
}

/* Returns radiance (steps of 2^-16 level) over weight (steps of 2^-30) in steps of 2^-16 level, up
 * to INT32_MAX. */
static int32_t per_weight(int64_t radiance, int64_t weight) {
    int64_t mean = scaled_quotient(radiance, weight, 30);
    return mean > INT32_MAX ? INT32_MAX : (int32_t)mean;
}

uint32_t learn_root(int64_t square) {
    uint32_t root = 0;
    for (int8_t i = 30; i >= 0; i--) {
        uint32_t larger = root | (uint32_t)1 << i;
        if ((int64_t)larger * larger <= square) {
            root = larger;
        }
    }
    return root;
}

/* Looks at the middle pixel of a cell of the grid; false where the budget ended the pixel. */
static bool look_at(const struct scene *scene, struct training *training, uint16_t cell,
                    struct render_counts *counts) {
    /* The middle of the cell; a 16-bit int holds 2 * 31 + 1 times 640. */
    uint16_t column = (uint16_t)(cell % COLUMNS), row = (uint16_t)(cell / COLUMNS);
    uint16_t x = (uint16_t)((uint32_t)(2u * column + 1) * scene->width / (2u * COLUMNS));
    uint16_t y = (uint16_t)((uint32_t)(2u * row + 1) * scene->height / (2u * ROWS));
    const struct ray ray = camera_ray(scene, x, y);
    struct tree tree;
    growth_start(&tree, scene, &ray, counts);
    tree.training = training;
    tree.ray_budget = scene->ray_budget / BUDGET_PART;
    growth_finish(&tree);
    return !tree.exhausted;
}

static void clear_training(struct training *training) {
    for (uint8_t i = 0; i < training->levels; i++) {
        struct training_level *level = &training->level[i];
        for (uint8_t j = 0; j < 3; j++) {
            for (uint8_t way = 0; way < WAYS; way++) {
                level->radiance[way][j] = level->weight[way][j] = level->rest[way][j] = 0;
            }
        }
        level->squares = 0;
    }
}

static void clear_sums(struct sums *sums) {
    const struct level_sum nothing = {{0, 0}, {0, 0}, 0, 0, 0, 0, 0, 0};
    for (uint8_t i = 0; i < sums->levels; i++) {
        struct level_sums *level = &sums->level[i];
        level->of[0] = level->of[1] = level->of[2] = nothing;
        level->squares = 0;
        level->pixels = 0;
    }
}

/* Adds one primary of a pixel. In the products a radiance above white counts as white: the screen
 * does not show more, so more is no error. */
static void add_primary(struct level_sum *to, const int64_t radiance[WAYS],
                        const int64_t weight[WAYS]) {
    const int64_t white = (int64_t)255 << 8;
    for (uint8_t way = 0; way < WAYS; way++) {
        to->radiance[way] += radiance[way];
        to->weight[way] += weight[way];
    }
    int64_t a = (radiance[WAY_DOWN] + radiance[WAY_UP]) >> 8;
    int64_t b = weight[WAY_DOWN] >> 12, c = weight[WAY_UP] >> 12;
    a = a < white ? a : white;
    to->aa += a * a;
    to->ab += a * b;
    to->ac += a * c;
    to->bb += b * b;
    to->bc += b * c;
    to->cc += c * c;
}

static void add_pixel(struct sums *sums, const struct training *training) {
    for (uint8_t i = 0; i < training->levels; i++) {
        const struct training_level *from = &training->level[i];
        struct level_sums *to = &sums->level[i];
        for (uint8_t j = 0; j < 3; j++) {
            int64_t radiance[WAYS], weight[WAYS];
            for (uint8_t way = 0; way < WAYS; way++) {
                int64_t rest = from->rest[way][j];
                bool is_known = sums->rest_mean != 0;
                radiance[way] = from->radiance[way][j];
                radiance[way] += is_known ? (rest * sums->rest_mean[j]) >> 30 : 0;
                weight[way] = from->weight[way][j] - (is_known ? 0 : rest);
            }
            add_primary(&to->of[j], radiance, weight);
        }
        to->squares += from->squares;
        to->pixels = (uint16_t)(to->pixels + (from->squares > 0));
    }
}

static void look(const struct scene *scene, struct training *training, struct sums *sums,
                 const int32_t *rest_mean, struct render_counts *counts) {
    sums->rest_mean = rest_mean;
    sums->levels = training->levels;
    sums->exhausted = 0;
    clear_sums(sums);
    for (uint16_t i = 0; i < COLUMNS * ROWS; i++) {
        clear_training(training);
        sums->exhausted = (uint16_t)(sums->exhausted + !look_at(scene, training, i, counts));
        add_pixel(sums, training);
    }
}

static void conclude_mean(const struct level_sums *sums, struct estimate_level *level) {
    for (uint8_t i = 0; i < 3; i++) {
        const struct level_sum *of = &sums->of[i];
        int64_t radiance = of->radiance[WAY_DOWN] + of->radiance[WAY_UP];
        int64_t weight = of->weight[WAY_DOWN] + of->weight[WAY_UP];
        level->mean[WAY_ANY][i] = per_weight(radiance, weight);
        for (uint8_t way = 0; way < WAYS; way++) {
            level->mean[way][i] = per_weight(of->radiance[way] + radiance / SHARED_PART,
                                             of->weight[way] + weight / SHARED_PART);
        }
    }
}

/* Multiplies a sum that holds one weight, in steps of 2^-18, by a mean, 0..2^23. The result is
 * without that weight's steps. The sum is taken in two parts, for bright scenes have sums times
 * means beyond 64 bits. */
static int64_t times_mean(int64_t sum, int64_t mean) {
    const int64_t below = ((int64_t)1 << 18) - 1;
    return (sum >> 18) * mean + (((sum & below) * mean) >> 18);
}

/* Returns the sum of the squares of how far pixels stray from the means, (a - down b - up c)^2. The
 * sum is that of the primary where it is largest, in steps of 2^-16 level^2. */
static int64_t squared_strays(const struct level_sums *sums, const struct estimate_level *level) {
    int64_t most = 0;
    for (uint8_t i = 0; i < 3; i++) {
        const struct level_sum *of = &sums->of[i];
        int64_t down = level->mean[WAY_DOWN][i] >> 8, up = level->mean[WAY_UP][i] >> 8;
        int64_t strays = of->aa - 2 * (times_mean(of->ab, down) + times_mean(of->ac, up)) +
                         times_mean(times_mean(of->bb, down) + 2 * times_mean(of->bc, up), down) +
                         times_mean(times_mean(of->cc, up), up);
        most = strays > most ? strays : most;
    }
    return most;
}

/* Sets a level's spread and squares_most. The spread, times the root of the squares, is to be no
 * more than the error that is asked for. */
static void conclude_spread(int64_t deviation, uint32_t error, struct estimate_level *level) {
    const int64_t all = (int64_t)1 << 26;
    int64_t spread = deviation * SPREAD_DEVIATIONS << 8;
    level->spread = spread > INT32_MAX ? INT32_MAX : (int32_t)spread;
    int64_t most = quotient((int64_t)error << 26, level->spread);
    most = most < all ? most : all;
    level->squares_most = most * most;
}

/* Tells whether the pixels' mean sum of squares is no more than what is asked for. */
static bool is_enough(const struct level_sums *sums, const struct estimate_level *level) {
    return quotient(sums->squares, sums->pixels) <= level->squares_most;
}

/* Returns one standard deviation, in steps of 2^-8 level, at least DEVIATION_LEAST levels. */
static int64_t deviation_of(const struct level_sums *sums, const struct estimate_level *level) {
    const int64_t least = (int64_t)DEVIATION_LEAST << 8;
    int64_t deviation = learn_root(scaled_quotient(squared_strays(sums, level), sums->squares, 52));
    return deviation > least ? deviation : least;
}

static bool is_trapped(const struct sums *sums) {
    return sums->exhausted > sums->level[0].pixels / EXHAUSTED_PART;
}

/* Concludes all levels from the sums of those that are known. For a level below these, the mean is
 * taken to be the same. The deviation grows by an eighth from each such level to the next, for what
 * is cut is more and more alike. Where light is trapped, the last MORE_LEVELS known levels count as
 * unknown. Their deviation would be that of the easier pixels. */
static void conclude(const struct sums *sums, uint32_t error, struct estimate *estimate) {
    uint8_t known = (uint8_t)(sums->levels - LEVELS_BELOW);
    if (is_trapped(sums) && known > MORE_LEVELS) {
        known = (uint8_t)(known - MORE_LEVELS);
    }
    int64_t deviation = 0;
    for (uint8_t i = 0; i < ESTIMATE_LEVELS; i++) {
        struct estimate_level *level = &estimate->level[i];
        if (i < known) {
            conclude_mean(&sums->level[i], level);
            deviation = deviation_of(&sums->level[i], level);
        } else {
            *level = estimate->level[known - 1];
            deviation += deviation >> 3;
        }
        conclude_spread(deviation, error, level);
    }
    estimate->typical = 0;
    while (estimate->typical + 1 < known &&
           !is_enough(&sums->level[estimate->typical], &estimate->level[estimate->typical])) {
        estimate->typical++;
    }
    estimate->first =
        (uint8_t)(estimate->typical > LEVELS_ABOVE ? estimate->typical - LEVELS_ABOVE : 0);
}

/* Looks deeper until the harder pixels' level is known, with enough levels below it. */
static void learn_levels(const struct scene *scene, struct training *training,
                         struct estimate *estimate, struct render_counts *counts) {
    struct sums sums;
    int32_t rest_mean[3];
    training->last_depth = scene->depth;
    training->of_depth = false;
    training->levels = FIRST_LEVELS;
    training->last = training->first >> (training->levels - 1);
    look(scene, training, &sums, 0, counts);
    for (;;) {
        conclude(&sums, scene->error, estimate);
        if (estimate->typical + LEVELS_BELOW < training->levels - 1 || is_trapped(&sums) ||
            training->levels + MORE_LEVELS > TRAINING_LEVELS) {
            return;
        }
        for (uint8_t i = 0; i < 3; i++) {
            rest_mean[i] = estimate->level[training->levels - FIRST_LEVELS].mean[WAY_ANY][i];
        }
        training->levels = (uint8_t)(training->levels + MORE_LEVELS);
        training->last = training->first >> (training->levels - 1);
        look(scene, training, &sums, rest_mean, counts);
    }
}

static void learn_level(const struct scene *scene, struct training *training,
                        struct estimate *estimate, struct render_counts *counts) {
    struct sums sums;
    uint16_t depth = (uint16_t)(scene->depth + ESTIMATE_EVENTS);
    training->last_depth = (uint8_t)(depth < UINT8_MAX ? depth : UINT8_MAX);
    training->of_depth = true;
    training->levels = 1;
    training->last = training->first >> LESS_WEIGHT_BITS;
    look(scene, training, &sums, 0, counts);
    conclude_mean(&sums.level[0], &estimate->level[0]);
    estimate->level[0].spread = 0;
    estimate->level[0].squares_most = 0;
    estimate->first = estimate->typical = 0;
}

void learn_estimate(const struct scene *scene, struct estimate *estimate,
                    struct render_counts *counts) {
    struct training training;
    if (!FEATURE_ESTIMATE) {
        return;
    }
    training.first = energy_steps(scene->threshold);
    if (FEATURE_KEPT > 0 && scene->error > 0) {
        learn_levels(scene, &training, estimate, counts);
    } else {
        learn_level(scene, &training, estimate, counts);
    }
}
