/* SPDX-License-Identifier: MIT */
/* The stream engines that are linked. */
#ifndef SUPERFRAME_ENGINES_H
#define SUPERFRAME_ENGINES_H

#include "render/engine.h"

struct engine_choice {
    const char *arithmetic; /* NULL ends the table */
    const struct stream_engine *engine;
    bool (*runs_here)(void); /* tells whether this CPU runs the engine; NULL: any does */
};

/* For each arithmetic, from the plainest engine to the best. */
extern const struct engine_choice engine_choices[];

#endif
