/* SPDX-License-Identifier: MIT */
/* The arithmetic f128: IEEE binary128 in software, the oracle of the others. */
#ifndef SUPERFRAME_REAL_H
#define SUPERFRAME_REAL_H

#define REAL_NAME f128

typedef __float128 floating;

extern __float128 sqrtq(__float128);

static inline floating floating_root(floating x) {
    return sqrtq(x);
}

/* 32 units in the last place at 512. */
#define LENGTH_NOISE ((floating)0x1p-98)

/* The smallest t of a ray's first crossing: 0, because rays snap to surfaces. */
#define LENGTH_EPSILON REAL_LENGTH(0.0)

#include "../floating.h"

#endif
