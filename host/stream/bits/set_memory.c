/* SPDX-License-Identifier: MIT */
/* The table of surfaces, from the solids of a scene. */
#include "set_memory.h"

#include "stream/surfaces.h"

bool set_memory_fits(const struct scene *scene) {
    return scene->primitive_count <= STREAM_PRIMITIVES_MOST && surface_last(scene) < TOUCHES - 1;
}

void set_memory_begin(struct set_memory *memory, const struct scene *scene) {
    const uint32_t count = scene->primitive_count > 0 ? surface_last(scene) + 1 : 0;
    for (uint32_t i = 0; i < TOUCHES; i++) {
        memory->touches[i] = i < count ? scene->surfaces[i].word[0] : 0;
    }
}
