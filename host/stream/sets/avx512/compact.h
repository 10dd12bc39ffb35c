/* SPDX-License-Identifier: MIT */
/* Putting chosen lanes side by side, sixteen at once: by AVX-512. */
#ifndef SUPERFRAME_COMPACT_H
#define SUPERFRAME_COMPACT_H

#include <immintrin.h>

#include "real.h"

enum { COMPACT_GROUP = 16 };

/* The chosen lanes of a group, and how many there are. The low half's are counted too, for numbers
 * that take two words. */
struct compact_order {
    __mmask16 chosen;
    uint32_t count, low_count;
};

/* Finds the chosen lanes of a group: see sets/plain/compact.h. */
static inline struct compact_order compact_order_of(uint64_t lanes) {
    const struct compact_order order = {(__mmask16)(lanes & 0xFFFF),
                                        (uint32_t)__builtin_popcountll(lanes & 0xFFFF),
                                        (uint32_t)__builtin_popcountll(lanes & 0xFF)};
    return order;
}

static inline void compact_words(uint32_t *to, const uint32_t *from,
                                 const struct compact_order *order) {
    const __m512i all = _mm512_loadu_si512(from);
    _mm512_storeu_si512(to, _mm512_maskz_compress_epi32(order->chosen, all));
}

static inline void compact_half_numbers(real_length *to, const real_length *from, __mmask8 chosen) {
    const __m512i all = _mm512_loadu_si512(from);
    _mm512_storeu_si512(to, _mm512_maskz_compress_epi64(chosen, all));
}

static inline void compact_numbers(real_length *to, const real_length *from,
                                   const struct compact_order *order) {
    if (sizeof(real_length) == sizeof(uint32_t)) {
        const __m512i all = _mm512_loadu_si512(from);
        _mm512_storeu_si512(to, _mm512_maskz_compress_epi32(order->chosen, all));
    } else {
        compact_half_numbers(to, from, (__mmask8)order->chosen);
        compact_half_numbers(to + order->low_count, from + 8, (__mmask8)(order->chosen >> 8));
    }
}

#endif
