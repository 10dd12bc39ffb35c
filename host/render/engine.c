/* SPDX-License-Identifier: MIT */
/* Stream engines by arithmetic. */
#include "render/engine.h"

#include <string.h>

#include "render/engines.h"

const struct stream_engine *stream_engine_get(const char *arithmetic, unsigned i) {
    for (const struct engine_choice *choice = engine_choices; choice->arithmetic; choice++) {
        if (strcmp(choice->arithmetic, arithmetic) == 0 &&
            (!choice->runs_here || choice->runs_here()) && i-- == 0) {
            return choice->engine;
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
