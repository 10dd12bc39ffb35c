/* SPDX-License-Identifier: MIT */
/* Frees what the scene reader made. */
#include "scene/description.h"

#include <stdlib.h>

void scene_description_free(struct scene_description *description) {
    if (!description) {
        return;
    }
    for (size_t i = 0; i < description->material_count; i++) {
        free(description->materials[i].name);
    }
    for (size_t i = 0; i < description->node_count; i++) {
        free(description->nodes[i].planes);
        free(description->nodes[i].children);
    }
    for (size_t i = 0; i < description->object_count; i++) {
        free(description->objects[i].name);
    }
    free(description->lights);
    free(description->materials);
    free(description->nodes);
    free(description->objects);
    free(description->title);
    free(description->path);
    free(description);
}
