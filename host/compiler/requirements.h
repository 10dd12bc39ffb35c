/* SPDX-License-Identifier: MIT */
/* What a scene requires of the renderer, what it provably does not, and its ranges, in words. */
#ifndef SUPERFRAME_REQUIREMENTS_H
#define SUPERFRAME_REQUIREMENTS_H

#include <stdio.h>

#include "compiler/tables.h"

/* Prints the features that the scene requires, as compiler/features.h finds them for `compile
 * --minimal`. Then come, each on a line, what is proved dead and why, and then ranges. */
void requirements_print(FILE *out, const struct compiled_scene *scene);

/* Returns how deep the scene's primitives are provably nested: 0 where none lies within another. */
int requirements_nesting(const struct compiled_scene *scene);

/* Tells whether a ray can meet a boundary from a denser to a thinner medium. False is a proof: all
 * that is transparent refracts like the air, or no direction is ever bent. */
bool requirements_total_reflection(const struct compiled_scene *scene);

/* Tells whether some material has a highlight, or mirrors. */
bool requirements_highlight(const struct compiled_scene *scene);

#endif
