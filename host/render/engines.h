/* SPDX-License-Identifier: MIT */
/* The stream engines that are linked. */
#ifndef SUPERFRAME_ENGINES_H
#define SUPERFRAME_ENGINES_H

#include "render/engine.h"

struct engine_choice {
    const char *arithmetic; /* NULL ends the table */
    const struct stream_engine *engine;
    bool (*runs_here)(void); /* whether this CPU has what it takes; NULL: any has */
};

/* From the plainest to the best. */
extern const struct engine_choice engine_choices[];

#endif
