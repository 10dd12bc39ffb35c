/* SPDX-License-Identifier: MIT */
/* Bins of waiting rays, one array a quantity. */
#include "queue.h"

#include <string.h>

void queue_clear(struct queue *queue) {
    queue->overflowed = false;
    for (int bin = 0; bin < QUEUE_BINS; bin++) {
        queue->bins[bin].count = 0;
    }
}

static void push_into(struct queue_bin *bin, const struct ray_lanes *rays,
                      const uint32_t lanes[LANES], uint32_t count) {
    const real_length *const numbers[QUEUE_NUMBERS] = {
        rays->origin.x,    rays->origin.y,    rays->origin.z,    rays->direction.x,
        rays->direction.y, rays->direction.z, rays->weight.red,  rays->weight.green,
        rays->weight.blue, rays->from};
    const uint32_t *const words[QUEUE_WORDS] = {rays->inside, rays->path, rays->target};
    for (int quantity = 0; quantity < QUEUE_NUMBERS; quantity++) {
        const real_length *restrict from = numbers[quantity];
        real_length *restrict to = bin->numbers[quantity] + bin->count;
        for (uint32_t k = 0; k < count; k++) {
            to[k] = from[lanes[k]];
        }
    }
    for (int quantity = 0; quantity < QUEUE_WORDS; quantity++) {
        const uint32_t *restrict from = words[quantity];
        uint32_t *restrict to = bin->words[quantity] + bin->count;
        for (uint32_t k = 0; k < count; k++) {
            to[k] = from[lanes[k]];
        }
    }
    bin->count += count;
}

void queue_push(struct queue *queue, const struct ray_lanes *rays, const uint32_t wanted[LANES]) {
    uint32_t lanes[QUEUE_BINS][LANES + 1];
    uint32_t count[QUEUE_BINS] = {0};
    for (uint32_t i = 0; i < LANES; i++) {
        uint32_t bin = path_object(rays->path[i]) % QUEUE_BINS;
        lanes[bin][count[bin]] = i;
        count[bin] += wanted[i];
    }
    for (int bin = 0; bin < QUEUE_BINS; bin++) {
        if (count[bin] == 0) {
            continue;
        }
        if (queue->bins[bin].count + count[bin] > QUEUE_ROOM) {
            queue->overflowed = true;
            continue;
        }
        push_into(&queue->bins[bin], rays, lanes[bin], count[bin]);
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

uint32_t queue_pop(struct queue *queue, struct ray_lanes *rays) {
    struct queue_bin *bin = fullest_bin(queue);
    uint32_t count = bin->count < LANES ? bin->count : LANES;
    bin->count -= count;
    real_length *numbers[QUEUE_NUMBERS] = {
        rays->origin.x,    rays->origin.y,    rays->origin.z,    rays->direction.x,
        rays->direction.y, rays->direction.z, rays->weight.red,  rays->weight.green,
        rays->weight.blue, rays->from};
    uint32_t *words[QUEUE_WORDS] = {rays->inside, rays->path, rays->target};
    for (int quantity = 0; quantity < QUEUE_NUMBERS; quantity++) {
        memcpy(numbers[quantity], bin->numbers[quantity] + bin->count,
               count * sizeof *numbers[quantity]);
    }
    for (int quantity = 0; quantity < QUEUE_WORDS; quantity++) {
        memcpy(words[quantity], bin->words[quantity] + bin->count, count * sizeof *words[quantity]);
    }
    return count;
}
