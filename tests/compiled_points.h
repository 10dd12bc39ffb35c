/* SPDX-License-Identifier: MIT */
/* Points of the file, and whether compiled objects hold them. */
#ifndef SUPERFRAME_TESTS_COMPILED_POINTS_H
#define SUPERFRAME_TESTS_COMPILED_POINTS_H

#include "scene_fixture.h"

/* Takes a point of the file to where the compiler puts it. */
static inline void scale_point(const struct compiled_scene *scene, const double point[3],
                               double scaled[3]) {
    for (int i = 0; i < 3; i++) {
        scaled[i] = ldexp(point[i] - scene->centre[i], scene->exponent);
    }
}

/* Says whether the compiled object holds a point of the file. */
static inline bool object_has(const struct compiled_scene *scene, uint8_t object,
                              const double point[3]) {
    struct compiled_set inside = {{0}};
    double scaled[3];
    scale_point(scene, point, scaled);
    for (uint8_t i = 0; i < scene->primitive_count; i++) {
        if (compiled_primitive_holds(scene, i, scaled)) {
            compiled_set_include(&inside, i);
        }
    }
    return compiled_object_holds(scene, object, &inside);
}

#endif
