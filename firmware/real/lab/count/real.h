/* SPDX-License-Identifier: MIT */
/* The arithmetic count: double, with every operation counted by its kind. */
#ifndef SUPERFRAME_REAL_H
#define SUPERFRAME_REAL_H

#define REAL_NAME count

#include "../wrap_kinds.h"

#include <stdint.h>

typedef double floating;

extern double sqrt(double);

static inline floating floating_root(floating x) {
    return sqrt(x);
}

#define LENGTH_NOISE ((floating)0x1p-39)

/* Indexed by enum wrap_kind, with one more for WRAP_PART. Defined by the program that counts. Not
 * for several threads. */
extern uint64_t count_operations[WRAP_KINDS + 1];

#define WRAP_VALUE(kind, x) (count_operations[kind]++, (x))
#define WRAP_AREA           WRAP_VALUE
#define WRAP_PLAIN          WRAP_VALUE
#define wrap_power          energy_power

/* The smallest t of a ray's first crossing: 0, because rays snap to surfaces. */
#define LENGTH_EPSILON REAL_LENGTH(0.0)

#include "../wrapped.h"

#endif
