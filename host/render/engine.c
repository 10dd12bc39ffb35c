/* SPDX-License-Identifier: MIT */
/* Stream engines by arithmetic. */
#include "render/engine.h"

#include <string.h>

/* Tells whether this CPU has a set of instructions. */
static bool is_here(const char *set) {
    for (size_t i = 0; instruction_sets_built[i] != NULL; i++) {
        if (strcmp(instruction_sets_built[i]->name, set) == 0) {
            return instruction_sets_built[i]->is_here();
        }
    }
    return true; /* a plain one */
}

const struct stream_engine *stream_engine_get(const char *arithmetic, unsigned i) {
    for (size_t j = 0; stream_engines_built[j] != NULL; j++) {
        const struct stream_engine *engine = stream_engines_built[j];
        if (strcmp(engine->arithmetic, arithmetic) == 0 && is_here(engine->set) && i-- == 0) {
            return engine;
        }
    }
    return NULL;
}

const struct stream_engine *stream_engine_find(const char *arithmetic) {
    const struct stream_engine *best = NULL, *next;
    for (unsigned i = 0; (next = stream_engine_get(arithmetic, i)) != NULL; i++) {
        best = next;
    }
    return best;
}
