/* SPDX-License-Identifier: MIT */
/* The arithmetic f32: IEEE float. */
#ifndef SUPERFRAME_REAL_H
#define SUPERFRAME_REAL_H

#define REAL_NAME f32

typedef float floating;

extern float sqrtf(float);

static inline floating floating_root(floating x) {
    return sqrtf(x);
}

/* 4 units in the last place at 512. */
#define LENGTH_NOISE ((floating)0x1p-12)

/* The smallest t of a ray's first crossing: 0, because rays snap to surfaces. */
#define LENGTH_EPSILON REAL_LENGTH(0.0)

#include "../floating.h"

#endif
