/* SPDX-License-Identifier: MIT */
/* A quadric that planes across its axes cut, while the scene compiler puts it together. */
#ifndef SUPERFRAME_COMPILE_CUT_H
#define SUPERFRAME_COMPILE_CUT_H

#include "compiler/compiler_internal.h"

/* Sides of the box that nothing cuts are infinite. */
struct cut_quadric {
    struct compiled_quadric quadric;
    struct compiled_box box;
    uint32_t frame;
    bool is_ball; /* any axes are its own */
    unsigned line;
};

/* Begins a cut quadric with a ball or a quadric, perhaps one that is cut already; false for other
 * kinds. */
bool cut_start(const struct compiled_scene *scene, uint32_t primitive, struct cut_quadric *cut);

/* Returns the axis that a plane lies across, -1 if there is none. A ball takes on the axes of its
 * first plane. */
int cut_axis(struct compiler *compiler, struct cut_quadric *cut, const double normal[3]);

/* Cuts by a plane across an axis. `along` is 1 if the plane's normal has the axis's direction, -1
 * if the opposite one. */
void cut_across(struct cut_quadric *cut, int axis, double along, double offset);

/* Returns the primitive that the cut quadric has become, new or already there; COMPILED_NONE with
 * the failure recorded. */
uint32_t cut_finish(struct compiler *compiler, struct cut_quadric *cut);

/* Puts the cut quadric in place of a primitive that is a quadric; false with the failure
 * recorded. */
bool cut_replace(struct compiler *compiler, struct cut_quadric *cut, uint32_t primitive);

#endif
