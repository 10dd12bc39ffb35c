/* SPDX-License-Identifier: MIT */
/* Powers of numbers from 0 to 1, with one bit more than an energy has. */
#ifndef SUPERFRAME_FIXED_POWER_H
#define SUPERFRAME_FIXED_POWER_H

#include "fixed_bits.h"

/* A power while it is computed: 31 bits of fraction. */
typedef uint32_t real_power;
#define POWER_ONE (UINT32_C(1) << 31)

static inline real_power power_of(int32_t base) {
    uint32_t power = base > 0 ? 2 * (uint32_t)base : 0;
    return power < POWER_ONE ? power : POWER_ONE;
}

static inline real_power power_product(real_power a, real_power b) {
    return (uint32_t)((fixed_times_unsigned(a, b) + POWER_ONE / 2) >> 31);
}

static inline int32_t energy_of_power(real_power power) {
    return (int32_t)((power + 1) >> 1);
}

static inline int32_t energy_power(int32_t base, uint16_t exponent) {
    real_power square = power_of(base);
    if (exponent == 0) {
        return energy_of_power(POWER_ONE);
    }
    for (; (exponent & 1) == 0; exponent >>= 1) {
        square = power_product(square, square);
    }
    real_power result = square;
    for (exponent >>= 1; exponent != 0; exponent >>= 1) {
        square = power_product(square, square);
        if (exponent & 1) {
            result = power_product(result, square);
        }
    }
    return energy_of_power(result);
}

#endif
