/* SPDX-License-Identifier: MIT */
/* The local intensity of a surface point: Eq. (1) without its last two terms. */
#ifndef SUPERFRAME_SHADE_H
#define SUPERFRAME_SHADE_H

#include "ray.h"

/* Returns a Ia + A { rho_d cos(theta) Ic + w cos^g(alpha) Ip } / (C + D), over all lights. ray is
 * the one that arrived, mirrored the ray's direction after reflection. */
struct colours shade(const struct scene *scene, const struct material *material,
                     const struct ray *ray, const struct hit *hit, const struct direction *mirrored,
                     struct render_counts *counts);

#endif
