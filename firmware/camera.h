/* SPDX-License-Identifier: MIT */
/* The ray from the eye through a pixel. */
#ifndef SUPERFRAME_CAMERA_H
#define SUPERFRAME_CAMERA_H

#include "ray.h"

/* Returns the ray through the centre of pixel (x, y); x counts to the right, y down. */
struct ray camera_ray(const struct scene *scene, uint16_t x, uint16_t y);

#endif
