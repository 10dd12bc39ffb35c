/* SPDX-License-Identifier: MIT */
/* The table into which the arithmetic checked writes what its operations did. */
#include "real.h"

struct fixed_record fixed_records[FIXED_OPERATION_COUNT];

#define FIXED_OPERATION_NAME(name) #name,

const char *const fixed_record_names[FIXED_OPERATION_COUNT] = {
    FIXED_OPERATIONS(FIXED_OPERATION_NAME)};
