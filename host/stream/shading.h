/* SPDX-License-Identifier: MIT */
/* Eq. (1) for all lanes: firmware/shade.c for many rays at once. */
#ifndef SUPERFRAME_SHADING_H
#define SUPERFRAME_SHADING_H

#include "image.h"
#include "stream/boundaries.h"

/* Finds the intensity that each boundary sends along its ray. scratch is a search to use for
 * shadows, whose content is lost: the search that found the boundaries will do. */
void shading_local(const struct scene *scene, const struct direction_lanes *direction,
                   const struct hit_lanes *hit, const struct boundary_lanes *boundary,
                   struct colour_lanes *local, struct search_lanes *scratch,
                   struct set_memory *memory, struct render_counts *counts);

#endif
