/* SPDX-License-Identifier: MIT */
/* The images of the firmware by name. */
#include "arithmetic.h"

#include <string.h>

static const struct arithmetic *const arithmetics[] = {&arithmetic_fx, &arithmetic_f32,
                                                       &arithmetic_f64, &arithmetic_f128};

/* Known to `superframe measure` alone. */
static const struct arithmetic *const examples[] = {&arithmetic_q16, &arithmetic_q16_epsilon};

const char arithmetic_names[] = "fx, f32, f64 or f128";

const struct arithmetic *arithmetic_find(const char *name) {
    for (size_t i = 0; i < sizeof arithmetics / sizeof arithmetics[0]; i++) {
        if (strcmp(arithmetics[i]->image->name, name) == 0) {
            return arithmetics[i];
        }
    }
    return NULL;
}

const struct arithmetic *arithmetic_find_any(const char *name) {
    for (size_t i = 0; i < sizeof examples / sizeof examples[0]; i++) {
        if (strcmp(examples[i]->image->name, name) == 0) {
            return examples[i];
        }
    }
    return arithmetic_find(name);
}
