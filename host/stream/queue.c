/* SPDX-License-Identifier: MIT */
/* Bins of waiting rays, one array a quantity. */
#include "queue.h"

#include <string.h>

void queue_clear(struct queue *queue, bool is_grey) {
    queue->is_grey = is_grey;
    queue->overflowed = false;
    for (int bin = 0; bin < QUEUE_BINS; bin++) {
        queue->bins[bin].count = 0;
    }
}

static void push_into(struct queue_bin *restrict bin, const struct ray_lanes *restrict rays,
                      uint64_t lanes, bool is_grey) {
    uint32_t at = bin->count;
    for (; lanes != 0; lanes &= lanes - 1, at++) {
        uint32_t lane = lanes_first(lanes);
        bin->origin_x[at] = rays->origin.x[lane];
        bin->origin_y[at] = rays->origin.y[lane];
        bin->origin_z[at] = rays->origin.z[lane];
        bin->direction_x[at] = rays->direction.x[lane];
        bin->direction_y[at] = rays->direction.y[lane];
        bin->direction_z[at] = rays->direction.z[lane];
        bin->red[at] = rays->weight.red[lane];
        if (!is_grey) {
            bin->green[at] = rays->weight.green[lane];
            bin->blue[at] = rays->weight.blue[lane];
        }
        bin->from[at] = rays->from[lane];
        bin->inside[at] = rays->inside[lane];
        bin->path[at] = rays->path[lane];
        bin->target[at] = rays->target[lane];
    }
    bin->count = at;
}

void queue_push(struct queue *queue, const struct ray_lanes *rays, const uint32_t wanted[LANES]) {
    uint32_t bit[LANES], chosen[LANES], bins = 0;
    for (int i = 0; i < LANES; i++) {
        bit[i] = wanted[i] << path_object(rays->path[i]) % QUEUE_BINS;
        bins |= bit[i];
    }
    for (uint32_t number = 0; bins >> number != 0; number++) {
        struct queue_bin *bin = &queue->bins[number];
        if (!(bins >> number & 1)) {
            continue;
        }
        if (bin->count + LANES > QUEUE_ROOM) {
            queue->overflowed = true;
            continue;
        }
        for (int i = 0; i < LANES; i++) {
            chosen[i] = bit[i] >> number & 1;
        }
        push_into(bin, rays, lanes_set(chosen), queue->is_grey);
    }
}

static struct queue_bin *fullest_bin(struct queue *queue) {
    struct queue_bin *fullest = &queue->bins[0];
    for (int bin = 1; bin < QUEUE_BINS; bin++) {
        if (queue->bins[bin].count > fullest->count) {
            fullest = &queue->bins[bin];
        }
    }
    return fullest;
}

uint32_t queue_fullest(const struct queue *queue) {
    uint32_t most = 0;
    for (int bin = 0; bin < QUEUE_BINS; bin++) {
        most = queue->bins[bin].count > most ? queue->bins[bin].count : most;
    }
    return most;
}

/* The roles of numbers are all of one type in the arithmetics that streams are built for. */
static void take_numbers(real_length *to, const real_length *from, uint32_t count) {
    memcpy(to, from, count * sizeof *to);
}

static void take_words(uint32_t *to, const uint32_t *from, uint32_t count) {
    memcpy(to, from, count * sizeof *to);
}

uint32_t queue_pop(struct queue *queue, struct ray_lanes *rays) {
    struct queue_bin *bin = fullest_bin(queue);
    uint32_t count = bin->count < LANES ? bin->count : LANES;
    bin->count -= count;
    take_numbers(rays->origin.x, bin->origin_x + bin->count, count);
    take_numbers(rays->origin.y, bin->origin_y + bin->count, count);
    take_numbers(rays->origin.z, bin->origin_z + bin->count, count);
    take_numbers(rays->direction.x, bin->direction_x + bin->count, count);
    take_numbers(rays->direction.y, bin->direction_y + bin->count, count);
    take_numbers(rays->direction.z, bin->direction_z + bin->count, count);
    take_numbers(rays->weight.red, bin->red + bin->count, count);
    if (!queue->is_grey) {
        take_numbers(rays->weight.green, bin->green + bin->count, count);
        take_numbers(rays->weight.blue, bin->blue + bin->count, count);
    }
    take_numbers(rays->from, bin->from + bin->count, count);
    take_words(rays->inside, bin->inside + bin->count, count);
    take_words(rays->path, bin->path + bin->count, count);
    take_words(rays->target, bin->target + bin->count, count);
    return count;
}
