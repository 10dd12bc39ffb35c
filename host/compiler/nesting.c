/* SPDX-License-Identifier: MIT */
/* The scene compiler: how many primitives a point may be inside of, at most. */
#include <stdlib.h>

#include "base/grow.h"
#include "compiler/compiler_internal.h"

/* The most is looked for in regions of space. They are halved until each is held by all bounds that
 * reach into it. No point of a region is inside of more primitives than reach into it. The region
 * with the most is always the next: once it cannot be halved, no other one has more. */

/* Work is given up after so many looks at bounds for each primitive; the most so far is told. */
enum { LOOKS_OF_EACH = 1024 };

/* A region, and what reaches into it. Those that hold all of it are only counted. */
struct region {
    struct bounds bounds;
    uint32_t holding;
    uint32_t *members;
    uint32_t member_count;
};

/* A heap by how many bounds reach into a region: none has more than its parent. */
struct regions {
    const struct neighbours *solids;
    struct region *entries;
    uint32_t count;
    uint64_t looks;
};

static uint32_t most_of(const struct region *region) {
    return region->holding + region->member_count;
}

static void swap(struct region *a, struct region *b) {
    const struct region kept = *a;
    *a = *b;
    *b = kept;
}

static bool push(struct regions *regions, const struct region *region) {
    if (!GROW(regions->entries, regions->count)) {
        return false;
    }
    uint32_t at = regions->count++;
    regions->entries[at] = *region;
    while (at > 0 && most_of(&regions->entries[at]) > most_of(&regions->entries[(at - 1) / 2])) {
        swap(&regions->entries[at], &regions->entries[(at - 1) / 2]);
        at = (at - 1) / 2;
    }
    return true;
}

static struct region pop(struct regions *regions) {
    const struct region top = regions->entries[0];
    regions->entries[0] = regions->entries[--regions->count];
    uint32_t at = 0, most = 0;
    do {
        swap(&regions->entries[at], &regions->entries[most]);
        at = most;
        for (uint32_t child = 2 * at + 1; child <= 2 * at + 2 && child < regions->count; child++) {
            if (most_of(&regions->entries[child]) > most_of(&regions->entries[most])) {
                most = child;
            }
        }
    } while (most != at);
    return top;
}

/* Tells whether bounds reach into a region; those that touch it only do not. */
static bool reaches(const struct bounds *bounds, const struct bounds *region) {
    for (int i = 0; i < 3; i++) {
        if (!(bounds->low[i] < region->high[i] && bounds->high[i] > region->low[i])) {
            return false;
        }
    }
    return true;
}

static bool holds(const struct bounds *bounds, const struct bounds *region) {
    for (int i = 0; i < 3; i++) {
        if (!(bounds->low[i] <= region->low[i] && bounds->high[i] >= region->high[i])) {
            return false;
        }
    }
    return true;
}

/* Fills a part of a region with what reaches into it; false if memory is out. */
static bool fill(struct regions *regions, const struct region *from, struct region *part) {
    part->holding = from->holding;
    part->member_count = 0;
    part->members = malloc(((size_t)from->member_count + 1) * sizeof *part->members);
    if (part->members == NULL) {
        return false;
    }
    regions->looks += from->member_count;
    for (uint32_t i = 0; i < from->member_count; i++) {
        const struct bounds *bounds = &regions->solids->entries[from->members[i]].bounds;
        if (holds(bounds, &part->bounds)) {
            part->holding++;
        } else if (reaches(bounds, &part->bounds)) {
            part->members[part->member_count++] = from->members[i];
        }
    }
    if (part->member_count == 0) {
        free(part->members);
        part->members = NULL;
    }
    return true;
}

static int compare_places(const void *a, const void *b) {
    const double one = *(const double *)a, other = *(const double *)b;
    return (one > other) - (one < other);
}

/* Finds the middle one of the ends, across an axis, of what reaches into a region. Returns how many
 * ends there are; false in *has_memory if memory is out. */
static uint32_t middle_end(const struct regions *regions, const struct region *region, int axis,
                           double *middle, bool *has_memory) {
    double *ends = malloc(((size_t)region->member_count + 1) * 2 * sizeof *ends);
    uint32_t count = 0;
    *has_memory = ends != NULL;
    for (uint32_t i = 0; i < region->member_count && ends != NULL; i++) {
        const struct bounds *bounds = &regions->solids->entries[region->members[i]].bounds;
        const double both[2] = {bounds->low[axis], bounds->high[axis]};
        for (int j = 0; j < 2; j++) {
            if (both[j] > region->bounds.low[axis] && both[j] < region->bounds.high[axis]) {
                ends[count++] = both[j];
            }
        }
    }
    if (count > 0) {
        qsort(ends, count, sizeof *ends, compare_places);
        *middle = ends[count / 2];
    }
    free(ends);
    return count;
}

/* Halves a region at the middle end along the axis that has the most; false if memory is out. */
static bool halve(struct regions *regions, const struct region *region) {
    double middle = 0;
    uint32_t most = 0;
    int across = 0;
    for (int axis = 0; axis < 3; axis++) {
        double place;
        bool has_memory;
        uint32_t count = middle_end(regions, region, axis, &place, &has_memory);
        if (!has_memory) {
            return false;
        }
        if (count > most) {
            most = count;
            middle = place;
            across = axis;
        }
    }
    regions->looks += 3 * (uint64_t)region->member_count;
    for (int side = 0; side < 2; side++) {
        struct region part = {.bounds = region->bounds};
        *(side == 0 ? &part.bounds.high[across] : &part.bounds.low[across]) = middle;
        if (!fill(regions, region, &part)) {
            return false;
        }
        if (!push(regions, &part)) {
            free(part.members);
            return false;
        }
    }
    return true;
}

/* Puts all of space into the heap; false if memory is out. */
static bool start(struct regions *regions) {
    struct region all = {.bounds = bounds_everything};
    all.members = malloc(((size_t)regions->solids->count + 1) * sizeof *all.members);
    if (all.members == NULL) {
        return false;
    }
    for (uint32_t i = 0; i < regions->solids->count; i++) {
        all.members[all.member_count++] = i;
    }
    if (!push(regions, &all)) {
        free(all.members);
        return false;
    }
    return true;
}

bool compile_nesting(struct compiler *compiler) {
    struct regions regions = {.solids = &compiler->solids};
    const uint64_t looks_most = LOOKS_OF_EACH * (uint64_t)(compiler->solids.count + 1);
    bool has_memory = start(&regions);
    while (has_memory && regions.entries[0].member_count > 0 && regions.looks < looks_most) {
        struct region most = pop(&regions);
        has_memory = halve(&regions, &most);
        free(most.members);
    }
    compiler->scene->nesting = has_memory ? most_of(&regions.entries[0]) : 0;
    for (uint32_t i = 0; i < regions.count; i++) {
        free(regions.entries[i].members);
    }
    free(regions.entries);
    return has_memory || compile_fail_memory(compiler);
}
