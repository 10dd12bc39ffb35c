/* SPDX-License-Identifier: MIT */
/* Blocks of waiting rays, one array a quantity. */
#include "stream/queue.h"

#include "compact.h"
#include "set_memory.h"

static uint32_t take_free(struct queue *queue) {
    uint32_t block = queue->free;
    queue->free = queue->next[block];
    return block;
}

void queue_give_back(struct queue *queue, uint32_t block) {
    queue->next[block] = queue->free;
    queue->free = block;
}

void queue_clear(struct queue *queue, bool is_grey) {
    queue->is_grey = is_grey;
    queue->overflowed = false;
    for (uint32_t block = 0; block < QUEUE_BLOCKS; block++) {
        queue->next[block] = block + 1;
    }
    queue->free = 0;
    for (uint32_t bin = 0; bin < QUEUE_BINS; bin++) {
        queue->bins[bin].count = 0;
        queue->bins[bin].filling = take_free(queue);
    }
}

/* Appends the chosen lanes of a group to the `at` rays of a block. */
static inline void append_group(struct ray_lanes *restrict block, uint32_t at,
                                const struct ray_columns *rays, int group,
                                const struct compact_order *order, bool is_grey) {
    compact_numbers(block->origin.x + at, rays->origin->x + group, order);
    compact_numbers(block->origin.y + at, rays->origin->y + group, order);
    compact_numbers(block->origin.z + at, rays->origin->z + group, order);
    compact_numbers(block->direction.x + at, rays->direction->x + group, order);
    compact_numbers(block->direction.y + at, rays->direction->y + group, order);
    compact_numbers(block->direction.z + at, rays->direction->z + group, order);
    compact_numbers(block->weight.red + at, rays->weight->red + group, order);
    if (!is_grey) {
        compact_numbers(block->weight.green + at, rays->weight->green + group, order);
        compact_numbers(block->weight.blue + at, rays->weight->blue + group, order);
    }
    compact_numbers(block->from + at, rays->from + group, order);
    compact_words(block->inside + at, rays->inside + group, order);
    compact_words(block->path + at, rays->path + group, order);
    compact_words(block->target + at, rays->target + group, order);
}

static void append(struct ray_lanes *restrict block, uint32_t at, const struct ray_columns *rays,
                   uint64_t lanes, bool is_grey) {
    for (int group = 0; group < LANES; group += COMPACT_GROUP) {
        const struct compact_order order = compact_order_of(lanes >> group);
        if (order.count > 0) {
            append_group(block, at, rays, group, &order, is_grey);
        }
        at += order.count;
    }
}

static uint64_t first_lanes(uint32_t count) {
    return count < LANES ? (UINT64_C(1) << count) - 1 : ~UINT64_C(0);
}

/* Makes a full block of `count` rays and of those that the bin has got last before them. Rays that
 * have set out together go on together; the first ones of a bin wait until the others are
 * through. */
static void fill_block(struct queue *queue, struct queue_bin *bin, const struct ray_columns *rays,
                       uint64_t lanes, uint32_t count) {
    uint32_t waiting = bin->count % LANES, taken = LANES - count;
    if (queue->free == QUEUE_BLOCKS) {
        queue->overflowed = true;
        return;
    }
    uint32_t full = take_free(queue);
    const struct ray_lanes *filling = &queue->blocks[bin->filling];
    const struct ray_columns before = columns_of(filling);
    append(&queue->blocks[full], 0, rays, lanes, queue->is_grey);
    append(&queue->blocks[full], count, &before, first_lanes(taken) << (waiting - taken),
           queue->is_grey);
    queue->next[full] = bin->full;
    bin->full = full;
}

static void push_into(struct queue *queue, struct queue_bin *bin, const struct ray_columns *rays,
                      uint64_t lanes) {
    uint32_t count = (uint32_t)__builtin_popcountll(lanes), waiting = bin->count % LANES;
    if (waiting + count < LANES) {
        append(&queue->blocks[bin->filling], waiting, rays, lanes, queue->is_grey);
    } else {
        fill_block(queue, bin, rays, lanes, count);
    }
    bin->count += count;
}

void queue_push(struct queue *queue, const struct ray_columns *rays, const uint32_t wanted[LANES]) {
    uint32_t bit[LANES], chosen[LANES], bins = 0;
    for (int i = 0; i < LANES; i++) {
        bit[i] = wanted[i] << path_bin(rays->path[i], rays->inside[i], QUEUE_BINS);
        bins |= bit[i];
    }
    for (uint32_t number = 0; bins >> number != 0; number++) {
        if (!(bins >> number & 1)) {
            continue;
        }
        for (int i = 0; i < LANES; i++) {
            chosen[i] = bit[i] >> number & 1;
        }
        push_into(queue, &queue->bins[number], rays, lanes_set(chosen));
    }
}

/* Fills the lanes after the first `count` with copies of those: an idle lane's numbers have to be
 * some ray's. */
static void fill_up(struct ray_lanes *block, uint32_t count) {
    const struct ray_lanes before = *block;
    const struct ray_columns rays = columns_of(&before);
    for (uint32_t at = count; at < LANES; at += count) {
        uint32_t copies = LANES - at < count ? LANES - at : count;
        append(block, at, &rays, first_lanes(copies), false);
    }
}

static const struct queue_bin *fullest_bin(const struct queue *queue) {
    const struct queue_bin *fullest = &queue->bins[0];
    for (int bin = 1; bin < QUEUE_BINS; bin++) {
        if (queue->bins[bin].count > fullest->count) {
            fullest = &queue->bins[bin];
        }
    }
    return fullest;
}

uint32_t queue_fullest(const struct queue *queue) {
    return fullest_bin(queue)->count;
}

uint32_t queue_take(struct queue *queue, uint32_t *block) {
    struct queue_bin *bin = &queue->bins[fullest_bin(queue) - queue->bins];
    uint32_t count = bin->count < LANES ? bin->count : LANES;
    bin->count -= count;
    if (count == LANES) {
        *block = bin->full;
        bin->full = queue->next[*block];
    } else if (count > 0) {
        *block = bin->filling;
        fill_up(&queue->blocks[*block], count);
        bin->filling = take_free(queue); /* no bin has a full block: most blocks are free */
    }
    return count;
}
