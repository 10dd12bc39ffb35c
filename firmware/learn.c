/* SPDX-License-Identifier: MIT */
/* The estimated radiance of pruned branches, learned from a few hundred pixels. */
#include "learn.h"

#include "camera.h"
#include "refine.h"

/* The pixels looked at: a grid over the whole picture, of at most every second pixel either way. */
enum { COLUMNS = 32, ROWS = 20 };

/* Without an accuracy asked for, pruned branches are followed down to this part of the threshold. A
 * pixel that is looked at has 1 / BUDGET_PART of the budget of rays. */
enum { LESS_WEIGHT_BITS = 5, BUDGET_PART = 8 };

/* A way's mean is learned as if this part of all that was pruned had gone that way, too. So a way
 * that few branches went has nearly the mean of all. */
enum { SHARED_PART = 64 };

/* With an accuracy asked for, in levels and levels^2: what is believed before anything is learned.
 * A pixel's mean varies about the means of all by VARIANCE_LEAST at least. */
enum { MEAN_BEFORE = 100, VARIANCE_BEFORE = 3600, VARIANCE_LEAST = 225 };
static const int32_t variance_most = INT32_C(65025);

/* The variance of a branch about its mean, in levels^2. All levels from black to white are taken to
 * be equally likely. What is brighter than white adds to that. */
enum { BRANCH_VARIANCE = 5476 };
static const int32_t branch_variance_most = INT32_C(1048576);

/* The grid is looked at twice. After the first look pixels begin where so many per cent of them
 * were accurate enough, after the second look as well. */
enum { LOOKS = 2 };
static const uint8_t first_percent[LOOKS] = {30, 85};

/* Sums over pixels, of one way and one channel. A pixel has gathered a, in steps of 2^-8 level, by
 * branches of a weight of b, in steps of 2^-18. */
struct way_sums {
    int64_t radiance; /* in steps of 2^-16 level */
    int64_t weight;   /* whose radiance that is, in steps of 2^-30 */
    int64_t aa, ab, bb;
};

