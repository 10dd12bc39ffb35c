/* SPDX-License-Identifier: MIT */
/* Putting chosen lanes side by side, one by one: for any CPU. */
#ifndef SUPERFRAME_COMPACT_H
#define SUPERFRAME_COMPACT_H

#include "real.h"

enum { COMPACT_GROUP = 64 };

/* Which lanes of a group of COMPACT_GROUP are chosen, and their number. */
struct compact_order {
    uint32_t count;
    uint8_t lane[COMPACT_GROUP];
};

/* Finds the chosen lanes of a group: those whose bits are set among the low COMPACT_GROUP of
 * `lanes`. */
static inline struct compact_order compact_order_of(uint64_t lanes) {
    struct compact_order order;
    order.count = 0;
    for (; lanes != 0; lanes &= lanes - 1) {
        order.lane[order.count++] = (uint8_t)__builtin_ctzll(lanes);
    }
    return order;
}

/* Writes a group's chosen numbers to to[0] on. With vectors, all up to to[COMPACT_GROUP - 1] is
 * overwritten. */
static inline void compact_numbers(real_length *restrict to, const real_length *restrict from,
                                   const struct compact_order *order) {
    for (uint32_t i = 0; i < order->count; i++) {
        to[i] = from[order->lane[i]];
    }
}

/* Writes a group's chosen words to to[0] on, as compact_numbers() does numbers. */
static inline void compact_words(uint32_t *restrict to, const uint32_t *restrict from,
                                 const struct compact_order *order) {
    for (uint32_t i = 0; i < order->count; i++) {
        to[i] = from[order->lane[i]];
    }
}

#endif
