/* SPDX-License-Identifier: MIT */
/* Which bounds may meet which: grids of cells, each as fine as what is in it is small. */
#ifndef SUPERFRAME_NEIGHBOURS_H
#define SUPERFRAME_NEIGHBOURS_H

#include "compiler/bounds.h"
#include "compiler/buckets.h"
#include "compiler/tables.h"

/* A grid whose cells are 2^(level - NEIGHBOUR_FINEST) wide has what is no wider than a cell, but
 * wider than half of one. The last level has no cells: it has what goes on without an end. */
enum { NEIGHBOUR_FINEST = 24, NEIGHBOUR_LEVELS = 38 };

struct neighbour {
    struct bounds bounds;
    uint32_t number;
    uint32_t next; /* of its level, or COMPILED_NONE */
};

/* All zero: nothing is in it. */
struct neighbours {
    struct neighbour *entries; /* grows as base/grow.h says */
    uint32_t count;
    struct buckets cells; /* entries by level and cell of their low corner */
    struct {
        uint32_t first, count; /* entries */
    } levels[NEIGHBOUR_LEVELS];
};

/* Adds bounds under a number; false if memory is out. Bounds whose low end lies above the high one
 * count as those between the two. */
bool neighbours_add(struct neighbours *neighbours, const struct bounds *bounds, uint32_t number);

/* Finds the numbers of all bounds that are not farther apart from these than a gap. Some that are
 * farther by a rounding may be among them. They come in ascending order, in place of what was in
 * the set. Returns false if memory is out. */
bool neighbours_find(const struct neighbours *neighbours, const struct bounds *bounds, double gap,
                     struct compiled_set *found);

/* Frees all memory and leaves nothing in it. */
void neighbours_clear(struct neighbours *neighbours);

#endif
