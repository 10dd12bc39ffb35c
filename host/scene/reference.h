/* SPDX-License-Identifier: MIT */
/* The keys of a scene file, as docs/scene-format.md has them. */
#ifndef SUPERFRAME_SCENE_REFERENCE_H
#define SUPERFRAME_SCENE_REFERENCE_H

#include <stdio.h>

/* Prints all keys, by sorts of groups, as tables of Markdown. */
void scene_print_reference(FILE *out);

#endif
