/* SPDX-License-Identifier: MIT */
/* What a scene is told to mean, and perhaps does not: no error, but worth a word. */
#ifndef SUPERFRAME_REMARKS_H
#define SUPERFRAME_REMARKS_H

#include <stdio.h>

#include "render/arithmetic.h"

/* Says on standard error what may spoil a picture in this arithmetic: near faces that it does not
 * tell apart, an eye inside an opaque solid. */
void remarks_complain(const struct compiled_scene *scene, const struct arithmetic *arithmetic);

/* Prints all remarks for `check`, with what each arithmetic does. */
void remarks_print(FILE *out, const struct compiled_scene *scene);

#endif
