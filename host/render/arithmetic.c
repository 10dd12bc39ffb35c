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

const struct arithmetic *arithmetic_with_lists(const struct arithmetic *arithmetic) {
    for (size_t i = 0; arithmetics_many_built[i] != NULL; i++) {
        if (strcmp(arithmetics_many_built[i]->image->name, arithmetic->image->name) == 0) {
            return arithmetics_many_built[i];
        }
    }
    return NULL;
}

/* Up to so many primitives, bits are faster on a host: the sets of stream engines are words. */
enum { BITS_BEST_MOST = 32 };

const struct arithmetic *arithmetic_for(const struct arithmetic *arithmetic,
                                        const struct compiled_scene *compiled) {
    const struct arithmetic *many = arithmetic_with_lists(arithmetic);
    bool is_small = compiled->primitive_count <= BITS_BEST_MOST && arithmetic->has_room(compiled);
    return many == NULL || is_small ? arithmetic : many;
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
