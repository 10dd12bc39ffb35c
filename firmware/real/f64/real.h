/* SPDX-License-Identifier: MIT */
/* The arithmetic f64: IEEE double. */
#ifndef SUPERFRAME_REAL_H
#define SUPERFRAME_REAL_H

#define REAL_NAME f64

typedef double floating;

extern double sqrt(double);

static inline floating floating_root(floating x) {
    return sqrt(x);
}

/* 16 units in the last place at 512. */
#define LENGTH_NOISE ((floating)0x1p-39)

/* The smallest t of a ray's first crossing: 0, because rays snap to surfaces. */
#define LENGTH_EPSILON REAL_LENGTH(0.0)

#include "../floating.h"

#endif
