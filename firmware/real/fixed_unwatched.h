/* SPDX-License-Identifier: MIT */
/* The hook of the fixed-point operations where nobody watches them. */
#ifndef SUPERFRAME_FIXED_UNWATCHED_H
#define SUPERFRAME_FIXED_UNWATCHED_H

#include "fixed_operations.h"

#include <stdbool.h>
#include <stdint.h>

/* Does nothing, so that the call and its arguments vanish. */
static inline void fixed_watch(enum fixed_operation operation, int64_t exact, bool saturated) {
    (void)operation;
    (void)exact;
    (void)saturated;
}

#endif
