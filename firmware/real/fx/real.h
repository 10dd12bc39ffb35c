/* SPDX-License-Identifier: MIT */
/* The arithmetic fx: fixed point, integers only, the same bits on every CPU and compiler. */
#ifndef SUPERFRAME_REAL_H
#define SUPERFRAME_REAL_H

#define REAL_NAME fx

#include "../fixed_operations.h"

#include <stdbool.h>
#include <stdint.h>

/* Nobody watches: the call and its arguments vanish. */
static inline void fixed_watch(enum fixed_operation operation, int64_t exact, bool saturated) {
    (void)operation;
    (void)exact;
    (void)saturated;
}

#include "../fixed.h"

#endif
