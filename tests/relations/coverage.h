/* SPDX-License-Identifier: MIT */
/* What the generated scenes covered: a generator that draws nothing of interest is noticed. */
#ifndef SUPERFRAME_RELATIONS_COVERAGE_H
#define SUPERFRAME_RELATIONS_COVERAGE_H

#include <stdio.h>

#include "compiler/tables.h"
#include "syntax.h"

enum { COVERAGE_MOST = 80 };

/* Scenes that had each thing. */
struct coverage {
    unsigned long scenes[COVERAGE_MOST];
};

/* Counts what one scene has. */
void coverage_add(struct coverage *coverage, const struct syntax *scene,
                  const struct compiled_scene *compiled);

/* Prints the counts, and returns how many are 0. */
int coverage_print(const struct coverage *coverage, FILE *file);

#endif
