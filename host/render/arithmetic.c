/* SPDX-License-Identifier: MIT */
/* The images of the firmware by name. */
#include "render/arithmetic.h"

#include <string.h>

/* Arithmetics that `superframe measure` alone knows. */
static const struct arithmetic *const examples[] = {&arithmetic_q16, &arithmetic_q16_epsilon};

const struct arithmetic *arithmetic_find(const char *name) {
    for (size_t i = 0; arithmetics_built[i] != NULL; i++) {
        if (strcmp(arithmetics_built[i]->image->name, name) == 0) {
            return arithmetics_built[i];
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

bool arithmetic_is_missing(const char *name) {
    /* The only one that takes what not every compiler has. */
    return strcmp(name, "f128") == 0 && arithmetic_find(name) == NULL;
}
