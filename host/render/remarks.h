/* SPDX-License-Identifier: MIT */
/* Remarks on what a scene says and perhaps does not mean; such remarks are no errors. */
#ifndef SUPERFRAME_REMARKS_H
#define SUPERFRAME_REMARKS_H

#include <stdio.h>

#include "render/arithmetic.h"
#include "render/render.h"

/* Says on standard error what may spoil a picture in this arithmetic. That is near faces which the
 * arithmetic does not tell apart, or an eye inside an opaque object. It is also an endless floor
 * that is seen to end, or nothing in view. */
void remarks_complain(const struct compiled_scene *scene, const struct arithmetic *arithmetic);

/* Says on standard error how many pixels are not as accurate as the scene asks for. Names the worst
 * of them; says nothing where there are none. */
void remarks_complain_of_error(const struct compiled_scene *scene,
                               const struct render_totals *totals);

/* Prints all remarks for `check`, with the arithmetics in which seams may show. */
void remarks_print(FILE *out, const struct compiled_scene *scene);

#endif
