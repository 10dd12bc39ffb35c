/* SPDX-License-Identifier: MIT */
/* The tree of rays of one pixel: Eq. (2) and (3). */
#ifndef SUPERFRAME_TREE_H
#define SUPERFRAME_TREE_H

#include "ray.h"

/* The intensity that arrives at the eye along a ray. */
struct colours tree_colour(const struct scene *scene, const struct ray *eye_ray,
                           struct render_counts *counts);

#endif
