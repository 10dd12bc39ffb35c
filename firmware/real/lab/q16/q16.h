/* SPDX-License-Identifier: MIT */
/* Plain fixed point, Q16.16 in every role: what fx is not, and why. For measurements only. */

/* Included by q16/real.h and q16_epsilon/real.h. Each operation is computed in double, then rounded
 * to the nearest 2^-16 and saturated just inside +-32768. So the numbers are those of an image in
 * 32-bit integers with 64-bit intermediates. Areas, which would not fit, keep the 32 bits of
 * fraction of a product. The arithmetic says how exact such an image would be, not how fast. */

#include "../wrap_kinds.h"

#include <stdint.h>

typedef double floating;

extern double sqrt(double);

static inline floating floating_root(floating x) {
    return sqrt(x);
}

/* 8 LSB, as in fx. */
#define LENGTH_NOISE ((floating)0x1p-13)

/* Rounds x to a multiple of 1 / steps, to nearest, halves away from zero. After the clamp
 * |x| * steps is at most 2^62. */
static inline floating q16_rounded(floating x, floating steps, floating most) {
    floating clamped = x > most ? most : x < -most ? -most : x;
    floating scaled = clamped * steps;
    return (floating)(int64_t)(scaled + (scaled < 0 ? -0.5 : 0.5)) / steps;
}

static inline floating q16_value(floating x) {
    return q16_rounded(x, 65536, 32767.9999);
}

static inline floating q16_area(floating x) {
    return q16_rounded(x, 4294967296.0, 1073741824.0);
}

/* Returns base^exponent, rounded at each step, as integers are. */
static inline floating wrap_power(floating base, uint16_t exponent) {
    floating result = 1;
    for (floating square = base; exponent != 0; exponent >>= 1) {
        if (exponent & 1) {
            result = q16_value(result * square);
        }
        square = q16_value(square * square);
    }
    return result;
}

#define WRAP_VALUE(kind, x) q16_value(x)
#define WRAP_AREA(kind, x)  q16_area(x)
#define WRAP_PLAIN(kind, x) (x)

#include "../wrapped.h"

/* Constants are rounded too. The result is an arithmetic constant where x is one. */
#define Q16_CONSTANT(x)                                                                            \
    ((floating)(int64_t)((double)(x)*65536.0 + ((double)(x) < 0 ? -0.5 : 0.5)) / 65536.0)

#undef REAL_LENGTH
#undef REAL_UNIT
#undef REAL_INDEX
#undef REAL_ENERGY
#undef REAL_COLOUR
#undef REAL_EXTINCTION
#define REAL_LENGTH(x)     Q16_CONSTANT(x)
#define REAL_UNIT(x)       Q16_CONSTANT(x)
#define REAL_INDEX(x)      Q16_CONSTANT(x)
#define REAL_ENERGY(x)     Q16_CONSTANT(x)
#define REAL_COLOUR(x)     Q16_CONSTANT(x)
#define REAL_EXTINCTION(x) Q16_CONSTANT(x)
