/* SPDX-License-Identifier: MIT */
/* sqrtf() for a CPU without a floating-point unit: correctly rounded, by the integer root. */
#include "real/fx/real.h"

#include <stdint.h>

float sqrtf(float x);

union float_bits {
    float value;
    uint32_t bits;
};

/* Returns the root of x = m 2^(e - 23), 2^23 <= m < 2^24. m 2^25 or m 2^26, whichever leaves an
 * even exponent over, has a root of 25 bits. The root has one bit more than a float, and a
 * remainder cannot make a tie. An x that is 0, negative, infinite or no number is returned as it
 * is. */
float sqrtf(float x) {
    union float_bits number = {x};
    if (!(x > 0) || number.bits >= UINT32_C(0x7F800000)) {
        return x;
    }
    int32_t exponent = (int32_t)(number.bits >> 23) - 127;
    uint32_t mantissa = number.bits & UINT32_C(0x7FFFFF);
    if (exponent == -127) { /* subnormal */
        unsigned zeros = fixed_leading_zeros(mantissa) - 8;
        mantissa <<= zeros;
        exponent = -126 - (int32_t)zeros;
    }
    mantissa |= UINT32_C(0x800000);
    uint32_t root = fixed_root64((uint64_t)mantissa << (25 + (exponent & 1)));
    root = (root + 1) >> 1; /* 2^23 <= root <= 2^24 */
    number.bits = ((uint32_t)((exponent >> 1) + 126) << 23) + root;
    return number.value;
}
