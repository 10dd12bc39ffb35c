/* SPDX-License-Identifier: MIT */
/* The tree of rays of one pixel, without recursion, to a threshold or to an accuracy. */
#include "tree.h"

#include "growth.h"
#include "learn.h"

/* What is kept is followed at most STEPS_MOST half octaves of the threshold farther at once. A
 * correction to that number is at most CORRECTION_MOST half octaves. */
enum { STEPS_MOST = 16, CORRECTION_MOST = 6, STEPS_ALL = 2 * ESTIMATE_LEVELS };

/* Follows the kept branches that a lower threshold lets through. */
static void follow_kept(struct tree *tree) {
    struct kept_branches *kept = tree->kept;
    uint16_t i = 0;
    while (i < kept->count && !growth_is_exhausted(tree)) {
        if (energy_less(energies_largest(kept->branches[i].weight), tree->threshold)) {
            i++;
            continue;
        }
        tree->branches[0] = kept->branches[i];
        tree->waiting = 1;
        kept->branches[i] = kept->branches[--kept->count];
        growth_finish(tree);
    }
}

/* Returns the sum of the squares of the pruned weights, in steps of 2^-52. */
static int64_t squares_of(const struct kept_branches *kept) {
    int64_t sum = kept->losses.squares;
    for (uint16_t i = 0; i < kept->count; i++) {
        sum += growth_square(kept->branches[i].weight);
    }
    return sum;
}

/* Begins a pixel, or begins it again: nothing is kept of the pixel but the count of its rays. */
static void begin(struct tree *tree, const struct ray *eye_ray, real_energy threshold) {
    struct kept_branches *kept = tree->kept;
    const struct tree_observer *observer = tree->observer;
    uint64_t rays_before = tree->rays_before;
    growth_start(tree, tree->scene, eye_ray, tree->counts);
    tree->rays_before = rays_before;
    tree->observer = observer;
    tree->threshold = threshold;
    tree->kept = kept;
    kept->count = 0;
    for (uint8_t i = 0; i < 3; i++) {
        kept->losses.weight[WAY_DOWN][i] = kept->losses.weight[WAY_UP][i] = 0;
        kept->losses.ended[i] = 0;
    }
    kept->losses.squares = kept->losses.depth = 0;
    growth_finish(tree);
}

/* Returns the threshold so many half octaves below the scene's own. */
static real_energy threshold_at(const struct scene *scene, uint8_t steps) {
    real_energy threshold = scene->threshold;
    for (uint8_t i = 0; i < steps / 2; i++) {
        threshold = energy_product(threshold, REAL_ENERGY(0.5));
    }
    return steps % 2 == 0 ? threshold : energy_product(threshold, REAL_ENERGY(0.75));
}

/* Returns the most squares with which a pixel is as accurate as was asked for. The threshold lies
 * `steps` half octaves below the scene's own. */
static int64_t squares_most(const struct tree *tree, uint8_t steps) {
    return tree->scene->estimate->level[steps / 2].squares_most;
}

/* Returns what is left of squares so many half octaves farther down: five eighths each time. */
static int64_t squares_below(int64_t squares, uint8_t steps) {
    for (uint8_t i = 0; i < steps; i++) {
        squares -= (squares >> 2) + (squares >> 3);
    }
    return squares;
}

/* Returns how far down no more than `most` is left of squares that were pruned at `from`, but at
 * most STEPS_MOST farther. */
static uint8_t steps_to_leave(uint8_t from, int64_t squares, int64_t most) {
    uint8_t steps = from;
    while (squares > most && steps < from + STEPS_MOST && steps + 1 < STEPS_ALL) {
        squares = squares_below(squares, 1);
        steps++;
    }
    return steps;
}

/* The last way down of what is kept: from where, and to where the way was expected to go. The rest
 * are squares: of what still waits, and of what is left as it is. `foreseen` and `found` are the
 * squares of all that waits no more. Both begin at an eighth of what is expected in all. */
struct last_way {
    uint8_t from, to, attempt;
    int64_t waiting, left, foreseen, found;
};

/* Returns by how many half octaves the last way has to be longer than was expected. Below 0, it has
 * to be shorter. */
static int8_t correction(const struct last_way *way) {
    int64_t foreseen = way->foreseen;
    int8_t steps = 0;
    while (steps < CORRECTION_MOST && way->found > foreseen + (foreseen >> 2)) {
        foreseen += (foreseen >> 1) + (foreseen >> 3);
        steps++;
    }
    while (steps > -CORRECTION_MOST && way->found + (way->found >> 2) < foreseen) {
        foreseen = squares_below(foreseen, 1);
        steps--;
    }
    return steps;
}

static uint8_t limited(int16_t steps, int16_t least, int16_t most) {
    int16_t result = steps < least ? least : steps > most ? most : steps;
    return (uint8_t)result;
}

/* Returns where the last way ends, as far as is known by now. */
static uint8_t end_of(const struct last_way *way) {
    return limited((int16_t)(way->to + correction(way)), way->from, STEPS_ALL - 1);
}

