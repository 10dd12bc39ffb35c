/* SPDX-License-Identifier: MIT */
/* A scene in another unit of length or at another place: its picture stays the same. */
#ifndef SUPERFRAME_TRANSFORMED_SCENE_H
#define SUPERFRAME_TRANSFORMED_SCENE_H

#include <stdbool.h>

#include "scene/description.h"

/* Scales about the origin, then moves by `move` along x, y and z, all that a description says of
 * places. (Light that fades by C + D is no such thing: its brightness goes by the file's unit.) */
static inline void transform_scene(struct scene_description *description, double scale,
                                   double move) {
    bool done[SCENE_NODES_MOST] = {false};
    for (size_t i = 0; i < description->object_count; i++) {
        int root = description->objects[i].solid;
        struct affine *placement = &description->nodes[root].placement;
        for (int row = 0; row < 3 && !done[root]; row++) {
            for (int column = 0; column < 4; column++) {
                placement->m[row][column] *= scale;
            }
            placement->m[row][3] += move;
        }
        done[root] = true;
    }
    for (size_t i = 0; i < description->material_count; i++) {
        struct scene_material *material = &description->materials[i];
        for (int j = 0; j < 3; j++) {
            material->absorption[j] /= scale;
            material->pattern.size[j] *= scale;
            material->pattern.origin[j] = scale * material->pattern.origin[j] + move;
        }
    }
    for (int i = 0; i < 3; i++) {
        description->camera.eye[i] = scale * description->camera.eye[i] + move;
        description->camera.look_at[i] = scale * description->camera.look_at[i] + move;
        for (size_t j = 0; j < description->light_count; j++) {
            double *position = description->lights[j].position;
            position[i] = scale * position[i] + move;
        }
    }
}

#endif
