/* SPDX-License-Identifier: MIT */
/* The scene compiler: the plane faces of primitives. */
#include <string.h>

#include "compiler/tables.h"

/* Lists the faces of a box that lie across those of its axes whose bits are set. Returns how many
 * there are. */
static int box_faces(const struct compiled_scene *scene, uint32_t frame,
                     const struct compiled_box *box, unsigned axes, struct compiled_face *faces) {
    int count = 0;
    for (int i = 0; i < 6; i++) {
        if ((axes >> i % 3 & 1) == 0) {
            continue;
        }
        double sign = i < 3 ? -1 : 1;
        const double *axis = compiled_axis(scene, frame, i % 3);
        struct compiled_face *face = &faces[count++];
        for (int j = 0; j < 3; j++) {
            face->normal[j] = sign * axis[j];
        }
        face->offset = sign * (i < 3 ? box->minimum[i] : box->maximum[i - 3]);
        face->surface = box->surface[i];
    }
    return count;
}

int compiled_faces(const struct compiled_scene *scene, uint32_t primitive_index,
                   struct compiled_face faces[COMPILED_FACES_MOST]) {
    const struct compiled_primitive *primitive = &scene->primitives[primitive_index];
    const struct compiled_quadric *quadric;
    const struct compiled_polyhedron *polyhedron;
    switch ((enum primitive_kind)primitive->kind) {
    case PRIMITIVE_BALL:
        return 0;
    case PRIMITIVE_BOX:
        return box_faces(scene, primitive->frame, &scene->boxes[primitive->index], 7, faces);
    case PRIMITIVE_QUADRIC:
        quadric = &scene->quadrics[primitive->index];
        return box_faces(scene, primitive->frame, compiled_box_of(scene, quadric), quadric->cuts,
                         faces);
    case PRIMITIVE_POLYHEDRON:
        polyhedron = &scene->polyhedra[primitive->index];
        for (uint32_t i = 0; i < polyhedron->count; i++) {
            const struct compiled_plane *plane = &scene->planes[polyhedron->first + i];
            memcpy(faces[i].normal, plane->normal, sizeof faces[i].normal);
            faces[i].offset = plane->offset;
            faces[i].surface = plane->surface;
        }
        return polyhedron->count;
    }
    return 0;
}
