/* SPDX-License-Identifier: MIT */
/* Products of 32 by 32 bits on a CPU that keeps only 32 bits of a product, such as a Cortex-M0. */
#ifndef SUPERFRAME_FIXED_PRODUCT_H
#define SUPERFRAME_FIXED_PRODUCT_H

#include <stdint.h>

/* Each function makes four products of 16 by 16 bits, where the compiler's library multiplies 64 by
 * 64 bits. No sum below leaves 32 bits: 65535 * 65535 + 65535 < 2^32,
 * 32767 * 65535 + 65535 < 2^31. */

static inline uint64_t fixed_times_unsigned(uint32_t a, uint32_t b) {
    uint32_t a_low = a & 0xFFFF;
    uint32_t a_high = a >> 16;
    uint32_t b_low = b & 0xFFFF;
    uint32_t b_high = b >> 16;
    uint32_t low = a_low * b_low;
    uint32_t middle = a_high * b_low + (low >> 16);
    uint32_t other = a_low * b_high + (middle & 0xFFFF);
    uint32_t high = a_high * b_high + (middle >> 16) + (other >> 16);
    return (uint64_t)high << 32 | (other << 16 | (low & 0xFFFF));
}

static inline int64_t fixed_times(int32_t a, int32_t b) {
    int32_t a_low = (int32_t)((uint32_t)a & 0xFFFF);
    int32_t a_high = a >> 16;
    int32_t b_low = (int32_t)((uint32_t)b & 0xFFFF);
    int32_t b_high = b >> 16;
    uint32_t low = (uint32_t)a_low * (uint32_t)b_low;
    int32_t middle = a_high * b_low + (int32_t)(low >> 16);
    int32_t other = a_low * b_high + (int32_t)((uint32_t)middle & 0xFFFF);
    int32_t high = a_high * b_high + (middle >> 16) + (other >> 16);
    return (int64_t)((uint64_t)(uint32_t)high << 32 | ((uint32_t)other << 16 | (low & 0xFFFF)));
}

#endif
