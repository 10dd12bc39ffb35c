/* SPDX-License-Identifier: MIT */
/* The ray from the eye through a pixel. */
#include "camera.h"

struct ray camera_ray(const struct scene *scene, uint16_t x, uint16_t y) {
    const struct camera *camera = &scene->camera;
    /* Half pixels from the middle, so that the centres of the pixels are whole numbers. */
    int16_t column = (int16_t)(2 * (int16_t)x + 1 - (int16_t)scene->width);
    int16_t row = (int16_t)(2 * (int16_t)y + 1 - (int16_t)scene->height);
    real_wide forward[3] = {wide_component(camera->forward.x, camera->column.x, column,
                                           camera->row.x, row, camera->shift),
                            wide_component(camera->forward.y, camera->column.y, column,
                                           camera->row.y, row, camera->shift),
                            wide_component(camera->forward.z, camera->column.z, column,
                                           camera->row.z, row, camera->shift)};
    struct ray ray;
    ray.origin = camera->eye;
    unit_normalise_wide(forward[0], forward[1], forward[2], &ray.direction.x, &ray.direction.y,
                        &ray.direction.z);
    ray.inside = camera->inside;
    ray.surface = SURFACE_NONE;
    ray.object = camera->object;
    return ray;
}