/* Returns the squares that are to be left of a pixel at a level: a little less than may be. Each
 * further attempt halves the squares. */
static int64_t squares_wanted(const struct tree *tree, uint8_t steps, uint8_t attempt) {
    int64_t most = squares_most(tree, steps);
    return (most - (most >> 3)) >> attempt;
}

/* Returns where the last way is expected to end. Levels farther down allow for fewer squares. */
static uint8_t expected_end(const struct tree *tree, const struct last_way *way) {
    int64_t lost = tree->kept->losses.squares, squares = way->waiting;
    uint8_t steps = way->from;
    while (squares + lost > squares_wanted(tree, steps, way->attempt) &&
           steps < way->from + STEPS_MOST && steps + 1 < STEPS_ALL) {
        squares = squares_below(squares, 1);
        steps++;
    }
    return steps;
}

/* Returns how far the next branch is to be followed. What the branches before have left is held
 * against what was to be left of them. The difference makes the way a little longer or shorter. */
static uint8_t next_steps(const struct tree *tree, const struct last_way *way) {
    uint8_t end = end_of(way);
    int64_t most = squares_wanted(tree, end, way->attempt) - way->left - tree->kept->losses.squares;
    int16_t steps = (int16_t)(steps_to_leave(way->from, way->waiting, most) + end - way->to);
    int16_t least = end > way->from ? (int16_t)(end - 1) : end;
    return limited(steps, least, end + 2 < STEPS_ALL ? (int16_t)(end + 2) : STEPS_ALL - 1);
}

/* Follows kept branch number i, and keeps nothing of that branch. Returns the squares of what is
 * cut then. */
static int64_t follow_to_the_end(struct tree *tree, uint16_t i) {
    struct kept_branches *kept = tree->kept;
    int64_t before = kept->losses.squares;
    uint16_t count = (uint16_t)(kept->count - 1);
    tree->branches[0] = kept->branches[i];
    tree->waiting = 1;
    kept->branches[i] = kept->branches[count];
    kept->count = KEPT_MOST; /* no place is free */
    growth_finish(tree);
    kept->count = count;
    return kept->losses.squares - before;
}

/* Follows what is kept to where the pixel is nearly as accurate as was asked for. The squares are
 * some seven eighths of the most, and at each further attempt half of that. Returns how far down
 * the last way has ended. */
static uint8_t follow_all(struct tree *tree, uint8_t from, uint8_t attempt) {
    struct kept_branches *kept = tree->kept;
    struct last_way way = {from, from, attempt, squares_of(kept) - kept->losses.squares, 0, 0, 0};
    way.to = expected_end(tree, &way);
    way.found = way.foreseen = squares_below(way.waiting, (uint8_t)(way.to - from)) >> 3;
    uint16_t i = 0;
    while (i < kept->count && !growth_is_exhausted(tree)) {
        uint8_t steps = next_steps(tree, &way);
        int64_t square = growth_square(kept->branches[i].weight);
        way.waiting -= square;
        way.foreseen += squares_below(square, (uint8_t)(steps - from));
        tree->threshold = threshold_at(tree->scene, steps);
        if (energy_less(energies_largest(kept->branches[i].weight), tree->threshold)) {
            way.left += square;
            way.found += square;
            i++;
        } else {
            way.found += follow_to_the_end(tree, i);
        }
    }
    uint8_t end = end_of(&way);
    return end > from ? end : (uint8_t)(from + 1);
}

/* Tells whether there will be more to keep than room for it: a quarter more each half octave. */
static bool is_too_much(const struct tree *tree, uint8_t steps) {
    const struct kept_branches *kept = tree->kept;
    uint8_t to = steps_to_leave(steps, squares_of(kept), squares_most(tree, steps));
    uint32_t count = kept->count;
    for (; to > steps && count <= KEPT_MOST; to--) {
        count += count >> 2;
    }
    return kept->count > KEPT_MOST / 4 && count > KEPT_MOST;
}

/* Tells whether the losses alone are too much, and there are rays enough to begin again. To begin
 * again takes about twice as many rays as what was done so far. */
static bool must_begin_again(const struct tree *tree, uint8_t steps) {
    uint64_t used = tree->counts->rays - tree->rays_before;
    return tree->kept->losses.squares > squares_most(tree, steps) && used < tree->ray_budget / 4;
}

/* Tells whether the pixel is as accurate as was asked for. After the last way half as many squares
 * again will do, because the gain does not repay the rays of another beginning. */
static bool is_accurate(const struct tree *tree, uint8_t steps, bool is_last) {
    int64_t most = squares_most(tree, steps);
    return squares_of(tree->kept) <= most + (is_last ? most >> 1 : 0);
}

/* Lowers the threshold until the pixel is as accurate as was asked for; returns the level. Branches
 * stray from the mean nearly independently of each other, so their squares add. */
