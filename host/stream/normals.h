/* SPDX-License-Identifier: MIT */
/* The normal at each lane's boundary, turned towards the arriving ray. */
#ifndef SUPERFRAME_NORMALS_H
#define SUPERFRAME_NORMALS_H

#include "stream/hits.h"

/* Sets hit->normal in the lanes that have a boundary, from hit->is and hit->where. */
void normals_find(const struct search_lanes *search, struct hit_lanes *hit);

#endif
