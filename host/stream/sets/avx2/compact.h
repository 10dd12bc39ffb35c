/* SPDX-License-Identifier: MIT */
/* Putting chosen lanes side by side, eight at once: by AVX2. */
#ifndef SUPERFRAME_COMPACT_H
#define SUPERFRAME_COMPACT_H

#include <immintrin.h>

#include "real.h"

enum { COMPACT_GROUP = 8 };

/* Where the lanes of a group come from. words is for words; low and high are for the halves of a
 * group of numbers that take two words each. */
struct compact_order {
    uint32_t count, low_count;
    __m256i words, low, high;
};

/* Returns the lanes that half a group's bits choose, a byte each, from the lowest on. */
static inline uint32_t compact_half(uint32_t chosen) {
    static const uint32_t lanes[16] = {0,      0,        1,        0x0100,    2,      0x0200,
                                       0x0201, 0x020100, 3,        0x0300,    0x0301, 0x030100,
                                       0x0302, 0x030200, 0x030201, 0x03020100};
    return lanes[chosen];
}

/* Returns the places of the words of the numbers that the low four bytes name; a number has two
 * words. */
static inline __m256i compact_pairs(uint32_t lanes) {
    __m256i first = _mm256_slli_epi64(_mm256_cvtepu8_epi64(_mm_cvtsi32_si128((int)lanes)), 1);
    return _mm256_or_si256(first,
                           _mm256_slli_epi64(_mm256_add_epi64(first, _mm256_set1_epi64x(1)), 32));
}

/* Finds the chosen lanes of a group: see sets/plain/compact.h. */
static inline struct compact_order compact_order_of(uint64_t lanes) {
    uint32_t low = (uint32_t)lanes & 15, high = (uint32_t)lanes >> 4 & 15;
    struct compact_order order;
    order.low_count = (uint32_t)__builtin_popcount(low);
    order.count = order.low_count + (uint32_t)__builtin_popcount(high);
    uint64_t all = (uint64_t)(compact_half(high) + 0x04040404U) << 8 * order.low_count;
    order.words = _mm256_cvtepu8_epi32(_mm_cvtsi64_si128((long long)(all | compact_half(low))));
    order.low = compact_pairs(compact_half(low));
    order.high = compact_pairs(compact_half(high));
    return order;
}

static inline void compact_words(uint32_t *to, const uint32_t *from,
                                 const struct compact_order *order) {
    const __m256i all = _mm256_loadu_si256((const void *)from);
    _mm256_storeu_si256((void *)to, _mm256_permutevar8x32_epi32(all, order->words));
}

static inline void compact_half_numbers(real_length *to, const real_length *from, __m256i half) {
    const __m256i all = _mm256_loadu_si256((const void *)from);
    _mm256_storeu_si256((void *)to, _mm256_permutevar8x32_epi32(all, half));
}

static inline void compact_numbers(real_length *to, const real_length *from,
                                   const struct compact_order *order) {
    if (sizeof(real_length) == sizeof(uint32_t)) {
        compact_half_numbers(to, from, order->words);
    } else {
        compact_half_numbers(to, from, order->low);
        compact_half_numbers(to + order->low_count, from + 4, order->high);
    }
}

#endif
