/* SPDX-License-Identifier: MIT */
/* The arithmetic checked: fx, with what each operation did recorded in a table. */
#ifndef SUPERFRAME_REAL_H
#define SUPERFRAME_REAL_H

#define REAL_NAME checked

#include "../../estimate_division.h"
#include "../../fixed_operations.h"
#include "../../leading_zeros_counted.h"
#include "../../product_whole.h"
#include "../../registers_64.h"
#include "../../root_table.h"

#include <stdbool.h>
#include <stdint.h>

/* What one operation has done since the start. `largest` is the greatest magnitude of a result
 * before saturation, in LSB of the result. For areas, which come saturated, the LSB is that of
 * Q23.40. */
struct fixed_record {
    uint32_t calls; /* stops at its end, as saturations does */
    uint32_t saturations;
    uint64_t largest;
};

/* The table is indexed by operation, and defined in record.c. Not for several threads: this image
 * runs in one. The table is writable, so that a test may clear it. */
extern struct fixed_record fixed_records[FIXED_OPERATION_COUNT];

/* The names of the operations, as in strict/real.h. */
extern const char *const fixed_record_names[FIXED_OPERATION_COUNT];

static inline void fixed_watch(enum fixed_operation operation, int64_t exact, bool saturated) {
    struct fixed_record *record = &fixed_records[operation];
    uint64_t magnitude = exact < 0 ? 0 - (uint64_t)exact : (uint64_t)exact;
    record->calls += record->calls < UINT32_MAX;
    record->saturations += saturated && record->saturations < UINT32_MAX;
    if (magnitude > record->largest) {
        record->largest = magnitude;
    }
}

#include "../../room_unasked.h"

#include "../../fixed.h"

#endif
