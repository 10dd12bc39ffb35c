/* SPDX-License-Identifier: MIT */
/* Leading zeros, on a CPU that has an instruction for them: the sibling of leading_zeros_counted.h.
 */
#ifndef SUPERFRAME_FIXED_ZEROS_H
#define SUPERFRAME_FIXED_ZEROS_H

#include <limits.h>
#include <stdint.h>

/* C99 has no name for the instruction. gcc and clang have __builtin_clz(), for an unsigned int. */
typedef char fixed_needs_int_of_32_bits[UINT_MAX == UINT32_MAX ? 1 : -1];

/* Returns the number of zero bits above the highest one; x > 0. */
static inline unsigned fixed_leading_zeros(uint32_t x) {
    return (unsigned)__builtin_clz(x);
}

#endif