static uint8_t refine(struct tree *tree, const struct ray *eye_ray) {
    const struct scene *scene = tree->scene;
    const uint8_t first = (uint8_t)(2 * scene->estimate->first);
    uint8_t steps = first, attempts = 0;
    bool is_last = false;
    begin(tree, eye_ray, threshold_at(scene, steps));
    while (!is_accurate(tree, steps, is_last)) {
        bool again = must_begin_again(tree, steps);
        bool is_stuck = tree->kept->count == 0 && !again;
        if (growth_is_exhausted(tree) || is_stuck || steps + 2 >= STEPS_ALL) {
            tree->exhausted = true;
            break;
        }
        is_last = !again && is_too_much(tree, steps);
        if (is_last) {
            steps = follow_all(tree, steps, attempts++);
        } else if (again) {
            steps = attempts > 0 ? first : (uint8_t)(steps + 2);
            begin(tree, eye_ray, threshold_at(scene, steps));
        } else {
            steps++;
            tree->threshold = threshold_at(scene, steps);
            follow_kept(tree);
        }
    }
    return steps / 2;
}

/* Cuts everything that is still kept. */
static void lose_kept(struct tree *tree) {
    struct kept_branches *kept = tree->kept;
    while (kept->count > 0) {
        growth_lose(tree, &kept->branches[--kept->count], END_THRESHOLD);
    }
}

/* Multiplies a weight in steps of 2^-30 by a mean; mean and product are in steps of 2^-16 level. */
static int64_t weighed(int64_t weight, int32_t mean) {
    return (weight * mean) >> 30;
}

/* Returns half of the estimated radiance beyond the depth level, of the channel where that half is
 * largest. */
static int64_t open_half(const struct losses *losses, const struct estimate_level *level) {
    int64_t most = 0;
    for (uint8_t i = 0; i < 3; i++) {
        int64_t half = weighed(losses->ended[i] / 2, level->mean[WAY_ANY][i]);
        most = half > most ? half : most;
    }
    return most;
}

/* Returns the estimated radiance of the losses. Where the depth level ends a path, a picture of
 * that level has no more light. A picture without a depth limit has the mean there. Half the mean
 * is added if that half is within the error asked for of both pictures. Otherwise nothing is added,
 * as in the picture of that level. */
static struct colours worth_of(const struct losses *losses, const struct estimate_level *level,
                               bool counts_open) {
    int32_t radiance[3];
    for (uint8_t i = 0; i < 3; i++) {
        int64_t sum = weighed(losses->weight[WAY_DOWN][i], level->mean[WAY_DOWN][i]) +
                      weighed(losses->weight[WAY_UP][i], level->mean[WAY_UP][i]);
        if (counts_open) {
            sum += weighed(losses->ended[i] / 2, level->mean[WAY_ANY][i]);
        }
        radiance[i] = sum < INT32_MAX ? (int32_t)sum : INT32_MAX;
    }
    const struct colours colours = {colour_of_steps(radiance[0]), colour_of_steps(radiance[1]),
                                    colour_of_steps(radiance[2])};
    return colours;
}

/* Notes a pixel's errors where they are the worst of all pixels that are counted. */
static void note_error(const struct scene *scene, const struct losses *losses, int64_t uncertainty,
                       struct render_counts *counts) {
    uint32_t estimated = uncertainty < (int64_t)UINT32_MAX ? (uint32_t)uncertainty : UINT32_MAX;
    uint32_t proved = (uint32_t)(((losses->depth >> 20) * scene->brightest) >> 10);
    if (estimated > counts->estimated_error) {
        counts->estimated_error = estimated;
    }
    if (proved > counts->proved_error) {
        counts->proved_error = proved;
    }
}

static struct colours refined_colour(const struct scene *scene, const struct ray *eye_ray,
                                     struct render_counts *counts,
                                     const struct tree_observer *observer) {
    struct tree tree;
    struct kept_branches kept;
    tree.scene = scene;
    tree.counts = counts;
    tree.observer = observer;
    tree.rays_before = counts->rays;
    tree.kept = &kept;
    const struct estimate_level *level = &scene->estimate->level[refine(&tree, eye_ray)];
    const struct losses *losses = &kept.losses;
    lose_kept(&tree);
    int64_t open = open_half(losses, level);
    bool counts_open = open <= (int64_t)scene->error;
    int64_t uncertainty = (((int64_t)learn_root(losses->squares) * level->spread) >> 26) + open;
    note_error(scene, losses, uncertainty, counts);
    counts->exhausted_pixels += tree.exhausted;
    return colours_add(tree.sum, worth_of(losses, level, counts_open));
}

struct colours tree_colour(const struct scene *scene, const struct ray *eye_ray,
                           struct render_counts *counts, const struct tree_observer *observer) {
    if (FEATURE_KEPT > 0 && scene->error > 0) {
        return refined_colour(scene, eye_ray, counts, observer);
    }
    struct tree tree;
    growth_start(&tree, scene, eye_ray, counts);
    tree.observer = observer;
    growth_finish(&tree);
    counts->exhausted_pixels += tree.exhausted;
    return tree.sum;
}
