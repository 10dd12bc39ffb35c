/* SPDX-License-Identifier: MIT */
/* Which bounds may meet which: grids of cells, each as fine as what is in it is small. */
#include "compiler/neighbours.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "base/grow.h"

enum { ENDLESS = NEIGHBOUR_LEVELS - 1 };

/* More than any rounding of what ends within FAR. */
#define ROUNDING 0x1p-30

/* Cells have no numbers beyond this. */
#define FAR 0x1p20

static double cell_of(int level) {
    return ldexp(1, level - NEIGHBOUR_FINEST);
}

static struct bounds in_order(const struct bounds *bounds) {
    struct bounds ordered;
    for (int i = 0; i < 3; i++) {
        ordered.low[i] = fmin(bounds->low[i], bounds->high[i]);
        ordered.high[i] = fmax(bounds->low[i], bounds->high[i]);
        if (!(ordered.low[i] <= ordered.high[i])) { /* no numbers: nothing is known */
            ordered.low[i] = -HUGE_VAL;
            ordered.high[i] = HUGE_VAL;
        }
    }
    return ordered;
}

/* Returns the level of the finest cells that bounds are no wider than. */
static int level_of(const struct bounds *bounds) {
    double widest = 0;
    int exponent;
    for (int i = 0; i < 3; i++) {
        if (!(bounds->low[i] > -FAR && bounds->high[i] < FAR)) {
            return ENDLESS;
        }
        widest = fmax(widest, bounds->high[i] - bounds->low[i]);
    }
    (void)frexp(widest, &exponent);
    exponent += NEIGHBOUR_FINEST;
    return exponent < 0 ? 0 : exponent < ENDLESS ? exponent : ENDLESS;
}

static uint64_t cell_key(int level, const double place[3]) {
    uint64_t key = (uint64_t)level;
    for (int i = 0; i < 3; i++) {
        key = bucket_key_of(key, place[i]);
    }
    return key;
}

bool neighbours_add(struct neighbours *neighbours, const struct bounds *bounds, uint32_t number) {
    const struct bounds ordered = in_order(bounds);
    const int level = level_of(&ordered);
    const uint32_t entry = neighbours->count;
    if (!GROW(neighbours->entries, entry)) {
        return false;
    }
    if (level != ENDLESS) {
        double place[3];
        for (int i = 0; i < 3; i++) {
            place[i] = floor(ordered.low[i] / cell_of(level));
        }
        if (!buckets_add(&neighbours->cells, cell_key(level, place), entry)) {
            return false;
        }
    }
    const bool is_first = neighbours->levels[level].count++ == 0;
    neighbours->entries[entry] = (struct neighbour){
        ordered, number, is_first ? COMPILED_NONE : neighbours->levels[level].first};
    neighbours->levels[level].first = entry;
    neighbours->count++;
    return true;
}

/* What is looked for, and what is found so far. */
struct search {
    const struct neighbours *neighbours;
    struct bounds bounds;
    double gap;
    struct compiled_set *found;
};

/* Takes an entry that is near enough; false if memory is out. */
static bool take(const struct search *search, uint32_t entry) {
    const struct neighbour *neighbour = &search->neighbours->entries[entry];
    if (bounds_are_apart(&neighbour->bounds, &search->bounds, search->gap)) {
        return true;
    }
    if (!GROW(search->found->members, search->found->count)) {
        return false;
    }
    search->found->members[search->found->count++] = neighbour->number;
    return true;
}

static bool take_level(const struct search *search, int level) {
    uint32_t entry = search->neighbours->levels[level].first;
    for (; entry != COMPILED_NONE; entry = search->neighbours->entries[entry].next) {
        if (!take(search, entry)) {
            return false;
        }
    }
    return true;
}

static bool take_cell(const struct search *search, uint64_t key) {
    const struct buckets *cells = &search->neighbours->cells;
    uint32_t slot = buckets_first(cells, key);
    for (; slot != COMPILED_NONE; slot = buckets_next(cells, slot)) {
        if (!take(search, cells->slots[slot].entry)) {
            return false;
        }
    }
    return true;
}

/* Takes what is near of one level: of the cells there, or of all that the level has where that is
 * less. A low corner may lie one cell before what its bounds meet. */
static bool search_level(const struct search *search, int level) {
    const double cell = cell_of(level);
    double low[3], high[3], cells = 1;
    for (int i = 0; i < 3; i++) {
        low[i] = floor((search->bounds.low[i] - search->gap) / cell) - 1;
        high[i] = floor((search->bounds.high[i] + search->gap) / cell);
        cells *= high[i] - low[i] + 1;
    }
    if (level == ENDLESS || !(cells <= search->neighbours->levels[level].count)) {
        return take_level(search, level);
    }
    double place[3];
    for (place[0] = low[0]; place[0] <= high[0]; place[0]++) {
        for (place[1] = low[1]; place[1] <= high[1]; place[1]++) {
            for (place[2] = low[2]; place[2] <= high[2]; place[2]++) {
                if (!take_cell(search, cell_key(level, place))) {
                    return false;
                }
            }
        }
    }
    return true;
}

static int compare_numbers(const void *a, const void *b) {
    const uint32_t one = *(const uint32_t *)a, other = *(const uint32_t *)b;
    return (one > other) - (one < other);
}

bool neighbours_find(const struct neighbours *neighbours, const struct bounds *bounds, double gap,
                     struct compiled_set *found) {
    const struct search search = {neighbours, in_order(bounds), gap + ROUNDING, found};
    found->count = 0;
    for (int level = 0; level < NEIGHBOUR_LEVELS; level++) {
        if (neighbours->levels[level].count > 0 && !search_level(&search, level)) {
            return false;
        }
    }
    if (found->count > 1) {
        qsort(found->members, found->count, sizeof *found->members, compare_numbers);
    }
    return true;
}

void neighbours_clear(struct neighbours *neighbours) {
    free(neighbours->entries);
    buckets_clear(&neighbours->cells);
    memset(neighbours, 0, sizeof *neighbours);
}