struct sums {
    struct way_sums of[WAYS][3]; /* red, green, blue */
    int64_t squares;             /* of the weights, in steps of 2^-52 */
    int64_t above_white;         /* as in struct tail */
    uint16_t pixels;             /* where something was cut */
    uint16_t ended[TAIL_STEPS];  /* of those, by the steps of their last look */
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

static void clear(struct sums *sums) {
    const struct way_sums nothing = {0, 0, 0, 0, 0};
    for (uint8_t i = 0; i < 3; i++) {
        sums->of[WAY_DOWN][i] = sums->of[WAY_UP][i] = nothing;
    }
    for (uint8_t i = 0; i < TAIL_STEPS; i++) {
        sums->ended[i] = 0;
    }
    sums->squares = sums->above_white = 0;
    sums->pixels = 0;
}

/* Adds what a pixel has seen behind its coarse threshold. In the products a radiance above white
 * counts as white: the screen does not show more, so more is no error. */
static void add_pixel(struct sums *sums, const struct tail *tail) {
    const int64_t white = (int64_t)255 << 8;
    for (uint8_t way = 0; way < WAYS; way++) {
        for (uint8_t i = 0; i < 3; i++) {
            struct way_sums *to = &sums->of[way][i];
            int64_t weight = tail->watched[way][i] - tail->rest[way][i];
            int64_t gathered = tail->gathered[tail_place_of((enum estimate_way)way)][i];
            int64_t a = gathered >> 8, b = weight >> 12;
            a = a < white ? a : white;
            to->radiance += gathered;
            to->weight += weight;
            to->aa += a * a;
            to->ab += a * b;
            to->bb += b * b;
        }
        sums->squares += tail->watched_squares[way];
    }
    sums->above_white += tail->above_white;
}

static void conclude_means(const struct sums *sums, struct estimate *estimate) {
    for (uint8_t i = 0; i < 3; i++) {
        const struct way_sums *down = &sums->of[WAY_DOWN][i], *up = &sums->of[WAY_UP][i];
        int64_t radiance = down->radiance + up->radiance, weight = down->weight + up->weight;
        estimate->mean[WAY_ANY][i] = per_weight(radiance, weight);
        for (uint8_t way = 0; way < WAYS; way++) {
            const struct way_sums *of = &sums->of[way][i];
            estimate->mean[way][i] = per_weight(of->radiance + radiance / SHARED_PART,
                                                of->weight + weight / SHARED_PART);
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

/* Returns the sum of the squares of how far pixels stray from the means, (a - m b)^2, in steps of
 * 2^-16 level^2. */
static int64_t squared_strays(const struct sums *sums, const struct estimate *estimate) {
    int64_t strays = 0;
    for (uint8_t way = 0; way < WAYS; way++) {
        for (uint8_t i = 0; i < 3; i++) {
            const struct way_sums *of = &sums->of[way][i];
            int64_t mean = estimate->mean[way][i] >> 8;
            strays +=
                of->aa - 2 * times_mean(of->ab, mean) + times_mean(times_mean(of->bb, mean), mean);
        }
    }
    return strays;
}

static int64_t squared_weights(const struct sums *sums) {
    int64_t sum = 0;
    for (uint8_t way = 0; way < WAYS; way++) {
        for (uint8_t i = 0; i < 3; i++) {
            sum += sums->of[way][i].bb;
        }
    }
    return sum;
}

/* Sets the variances of a pixel's mean and of a branch. */
static void set_variances(int64_t mean, int64_t branch, struct estimate *estimate) {
    estimate->mean_variance = (int32_t)(mean < VARIANCE_LEAST  ? VARIANCE_LEAST
                                        : mean > variance_most ? variance_most
                                                               : mean);
    estimate->branch_variance =
        (int32_t)(branch < branch_variance_most ? branch : branch_variance_most);
    estimate->noise =
        (int32_t)quotient((int64_t)estimate->branch_variance << 8, estimate->mean_variance);
}

/* Concludes how much pixels' means vary: what strays, less what so many branches of these weights
 * stray by themselves. */
static void conclude_variance(const struct sums *sums, struct estimate *estimate) {
    /* Few pixels see what is above white: it counts twice. */
    int64_t branch = BRANCH_VARIANCE + scaled_quotient(sums->above_white, sums->squares, 37);
    int64_t noise = (sums->squares >> 26) * BRANCH_VARIANCE * 3 >> 10;
    int64_t strays = squared_strays(sums, estimate) - noise;
    set_variances(strays > 0 ? scaled_quotient(strays, squared_weights(sums), 20) : 0, branch,
                  estimate);
}

/* Returns the step with which so many per cent of the pixels were accurate enough. */
static uint8_t step_of_percent(const struct sums *sums, uint8_t percent) {
    const uint32_t wanted = (uint32_t)sums->pixels * percent;
    uint32_t count = 0;
    uint8_t step = 0;
    while (step + 1 < TAIL_STEPS && (count += sums->ended[step], count * 100 < wanted)) {
        step++;
    }
    return step;
}

/* A grid over the whole picture. */
struct grid {
    uint16_t columns, rows;
};

/* Returns the eye's ray through the middle pixel of a cell. */
static struct ray ray_of(const struct scene *scene, const struct grid *grid, uint16_t cell) {
    /* A 16-bit int holds 2 * 31 + 1 times 640. */
    uint16_t column = (uint16_t)(cell % grid->columns), row = (uint16_t)(cell / grid->columns);
    uint16_t x = (uint16_t)((uint32_t)(2u * column + 1) * scene->width / (2u * grid->columns));
    uint16_t y = (uint16_t)((uint32_t)(2u * row + 1) * scene->height / (2u * grid->rows));
    return camera_ray(scene, x, y);
}

static uint16_t cells(uint16_t pixels, uint16_t most) {
    uint16_t half = (uint16_t)((pixels + 1) / 2);
    return half < most ? half : most;
}

/* Looks at all pixels of the grid until each is as accurate as was asked for. */
static void look_at_pixels(const struct scene *scene, struct sums *sums,
                           struct render_counts *counts) {
    const struct grid grid = {cells(scene->width, COLUMNS), cells(scene->height, ROWS)};
    const struct refining refining = {scene, 0, scene->ray_budget / BUDGET_PART};
    struct tail tail;
    struct tail_verdict verdict;
    clear(sums);
    for (uint16_t i = 0; i < grid.columns * grid.rows; i++) {
        const struct ray ray = ray_of(scene, &grid, i);
        uint8_t steps = refine_pixel(&refining, &ray, counts, &tail, &verdict);
        if (tail.cut_squares > 0) {
            sums->pixels++;
            sums->ended[steps]++;
        }
        add_pixel(sums, &tail);
    }
}

/* Learns for an accuracy that is asked for. The second look knows what the first has learned. */
static void learn_for_accuracy(const struct scene *scene, struct estimate *estimate,
                               struct render_counts *counts) {
    struct scene learned = *scene;
    struct sums sums;
    learned.estimate = estimate;
    for (uint8_t i = 0; i < 3; i++) {
        estimate->mean[WAY_DOWN][i] = estimate->mean[WAY_UP][i] = estimate->mean[WAY_ANY][i] =
            (int32_t)MEAN_BEFORE << 16;
    }
    set_variances(VARIANCE_BEFORE, BRANCH_VARIANCE, estimate);
    estimate->first = 0;
    for (uint8_t look = 0; look < LOOKS; look++) {
        look_at_pixels(&learned, &sums, counts);
        conclude_means(&sums, estimate);
        conclude_variance(&sums, estimate);
        estimate->first = step_of_percent(&sums, first_percent[look]);
    }
}

/* Returns a threshold of which weights are learned that a scene's own threshold cuts. */
static real_energy lower_threshold(const struct scene *scene) {
    real_energy threshold = scene->threshold;
    for (uint8_t i = 0; i < LESS_WEIGHT_BITS; i++) {
        threshold = energy_product(threshold, REAL_ENERGY(0.5));
    }
    return threshold;
}

/* Learns what the scene's threshold and depth level cut. */
static void learn_tail(const struct scene *scene, struct estimate *estimate,
                       struct render_counts *counts) {
    const struct grid grid = {COLUMNS, ROWS};
    const uint16_t depth = (uint16_t)(scene->depth + ESTIMATE_EVENTS);
    struct tail tail;
    struct sums sums;
    clear(&sums);
    for (uint16_t i = 0; i < COLUMNS * ROWS; i++) {
        struct tree tree;
        const struct ray ray = ray_of(scene, &grid, i);
        tail_clear(&tail);
        growth_start(&tree, scene, &ray, counts);
        tree.tail = &tail;
        tree.threshold = lower_threshold(scene);
        tree.ray_budget = scene->ray_budget / BUDGET_PART;
        tree.last_depth = (uint8_t)(depth < UINT8_MAX ? depth : UINT8_MAX);
        tree.learns_depth = true;
        growth_finish(&tree);
        add_pixel(&sums, &tail);
    }
    conclude_means(&sums, estimate);
    set_variances(VARIANCE_BEFORE, BRANCH_VARIANCE, estimate);
    estimate->first = 0;
}

void learn_estimate(const struct scene *scene, struct estimate *estimate,
                    struct render_counts *counts) {
    if (!FEATURE_ESTIMATE) {
        return;
    }
    if (FEATURE_ACCURACY && scene->error > 0) {
        learn_for_accuracy(scene, estimate, counts);
    } else {
        learn_tail(scene, estimate, counts);
    }
}
